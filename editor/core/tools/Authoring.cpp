// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/Authoring.h"

#include <QPointer>
#include <QUndoCommand>

#include "editor/core/AuthorEdits.h"
#include "simcore/coupling/RegionAnchors.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/mesh/TrianglePatch.h"

namespace glenoid {
namespace {

constexpr std::array<float, 3> kSelected{1.0f, 0.55f, 0.10f}, kPreview{0.30f, 0.75f, 0.95f}, kNode{0.80f, 0.86f, 0.94f};

}  // namespace

class Authoring::PickCommand : public QUndoCommand {
 public:
  PickCommand(Authoring& authoring, const QString& text, Picked before, Picked after)
      : QUndoCommand(text), m_authoring(&authoring), m_before(std::move(before)), m_after(std::move(after)) {}
  void undo() override { give(m_before); }
  void redo() override { give(m_after); }

 private:
  void give(const Picked& picked) {
    if (m_authoring) m_authoring->set(picked);
  }
  QPointer<Authoring> m_authoring;  // the document's steps may outlive the window
  Picked m_before, m_after;
};

Authoring::Authoring(Document& document, const DisplayState& display, QObject* parent)
    : QObject(parent), m_document(document), m_display(display) {
  connect(&document, &Document::changed, this, &Authoring::onDocumentChanged);
}

void Authoring::setTool(Tool tool) {
  if (tool == m_tool) return;
  cancel();
  m_tool = tool;
  m_cursor.reset();
  m_stateOf.reset();
  refreshCage();
  emit toolChanged();
  emit modeChanged();
  emit looksChanged();
}

void Authoring::setMode(PickMode mode) {
  if (mode == this->mode()) return;
  cancel();
  if (m_tool == Tool::Cage) {
    m_cageMode = mode;
    m_cage.setMode(mode);
  } else {
    m_select.setMode(mode);
  }
  emit modeChanged();
  emit looksChanged();
}

void Authoring::setRadius(double pixels) {
  m_select.setRadius(pixels);
  m_cage.setRadius(m_select.radius());
  emit modeChanged();
  emit looksChanged();
}

std::shared_ptr<const TriMesh> Authoring::mesh() const {
  const int index = findPart(m_document.joint(), m_picked.part);
  if (index < 0) return nullptr;
  const Part& part = m_document.joint().parts[index];
  return m_picked.surface == SurfaceKind::Visual ? part.visual : part.collision;
}

std::shared_ptr<const TetMesh> Authoring::cells() const {
  const int index = findPart(m_document.joint(), m_picked.part);
  if (index < 0) return nullptr;
  const Part& part = m_document.joint().parts[index];
  return part.kind == PartKind::Soft && part.volume && !part.volume->tets.empty() ? part.volume : nullptr;
}

void Authoring::setTarget(const std::string& part, SurfaceKind surface) {
  if (part == m_picked.part && surface == m_picked.surface) return;
  cancel();
  // Nodes do not lie on either surface.
  set({part, surface, m_picked.picking, {}, part == m_picked.part ? m_picked.nodes : std::vector<int>()});
}

void Authoring::setPicking(Picking picking) {
  if (picking == m_picked.picking) return;
  cancel();
  Picked other = m_picked;
  other.picking = picking;
  set(other);
}

void Authoring::set(const Picked& picked) {
  const bool another = picked.part != m_picked.part || picked.surface != m_picked.surface, otherwise = picked.picking != m_picked.picking;
  m_picked = picked;
  m_mesh = mesh();
  m_cells = cells();
  // A step taken back may speak of a surface or of cells that the document has no longer.
  const int count = m_mesh ? static_cast<int>(m_mesh->triangles.size()) : 0, nodes = m_cells ? static_cast<int>(m_cells->nodes.size()) : 0;
  if (!m_picked.triangles.empty() && m_picked.triangles.back() >= count) m_picked.triangles.clear();
  if (!m_picked.nodes.empty() && m_picked.nodes.back() >= nodes) m_picked.nodes.clear();
  m_preview.clear();
  refreshNodes();
  if (another) {
    refreshCage();
    emit targetChanged();
  }
  if (otherwise) emit modeChanged();
  emit selectionChanged();
  emit looksChanged();
}

void Authoring::push(Picked after, const QString& text) {
  m_document.undoStack().push(new PickCommand(*this, text, m_picked, std::move(after)));
}

void Authoring::select(const std::vector<int>& triangles, const QString& text) {
  if (triangles == m_picked.triangles) return;
  Picked after = m_picked;
  after.triangles = triangles;
  push(std::move(after), text);
}

void Authoring::selectNodes(const std::vector<int>& nodes, const QString& text) {
  if (nodes == m_picked.nodes) return setPicking(Picking::Nodes);
  Picked after = m_picked;
  after.picking = Picking::Nodes;
  after.nodes = nodes;
  push(std::move(after), text);
}

template <class OfTriangles, class OfNodes>
void Authoring::change(OfTriangles&& ofTriangles, OfNodes&& ofNodes, const QString& text) {
  if (picksNodes() && m_cells) selectNodes(ofNodes(*m_cells, selectedNodes()), text);
  else if (!picksNodes() && m_mesh) select(ofTriangles(*m_mesh, selected()), text);
}

void Authoring::grow() { change(grown, grownNodes, tr("Grow the selection")); }

void Authoring::shrink() { change(shrunk, shrunkNodes, tr("Shrink the selection")); }

void Authoring::selectConnected() { change(connected, connectedNodes, tr("Select what is connected")); }

void Authoring::invert() { change(inverted, invertedNodes, tr("Invert the selection")); }

void Authoring::clear() {
  if (picksNodes()) selectNodes({}, tr("Select no nodes"));
  else select({}, tr("Select no triangles"));
}

void Authoring::preview(std::vector<int> items) {
  if (items == m_preview) return;
  m_preview = std::move(items);
  emit looksChanged();
}

void Authoring::showAnchors(std::vector<Vec3> anchors_W) {
  m_anchors_W = std::move(anchors_W);
  emit looksChanged();
}

void Authoring::onDocumentChanged() {
  // Indices mean nothing on another surface, nor in other cells.
  if (mesh() != m_mesh || cells() != m_cells) {
    cancel();
    Picked left = m_picked;
    if (mesh() != m_mesh) left.triangles.clear();
    if (cells() != m_cells) left.nodes.clear();
    set(left);
  } else {
    refreshNodes();
  }
  m_stateOf.reset();
  refreshCage();
}

// ---- Cages

void Authoring::refreshCage() {
  const int index = findPart(m_document.joint(), m_picked.part);
  const Cage* cage = index < 0 ? nullptr : findCage(m_document.joint(), m_picked.part);
  m_cage.setCage(cage);
  m_cage.setMode(m_cageMode);
  if (!cage) {
    m_follower.reset();
    m_followerJob.drop();
  } else if (m_tool == Tool::Cage &&
             !(m_follower && m_follower->isFor(m_document.joint().parts[index], *cage))) {
    m_follower.reset();
    // Coordinates of a cage take seconds where it is concave, so not on the thread that draws.
    m_followerJob.ask([this, starts = m_starts, part = m_document.joint().parts[index],
                       cage = *cage](const std::atomic<bool>&) -> LatestJob::Answer {
      const auto made = starts->follower(part, cage);
      return [this, made] {
        if (made.ok()) m_follower = *made;
        m_stateOf.reset();
        emit looksChanged();
      };
    });
  }
  emit cageChanged();
}

void Authoring::pickHandles(std::set<int> handles) {
  m_cage.pick(std::move(handles));
  emit cageChanged();
  emit looksChanged();
}

void Authoring::setMeanShift(const Vec3& shift_W) {
  if (!m_cage.picked().empty())
    moveHandles(m_document, m_picked.part, m_cage.withMeanShift(shift_W), QStringLiteral("handles"));
}

Joint Authoring::liveJoint() const {
  Joint joint = m_document.joint();
  for (Cage& cage : joint.cages)
    if (cage.part == m_picked.part && cage.moved_W.size() == m_cage.moved_W().size())
      cage.moved_W = m_cage.moved_W();
  return joint;
}

void Authoring::showCuts(std::vector<Vec3> cuts_W) {
  if (cuts_W.empty() && m_cuts_W.empty()) return;
  m_cuts_W = std::move(cuts_W);
  emit looksChanged();
}

void Authoring::refreshNodes() {
  m_nodes_W.clear();
  m_nodesJob.drop();
  const int index = findPart(m_document.joint(), m_picked.part);
  if (index < 0 || m_picked.triangles.empty() || picksNodes()) return;
  const Part& part = m_document.joint().parts[index];
  if (part.kind != PartKind::Soft || !part.volume || part.volume->tets.empty()) return;
  Region region;
  region.surface = m_picked.surface;
  region.triangles = runsOf(m_picked.triangles);
  // Finding the cell of every vertex of a fine surface takes longer than a frame.
  m_nodesJob.ask([this, part, region](const std::atomic<bool>&) -> LatestJob::Answer {
    std::vector<Vec3> nodes;
    for (const RegionAnchor& anchor : regionAnchors({&part, Vec3::Zero()}, region))
      nodes.push_back(anchor.rest_W);
    return [this, nodes = std::move(nodes)] {
      m_nodes_W = nodes;
      emit looksChanged();
    };
  });
}

// ---- From the view

void Authoring::refreshTarget() {
  std::vector<std::shared_ptr<const TriMesh>> others;
  for (const Part& part : m_document.joint().parts) {
    const bool soloed = m_display.soloed().empty() || m_display.soloed().count(part.id) > 0;
    if (part.id != m_picked.part && soloed && m_display.isVisible(part.id) && m_display.opacity(part.id) >= 1)
      others.push_back(part.visual);
  }
  if (picksNodes()) m_select.setNodes(m_cells, std::move(others));
  else m_select.setTarget(m_mesh, std::move(others));
}

void Authoring::press(const Viewport& viewport, const Pointer& pointer) {
  m_cursor = pointer.at;
  if (m_tool == Tool::Select) {
    refreshTarget();
    m_select.press(viewport, pointer, picksNodes() ? m_picked.nodes : m_picked.triangles);
  } else if (m_tool == Tool::Cage) {
    m_document.endGesture();
    m_cage.press(viewport, pointer);
    emit cageChanged();
  }
  emit looksChanged();
}

void Authoring::move(const Viewport& viewport, const Pointer& pointer) {
  m_cursor = pointer.at;
  if (m_tool == Tool::Select) m_select.move(pointer);
  if (m_tool == Tool::Cage) {
    m_cage.move(viewport, pointer);
    if (m_cage.isDragging()) {
      m_stateOf.reset();
      emit cageChanged();
    }
  }
  if (busy() || mode() == PickMode::Brush || m_tool == Tool::Cage) emit looksChanged();
}

void Authoring::release(const Viewport& viewport, const Pointer& pointer) {
  if (m_cage.busy()) {
    const CageTool::Done done = m_cage.release(viewport, pointer);
    const std::vector<Vec3> moved = m_cage.moved_W();  // the change comes back and sets the tool anew
    if (done == CageTool::Done::Moved) moveHandles(m_document, m_picked.part, moved);
    if (done == CageTool::Done::Picked) emit cageChanged();
  }
  if (m_select.busy()) {
    const std::vector<int> items = m_select.release(pointer);
    const int count = static_cast<int>(items.size());
    if (picksNodes()) selectNodes(items, tr("Select %n node(s)", nullptr, count));
    else select(items, tr("Select %n triangle(s)", nullptr, count));
  }
  emit looksChanged();
}

void Authoring::leave() {
  m_cursor.reset();
  emit looksChanged();
}

void Authoring::cancel() {
  if (!busy()) return;
  m_select.cancel();
  m_cage.cancel();
  m_stateOf.reset();
  emit cageChanged();
  emit looksChanged();
}

// ---- Drawing

VecX restState(const Model& model) {
  VecX q = model.start.q;
  for (const SceneObject& object : model.objects) {
    if (object.layout.rigid || !object.volume) continue;
    for (int i = 0; i < object.layout.nodeCount; ++i)
      q.segment<3>(object.layout.qOffset + 3 * i) = object.volume->nodes[i];
  }
  return q;
}

const VecX* Authoring::stateFor(const std::shared_ptr<const Model>& model) {
  if (m_tool == Tool::None || !model) return nullptr;
  if (m_stateOf.lock() != model) {
    m_state = m_tool == Tool::Cage ? model->start.q : restState(*model);
    m_stateOf = model;
    const int index = findPart(m_document.joint(), m_picked.part);
    if (m_tool == Tool::Cage && index >= 0)
      for (const SceneObject& object : model->objects) {
        if (object.tool || object.id != m_picked.part || object.layout.rigid) continue;
        const Part& part = m_document.joint().parts[index];
        if (object.volume != part.volume || (m_cage.hasCage() && !m_follower)) continue;
        const std::vector<Vec3> nodes =
            m_cage.hasCage() ? m_follower->nodes(m_cage.moved_W()) : part.volume->nodes;
        for (int i = 0; i < object.layout.nodeCount; ++i)
          m_state.segment<3>(object.layout.qOffset + 3 * i) = nodes[i];
      }
  }
  return &m_state;
}

/// Nodes as dots: all of them, and larger those that are selected or would be.
void Authoring::drawDots(Layers& layers) const {
  if (!m_cells) return;
  const std::vector<int> selected = m_select.busy() ? m_select.now() : m_picked.nodes;
  const auto draw = [&](const std::vector<int>& nodes, const std::array<float, 3>& color, float size, float hidden) {
    Strokes dots;
    dots.dotPx = size;
    dots.hiddenStrength = hidden;
    for (const int node : nodes) dots.dots.push_back({m_cells->nodes[node].cast<float>(), {color[0], color[1], color[2], 1}});
    if (!dots.dots.empty()) layers.strokes.push_back(std::move(dots));
  };
  draw(without(without(usedNodes(*m_cells), selected), m_preview), kNode, 5, 0.25f);
  draw(without(m_preview, selected), kPreview, 8, 0.6f);
  draw(selected, kSelected, 8, 0.6f);
}

void Authoring::decorate(const Model& model, const Viewport& viewport, Layers& layers) const {
  if (m_tool == Tool::None) return;
  if (m_tool == Tool::Select && m_picked.surface == SurfaceKind::Collision) {
    layers.visual = false;
    layers.collision = true;
  }
  for (int i = 0; i < static_cast<int>(model.objects.size()); ++i) {
    const SceneObject& object = model.objects[i];
    if (object.tool || object.id != m_picked.part) continue;
    // Until the change before is compiled the view shows another surface.
    if ((m_picked.surface == SurfaceKind::Visual ? object.visual : object.collision).mesh != m_mesh) continue;
    const std::vector<int> triangles = m_select.busy() && !picksNodes() ? m_select.now() : m_picked.triangles;
    // The tint of a selected part would hide what is picked on it, and where it bends.
    if (i < static_cast<int>(layers.objects.size()))
      layers.objects[i].hovered = layers.objects[i].selected = false;
    if (m_tool != Tool::Select || picksNodes()) continue;
    if (!triangles.empty()) layers.marks.push_back({i, m_picked.surface, triangles, kSelected});
    if (!m_preview.empty()) layers.marks.push_back({i, m_picked.surface, m_preview, kPreview});
  }
  if (m_tool == Tool::Select && picksNodes()) drawDots(layers);
  Strokes dots;
  dots.dotPx = 6;
  dots.hiddenStrength = 0.45f;
  if (m_tool == Tool::Select && !m_select.busy())
    for (const Vec3& p : m_nodes_W) dots.dots.push_back({p.cast<float>(), {1.0f, 0.85f, 0.35f, 1}});
  if (m_tool == Tool::Cage)
    for (const Vec3& p : m_cuts_W) dots.dots.push_back({p.cast<float>(), {0.95f, 0.15f, 0.12f, 1}});
  if (m_tool == Tool::Select)
    for (const Vec3& p : m_anchors_W) dots.dots.push_back({p.cast<float>(), {0.25f, 0.85f, 0.80f, 1}});
  if (!dots.dots.empty()) layers.strokes.push_back(std::move(dots));

  if (m_tool == Tool::Cage)
    for (Strokes& strokes : m_cage.strokes(viewport)) layers.strokes.push_back(std::move(strokes));
  std::vector<Vec2> outline;
  const PickStroke* stroke = m_tool == Tool::Cage ? m_cage.stroke() : m_select.stroke();
  if (stroke)
    outline = stroke->outline();
  else if (m_cursor && mode() == PickMode::Brush)
    outline = circleOutline(*m_cursor, radius());
  if (outline.size() > 1) {
    Strokes screen;
    screen.onScreen = true;
    const auto end = [](const Vec2& p) {
      return Strokes::End{Eigen::Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()), 0),
                          {1.0f, 0.72f, 0.25f, 1}};
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
      screen.lines.push_back(end(outline[i]));
      screen.lines.push_back(end(outline[(i + 1) % outline.size()]));
    }
    layers.strokes.push_back(std::move(screen));
  }
}

}  // namespace glenoid
