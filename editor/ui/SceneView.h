// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "editor/core/DisplayState.h"
#include "editor/core/FieldView.h"
#include "editor/core/PlayLink.h"
#include "editor/core/ToolDrag.h"
#include "editor/core/tools/Authoring.h"
#include "editor/render/SceneRenderer.h"
#include "editor/render/ScopeView.h"

class QLabel;
class QOpenGLFramebufferObject;

namespace glenoid {

/// The 3D view: hosts the renderer, steers the camera, picks parts and drags tools. Draws only when something
/// has changed. Left picks or drags a tool, middle orbits, Shift+middle pans, the wheel zooms at the cursor,
/// Alt+left orbits and Alt+Shift+left pans on a touchpad; Ctrl+wheel moves the chosen tool in depth. While one of the
/// author's tools is active the left button is that tool's, and the right one orbits and pans as the middle one does.
/// Only where probeGraphics() says usable. GUI thread only.
class SceneView : public QOpenGLWidget {
  Q_OBJECT
 public:
  SceneView(PlayLink& link, DisplayState& display, Selection& selection, bool softwareGraphics,
            QWidget* parent = nullptr);
  ~SceneView() override;

  const View& view() const { return m_view; }
  void setView(const View& view);
  void lookFrom(Side side);
  void frameAll();        ///< everything shown, same direction
  void frameSelection();  ///< the selected objects, else everything
  void home();            ///< the scenario's first camera, else from the front

  /// The tool that a drag moves wherever it begins, index in the scenario; −1: only a drag that begins on a tool.
  void setChosenTool(int tool);
  int chosenTool() const { return m_chosenTool; }
  bool isDraggingTool() const { return m_toolDrag.has_value(); }

  /// Where the arthroscope's picture stands. Large: the outside is in the corner, a tool is dragged in the scope's picture, and
  /// nothing is picked in it. Off while an author's tool is active, and where the scene has no arthroscope. The chosen tool's,
  /// where that is an arthroscope, else the first one's.
  enum class ScopePlace { Off, Small, Large };
  void setScope(ScopePlace place);
  ScopePlace scope() const { return m_scope; }

  /// Whose the left button is while a tool of it is active; it must outlive the view or be taken back with null.
  void setAuthoring(Authoring* authoring);

  /// What colours the parts, and what is read where the mouse points, in a small label beside it. It must outlive the view or
  /// be taken back with null.
  void setField(FieldView* field);

  /// Frames drawn in the last second.
  double framesPerSecond() const;
  /// The picture as it is shown, drawn at another size; null when the renderer failed.
  QImage picture(int width, int height);
  /// Where a point of the world is seen, logical pixels; nothing when behind the eye.
  std::optional<QPointF> toScreen(const Vec3& p_W) const;

 signals:
  void graphicsFailed(const glenoid::Error& error);
  void chosenToolChanged(int tool);
  void scopeChanged();
  void drawn();  ///< a frame was drawn

 protected:
  void initializeGL() override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  enum class Gesture { None, Orbit, Pan, Tool, Pick, Author };
  void requestDraw();
  void drawCoarse();
  std::optional<int> scopeObject() const;
  bool scopeIsLarge() const;
  View shownView();  ///< of the large picture
  void drawInto(const Target& target, bool through, const Look& look);
  void drawInset(const Look& look);
  void takeModel();
  void releaseRenderer();
  Look look() const;
  Layers layers() const;
  Target target() const;
  const VecX& shownState();
  Viewport viewport() const { return {m_view, width(), height()}; }
  bool isAuthoring() const { return m_authoring && m_authoring->active(); }
  QPointF device(const QPointF& logical) const { return logical * devicePixelRatioF(); }
  std::optional<PickHit> pickAt(const QPointF& logical);
  std::string idOf(int object) const;
  void readAt(const std::optional<PickHit>& hit);
  void refreshReading();
  Box3 boundsOf(const std::set<std::string>& ids);
  void beginToolDrag(int tool, const QPointF& at);
  void endGesture();
  void select(const QPointF& at, Qt::KeyboardModifiers modifiers);
  double aspect() const { return height() > 0 ? static_cast<double>(width()) / height() : 1.0; }

  PlayLink& m_link;
  DisplayState& m_display;
  Selection& m_selection;
  Authoring* m_authoring = nullptr;
  FieldView* m_field = nullptr;
  QLabel* m_reading;                           ///< hidden while there is nothing to read
  std::optional<FieldView::Place> m_readPlace; ///< where the mouse points, on the part: it goes with it
  bool m_software;
  std::unique_ptr<SceneRenderer> m_renderer;
  std::shared_ptr<const Model> m_model;  ///< what the renderer holds
  std::string m_sceneId;                 ///< a scene seen for the first time is framed
  View m_view;

  Gesture m_gesture = Gesture::None;
  QPointF m_pressed, m_last;
  int m_chosenTool = -1, m_draggedTool = -1;
  std::optional<ToolDrag> m_toolDrag;
  // A software renderer that is slow draws at half the size while things move, and leaves the window as much
  // time as it takes itself; once all is still it draws one fine picture.
  QTimer m_draw, m_fine;
  double m_paintMs = 0;  ///< of the last frames, smoothed
  bool m_coarse = false;
  std::unique_ptr<QOpenGLFramebufferObject> m_small, m_inset;
  ScopePlace m_scope = ScopePlace::Off;

  QTimer m_wheelRest;
  int m_wheelHolds = -1;
  QElapsedTimer m_hoverClock, m_clock;
  std::array<qint64, 64> m_frameTimes{};
  std::size_t m_frames = 0;
};

}  // namespace glenoid
