// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QScrollArea>
#include <map>

#include "editor/core/LatestJob.h"
#include "editor/core/tools/Authoring.h"
#include "simcore/coupling/CouplingFigures.h"
#include "simcore/scene/ProposeExclusions.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace glenoid {

/// Couplings by picking: which two parts, over which triangles or at which nodes, how stiff; the joint's couplings with their
/// figures; and the pairs whose collision their bonds make needless. Shows and forwards: what is done is in
/// AuthorEdits.
class CouplingPanel : public QScrollArea {
  Q_OBJECT
 public:
  CouplingPanel(Document& document, Selection& selection, Authoring& authoring, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makePick();
  QWidget* makeRegions();
  QWidget* makeBond();
  QWidget* makeList();
  void retranslate();
  void refreshParts();
  void refreshRegions();
  void refreshSelection();
  void refreshStiffness();
  void refreshList();
  void refreshDetail();
  void refreshProposals(const std::vector<ExclusionProposal>& proposals);
  void askFigures();
  void askNear(bool select);
  void takeRegion();
  void refreshContact();
  void showMeaning();
  void couple();
  // At nodes.
  bool picksNodes() const { return m_authoring.picking() == Authoring::Picking::Nodes; }
  bool isByNodes(const std::string& coupling) const;
  void refreshPicking();
  void refreshNodeSelection();
  void askNearNodes(bool select);
  void takeNodes();
  void replaceNodes();
  std::string partB() const;
  std::string currentRegion() const;
  std::string currentCoupling() const;

  Document& m_document;
  Selection& m_selection;
  Authoring& m_authoring;
  LatestJob m_figuresJob, m_nearJob;
  std::map<std::string, Result<CouplingFigures>> m_figures;  ///< by coupling
  bool m_showing = false;
  double m_suggested = 0;  ///< N/m per m², what the stiffness field offers of itself
  double m_suggestedNode = 0;  ///< N/m, the same of each node

  std::vector<QGroupBox*> m_groups;
  std::vector<QLabel*> m_labels;
  QComboBox *m_partA, *m_partB, *m_what, *m_surface, *m_combine;
  QFormLayout *m_pickForm, *m_bondForm;
  QCheckBox *m_contact, *m_inSelection;
  QLabel *m_selected, *m_asPressure, *m_detail;
  QDoubleSpinBox *m_within, *m_stiffness, *m_nodeStiffness, *m_ownStiffness, *m_ownDamping;
  QPushButton *m_near, *m_newRegion, *m_setRegion, *m_removeRegion, *m_couple, *m_remove, *m_takeNodes, *m_replaceNodes;
  QListWidget* m_regions;
  QLineEdit *m_reason, *m_ownReason;
  QTreeWidget* m_list;
  QWidget* m_proposals;
  QVBoxLayout* m_proposalsLayout;
};

}  // namespace glenoid
