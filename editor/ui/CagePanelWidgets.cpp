// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of the start is made of, and its texts.
#include <QFormLayout>
#include <QGroupBox>
#include <QProgressBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/ui/CagePanel.h"
#include "editor/ui/Numbers.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {
namespace {

QDoubleSpinBox* millimetres(const QString& name, double low, double high, int decimals) {
  QDoubleSpinBox* box = panel::field(name, low, high, decimals);
  box->setSingleStep(0.1);
  return box;
}

}  // namespace

QWidget* CagePanel::makeCageBox() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* form = new QFormLayout(box);
  const auto button = [this](const char* name, void (CagePanel::*pressed)()) {
    auto* made = new QPushButton;
    made->setObjectName(QLatin1String(name));
    connect(made, &QPushButton::clicked, this, pressed);
    return made;
  };
  const auto row = [&](QWidget* widget, QLayout* layout = nullptr) {
    auto* label = new QLabel;
    label->setBuddy(widget);
    m_labels.push_back(label);
    layout ? form->addRow(label, layout) : form->addRow(label, widget);
  };
  m_part = new QLabel;
  m_part->setWordWrap(true);
  row(m_part);
  m_handles = new QSpinBox;
  m_handles->setObjectName(QStringLiteral("cages.handles"));
  m_handles->setRange(8, 2000);
  m_handles->setValue(60);
  m_handles->setFocusPolicy(Qt::StrongFocus);
  row(m_handles);
  m_make = button("cages.make", &CagePanel::makeTheCage);
  m_reset = button("cages.reset", &CagePanel::resetCage);
  m_remove = new QPushButton;
  m_remove->setObjectName(QStringLiteral("cages.remove"));
  connect(m_remove, &QPushButton::clicked, this, [this] { removeCage(m_document, m_authoring.part()); });
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {m_make, m_reset, m_remove}) buttons->addWidget(each);
  form->addRow(buttons);
  m_picked = new QLabel;
  m_picked->setObjectName(QStringLiteral("cages.picked"));
  m_picked->setWordWrap(true);
  m_picked->setProperty("role", QStringLiteral("hint"));
  form->addRow(m_picked);
  for (int axis = 0; axis < 3; ++axis) {
    m_shift[axis] = millimetres(QStringLiteral("cages.shift.%1").arg(axis), -500, 500, 2);
    row(m_shift[axis]);
    connect(m_shift[axis], &QDoubleSpinBox::valueChanged, this, [this] {
      if (!m_showing)
        m_authoring.setMeanShift(1e-3 * Vec3(m_shift[0]->value(), m_shift[1]->value(), m_shift[2]->value()));
    });
    connect(m_shift[axis], &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
  }
  return box;
}

QWidget* CagePanel::makeOverlapBox() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* layout = new QVBoxLayout(box);
  const auto label = [&](const char* name) {
    auto* made = new QLabel;
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    return made;
  };
  m_summary = label("cages.summary");
  layout->addWidget(m_summary);
  m_list = new QTreeWidget;
  m_list->setObjectName(QStringLiteral("cages.overlaps"));
  m_list->setRootIsDecorated(false);
  m_list->setColumnCount(3);
  m_list->setUniformRowHeights(true);
  m_list->setMinimumHeight(120);
  layout->addWidget(m_list);
  connect(m_list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (m_showing || !item) return;
    const int index = m_list->indexOfTopLevelItem(item);
    if (index < 0 || index >= static_cast<int>(m_overlaps.size())) return;
    const Overlap& overlap = m_overlaps[index];
    const auto& parts = m_document.joint().parts;
    if (std::max(overlap.partA, overlap.partB) >= static_cast<int>(parts.size())) return;
    m_authoring.showCuts(m_cuts_W[index]);
    // The part whose cage is moved stays the chosen one; else the one that can have a cage.
    const bool second =
        parts[overlap.partB].id == m_authoring.part() ||
        (parts[overlap.partA].id != m_authoring.part() && parts[overlap.partA].kind == PartKind::Rigid);
    emit partsWanted({parts[overlap.partA].id, parts[overlap.partB].id},
                     parts[second ? overlap.partB : overlap.partA].id);
  });
  auto* form = new QFormLayout;
  m_clearance = millimetres(QStringLiteral("cages.clearance"), 0.01, 10, 2);
  m_clearance->setValue(1);
  auto* name = new QLabel;
  name->setBuddy(m_clearance);
  m_labels.push_back(name);
  form->addRow(name, m_clearance);
  layout->addLayout(form);
  const auto button = [this](const char* id) {
    auto* made = new QPushButton;
    made->setObjectName(QLatin1String(id));
    return made;
  };
  m_suggest = button("cages.suggest");
  m_prove = button("cages.prove");
  m_stop = button("cages.stop");
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {m_suggest, m_prove, m_stop}) row->addWidget(each);
  layout->addLayout(row);
  m_progress = new QProgressBar;
  m_progress->setObjectName(QStringLiteral("cages.progress"));
  m_progress->setRange(0, 1000);
  m_progress->hide();
  layout->addWidget(m_progress);
  m_outcome = label("cages.outcome");
  layout->addWidget(m_outcome);
  m_proof = label("cages.proof");
  layout->addWidget(m_proof);
  connect(m_suggest, &QPushButton::clicked, this, &CagePanel::suggest);
  connect(m_prove, &QPushButton::clicked, this, &CagePanel::prove);
  connect(m_stop, &QPushButton::clicked, this, [this] { m_jobs.cancel(m_job); });
  return box;
}

void CagePanel::retranslate() {
  const QStringList groups = {tr("Cage"), tr("Overlaps at the start")};
  for (std::size_t i = 0; i < m_groups.size(); ++i) m_groups[i]->setTitle(groups.value(static_cast<int>(i)));
  const QStringList labels = {tr("Around:"),   tr("Handles:"), tr("Anterior:"),
                              tr("Superior:"), QString(), tr("Clearance:")};
  for (std::size_t i = 0; i < m_labels.size(); ++i) m_labels[i]->setText(labels.value(static_cast<int>(i)));
  m_handles->setAccessibleName(tr("Number of handles of a new cage"));
  m_make->setText(tr("Make"));
  m_make->setToolTip(tr("Make a cage around this part; an old one goes"));
  m_reset->setText(tr("Reset"));
  m_reset->setToolTip(tr("Put all handles back to rest"));
  m_remove->setText(tr("Remove"));
  m_remove->setToolTip(tr("Let the part start at rest"));
  m_suggest->setText(tr("Suggest"));
  m_suggest->setToolTip(tr("Move cages until no two parts cut each other"));
  m_prove->setText(tr("Prove"));
  m_prove->setToolTip(tr("Count every cut exactly and write the result into the joint"));
  m_stop->setText(tr("Stop"));
  m_stop->setToolTip(tr("Stop what is under way; nothing is changed then"));
  for (QDoubleSpinBox* box : m_shift) {
    box->setSuffix(tr(" mm"));
    box->setAccessibleName(tr("Shift of the picked handles"));
  }
  m_clearance->setSuffix(tr(" mm"));
  m_clearance->setAccessibleName(tr("Clearance that a suggestion keeps"));
  m_list->setHeaderLabels({tr("Parts"), tr("Depth"), tr("Cuts")});
  m_list->setAccessibleName(tr("Overlaps at the start"));
  m_progress->setAccessibleName(tr("Progress"));
  if (m_overlapsKnown) {
    m_summary->setText(m_overlaps.empty() ? tr("No two parts that may collide overlap at the start.")
                                          : tr("%n pair(s) of parts overlap at the start.", nullptr,
                                               static_cast<int>(m_overlaps.size())));
  }
  refresh();
  refreshProof();
}

}  // namespace glenoid
