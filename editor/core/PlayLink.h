// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <functional>

#include "editor/core/Document.h"
#include "simcore/live/LiveWatch.h"
#include "simcore/live/SimulationThread.h"
#include "simcore/live/StepMeter.h"

namespace glenoid {

/// Between the document and the run. A change that matters is compiled on a worker; if that succeeds the run takes
/// the new model and carries its state over by id, if not `problem` says why and the old model keeps running.
/// Commands go on to the simulation thread; what it publishes is looked at here at display rate. GUI thread only.
class PlayLink : public QObject {
  Q_OBJECT
 public:
  using Compiler = std::function<Result<std::shared_ptr<const Model>>(const Joint&, const Scenario&)>;

  /// `document` must outlive this. Compiler and makers are the real ones outside of tests; without a StepMaker it is the meter's.
  explicit PlayLink(Document& document, Compiler compiler = compileModel, StepMaker maker = {},
                    WatchMaker watchMaker = makeLiveWatch, QObject* parent = nullptr);
  ~PlayLink() override;

  /// What the run last published; its model is null until the first one is compiled.
  const Snapshot& snapshot() const { return m_simulation.snapshot(); }
  /// What must be said about the run, those first after which its figures are not to be trusted (isGrave).
  const std::vector<Notice>& notices() const { return m_notices; }
  bool isCompiling() const { return m_compiling > 0; }
  /// A recorded input exists for this scene, and whether tools that nobody holds follow it.
  bool hasRecording() const { return m_document.scene().input != nullptr; }
  bool followsRecording() const { return m_followRecording; }

 public slots:
  void play() { m_simulation.play(); }
  void pause() { m_simulation.pause(); }
  void togglePlay() { snapshot().playing ? pause() : play(); }
  void stepOnce() { m_simulation.stepOnce(); }
  void reset();
  void setFollowRecording(bool follow);

 public:
  /// The hand takes the tool (index in the scenario) to a pose, and keeps it there until release.
  void holdTool(int tool, const Pose& hand);
  void releaseTool(int tool);
  /// For who reads tissue: snapshots with rotations.
  void setRotationsWanted(bool wanted) { m_simulation.setRotationsWanted(wanted); }
  bool isHeld(int tool) const;
  /// Asks for what hands did since the run began; `answer` comes later, here: a recording for `glenoid replay`, without the scenario's
  /// name, or nothing where the scene was changed while it ran or nothing was run.
  void askForSession(std::function<void(std::optional<Recording>)> answer);
  /// Where the hand of a tool is wanted: by who holds it, else by the run. Identity for an unknown tool.
  Pose handOf(int tool) const;

  /// What each step took, while somebody wants it.
  StepMeter& meter() { return m_meter; }

  /// Something else than the document's scene, such as a failure of a study, takes its place and is run from its start by these steps,
  /// until endGuest() or until the document changes in what is computed. Its hands are its own.
  void playGuest(std::shared_ptr<const Model> model, StepMaker maker);
  bool hasGuest() const { return m_guest; }
  /// Back to the document's scene, at its start.
  void endGuest();

 signals:
  void guestChanged();
  void snapshotChanged();
  void noticesChanged();
  void compilingChanged();
  void followChanged();                       ///< followsRecording() has
  void problem(const glenoid::Error& error);  ///< the last change cannot be simulated
  void compiled();                            ///< it can; snapshotChanged follows when the run has taken it

 private:
  void onChanged(const ChangeSet& changes);
  void onCompiled(long generation, bool carry, Result<std::shared_ptr<const Model>> result);
  void compile(bool carry);
  void look();

  Document& m_document;
  Compiler m_compiler;
  StepMeter m_meter;
  SimulationThread m_simulation;
  std::vector<HandWish> m_wishes;
  std::shared_ptr<const std::vector<Notice>> m_told;  // as the run published them
  std::vector<Notice> m_notices;                      // in order
  bool m_followRecording = true, m_guest = false;
  long m_generation = 0;
  int m_compiling = 0;
  bool m_carry = true;  // false as long as an opened scene has not been taken
  QTimer m_look;
  QThreadPool m_workers;
};

}  // namespace glenoid
