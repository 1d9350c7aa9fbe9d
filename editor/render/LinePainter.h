// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "editor/render/GlResources.h"
#include "editor/render/SceneGeometry.h"

namespace glenoid {

/// End of a line or a dot whose position the CPU knows.
struct ColoredPoint {
  Eigen::Vector3f position;
  Eigen::Vector4f color;  ///< linear, alpha
};

/// How a set of lines or dots is drawn.
struct Stroke {
  float sizePx = 1;    ///< width of a line, diameter of a dot; device pixels
  float lift = 0;      ///< towards the viewer, share of the distance: lines on a surface stay visible
  float strength = 1;  ///< times the colour's alpha
};

/// Lines of any width with soft edges, and round dots. Writes no depth; depth test and blending are the
/// caller's.
class LinePainter {
 public:
  Result<Done> build();

  /// What all following draws share; viewport in pixels of the bound target. `depthScale` = 2 f n / (f − n)
  /// of the projection: bringing a point nearer by the share ε of its distance lowers its clip z by ε ·
  /// depthScale.
  void begin(const Eigen::Matrix4f& toClip, int widthPx, int heightPx, double depthScale);

  /// The same for positions in pixels of the target from its lower left corner.
  void beginPixels(int widthPx, int heightPx);

  /// From a vertex array with positions: by index, or each two neighbours from `vertices` on.
  void linesByIndex(unsigned array, Range indices, const Eigen::Vector4f& color, const Stroke& stroke);
  void lines(unsigned array, Range vertices, const Eigen::Vector4f& color, const Stroke& stroke);
  void dots(unsigned array, Range vertices, const Eigen::Vector4f& color, const Stroke& stroke);

  /// From the CPU.
  void lines(const std::vector<ColoredPoint>& points, const Stroke& stroke);
  void dots(const std::vector<ColoredPoint>& points, const Stroke& stroke);

 private:
  void useLines(const Stroke& stroke);
  void useDots(const Stroke& stroke);
  void send(const std::vector<ColoredPoint>& points);

  Program m_lineProgram, m_dotProgram;
  GlBuffer m_buffer;
  GlVertexArray m_array;
  Eigen::Matrix4f m_toClip = Eigen::Matrix4f::Identity();
  float m_width = 1, m_height = 1, m_depthScale = 0;
};

}  // namespace glenoid
