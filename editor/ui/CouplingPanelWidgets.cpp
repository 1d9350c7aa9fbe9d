// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of couplings is made of, and its texts.
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/PartEdits.h"
#include "editor/ui/CouplingPanel.h"
#include "editor/ui/Numbers.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {

using panel::button;
using panel::words;

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr double kPerField = 1e7;      ///< N/m per m² in one N/mm per cm²
constexpr double kPerNodeField = 1e3;  ///< N/m in one N/mm

QDoubleSpinBox* stiff(const QString& name, double low, double high, int decimals) {
  QDoubleSpinBox* box = panel::field(name, low, high, decimals);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  return box;
}

}  // namespace

QWidget* CouplingPanel::makePick() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* form = m_pickForm = new QFormLayout(box);
  const auto row = [&](QWidget* widget) {
    auto* label = new QLabel;
    label->setBuddy(widget);
    m_labels.push_back(label);
    form->addRow(label, widget);
  };
  m_partA = new QComboBox;
  m_partA->setObjectName(QStringLiteral("couplings.partA"));
  m_what = new QComboBox;
  m_what->setObjectName(QStringLiteral("couplings.what"));
  m_what->addItems({{}, {}});
  m_surface = new QComboBox;
  m_surface->setObjectName(QStringLiteral("couplings.surface"));
  m_surface->addItems({{}, {}});
  m_partB = new QComboBox;
  m_partB->setObjectName(QStringLiteral("couplings.partB"));
  for (QComboBox* combo : {m_partA, m_what, m_surface, m_partB}) {
    combo->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    combo->setFocusPolicy(Qt::StrongFocus);
  }
  row(m_partA);
  row(m_what);
  row(m_surface);
  row(m_partB);
  m_within = stiff(QStringLiteral("couplings.within"), 0, 100, 2);
  m_within->setValue(1.5);
  m_near = button("couplings.near");
  auto* pair = new QWidget;
  auto* pairLayout = new QHBoxLayout(pair);
  pairLayout->setContentsMargins(0, 0, 0, 0);
  pairLayout->addWidget(m_within);
  pairLayout->addWidget(m_near);
  row(pair);
  m_labels.back()->setBuddy(m_within);
  m_inSelection = new QCheckBox;
  m_inSelection->setObjectName(QStringLiteral("couplings.inSelection"));
  form->addRow(m_inSelection);
  m_contact = new QCheckBox;
  m_contact->setObjectName(QStringLiteral("couplings.contact"));
  form->addRow(m_contact);
  m_selected = words("couplings.selected", "hint");
  form->addRow(m_selected);

  const auto target = [this] {
    if (!m_showing)
      m_authoring.setTarget(m_partA->currentData().toString().toStdString(),
                            m_surface->currentIndex() == 1 ? SurfaceKind::Collision : SurfaceKind::Visual);
  };
  connect(m_partA, &QComboBox::currentIndexChanged, this, target);
  connect(m_what, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (!m_showing) m_authoring.setPicking(index == 1 ? Authoring::Picking::Nodes : Authoring::Picking::Triangles);
  });
  connect(m_surface, &QComboBox::currentIndexChanged, this, target);
  connect(m_partB, &QComboBox::currentIndexChanged, this, [this] {
    if (m_showing) return;
    refreshStiffness();
    refreshContact();
  });
  connect(m_contact, &QCheckBox::toggled, this, [this](bool on) {
    if (!m_showing) setContact(m_document, m_authoring.part(), partB(), on);
  });
  connect(m_inSelection, &QCheckBox::toggled, this, [this] { askNear(false); });
  connect(m_within, &QDoubleSpinBox::valueChanged, this, [this] { askNear(false); });
  connect(m_near, &QPushButton::clicked, this, [this] { askNear(true); });
  return box;
}

QWidget* CouplingPanel::makeRegions() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* layout = new QVBoxLayout(box);
  m_regions = new QListWidget;
  m_regions->setObjectName(QStringLiteral("couplings.regions"));
  m_regions->setMaximumHeight(110);
  layout->addWidget(m_regions);
  m_combine = new QComboBox;
  m_combine->setObjectName(QStringLiteral("couplings.combine"));
  m_combine->addItems({{}, {}, {}, {}});
  m_combine->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_combine->setFocusPolicy(Qt::StrongFocus);
  layout->addWidget(m_combine);
  m_newRegion = button("couplings.newRegion");
  m_setRegion = button("couplings.setRegion");
  m_removeRegion = button("couplings.removeRegion");
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {m_newRegion, m_setRegion, m_removeRegion}) row->addWidget(each);
  layout->addLayout(row);
  connect(m_regions, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    refreshSelection();
    if (!m_showing && item) takeRegion();
  });
  // The same region once more: to add back what was taken away.
  connect(m_regions, &QListWidget::itemClicked, this, [this] { takeRegion(); });
  connect(m_regions, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!m_showing)
      renameRegion(m_document, m_authoring.part(), item->data(kIdRole).toString().toStdString(),
                   item->text());
  });
  connect(m_newRegion, &QPushButton::clicked, this, [this] {
    addRegion(m_document, m_authoring.part(), tr("New region"), m_authoring.surface(),
              m_authoring.selected());
  });
  connect(m_setRegion, &QPushButton::clicked, this, [this] {
    setRegion(m_document, m_authoring.part(), currentRegion(), m_authoring.surface(), m_authoring.selected());
  });
  connect(m_removeRegion, &QPushButton::clicked, this,
          [this] { removeRegion(m_document, m_authoring.part(), currentRegion()); });
  return box;
}

QWidget* CouplingPanel::makeBond() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* form = m_bondForm = new QFormLayout(box);
  m_nodeStiffness = stiff(QStringLiteral("couplings.nodeStiffness"), 1e-6, 1e9, 6);
  m_stiffness = stiff(QStringLiteral("couplings.stiffness"), 1e-5, 1e6, 5);
  m_reason = new QLineEdit;
  m_reason->setObjectName(QStringLiteral("couplings.reason"));
  m_asPressure = words("couplings.asPressure", "hint");
  m_couple = button("couplings.couple");
  for (QWidget* widget : {static_cast<QWidget*>(m_stiffness), static_cast<QWidget*>(m_nodeStiffness),
                          static_cast<QWidget*>(m_asPressure), static_cast<QWidget*>(m_reason)}) {
    auto* label = new QLabel;
    m_labels.push_back(label);
    label->setBuddy(widget);
    form->addRow(label, widget);
  }
  form->addRow(m_couple);
  for (QDoubleSpinBox* each : {m_stiffness, m_nodeStiffness}) connect(each, &QDoubleSpinBox::valueChanged, this, [this] { showMeaning(); });
  connect(m_couple, &QPushButton::clicked, this, &CouplingPanel::couple);
  return box;
}

void CouplingPanel::showMeaning() {
  m_asPressure->setText(picksNodes() ? tr("%1 N/mm in all").arg(number(m_nodeStiffness->value() * static_cast<double>(m_authoring.selectedNodes().size()), 4))
                                     : tr("%1 kPa per mm").arg(number(m_stiffness->value() * kPerField * 1e-6, 3)));
}

QWidget* CouplingPanel::makeList() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* layout = new QVBoxLayout(box);
  m_list = new QTreeWidget;
  m_list->setObjectName(QStringLiteral("couplings.list"));
  m_list->setRootIsDecorated(false);
  m_list->setUniformRowHeights(true);
  m_list->setColumnCount(5);
  m_list->setMinimumHeight(150);
  layout->addWidget(m_list);
  m_detail = words("couplings.detail", "hint");
  layout->addWidget(m_detail);
  auto* form = new QFormLayout;
  m_ownStiffness = stiff(QStringLiteral("couplings.ownStiffness"), 1e-5, 1e6, 5);
  m_ownDamping = stiff(QStringLiteral("couplings.ownDamping"), 0, 1000, 3);
  m_ownReason = new QLineEdit;
  m_ownReason->setObjectName(QStringLiteral("couplings.ownReason"));
  for (QWidget* widget : {static_cast<QWidget*>(m_ownStiffness), static_cast<QWidget*>(m_ownDamping),
                          static_cast<QWidget*>(m_ownReason)}) {
    auto* label = new QLabel;
    m_labels.push_back(label);
    label->setBuddy(widget);
    form->addRow(label, widget);
  }
  layout->addLayout(form);
  m_takeNodes = button("couplings.takeNodes");
  m_replaceNodes = button("couplings.replaceNodes");
  auto* own = new QHBoxLayout;
  for (QPushButton* each : {m_takeNodes, m_replaceNodes}) own->addWidget(each);
  layout->addLayout(own);
  m_remove = button("couplings.remove");
  layout->addWidget(m_remove);
  m_proposals = new QWidget;
  m_proposals->setObjectName(QStringLiteral("couplings.proposals"));
  m_proposalsLayout = new QVBoxLayout(m_proposals);
  m_proposalsLayout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_proposals);

  connect(m_list, &QTreeWidget::currentItemChanged, this, &CouplingPanel::refreshDetail);
  connect(m_ownStiffness, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!m_showing) m_document.setCouplingStiffness(currentCoupling(), (isByNodes(currentCoupling()) ? kPerNodeField : kPerField) * value);
  });
  connect(m_ownDamping, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!m_showing) setCouplingDamping(m_document, currentCoupling(), 1e-3 * value);
  });
  for (QDoubleSpinBox* own : {m_ownStiffness, m_ownDamping})
    connect(own, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
  connect(m_ownReason, &QLineEdit::editingFinished, this, [this] {
    if (!m_showing) setCouplingReason(m_document, currentCoupling(), m_ownReason->text());
  });
  connect(m_takeNodes, &QPushButton::clicked, this, &CouplingPanel::takeNodes);
  connect(m_replaceNodes, &QPushButton::clicked, this, &CouplingPanel::replaceNodes);
  connect(m_remove, &QPushButton::clicked, this, [this] { removeCoupling(m_document, currentCoupling()); });
  return box;
}

void CouplingPanel::retranslate() {
  const QStringList groups = {tr("Pick"), tr("Regions of this part"), tr("New coupling"), tr("Couplings")};
  for (std::size_t i = 0; i < m_groups.size(); ++i) m_groups[i]->setTitle(groups.value(static_cast<int>(i)));
  const QStringList labels = {tr("Pick on:"),   tr("What:"),       tr("Surface:"),     tr("Couple to:"), tr("Near:"), tr("Stiffness:"),
                              tr("Stiffness:"), tr("This means:"), tr("Why:"),         tr("Stiffness:"), tr("Damping:"), tr("Why:")};
  for (std::size_t i = 0; i < m_labels.size(); ++i) m_labels[i]->setText(labels.value(static_cast<int>(i)));
  m_what->setItemText(0, tr("triangles of its surface"));
  m_what->setItemText(1, tr("nodes of its cells"));
  m_what->setToolTip(tr("Over triangles the parts are glued; at nodes a spring of its own holds each"));
  m_surface->setItemText(0, tr("visual"));
  m_surface->setItemText(1, tr("collision"));
  m_within->setSuffix(tr(" mm"));
  m_within->setAccessibleName(tr("Distance to the other part"));
  m_near->setText(tr("Select"));
  m_near->setToolTip(
      tr("Select all that lies within this distance of the other part, or inside it"));
  m_inSelection->setText(tr("Only within what is selected"));
  m_inSelection->setToolTip(tr("Draw a lasso first: of what is near, only what lies in it is taken"));
  m_contact->setText(tr("The two touch each other"));
  m_contact->setToolTip(tr("Off: contact between these two parts is not looked for"));
  m_combine->setItemText(0, tr("A region becomes the selection"));
  m_combine->setItemText(1, tr("A region is added to the selection"));
  m_combine->setItemText(2, tr("A region is taken from the selection"));
  m_combine->setItemText(3, tr("The selection keeps what a region shares"));
  m_combine->setAccessibleName(tr("What choosing a region does"));
  m_newRegion->setText(tr("New"));
  m_newRegion->setToolTip(tr("Make a region of what is selected"));
  m_setRegion->setText(tr("Set"));
  m_setRegion->setToolTip(tr("The chosen region becomes what is selected"));
  m_removeRegion->setText(tr("Remove"));
  m_removeRegion->setToolTip(tr("Remove the chosen region; one that is in use stays"));
  m_stiffness->setSuffix(tr(" N/mm per cm²"));
  m_nodeStiffness->setSuffix(tr(" N/mm per node"));
  m_ownDamping->setSuffix(tr(" ms"));
  m_ownDamping->setToolTip(tr("Damping force per velocity, over the stiffness"));
  m_reason->setPlaceholderText(tr("What joins the two, for people"));
  m_takeNodes->setText(tr("Select its nodes"));
  m_takeNodes->setToolTip(tr("The nodes of the chosen coupling become the selection"));
  m_replaceNodes->setText(tr("Set its nodes"));
  m_replaceNodes->setToolTip(tr("The chosen coupling holds at the selected nodes from now on"));
  m_remove->setText(tr("Remove this coupling"));
  m_list->setHeaderLabels({tr("Parts"), tr("Region"), tr("Springs"), tr("Gap"), tr("Stiffness")});
  m_list->setAccessibleName(tr("Couplings of the joint"));
  m_regions->setAccessibleName(tr("Regions of the part"));
  m_stiffness->setAccessibleName(tr("Stiffness per area"));
  m_nodeStiffness->setAccessibleName(tr("Stiffness of each spring"));
  m_ownDamping->setAccessibleName(tr("Damping of the coupling"));
  for (QLineEdit* edit : {m_reason, m_ownReason}) edit->setAccessibleName(tr("Why the parts are coupled"));
  refreshParts();
  refreshRegions();
  refreshContact();
  refreshPicking();
  refreshStiffness();
  refreshList();
  showMeaning();
}

}  // namespace glenoid
