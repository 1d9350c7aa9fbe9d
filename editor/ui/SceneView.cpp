// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/SceneView.h"

#include <QLabel>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QWheelEvent>
#include <cmath>

#include "editor/ui/Theme.h"

namespace glenoid {

SceneView::SceneView(PlayLink& link, DisplayState& display, Selection& selection, bool softwareGraphics,
                     QWidget* parent)
    : QOpenGLWidget(parent), m_link(link), m_display(display), m_selection(selection), m_software(softwareGraphics) {
  setObjectName(QStringLiteral("sceneView"));
  setMinimumSize(320, 240);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  m_reading = new QLabel(this);
  m_reading->setObjectName(QStringLiteral("fieldReading"));
  m_reading->setProperty("role", QStringLiteral("reading"));
  m_reading->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_reading->hide();
  // Not while a frame is being drawn.
  connect(this, &SceneView::drawn, this, &SceneView::refreshReading, Qt::QueuedConnection);
  m_clock.start();
  // A wheel has no release: the hand lets go when it has been still for a moment.
  m_wheelRest.setSingleShot(true);
  m_wheelRest.setInterval(600);
  connect(&m_wheelRest, &QTimer::timeout, this, [this] {
    if (m_gesture != Gesture::Tool) m_link.releaseTool(m_wheelHolds);
  });
  m_draw.setSingleShot(true);
  connect(&m_draw, &QTimer::timeout, this, [this] { update(); });
  m_fine.setSingleShot(true);
  m_fine.setInterval(250);
  connect(&m_fine, &QTimer::timeout, this, [this] {
    m_coarse = false;
    update();
  });
  const auto redraw = [this] { requestDraw(); };
  connect(&link, &PlayLink::snapshotChanged, this, redraw);
  connect(&display, &DisplayState::changed, this, redraw);
  connect(&selection, &Selection::changed, this, redraw);
  connect(&selection, &Selection::hoverChanged, this, redraw);
}

SceneView::~SceneView() { releaseRenderer(); }

void SceneView::requestDraw() {
  if (!m_software) return update();
  constexpr double kSlowMs = 25;
  m_coarse = m_paintMs > kSlowMs || (m_coarse && m_paintMs > 0.4 * kSlowMs);
  if (m_coarse) m_fine.start();
  // What follows the author's hand comes first; else the window has as much time as drawing takes.
  const double rest = m_gesture == Gesture::Author ? 0.25 * m_paintMs : m_paintMs;
  if (!m_draw.isActive()) m_draw.start(static_cast<int>(std::min(rest, 200.0)));
}

void SceneView::releaseRenderer() {
  if (!m_renderer) return;
  makeCurrent();
  m_renderer.reset();
  m_small.reset();
  m_inset.reset();
  m_model.reset();
  doneCurrent();
}

void SceneView::initializeGL() {
  // Moving the widget to another window gives it a new context, and calls this again.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { releaseRenderer(); });
  auto renderer = SceneRenderer::create();
  if (renderer.ok()) {
    m_renderer = std::move(renderer).value();
    m_model.reset();
  } else {
    emit graphicsFailed(renderer.error());
  }
}

Look SceneView::look() const {
  Look look;
  look.dark = currentTheme().dark;
  look.pixelRatio = devicePixelRatioF();
  if (m_software) look.samples = 1;
  return look;
}

Layers SceneView::layers() const {
  if (!m_model) return {};
  Layers layers = m_display.layersFor(*m_model, m_selection);
  const Snapshot& snapshot = m_link.snapshot();
  if (!m_authoring || !m_authoring->stateFor(snapshot.model)) layers.dents = snapshot.report.dents;
  // Colours are the run's; what an author places is not of it.
  if (m_field && (!m_authoring || !m_authoring->stateFor(snapshot.model))) layers.field = m_field->look(layers);
  if (m_authoring) m_authoring->decorate(*m_model, viewport(), layers);
  return layers;
}

const VecX& SceneView::shownState() {
  const Snapshot& snapshot = m_link.snapshot();
  const VecX* authored = m_authoring ? m_authoring->stateFor(snapshot.model) : nullptr;
  return authored ? *authored : snapshot.q;
}

void SceneView::setAuthoring(Authoring* authoring) {
  if (m_authoring) m_authoring->disconnect(this);
  m_authoring = authoring;
  if (!authoring) return;
  connect(authoring, &Authoring::looksChanged, this, [this] { requestDraw(); });
  connect(authoring, &Authoring::toolChanged, this, [this] { isAuthoring() ? setCursor(Qt::CrossCursor) : unsetCursor(); });
}

void SceneView::setField(FieldView* field) {
  if (m_field) m_field->disconnect(this);
  m_field = field;
  readAt(std::nullopt);
  if (field) connect(field, &FieldView::changed, this, [this] { requestDraw(); });
}

void SceneView::readAt(const std::optional<PickHit>& hit) {
  m_readPlace = m_field && hit ? m_field->placeOf(*hit) : std::nullopt;
  refreshReading();
}

void SceneView::refreshReading() {
  const QString words = m_readPlace && m_field ? m_field->readingAt(*m_readPlace) : QString();
  if (words.isEmpty()) return m_reading->hide();
  if (m_reading->text() != words) m_reading->setText(words);
  m_reading->adjustSize();
  // Beside the pointer; on its other side where the view ends.
  const QPoint at = m_last.toPoint();
  QPoint corner = at + QPoint(16, 18);
  if (corner.x() + m_reading->width() > width()) corner.setX(std::max(0, at.x() - 10 - m_reading->width()));
  if (corner.y() + m_reading->height() > height()) corner.setY(std::max(0, at.y() - 10 - m_reading->height()));
  m_reading->move(corner);
  m_reading->show();
  m_reading->raise();
}

Target SceneView::target() const {
  const double ratio = devicePixelRatioF();
  return {defaultFramebufferObject(), static_cast<int>(std::lround(width() * ratio)),
          static_cast<int>(std::lround(height() * ratio))};
}

// The model that belongs to the snapshot goes to the GPU once; a context must be current.
void SceneView::takeModel() {
  const Snapshot& snapshot = m_link.snapshot();
  if (!m_renderer || snapshot.model == m_model || !snapshot.model) return;
  const auto taken = m_renderer->setScene(*snapshot.model);
  if (!taken.ok()) {
    emit graphicsFailed(taken.error());
    return;
  }
  m_model = snapshot.model;
  const std::string id = m_model->joint.id + '/' + m_model->scenario.id;
  if (id == m_sceneId) return;
  m_sceneId = id;
  home();
  if (m_chosenTool >= static_cast<int>(m_model->scenario.tools.size())) setChosenTool(-1);
}

void SceneView::paintGL() {
  if (!m_renderer) return;
  takeModel();
  QElapsedTimer clock;
  clock.start();
  if (m_coarse) {
    drawCoarse();
  } else {
    drawInto(target(), scopeIsLarge(), look());
  }
  drawInset(look());
  if (m_software) {
    context()->functions()->glFinish();  // the CPU does the work anyway; now its time is known
    const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    m_paintMs = m_frames < 3 ? 0 : 0.7 * m_paintMs + 0.3 * ms;  // the first frames compile shaders
  }
  if (m_renderer->settling()) QTimer::singleShot(100, this, [this] { requestDraw(); });
  m_frameTimes[m_frames++ % m_frameTimes.size()] = m_clock.elapsed();
  emit drawn();
}

void SceneView::drawCoarse() {
  const Target full = target();
  const QSize size(std::max(full.width / 2, 1), std::max(full.height / 2, 1));
  if (!m_small || m_small->size() != size) {
    m_small = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
  }
  Look coarse = look();
  coarse.pixelRatio /= 2;  // lines keep their width on the screen
  drawInto({m_small->handle(), size.width(), size.height()}, scopeIsLarge(), coarse);
  QOpenGLFunctions* gl = context()->functions();
  QOpenGLFramebufferObject::blitFramebuffer(nullptr, QRect(0, 0, full.width, full.height), m_small.get(),
                                            QRect(QPoint(0, 0), size), GL_COLOR_BUFFER_BIT, GL_LINEAR);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, full.framebuffer);
}

double SceneView::framesPerSecond() const {
  const qint64 now = m_clock.elapsed();
  int count = 0;
  for (std::size_t i = 0; i < std::min(m_frames, m_frameTimes.size()); ++i) {
    if (now - m_frameTimes[i] <= 1000) ++count;
  }
  return count;
}

QImage SceneView::picture(int width, int height) {
  if (!m_renderer || !m_model) return {};
  makeCurrent();
  Look fine = look();
  fine.samples = -1;
  const Snapshot& snapshot = m_link.snapshot();
  View view = m_view;
  Layers shown = layers();
  if (scopeIsLarge()) {
    const int object = *scopeObject();
    const ScopeSight sight = scopeSight(*m_model, shownState(), object, width, height);
    view = sight.view;
    fine.scope = sight.look;
    shown = throughScope(std::move(shown), object);
  }
  auto image = m_renderer->picture(view, shownState(), shown, snapshot.report.contactViews, fine, width, height);
  doneCurrent();
  if (!image.ok()) return {};
  return QImage(image->rgba.data(), image->width, image->height, 4 * image->width, QImage::Format_RGBA8888).copy();
}

std::optional<QPointF> SceneView::toScreen(const Vec3& p_W) const {
  const auto pixel = scopeIsLarge() && scopeObject()
                         ? seenThrough(scopeSight(*m_model, m_link.snapshot().q, *scopeObject(), width(), height()), p_W, width(), height())
                         : projected(m_view, p_W, width(), height());
  if (!pixel) return std::nullopt;
  return QPointF(pixel->x(), pixel->y());
}

// ---- Camera

void SceneView::setView(const View& view) {
  m_view = view;
  requestDraw();
}

Box3 SceneView::boundsOf(const std::set<std::string>& ids) {
  Box3 box;
  const Snapshot& snapshot = m_link.snapshot();
  if (!snapshot.model) return box;
  std::vector<Vec3> points;
  for (const SceneObject& object : snapshot.model->objects) {
    const ObjectLook shown{m_display.isVisible(object.id)};
    if (ids.empty() ? !shown.visible || object.tool : ids.count(object.id) == 0) continue;
    points.resize(object.visual.vertices.size());
    surfacePositions(object.visual, object.layout, shownState(), points);
    for (const Vec3& p : points) box.extend(p);
  }
  return box;
}

void SceneView::lookFrom(Side side) {
  const auto& model = m_link.snapshot().model;
  setView(viewFrom(side, boundsOf({}), aspect(), m_view.fieldOfView, model ? model->joint.side : JointSide::Unsaid));
}

void SceneView::frameAll() { setView(framed(m_view, boundsOf({}), aspect())); }

void SceneView::frameSelection() { setView(framed(m_view, boundsOf(m_selection.ids()), aspect())); }

void SceneView::home() {
  const Snapshot& snapshot = m_link.snapshot();
  if (!snapshot.model) return;
  const auto& cameras = snapshot.model->scenario.cameras;
  if (!cameras.empty()) return setView(viewOf(cameras.front()));
  // From the front and a little from the side and above, where a shoulder shows most of itself.
  View view = viewFrom(Side::Anterior, boundsOf({}), aspect());
  setView(framed(orbited(view, -0.5, 0.25), boundsOf({}), aspect()));
}

// ---- Mouse

namespace {

Pointer pointerOf(const QMouseEvent& event) {
  const QPointF at = event.position();
  return {Vec2(at.x() + 0.5, at.y() + 0.5), (event.modifiers() & Qt::ShiftModifier) != 0,
          (event.modifiers() & Qt::ControlModifier) != 0, (event.modifiers() & Qt::AltModifier) != 0};
}

}  // namespace

std::optional<PickHit> SceneView::pickAt(const QPointF& logical) {
  if (scopeIsLarge()) return std::nullopt;
  if (!m_renderer || !m_model || m_link.snapshot().model != m_model) return std::nullopt;
  makeCurrent();
  const QPointF at = device(logical);
  const auto hit = m_renderer->pick(m_view, shownState(), layers(), target(), at.x(), at.y());
  doneCurrent();
  return hit;
}

std::string SceneView::idOf(int object) const {
  return m_model && object >= 0 && object < static_cast<int>(m_model->objects.size()) ? m_model->objects[object].id
                                                                                     : std::string();
}

void SceneView::setChosenTool(int tool) {
  if (tool == m_chosenTool) return;
  m_chosenTool = tool;
  emit chosenToolChanged(tool);
}

void SceneView::beginToolDrag(int tool, const QPointF& at) {
  const Snapshot& snapshot = m_link.snapshot();
  if (tool < 0 || tool >= static_cast<int>(snapshot.hands.size())) return;
  const Pose hand = snapshot.hands[tool];
  m_draggedTool = tool;
  m_toolDrag.emplace(shownView(), hand, hand.p_WB, at.x(), at.y(), height());
  m_gesture = Gesture::Tool;
  m_link.holdTool(tool, hand);
  setCursor(Qt::ClosedHandCursor);
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  if (m_gesture != Gesture::None) return;  // a second button changes nothing
  const QPointF at = event->position();
  m_pressed = m_last = at;
  const bool alt = event->modifiers() & Qt::AltModifier, shift = event->modifiers() & Qt::ShiftModifier;
  if (isAuthoring() && event->button() == Qt::LeftButton) {
    m_gesture = Gesture::Author;
    m_authoring->press(viewport(), pointerOf(*event));
    return;
  }
  const bool middle = event->button() == Qt::MiddleButton || (isAuthoring() && event->button() == Qt::RightButton);
  if (middle || (event->button() == Qt::LeftButton && alt)) {
    m_gesture = shift ? Gesture::Pan : Gesture::Orbit;
    setCursor(shift ? Qt::SizeAllCursor : Qt::CrossCursor);
  } else if (event->button() == Qt::LeftButton) {
    m_gesture = Gesture::Pick;
    // On a tool the drag is that tool's; anywhere else it is the chosen one's.
    const auto hit = pickAt(at);
    if (hit && m_model->objects[hit->object].tool) setChosenTool(m_model->objects[hit->object].toolIndex);
    if (m_chosenTool >= 0 && event->modifiers() == Qt::NoModifier) beginToolDrag(m_chosenTool, at);
  }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position(), by = at - m_last;
  m_last = at;
  switch (m_gesture) {
    case Gesture::Orbit:
      setView(orbited(m_view, 0.008 * by.x(), 0.008 * by.y()));
      break;
    case Gesture::Pan:
      setView(panned(m_view, by.x(), by.y(), height()));
      break;
    case Gesture::Tool:
      m_link.holdTool(m_draggedTool, m_toolDrag->moved(at.x(), at.y()));
      break;
    case Gesture::Author: m_authoring->move(viewport(), pointerOf(*event)); break;
    case Gesture::Pick: break;
    case Gesture::None:
      if (isAuthoring()) {
        m_authoring->move(viewport(), pointerOf(*event));
        break;
      }
      // Picking draws once more, so not for every pixel the mouse passes.
      if (!m_hoverClock.isValid() || m_hoverClock.elapsed() > (m_software ? 120 : 30)) {
        m_hoverClock.restart();
        const auto hit = pickAt(at);
        m_selection.hover(hit ? idOf(hit->object) : std::string());
        readAt(hit);
      }
      break;
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (m_gesture == Gesture::Author) {
    if (event->button() != Qt::LeftButton) return;
    m_authoring->release(viewport(), pointerOf(*event));
    m_gesture = Gesture::None;
    return;
  }
  const QPointF moved = event->position() - m_pressed;
  const bool click = std::hypot(moved.x(), moved.y()) < 4;
  if (click && event->button() == Qt::LeftButton && (m_gesture == Gesture::Pick || m_gesture == Gesture::Tool)) {
    endGesture();
    select(event->position(), event->modifiers());
    return;
  }
  endGesture();
}

void SceneView::endGesture() {
  if (m_gesture == Gesture::Tool) m_link.releaseTool(m_draggedTool);
  if (m_gesture == Gesture::Author && m_authoring) m_authoring->cancel();
  m_gesture = Gesture::None;
  m_toolDrag.reset();
  m_draggedTool = -1;
  isAuthoring() ? setCursor(Qt::CrossCursor) : unsetCursor();
}

void SceneView::select(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const auto hit = pickAt(at);
  const std::string id = hit ? idOf(hit->object) : std::string();
  if (modifiers & Qt::ShiftModifier) {
    if (!id.empty()) m_selection.add(id);
  } else if (modifiers & Qt::ControlModifier) {
    if (!id.empty()) m_selection.remove(id);
  } else if (id.empty()) {
    m_selection.clear();
  } else {
    m_selection.select(id);
  }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !isAuthoring() && !m_selection.current().empty() && m_chosenTool < 0) {
    frameSelection();
  } else {
    mousePressEvent(event);
  }
}

void SceneView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches == 0) return;
  const bool depth = event->modifiers() & Qt::ControlModifier;
  if (m_gesture == Gesture::Tool) {  // while dragging the wheel is the third axis
    m_toolDrag->push(kDepthPerNotch * notches);
    m_link.holdTool(m_draggedTool, m_toolDrag->moved(m_last.x(), m_last.y()));
  } else if (depth && m_chosenTool >= 0 && m_chosenTool < static_cast<int>(m_link.snapshot().hands.size())) {
    Pose hand = m_link.handOf(m_chosenTool);
    hand.p_WB -= axesOf(shownView()).back_W * (kDepthPerNotch * notches);
    m_link.holdTool(m_chosenTool, hand);
    m_wheelHolds = m_chosenTool;
    m_wheelRest.start();
  } else {
    const QPointF at = event->position();
    setView(zoomedAt(m_view, std::pow(0.85, notches), at.x(), at.y(), width(), height()));
  }
  event->accept();
}

void SceneView::leaveEvent(QEvent*) {
  m_selection.hover({});
  readAt(std::nullopt);
  if (isAuthoring()) m_authoring->leave();
}

bool SceneView::event(QEvent* event) {
  // Escape belongs to the author's tool before it clears the selection of parts.
  if (event->type() == QEvent::ShortcutOverride && isAuthoring() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QOpenGLWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !isAuthoring()) return QOpenGLWidget::keyPressEvent(event);
  if (m_authoring->busy()) {
    m_authoring->cancel();
  } else {
    m_authoring->setTool(Authoring::Tool::None);
  }
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  // A dialog that comes up in the middle of a drag must not leave a tool held for ever.
  if (m_gesture != Gesture::None) endGesture();
  QOpenGLWidget::focusOutEvent(event);
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) update();
  if (event->type() == QEvent::LanguageChange) setAccessibleName(tr("3D view of the joint"));
  QOpenGLWidget::changeEvent(event);
}

}  // namespace glenoid
