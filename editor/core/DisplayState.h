// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <array>
#include <map>
#include <string>

#include "editor/core/Selection.h"
#include "editor/render/Layers.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// What of a scene is shown and how, by id, so that it outlives a recompiled model. Belongs to the window, not
/// to the document: looking is not an edit. GUI thread only.
class DisplayState : public QObject {
  Q_OBJECT
 public:
  enum class Layer { Visual, Collision, Dynamics, Couplings, Islands, Contacts, Regions, Labels, Marker };
  static constexpr Layer kLayers[] = {Layer::Visual,   Layer::Collision, Layer::Dynamics, Layer::Couplings,
                                      Layer::Islands,  Layer::Contacts,  Layer::Regions,  Layer::Labels,
                                      Layer::Marker};

  /// Colour of a coupling island, sRGB; neighbours in number differ clearly. Fixed parts keep their own colour.
  static std::array<float, 3> islandColor(int island);

  using QObject::QObject;

  bool isShown(Layer layer) const { return m_layers.*member(layer); }
  void show(Layer layer, bool on);

  bool isVisible(const std::string& id) const { return lookOf(id).visible; }
  void setVisible(const std::string& id, bool visible);
  double opacity(const std::string& id) const { return lookOf(id).opacity; }
  void setOpacity(const std::string& id, double opacity);  ///< clamped to 0…1

  /// While one or more objects are soloed, the others are hidden; what was visible before comes back after.
  const std::set<std::string>& soloed() const { return m_soloed; }
  void solo(const std::set<std::string>& ids);
  void showAll();  ///< everything visible and opaque, no solo

  /// For the renderer: the layers with one look for each object of the model.
  Layers layersFor(const Model& model, const Selection& selection) const;

 signals:
  void changed();

 private:
  static bool Layers::*member(Layer layer);
  ObjectLook lookOf(const std::string& id) const;

  Layers m_layers;
  std::map<std::string, ObjectLook> m_looks;
  std::set<std::string> m_soloed;
};

}  // namespace glenoid
