// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QScrollArea>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <memory>

#include "editor/core/LatestJob.h"
#include "editor/core/tools/Authoring.h"
#include "simcore/author/Overlaps.h"

class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace glenoid {

/// A start without intersections by cages: the overlaps of the joint as it starts, live while handles are dragged; a cage
/// around the chosen part; the program's own suggestion; and the proof. Shows and forwards.
class CagePanel : public QScrollArea {
  Q_OBJECT
 public:
  CagePanel(Document& document, Selection& selection, Authoring& authoring, QWidget* parent = nullptr);
  ~CagePanel() override;

 signals:
  void partsWanted(const std::set<std::string>& ids, const std::string& current);  ///< show these two

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeCageBox();
  QWidget* makeOverlapBox();
  void retranslate();
  void refresh();
  void refreshProof();  ///< hashes the joint, so not while a handle is dragged
  void askOverlaps();
  void showOverlaps(const std::vector<Overlap>& overlaps, const std::vector<TriMesh>& surfaces);
  void makeTheCage();
  void resetCage();
  void suggest();
  void prove();
  using Cancel = std::shared_ptr<std::atomic<bool>>;
  /// Runs on the worker; what it answers runs here, unless somebody has pressed Stop meanwhile.
  void run(const QString& phase, std::function<std::function<void()>(const Cancel&)> work);
  void end(const QString& sentence);
  bool sameStart(const Joint& joint) const;

  Document& m_document;
  Selection& m_selection;
  Authoring& m_authoring;
  LatestJob m_overlapJob;
  QTimer m_later;  ///< overlaps are asked for when the hand rests for a moment, or this long after the last answer
  std::vector<Overlap> m_overlaps;
  std::vector<std::vector<Vec3>> m_cuts_W;  ///< by overlap
  bool m_overlapsKnown = false, m_showing = false;
  Cancel m_cancel;  ///< of the job that somebody waits for
  QThreadPool m_workers;

  std::vector<QGroupBox*> m_groups;
  std::vector<QLabel*> m_labels;
  QLabel *m_part, *m_picked, *m_summary, *m_proof, *m_outcome;
  QSpinBox* m_handles;
  QPushButton *m_make, *m_reset, *m_remove, *m_suggest, *m_prove, *m_stop;
  QDoubleSpinBox *m_shift[3], *m_clearance;
  QProgressBar* m_progress;
  QTreeWidget* m_list;
};

}  // namespace glenoid
