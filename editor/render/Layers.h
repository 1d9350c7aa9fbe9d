// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/render/ColorMap.h"
#include "editor/render/ScopeLook.h"
#include "simcore/base/Error.h"
#include "simcore/scene/Part.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// How one object is shown.
struct ObjectLook {
  bool visible = true;
  float opacity = 1;      ///< 0…1; below 1 the object's front layer is blended
  bool selected = false;  ///< outline and tint
  bool hovered = false;   ///< fainter than selected
  std::optional<std::array<float, 3>> color = std::nullopt;  ///< sRGB, in place of the object's own
};

/// Triangles of one surface in a colour of their own: a region that is being picked, an error shown in place.
struct TriangleMark {
  int object = 0;
  SurfaceKind surface = SurfaceKind::Visual;
  std::vector<int> triangles;
  std::array<float, 3> color{1.0f, 0.55f, 0.1f};  ///< sRGB
};

/// Lines and dots that belong to no object: handles, arrows, the outline of what is being picked.
struct Strokes {
  struct End {
    Eigen::Vector3f at;
    std::array<float, 4> color{1, 1, 1, 1};  ///< sRGB and alpha
  };
  std::vector<End> lines;  ///< two by two
  std::vector<End> dots;
  float linePx = 1.5f, dotPx = 7;  ///< logical pixels
  bool onScreen = false;           ///< `at` in logical pixels from the top left, on top of all; else W, m
  float hiddenStrength = 0.3f;     ///< how much of it is seen through surfaces, 0…1
};

/// Values on visual surfaces, shown as colours with a scale beside them. Where a part faces the viewer it has the scale's
/// colour, whatever lights and tones do to tissue; where it turns away it is darker, in hue the same. Parts without values are
/// grey, tools and collision surfaces look as always.
struct FieldLook {
  /// By object, then by vertex of its visual surface; an empty list, or one of another length: no values. Told apart by
  /// address: other values want another vector.
  std::shared_ptr<const std::vector<std::vector<float>>> values;
  double low = 0, high = 1;  ///< of the scale, in the values' unit; low < high
  bool zeroIsNone = false;   ///< low is nothing at all: the scale begins with the grey of parts without values
  /// The legend's words, ready to be read; no title: no legend.
  std::string title;
  struct Tick {
    double at;
    std::string text;
  };
  std::vector<Tick> ticks;
};
/// A scale across zero parts at zero, at any values of its ends; another one does not.
ColorMap mapOf(const FieldLook& field);
/// Colour of a value, sRGB.
std::array<float, 3> colorOf(const FieldLook& field, double value);

/// What is shown: each layer for itself, as in the paper's Figure 1.
struct Layers {
  bool visual = true;               ///< visual surfaces, smooth
  bool collision = false;           ///< collision surfaces, flat with their edges
  bool dynamics = false;            ///< edges of the tetrahedra
  bool couplings = false;           ///< springs and their ends
  bool islands = false;             ///< parts in the colour of their coupling island; `objects` holds the colours
  bool contacts = false;            ///< points, normals, length by force
  bool tools = true;                ///< tools, whatever surface is shown
  bool regions = false;             ///< all named regions, colour by kind
  bool labels = false;              ///< names beside what is shown
  bool marker = true;               ///< orientation in the corner
  std::vector<ObjectLook> objects;  ///< by object index; missing entries: default
  std::vector<TriangleMark> marks;
  std::vector<Strokes> strokes;
  std::vector<DentView> dents;      ///< of the step that led to the state shown: surfaces sink there
  std::optional<FieldLook> field = std::nullopt;
  std::map<std::string, std::string> names;  ///< for labels: what to write in place of a name of the model

  ObjectLook lookOf(int object) const {
    return object < static_cast<int>(objects.size()) ? objects[object] : ObjectLook{};
  }
};

/// From a comma-separated list ("visual,contacts"); words as the members above, without `marker`. Tools and
/// marker stay as they are by default; "all" and "none" are understood. Fails with BadUsage naming the word.
Result<Layers> layersFromWords(std::string_view words);

/// How it is drawn.
struct Look {
  bool dark = false;             ///< background for a dark theme
  bool transparent = false;      ///< no background: alpha 0 where nothing is
  bool detail = true;            ///< fibres of muscle, mottled bone
  bool ambientOcclusion = true;  ///< darker hollows, and tissue darker near a tool
  int samples = -1;              ///< MSAA; −1: 4, or 1 on a software renderer
  int supersample = 1;           ///< 1…4: drawn larger by this factor and averaged
  double pixelRatio = 1;         ///< device pixels per logical pixel: width of lines and size of the marker
  /// As through an arthroscope, see ScopeView.h: no background, marker, labels, legend or strokes then.
  std::optional<ScopeLook> scope = std::nullopt;
};

}  // namespace glenoid
