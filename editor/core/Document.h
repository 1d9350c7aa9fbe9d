// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>

#include "editor/core/ChangeSet.h"
#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

class FrozenScene;

/// What the window works on: the two things that somebody authored, and the input that ships with them. Values;
/// meshes are shared and never change.
struct Scene {
  Joint joint;
  Scenario scenario;
  std::shared_ptr<const Recording> input;  ///< may be null
};

/// Reads a scene; comes from the application, since where things lie is its business. May run on any thread.
using SceneLoader = std::function<Result<Scene>(const std::string& path)>;
/// Writes one. As above.
using SceneSaver = std::function<Result<Done>(const Scene& scene, const std::string& path)>;

/// The one scene of a window, with undo. Every edit makes a new value and swaps it in; undo and redo are the
/// same swap, so they cannot drift apart. GUI thread only.
class Document : public QObject {
  Q_OBJECT
 public:
  using Edit = std::function<void(Scene&)>;

  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  const Scene& scene() const { return m_scene; }
  const Joint& joint() const { return m_scene.joint; }
  const Scenario& scenario() const { return m_scene.scenario; }
  QString path() const { return m_path; }
  bool isEmpty() const { return m_scene.joint.parts.empty(); }
  QUndoStack& undoStack() { return m_undo; }

  /// Another scene; forgets undo.
  void open(Scene scene, const QString& path);
  /// The same for a scene that lies nowhere yet: it counts as changed until it is saved.
  void openUnsaved(Scene scene, const QString& origin);
  /// The scene was written there: no unsaved changes.
  void saved(const QString& path);
  /// One undo step called `text`. Edits in a row with the same `gesture` that is not empty are one step, until
  /// endGesture(). Callers check first that something changes.
  void edit(const QString& text, const ChangeSet& changes, const Edit& change, const QString& gesture = {});
  void endGesture() { ++m_gestureNumber; }

  // Edits by name, in SI units. Nothing happens when the id is unknown or the value is the same.
  void setYoungsModulus(const std::string& material, double pascal);
  /// Per area (N/m per m²), or of a coupling at nodes that of each spring (N/m).
  void setCouplingStiffness(const std::string& coupling, double stiffness);
  void setProfile(Profile profile);

 signals:
  void changed(const glenoid::ChangeSet& changes);
  void savedTo(const QString& path);

 private:
  class SwapCommand;
  void swap(Scene scene, std::shared_ptr<const FrozenScene> frozen, const ChangeSet& changes);

  Scene m_scene;
  std::shared_ptr<const FrozenScene> m_frozen;  ///< the same, as undo keeps it
  QString m_path;
  QUndoStack m_undo;
  int m_gestureNumber = 0;
};

}  // namespace glenoid
