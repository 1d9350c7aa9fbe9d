// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QImage>
#include <QWidget>
#include <memory>
#include <vector>

#include "editor/render/View.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A picture of one mesh with some triangles marked, turned by dragging and zoomed by the wheel. Drawn on the CPU, so
/// that it works without OpenGL.
class ImportPicture : public QWidget {
  Q_OBJECT
 public:
  explicit ImportPicture(QWidget* parent = nullptr);

  /// Keeps the direction of view; frames the mesh when it is another one. Null shows nothing.
  void show(std::shared_ptr<const TriMesh> mesh);
  void mark(std::vector<int> triangles);  ///< ascending
  QSize sizeHint() const override { return {420, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void redraw();
  void turn(double yaw, double pitch);

  std::shared_ptr<const TriMesh> m_mesh;
  std::vector<int> m_marked;
  View m_view;
  QImage m_image;
  QPointF m_last;
};

}  // namespace glenoid
