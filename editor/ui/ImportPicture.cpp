// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/ImportPicture.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "editor/core/tools/MeshPicture.h"

namespace glenoid {

ImportPicture::ImportPicture(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 180);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::OpenHandCursor);
}

void ImportPicture::show(std::shared_ptr<const TriMesh> mesh) {
  if (mesh == m_mesh) return;
  m_mesh = std::move(mesh);
  m_marked.clear();
  if (m_mesh) {
    // Files come in any unit, so the picture keeps no metres: the ball around the box fills the height.
    const Box3 box = boundsOf(*m_mesh);
    m_view = View();
    m_view.target_W = box.center();
    m_view.eye_W = box.center() + 0.53 * box.diagonal().norm() / std::sin(m_view.fieldOfView / 2) * Vec3(0.7, 0.4, 0.9).normalized();
  }
  redraw();
}

void ImportPicture::mark(std::vector<int> triangles) {
  m_marked = std::move(triangles);
  redraw();
}

void ImportPicture::redraw() {
  const qreal ratio = devicePixelRatioF();
  m_image = {};
  if (m_mesh && width() > 0 && height() > 0) {
    MeshLook look;
    look.color = {0.72f, 0.74f, 0.78f};
    look.edges = m_mesh->triangles.size() < 20000;
    look.marked = m_marked;
    const Image image = meshPicture(*m_mesh, {m_view, static_cast<int>(width() * ratio), static_cast<int>(height() * ratio)}, look);
    m_image = QImage(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888).copy();
    m_image.setDevicePixelRatio(ratio);
  }
  update();
}

void ImportPicture::turn(double yaw, double pitch) {
  if (!m_mesh) return;
  m_view = orbited(m_view, yaw, pitch);
  redraw();
}

void ImportPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!m_image.isNull()) painter.drawImage(QPointF(0, 0), m_image);
  if (hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void ImportPicture::resizeEvent(QResizeEvent*) { redraw(); }

void ImportPicture::mousePressEvent(QMouseEvent* event) { m_last = event->position(); }

void ImportPicture::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPointF by = event->position() - m_last;
  m_last = event->position();
  turn(0.01 * by.x(), 0.01 * by.y());
}

void ImportPicture::wheelEvent(QWheelEvent* event) {
  if (!m_mesh) return;
  const double factor = std::pow(0.999, event->angleDelta().y());
  m_view.eye_W = m_view.target_W + factor * (m_view.eye_W - m_view.target_W);
  redraw();
}

void ImportPicture::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left: return turn(-0.15, 0);
    case Qt::Key_Right: return turn(0.15, 0);
    case Qt::Key_Up: return turn(0, -0.15);
    case Qt::Key_Down: return turn(0, 0.15);
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace glenoid
