// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/CouplingPanel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/Sentences.h"
#include "editor/ui/Numbers.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr double kPerField = 1e7;  ///< N/m per m² in one N/mm per cm²

QString text(const std::string& words) { return QString::fromStdString(words); }

QIcon swatch(const std::array<float, 3>& color) {
  QPixmap pixmap(24, 24);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(QColor::fromRgbF(color[0], color[1], color[2]));
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(3, 3, 18, 18, 5, 5);
  return QIcon(pixmap);
}

QDoubleSpinBox* field(const char* name, double low, double high, int decimals) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setMinimumWidth(90);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

QPushButton* button(const char* name) {
  auto* made = new QPushButton;
  made->setObjectName(QLatin1String(name));
  return made;
}

QLabel* words(const char* role = nullptr) {
  auto* made = new QLabel;
  made->setWordWrap(true);
  if (role) made->setProperty("role", QLatin1String(role));
  return made;
}

}  // namespace

CouplingPanel::CouplingPanel(Document& document, Selection& selection, Authoring& authoring, QWidget* parent)
    : QScrollArea(parent), m_document(document), m_selection(selection), m_authoring(authoring) {
  setObjectName(QStringLiteral("couplings"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(310);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  for (QWidget* group : {makePick(), makeRegions(), makeBond(), makeList()}) layout->addWidget(group);
  layout->addStretch(1);
  setWidget(content);

  connect(&document, &Document::changed, this, [this](const ChangeSet&) {
    refreshParts();
    refreshRegions();
    refreshSelection();
    refreshList();
    refreshStiffness();
    askFigures();
  });
  connect(&authoring, &Authoring::targetChanged, this, [this] {
    refreshParts();
    refreshRegions();
    refreshStiffness();
  });
  connect(&authoring, &Authoring::selectionChanged, this, &CouplingPanel::refreshSelection);
  // A part chosen in the tree while nothing is picked yet is the one to work on.
  connect(&selection, &Selection::changed, this, [this] {
    if (m_authoring.selected().empty() && findPart(m_document.joint(), m_selection.current()) >= 0)
      m_authoring.setTarget(m_selection.current(), m_authoring.surface());
  });
  retranslate();
}

// ---- Widgets

QWidget* CouplingPanel::makePick() {
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* form = new QFormLayout(box);
  const auto row = [&](QWidget* widget) {
    auto* label = new QLabel;
    label->setBuddy(widget);
    m_labels.push_back(label);
    form->addRow(label, widget);
  };
  m_partA = new QComboBox;
  m_partA->setObjectName(QStringLiteral("couplings.partA"));
  m_surface = new QComboBox;
  m_surface->setObjectName(QStringLiteral("couplings.surface"));
  m_surface->addItems({{}, {}});
  m_partB = new QComboBox;
  m_partB->setObjectName(QStringLiteral("couplings.partB"));
  for (QComboBox* combo : {m_partA, m_surface, m_partB}) {
    combo->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    combo->setFocusPolicy(Qt::StrongFocus);
  }
  row(m_partA);
  row(m_surface);
  row(m_partB);
  m_within = field("couplings.within", 0, 100, 2);
  m_within->setValue(1.5);
  m_near = button("couplings.near");
  auto* pair = new QWidget;
  auto* pairLayout = new QHBoxLayout(pair);
  pairLayout->setContentsMargins(0, 0, 0, 0);
  pairLayout->addWidget(m_within);
  pairLayout->addWidget(m_near);
  row(pair);
  m_labels.back()->setBuddy(m_within);
  m_selected = words("hint");
  m_selected->setObjectName(QStringLiteral("couplings.selected"));
  form->addRow(m_selected);

  const auto target = [this] {
    if (!m_showing)
      m_authoring.setTarget(m_partA->currentData().toString().toStdString(),
                            m_surface->currentIndex() == 1 ? SurfaceKind::Collision : SurfaceKind::Visual);
  };
  connect(m_partA, &QComboBox::currentIndexChanged, this, target);
  connect(m_surface, &QComboBox::currentIndexChanged, this, target);
  connect(m_partB, &QComboBox::currentIndexChanged, this, [this] {
    if (!m_showing) refreshStiffness();
  });
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
  m_newRegion = button("couplings.newRegion");
  m_setRegion = button("couplings.setRegion");
  m_removeRegion = button("couplings.removeRegion");
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {m_newRegion, m_setRegion, m_removeRegion}) row->addWidget(each);
  layout->addLayout(row);
  connect(m_regions, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    refreshSelection();
    if (m_showing || !item) return;
    const int part = findPart(m_document.joint(), m_authoring.part());
    const Region* region = part < 0 ? nullptr : findRegion(m_document.joint().parts[part], currentRegion());
    if (!region) return;
    const QScopedValueRollback guard(m_showing, true);  // the list stays as it is while its row is taken
    m_surface->setCurrentIndex(region->surface == SurfaceKind::Collision ? 1 : 0);
    m_authoring.setTarget(m_authoring.part(), region->surface);
    m_authoring.select(trianglesOf(*region), tr("Select the region “%1”").arg(anatomyName(region->name)));
  });
  connect(m_regions, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!m_showing)
      renameRegion(m_document, m_authoring.part(), item->data(kIdRole).toString().toStdString(), item->text());
  });
  connect(m_newRegion, &QPushButton::clicked, this, [this] {
    addRegion(m_document, m_authoring.part(), tr("New region"), m_authoring.surface(), m_authoring.selected());
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
  auto* form = new QFormLayout(box);
  m_stiffness = field("couplings.stiffness", 1e-5, 1e6, 5);
  m_reason = new QLineEdit;
  m_reason->setObjectName(QStringLiteral("couplings.reason"));
  m_asPressure = words("hint");
  m_couple = button("couplings.couple");
  for (QWidget* widget : {static_cast<QWidget*>(m_stiffness), static_cast<QWidget*>(m_asPressure), static_cast<QWidget*>(m_reason)}) {
    auto* label = new QLabel;
    m_labels.push_back(label);
    label->setBuddy(widget);
    form->addRow(label, widget);
  }
  form->addRow(m_couple);
  connect(m_stiffness, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    m_asPressure->setText(tr("%1 kPa per mm").arg(number(value * kPerField * 1e-6, 3)));
  });
  connect(m_couple, &QPushButton::clicked, this, &CouplingPanel::couple);
  return box;
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
  m_detail = words("hint");
  m_detail->setObjectName(QStringLiteral("couplings.detail"));
  layout->addWidget(m_detail);
  auto* form = new QFormLayout;
  m_ownStiffness = field("couplings.ownStiffness", 1e-5, 1e6, 5);
  m_ownDamping = field("couplings.ownDamping", 0, 1000, 3);
  m_ownReason = new QLineEdit;
  m_ownReason->setObjectName(QStringLiteral("couplings.ownReason"));
  for (QWidget* widget :
       {static_cast<QWidget*>(m_ownStiffness), static_cast<QWidget*>(m_ownDamping), static_cast<QWidget*>(m_ownReason)}) {
    auto* label = new QLabel;
    m_labels.push_back(label);
    label->setBuddy(widget);
    form->addRow(label, widget);
  }
  layout->addLayout(form);
  m_remove = button("couplings.remove");
  layout->addWidget(m_remove);
  m_proposals = new QWidget;
  m_proposals->setObjectName(QStringLiteral("couplings.proposals"));
  m_proposalsLayout = new QVBoxLayout(m_proposals);
  m_proposalsLayout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_proposals);

  connect(m_list, &QTreeWidget::currentItemChanged, this, &CouplingPanel::refreshDetail);
  connect(m_ownStiffness, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!m_showing) m_document.setCouplingStiffness(currentCoupling(), kPerField * value);
  });
  connect(m_ownDamping, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!m_showing) setCouplingDamping(m_document, currentCoupling(), 1e-3 * value);
  });
  for (QDoubleSpinBox* own : {m_ownStiffness, m_ownDamping})
    connect(own, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
  connect(m_ownReason, &QLineEdit::editingFinished, this, [this] {
    if (!m_showing) setCouplingReason(m_document, currentCoupling(), m_ownReason->text());
  });
  connect(m_remove, &QPushButton::clicked, this, [this] { removeCoupling(m_document, currentCoupling()); });
  return box;
}

// ---- What is shown

std::string CouplingPanel::partB() const { return m_partB->currentData().toString().toStdString(); }

std::string CouplingPanel::currentRegion() const {
  const QListWidgetItem* item = m_regions->currentItem();
  return item ? item->data(kIdRole).toString().toStdString() : std::string();
}

std::string CouplingPanel::currentCoupling() const {
  const QTreeWidgetItem* item = m_list->currentItem();
  return item ? item->data(0, kIdRole).toString().toStdString() : std::string();
}

void CouplingPanel::refreshParts() {
  const QScopedValueRollback guard(m_showing, true);
  const Joint& joint = m_document.joint();
  const QVariant other = m_partB->currentData();
  for (QComboBox* combo : {m_partA, m_partB}) {
    combo->clear();
    for (const Part& part : joint.parts) combo->addItem(anatomyName(part.name), text(part.id));
  }
  if (findPart(joint, m_authoring.part()) < 0 && !joint.parts.empty())
    m_authoring.setTarget(joint.parts.front().id, SurfaceKind::Visual);
  m_partA->setCurrentIndex(m_partA->findData(text(m_authoring.part())));
  m_surface->setCurrentIndex(m_authoring.surface() == SurfaceKind::Collision ? 1 : 0);
  int kept = m_partB->findData(other);
  if (kept < 0 || kept == m_partA->currentIndex()) kept = m_partA->currentIndex() == 0 ? 1 : 0;
  m_partB->setCurrentIndex(std::min(kept, m_partB->count() - 1));
}

void CouplingPanel::refreshRegions() {
  const QScopedValueRollback guard(m_showing, true);
  const QString current = text(currentRegion());
  m_regions->clear();
  const int index = findPart(m_document.joint(), m_authoring.part());
  if (index >= 0)
    for (const Region& region : m_document.joint().parts[index].regions) {
      auto* item = new QListWidgetItem(anatomyName(region.name), m_regions);
      item->setData(kIdRole, text(region.id));
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      if (text(region.id) == current) m_regions->setCurrentItem(item);
    }
}

void CouplingPanel::refreshSelection() {
  const auto mesh = m_authoring.mesh();
  const std::vector<int>& selected = m_authoring.selected();
  const bool any = mesh && !selected.empty();
  const QString count = tr("%n triangle(s) selected", nullptr, static_cast<int>(selected.size()));
  const double area = any ? areaOf(*mesh, selected) : 0;
  m_selected->setText(any ? tr("%1: %2 mm², %3 % of the surface.")
                                .arg(count, number(1e6 * area, 1), number(100 * area / areaOf(*mesh, inverted(*mesh, {})), 1))
                          : tr("Nothing is selected. Paint on the part in the view, or take what is near."));
  const std::string region = currentRegion();
  m_newRegion->setEnabled(any);
  m_setRegion->setEnabled(any && !region.empty());
  m_removeRegion->setEnabled(!region.empty() && !isRegionUsed(m_document.joint(), m_authoring.part(), region));
  m_couple->setEnabled(any && !partB().empty() && partB() != m_authoring.part());
}

void CouplingPanel::refreshStiffness() {
  const double suggested = suggestedStiffness(m_document.joint(), m_authoring.part(), partB());
  // What somebody typed stays; what the program offered follows the pair.
  if (m_suggested == 0 || std::abs(m_stiffness->value() - m_suggested / kPerField) < 1e-4) m_stiffness->setValue(suggested / kPerField);
  m_suggested = suggested;
  m_stiffness->setToolTip(tr("The materials suggest %1 N/mm per cm²: the softer tissue's modulus over one cell.")
                              .arg(number(suggested / kPerField, 4)));
  refreshSelection();
}

void CouplingPanel::refreshList() {
  const QScopedValueRollback guard(m_showing, true);
  const Joint& joint = m_document.joint();
  const QString current = text(currentCoupling());
  m_list->clear();
  const auto nameOf = [&joint](const std::string& id) {
    const int index = findPart(joint, id);
    return anatomyName(index < 0 ? id : joint.parts[index].name);
  };
  for (const Coupling& coupling : joint.couplings) {
    const int part = findPart(joint, coupling.partA);
    const Region* region = part < 0 ? nullptr : findRegion(joint.parts[part], coupling.regionA);
    auto* item = new QTreeWidgetItem(m_list);
    item->setData(0, kIdRole, text(coupling.id));
    item->setText(0, tr("%1 to %2").arg(nameOf(coupling.partA), nameOf(coupling.partB)));
    item->setToolTip(0, text(coupling.reason));
    item->setText(1, anatomyName(region ? region->name : coupling.regionA));
    const auto found = m_figures.find(coupling.id);
    if (found != m_figures.end() && found->second.ok()) {
      const CouplingFigures& figures = found->second.value();
      item->setText(2, number(static_cast<long>(figures.springs)));
      item->setText(3, tr("%1 mm").arg(number(1e3 * figures.meanGap, 2)));
      item->setText(4, tr("%1 N/mm").arg(number(1e-3 * figures.stiffness, 2)));
      item->setIcon(0, figures.island < 0 ? QIcon() : swatch(DisplayState::islandColor(figures.island)));
    }
    if (text(coupling.id) == current) m_list->setCurrentItem(item);
  }
  for (int column = 0; column < 5; ++column) m_list->resizeColumnToContents(column);
  refreshDetail();
}

void CouplingPanel::refreshDetail() {
  const QScopedValueRollback guard(m_showing, true);
  const std::string id = currentCoupling();
  const auto& all = m_document.joint().couplings;
  const auto coupling = std::find_if(all.begin(), all.end(), [&](const Coupling& c) { return c.id == id; });
  const bool any = coupling != all.end();
  for (QWidget* widget : {static_cast<QWidget*>(m_ownStiffness), static_cast<QWidget*>(m_ownDamping),
                          static_cast<QWidget*>(m_ownReason), static_cast<QWidget*>(m_remove)})
    widget->setEnabled(any);
  if (!any) {
    m_detail->setText(tr("Choose a coupling to see its figures."));
    m_ownReason->clear();
    m_authoring.showAnchors({});
    return;
  }
  m_ownStiffness->setValue(coupling->stiffnessPerArea / kPerField);
  m_ownDamping->setValue(1e3 * coupling->damping);
  m_ownReason->setText(text(coupling->reason));
  const auto found = m_figures.find(id);
  if (found == m_figures.end()) {
    m_detail->setText(tr("Counting springs…"));
  } else if (!found->second.ok()) {
    m_detail->setText(sentenceOf(found->second.error()));
    m_authoring.showAnchors({});
  } else {
    const CouplingFigures& figures = found->second.value();
    m_detail->setText(tr("%1 over %2 mm² (%3 % of the part), %4 N/mm in all. The region lies %5 mm from the other part on "
                         "average, %6 mm at most.")
                          .arg(tr("%n spring(s)", nullptr, figures.springs), number(1e6 * figures.area, 1),
                               number(100 * figures.coverage, 1), number(1e-3 * figures.stiffness, 2),
                               number(1e3 * figures.meanGap, 2), number(1e3 * figures.maxGap, 2)));
    m_authoring.showAnchors(figures.anchors_W);
  }
}

void CouplingPanel::refreshProposals(const std::vector<ExclusionProposal>& proposals) {
  while (QLayoutItem* item = m_proposalsLayout->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  const Joint& joint = m_document.joint();
  for (const ExclusionProposal& proposal : proposals) {
    const int a = findPart(joint, proposal.partA), b = findPart(joint, proposal.partB);
    if (a < 0 || b < 0) continue;
    auto* sentence = words();
    sentence->setText(tr("%1 and %2 are bonded over %3 mm², %4 % of the smaller one and %5 % of what lies near. They need "
                         "no collision.")
                          .arg(anatomyName(joint.parts[a].name), anatomyName(joint.parts[b].name),
                               number(1e6 * proposal.bonded, 0), number(100 * proposal.ofPart, 0),
                               number(100 * proposal.ofNear, 0)));
    auto* apply = button("couplings.exclude");
    apply->setText(tr("Switch their collision off"));
    connect(apply, &QPushButton::clicked, this, [this, proposal] { excludePair(m_document, proposal); });
    m_proposalsLayout->addWidget(sentence);
    m_proposalsLayout->addWidget(apply);
  }
}

// ---- What is asked

void CouplingPanel::askFigures() {
  const Scene scene = m_document.scene();
  m_figuresJob.ask([this, scene](const std::atomic<bool>& stale) -> LatestJob::Answer {
    std::map<std::string, Result<CouplingFigures>> figures;
    for (std::size_t i = 0; i < scene.joint.couplings.size() && !stale; ++i)
      figures.emplace(scene.joint.couplings[i].id,
                      couplingFigures(scene.joint, static_cast<int>(i), scene.scenario.fixedParts));
    auto proposals = stale ? std::vector<ExclusionProposal>() : proposeExclusions(scene.joint);
    return [this, figures = std::move(figures), proposals = std::move(proposals)] {
      m_figures = figures;
      refreshList();
      refreshProposals(proposals);
    };
  });
}

void CouplingPanel::askNear(bool select) {
  const auto mesh = m_authoring.mesh();
  const int other = findPart(m_document.joint(), partB());
  if (!mesh || other < 0 || partB() == m_authoring.part()) return;
  const auto otherMesh = m_document.joint().parts[other].visual;
  if (!otherMesh) return;
  m_nearJob.ask([this, mesh, otherMesh, select, distance = 1e-3 * m_within->value(), target = m_authoring.part(),
                 surface = m_authoring.surface()](const std::atomic<bool>&) -> LatestJob::Answer {
    std::vector<int> near = trianglesNear(*mesh, *otherMesh, distance);
    return [=, this] {
      if (target != m_authoring.part() || surface != m_authoring.surface() || mesh != m_authoring.mesh()) return;
      if (!select) return m_authoring.preview(near);
      m_authoring.preview({});
      m_authoring.select(near, tr("Select what is within %1 mm").arg(number(1e3 * distance, 2)));
    };
  });
}

void CouplingPanel::couple() {
  CouplingWish wish;
  wish.partA = m_authoring.part();
  wish.partB = partB();
  wish.surface = m_authoring.surface();
  wish.triangles = m_authoring.selected();
  // A region that is exactly what is selected is taken as it is.
  const int part = findPart(m_document.joint(), wish.partA);
  if (part >= 0)
    for (const Region& region : m_document.joint().parts[part].regions)
      if (region.surface == wish.surface && trianglesOf(region) == wish.triangles) wish.region = region.id;
  wish.stiffnessPerArea = kPerField * m_stiffness->value();
  wish.reason = m_reason->text().toStdString();
  const std::string id = addCoupling(m_document, wish);
  if (id.empty()) return;
  m_reason->clear();
  for (int i = 0; i < m_list->topLevelItemCount(); ++i)
    if (m_list->topLevelItem(i)->data(0, kIdRole).toString() == text(id)) m_list->setCurrentItem(m_list->topLevelItem(i));
}

// ---- Texts

void CouplingPanel::retranslate() {
  const QStringList groups = {tr("Pick"), tr("Regions of this part"), tr("New coupling"), tr("Couplings")};
  for (std::size_t i = 0; i < m_groups.size(); ++i) m_groups[i]->setTitle(groups.value(static_cast<int>(i)));
  const QStringList labels = {tr("Pick on:"),    tr("Surface:"), tr("Couple to:"), tr("Near:"),    tr("Stiffness:"),
                              tr("This means:"), tr("Why:"),     tr("Stiffness:"), tr("Damping:"), tr("Why:")};
  for (std::size_t i = 0; i < m_labels.size(); ++i) m_labels[i]->setText(labels.value(static_cast<int>(i)));
  m_surface->setItemText(0, tr("visual"));
  m_surface->setItemText(1, tr("collision"));
  m_within->setSuffix(tr(" mm"));
  m_within->setAccessibleName(tr("Distance to the other part"));
  m_near->setText(tr("Select"));
  m_near->setToolTip(tr("Select all triangles that lie within this distance of the other part, or inside it"));
  m_newRegion->setText(tr("New"));
  m_newRegion->setToolTip(tr("Make a region of what is selected"));
  m_setRegion->setText(tr("Set"));
  m_setRegion->setToolTip(tr("The chosen region becomes what is selected"));
  m_removeRegion->setText(tr("Remove"));
  m_removeRegion->setToolTip(tr("Remove the chosen region; one that is in use stays"));
  m_stiffness->setSuffix(tr(" N/mm per cm²"));
  m_ownStiffness->setSuffix(tr(" N/mm per cm²"));
  m_ownDamping->setSuffix(tr(" ms"));
  m_ownDamping->setToolTip(tr("Damping force per velocity, over the stiffness"));
  m_reason->setPlaceholderText(tr("What joins the two, for people"));
  m_couple->setText(tr("Couple over the selection"));
  m_remove->setText(tr("Remove this coupling"));
  m_list->setHeaderLabels({tr("Parts"), tr("Region"), tr("Springs"), tr("Gap"), tr("Stiffness")});
  m_list->setAccessibleName(tr("Couplings of the joint"));
  m_regions->setAccessibleName(tr("Regions of the part"));
  for (QDoubleSpinBox* box : {m_stiffness, m_ownStiffness}) box->setAccessibleName(tr("Stiffness per area"));
  m_ownDamping->setAccessibleName(tr("Damping of the coupling"));
  for (QLineEdit* edit : {m_reason, m_ownReason}) edit->setAccessibleName(tr("Why the parts are coupled"));
  refreshParts();
  refreshRegions();
  refreshStiffness();
  refreshList();
  m_asPressure->setText(tr("%1 kPa per mm").arg(number(m_stiffness->value() * kPerField * 1e-6, 3)));
}

void CouplingPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QScrollArea::changeEvent(event);
}

}  // namespace glenoid
