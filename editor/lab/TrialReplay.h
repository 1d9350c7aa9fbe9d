// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <atomic>
#include <memory>

#include "editor/core/PlayLink.h"
#include "editor/lab/LabServices.h"

namespace glenoid {

/// Runs a trial of the gauntlet in the window's view in place of the document's scene, step for step as the study did: its start, what its
/// hands do, its pushes. At its last step it stands still and says whether its state is the study's, bit for bit. GUI thread only.
class TrialReplay : public QObject {
  Q_OBJECT
 public:
  explicit TrialReplay(PlayLink& link, QObject* parent = nullptr);

  void start(TrialToReplay trial);
  /// Back to the document's scene.
  void end() { m_link.endGuest(); }

  bool isShown() const { return m_progress && m_link.hasGuest(); }
  const std::string& trial() const { return m_trial; }
  long steps() const { return m_steps; }
  /// How its end compares with the study's; nothing before it is there, or where the study said nothing.
  std::optional<bool> sameAsStudied() const;
  bool hasEnded() const;

 signals:
  void changed();

 private:
  struct Progress {
    std::atomic<bool> ended{false};
    std::atomic<int> same{-1};  ///< −1: not known
  };

  PlayLink& m_link;
  std::shared_ptr<Progress> m_progress;
  std::string m_trial;
  long m_steps = 0;
  bool m_told = false;
};

}  // namespace glenoid
