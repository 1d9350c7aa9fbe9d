// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QScrollArea>
#include <QTimer>

#include "editor/core/JobSystem.h"
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

/// A start without intersections by cages: the overlaps of the joint as it starts, live while handles are
/// dragged; a cage around the chosen part; the program's own suggestion; and the proof. Shows and forwards.
class CagePanel : public QScrollArea {
  Q_OBJECT
 public:
  CagePanel(Document& document, Selection& selection, Authoring& authoring, JobSystem& jobs,
            QWidget* parent = nullptr);

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
  void begin(int job, const QString& phase);
  void showJob();

  Document& m_document;
  Selection& m_selection;
  Authoring& m_authoring;
  LatestJob m_overlapJob;
  QTimer m_later;  ///< overlaps are asked for when the hand rests for a moment, or this long after the last
                   ///< answer
  std::vector<Overlap> m_overlaps;
  std::vector<std::vector<Vec3>> m_cuts_W;  ///< by overlap
  bool m_overlapsKnown = false, m_showing = false;
  JobSystem& m_jobs;
  int m_job = 0;  ///< that was begun here; 0: none

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
