// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "editor/core/DisplayState.h"
#include "editor/core/Document.h"
#include "editor/core/tools/SelectTool.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// The author's tools in the view: which one has the mouse, what it works on, what it draws over the scene. While one is
/// active the view shows the joint at rest, since regions and couplings are authored there. Selected triangles lie
/// outside of the document, as parts that are selected do, but each stroke is a step that undo takes back. GUI thread
/// only.
class Authoring : public QObject {
  Q_OBJECT
 public:
  enum class Tool { None, Select };

  /// Both must outlive this.
  Authoring(Document& document, const DisplayState& display, QObject* parent = nullptr);

  Tool tool() const { return m_tool; }
  void setTool(Tool tool);
  PickMode mode() const { return m_select.mode(); }
  void setMode(PickMode mode);
  double radius() const { return m_select.radius(); }
  void setRadius(double pixels);

  /// The part and surface from which triangles are picked; another one begins with nothing selected.
  void setTarget(const std::string& part, SurfaceKind surface);
  const std::string& part() const { return m_picked.part; }
  SurfaceKind surface() const { return m_picked.surface; }
  /// Null while the part is unknown.
  std::shared_ptr<const TriMesh> mesh() const;
  const std::vector<int>& selected() const { return m_picked.triangles; }
  /// One undo step called `text`; nothing when they are selected already. Triangles ascending.
  void select(const std::vector<int>& triangles, const QString& text);
  void grow();
  void shrink();
  void selectConnected();
  void invert();
  void clear();
  /// Shown in another colour until the next call: what a button would select.
  void preview(std::vector<int> triangles);
  /// Where a coupling holds, shown as dots; m, W.
  void showAnchors(std::vector<Vec3> anchors_W);

  // From the view.
  bool active() const { return m_tool != Tool::None; }
  bool busy() const { return m_select.busy(); }
  void press(const Viewport& viewport, const Pointer& pointer);
  void move(const Viewport& viewport, const Pointer& pointer);
  void release(const Pointer& pointer);
  void leave();
  void cancel();
  /// State to draw a model in, null: that of the run.
  const VecX* stateFor(const std::shared_ptr<const Model>& model);
  void decorate(const Model& model, Layers& layers) const;

 signals:
  void toolChanged();
  void modeChanged();       ///< or the brush's radius
  void targetChanged();
  void selectionChanged();
  void looksChanged();      ///< what decorate or stateFor gives

 private:
  struct Picked {
    std::string part;
    SurfaceKind surface = SurfaceKind::Visual;
    std::vector<int> triangles;
    bool operator==(const Picked&) const = default;
  };
  class PickCommand;
  void set(const Picked& picked);
  void onDocumentChanged();
  void refreshTarget();
  void refreshNodes();

  Document& m_document;
  const DisplayState& m_display;
  Tool m_tool = Tool::None;
  SelectTool m_select;
  Picked m_picked;
  std::shared_ptr<const TriMesh> m_mesh;  ///< that the selection belongs to
  std::vector<int> m_preview;
  std::vector<Vec3> m_nodes_W, m_anchors_W;
  std::optional<Vec2> m_cursor;
  std::weak_ptr<const Model> m_stateOf;
  VecX m_state;
};

/// A model's state with every part at rest: rigid ones as they start, soft ones without a cage.
VecX restState(const Model& model);

}  // namespace glenoid
