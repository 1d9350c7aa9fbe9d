// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "editor/core/DisplayState.h"
#include "editor/core/Document.h"
#include "editor/core/LatestJob.h"
#include "editor/core/tools/CageTool.h"
#include "editor/core/tools/SelectTool.h"
#include "editor/core/tools/StartSurfaces.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// The author's tools in the view: which one has the mouse, what it works on, what it draws over the scene.
/// While one is active the view shows the joint as it is authored: at rest for picking, since regions and
/// couplings belong there, or as its cages make it start. Selected triangles and nodes lie outside of the document, as
/// parts that are selected do, but each stroke is a step that undo takes back. GUI thread only.
class Authoring : public QObject {
  Q_OBJECT
 public:
  enum class Tool { None, Select, Cage };
  /// What the Select tool picks: triangles of a surface, or nodes of a soft part's cells.
  enum class Picking { Triangles, Nodes };

  /// Both must outlive this.
  Authoring(Document& document, const DisplayState& display, QObject* parent = nullptr);

  Tool tool() const { return m_tool; }
  void setTool(Tool tool);
  /// How is picked with the active tool; each keeps its own way.
  PickMode mode() const { return m_tool == Tool::Cage ? m_cageMode : m_select.mode(); }
  void setMode(PickMode mode);
  double radius() const { return m_select.radius(); }
  void setRadius(double pixels);

  /// The part and surface from which triangles are picked; another one begins with nothing selected.
  void setTarget(const std::string& part, SurfaceKind surface);
  const std::string& part() const { return m_picked.part; }
  SurfaceKind surface() const { return m_picked.surface; }
  /// Null while the part is unknown.
  std::shared_ptr<const TriMesh> mesh() const;
  /// The tetrahedra of a soft part whose nodes can be picked; null where there are none.
  std::shared_ptr<const TetMesh> cells() const;
  Picking picking() const { return m_picked.picking; }
  /// Each keeps its own selection.
  void setPicking(Picking picking);
  const std::vector<int>& selected() const { return m_picked.triangles; }
  const std::vector<int>& selectedNodes() const { return m_picked.nodes; }
  /// Whether any of what is being picked is selected.
  bool anySelected() const { return !(picksNodes() ? m_picked.nodes : m_picked.triangles).empty(); }
  /// Points of a soft part at which springs over the selection would hold, m; they come from a worker a moment after it.
  const std::vector<Vec3>& nodes() const { return m_nodes_W; }
  /// One undo step called `text`; nothing when they are selected already. Triangles ascending.
  void select(const std::vector<int>& triangles, const QString& text);
  /// The same of nodes, ascending; nodes are what is picked from then on.
  void selectNodes(const std::vector<int>& nodes, const QString& text);
  void grow();
  void shrink();
  void selectConnected();
  void invert();
  void clear();
  /// Shown in another colour until the next call: what a button would select, of what is being picked.
  void preview(std::vector<int> items);
  /// Where a coupling holds, shown as dots; m, W.
  void showAnchors(std::vector<Vec3> anchors_W);

  // Cages: handles of the target's cage.
  const CageTool& cage() const { return m_cage; }
  void pickHandles(std::set<int> handles);
  /// The picked handles so that their mean shift from rest is this, m. Steps in a row are one until
  /// endGesture().
  void setMeanShift(const Vec3& shift_W);
  /// The document's joint with the drag that is under way.
  Joint liveJoint() const;
  StartSurfaces& starts() { return *m_starts; }
  std::shared_ptr<StartSurfaces> sharedStarts() const { return m_starts; }
  /// Places where surfaces cut each other, shown as red dots; m, W.
  void showCuts(std::vector<Vec3> cuts_W);

  // From the view.
  bool active() const { return m_tool != Tool::None; }
  bool busy() const { return m_select.busy() || m_cage.busy(); }
  void press(const Viewport& viewport, const Pointer& pointer);
  void move(const Viewport& viewport, const Pointer& pointer);
  void release(const Viewport& viewport, const Pointer& pointer);
  void leave();
  void cancel();
  /// State to draw a model in, null: that of the run.
  const VecX* stateFor(const std::shared_ptr<const Model>& model);
  void decorate(const Model& model, const Viewport& viewport, Layers& layers) const;

 signals:
  void toolChanged();
  void modeChanged();  ///< or the brush's radius
  void targetChanged();
  void selectionChanged();
  void cageChanged();   ///< handles picked or moved, also in the middle of a drag
  void looksChanged();  ///< what decorate or stateFor gives

 private:
  struct Picked {
    std::string part;
    SurfaceKind surface = SurfaceKind::Visual;
    Picking picking = Picking::Triangles;
    std::vector<int> triangles, nodes;
    bool operator==(const Picked&) const = default;
  };
  class PickCommand;
  void set(const Picked& picked);
  void push(Picked after, const QString& text);
  bool picksNodes() const { return m_picked.picking == Picking::Nodes; }
  /// Another set of what is being picked, by a function of its mesh and the set.
  template <class OfTriangles, class OfNodes>
  void change(OfTriangles&& ofTriangles, OfNodes&& ofNodes, const QString& text);
  void onDocumentChanged();
  void refreshTarget();
  void refreshNodes();
  void drawDots(Layers& layers) const;
  void refreshCage();

  Document& m_document;
  const DisplayState& m_display;
  Tool m_tool = Tool::None;
  SelectTool m_select;
  Picked m_picked;
  std::shared_ptr<const TriMesh> m_mesh;  ///< that the selection belongs to
  std::shared_ptr<const TetMesh> m_cells; ///< the same of nodes
  std::vector<int> m_preview;
  std::vector<Vec3> m_nodes_W, m_anchors_W, m_cuts_W;
  CageTool m_cage;
  PickMode m_cageMode = PickMode::Click;
  std::shared_ptr<StartSurfaces> m_starts = std::make_shared<StartSurfaces>();
  std::shared_ptr<const CageFollower> m_follower;  ///< of the target's cage; null while it is made
  LatestJob m_followerJob, m_nodesJob;
  std::optional<Vec2> m_cursor;
  std::weak_ptr<const Model> m_stateOf;
  VecX m_state;
};

/// A model's state with every part at rest: rigid ones as they start, soft ones without a cage.
VecX restState(const Model& model);

}  // namespace glenoid
