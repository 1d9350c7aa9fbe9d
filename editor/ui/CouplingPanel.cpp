// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/CouplingPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/Sentences.h"
#include "editor/ui/Numbers.h"
#include "editor/ui/PanelParts.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

using panel::button;
using panel::text;
using panel::words;

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr double kPerField = 1e7;      ///< N/m per m² in one N/mm per cm²
constexpr double kPerNodeField = 1e3;  ///< N/m in one N/mm

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
    refreshContact();
    refreshList();
    refreshStiffness();
    askFigures();
  });
  connect(&authoring, &Authoring::targetChanged, this, [this] {
    refreshParts();
    refreshRegions();
    refreshContact();
    refreshStiffness();
  });
  connect(&authoring, &Authoring::selectionChanged, this, &CouplingPanel::refreshSelection);
  connect(&authoring, &Authoring::modeChanged, this, &CouplingPanel::refreshPicking);
  // A part chosen in the tree while nothing is picked yet is the one to work on.
  connect(&selection, &Selection::changed, this, [this] {
    if (!m_authoring.anySelected() && findPart(m_document.joint(), m_selection.current()) >= 0)
      m_authoring.setTarget(m_selection.current(), m_authoring.surface());
  });
  retranslate();
}

// ---- What is shown

std::string CouplingPanel::partB() const {
  return m_partB->currentData().toString().toStdString();
}

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

void CouplingPanel::refreshContact() {
  const QScopedValueRollback guard(m_showing, true);
  const std::string a = m_authoring.part(), b = partB();
  const auto& off = m_document.joint().exclusions;
  const auto found = std::find_if(off.begin(), off.end(), [&](const Exclusion& e) { return (e.partA == a && e.partB == b) || (e.partA == b && e.partB == a); });
  m_contact->setEnabled(!a.empty() && !b.empty() && a != b);
  m_contact->setChecked(found == off.end());
}

/// The chosen region and the selection: the one, both, the difference, what they share.
void CouplingPanel::takeRegion() {
  const int part = findPart(m_document.joint(), m_authoring.part());
  const Region* region = part < 0 ? nullptr : findRegion(m_document.joint().parts[part], currentRegion());
  if (!region) return;
  const QString name = anatomyName(region->name);
  const std::vector<int> own = trianglesOf(*region);
  const QScopedValueRollback guard(m_showing, true);  // the list stays as it is while its row is taken
  // Triangles of another surface have nothing in common with what is selected.
  const int how = region->surface == m_authoring.surface() ? m_combine->currentIndex() : 0;
  const std::vector<int> selected = m_authoring.selected();
  m_surface->setCurrentIndex(region->surface == SurfaceKind::Collision ? 1 : 0);
  m_authoring.setTarget(m_authoring.part(), region->surface);
  switch (how) {
    case 1: return m_authoring.select(united(selected, own), tr("Add the region “%1”").arg(name));
    case 2: return m_authoring.select(without(selected, own), tr("Take the region “%1” away").arg(name));
    case 3: return m_authoring.select(common(selected, own), tr("Keep what the region “%1” shares").arg(name));
    default: return m_authoring.select(own, tr("Select the region “%1”").arg(name));
  }
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
  if (picksNodes()) return refreshNodeSelection();
  const auto mesh = m_authoring.mesh();
  const std::vector<int>& selected = m_authoring.selected();
  const bool any = mesh && !selected.empty();
  const QString count = tr("%n triangle(s) selected", nullptr, static_cast<int>(selected.size()));
  const double area = any ? areaOf(*mesh, selected) : 0;
  m_selected->setText(
      any ? tr("%1: %2 mm², %3 % of the surface.")
                .arg(count, number(1e6 * area, 1), number(100 * area / areaOf(*mesh, inverted(*mesh, {})), 1))
          : tr("Nothing is selected. Paint on the part in the view, or take what is near."));
  const std::string region = currentRegion();
  m_newRegion->setEnabled(any);
  m_setRegion->setEnabled(any && !region.empty());
  m_removeRegion->setEnabled(!region.empty() &&
                             !isRegionUsed(m_document.joint(), m_authoring.part(), region));
  m_couple->setEnabled(any && !partB().empty() && partB() != m_authoring.part());
}

void CouplingPanel::refreshStiffness() {
  const double suggested = suggestedStiffness(m_document.joint(), m_authoring.part(), partB());
  // What somebody typed stays; what the program offered follows the pair.
  if (m_suggested == 0 || std::abs(m_stiffness->value() - m_suggested / kPerField) < 1e-4)
    m_stiffness->setValue(suggested / kPerField);
  m_suggested = suggested;
  const double node = suggestedNodeStiffness(m_document.joint(), m_authoring.part(), partB());
  if (m_suggestedNode == 0 || std::abs(m_nodeStiffness->value() - m_suggestedNode / kPerNodeField) < 1e-5) m_nodeStiffness->setValue(node / kPerNodeField);
  m_suggestedNode = node;
  m_nodeStiffness->setToolTip(tr("The materials suggest %1 N/mm: the softer tissue's modulus times the edge of a cell.").arg(number(node / kPerNodeField, 4)));
  m_stiffness->setToolTip(
      tr("The materials suggest %1 N/mm per cm²: the softer tissue's modulus over one cell.")
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
    item->setText(1, coupling.byNodes() ? tr("%n node(s)", nullptr, static_cast<int>(coupling.nodesA.size()))
                                        : anatomyName(region ? region->name : coupling.regionA));
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
  const bool byNodes = any && coupling->byNodes();
  m_takeNodes->setVisible(byNodes);
  m_replaceNodes->setVisible(byNodes);
  m_replaceNodes->setEnabled(byNodes && m_authoring.part() == coupling->partA && !m_authoring.selectedNodes().empty() && m_authoring.selectedNodes() != coupling->nodesA);
  m_ownStiffness->setSuffix(byNodes ? tr(" N/mm per node") : tr(" N/mm per cm²"));
  m_ownStiffness->setAccessibleName(byNodes ? tr("Stiffness of each spring") : tr("Stiffness per area"));
  if (!any) {
    m_detail->setText(tr("Choose a coupling to see its figures."));
    m_ownReason->clear();
    m_authoring.showAnchors({});
    return;
  }
  m_ownStiffness->setValue(byNodes ? coupling->stiffnessPerNode / kPerNodeField : coupling->stiffnessPerArea / kPerField);
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
    m_detail->setText(
        byNodes ? tr("%1 at picked nodes, %2 N/mm in all. They lie %3 mm from the other part on average, %4 mm at most.")
                      .arg(tr("%n spring(s)", nullptr, figures.springs), number(1e-3 * figures.stiffness, 2), number(1e3 * figures.meanGap, 2),
                           number(1e3 * figures.maxGap, 2)) :
        tr("%1 over %2 mm² (%3 % of the part), %4 N/mm in all. The region lies %5 mm from the other part on "
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
    auto* sentence = words("couplings.proposal");
    sentence->setText(
        tr("%1 and %2 are bonded over %3 mm², %4 % of the smaller one and %5 % of what lies near. They need "
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
  if (picksNodes()) return askNearNodes(select);
  const auto mesh = m_authoring.mesh();
  const int other = findPart(m_document.joint(), partB());
  if (!mesh || other < 0 || partB() == m_authoring.part()) return;
  const auto otherMesh = m_document.joint().parts[other].visual;
  if (!otherMesh) return;
  m_nearJob.ask([this, mesh, otherMesh, select, distance = 1e-3 * m_within->value(),
                 target = m_authoring.part(), surface = m_authoring.surface(), limited = m_inSelection->isChecked(),
                 selected = m_authoring.selected()](const std::atomic<bool>&) -> LatestJob::Answer {
    std::vector<int> near = trianglesNear(*mesh, *otherMesh, distance);
    if (limited) near = common(near, selected);
    return [=, this] {
      if (target != m_authoring.part() || surface != m_authoring.surface() || mesh != m_authoring.mesh())
        return;
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
  if (picksNodes()) wish.nodes = m_authoring.selectedNodes();
  else wish.triangles = m_authoring.selected();
  // A region that is exactly what is selected is taken as it is.
  const int part = findPart(m_document.joint(), wish.partA);
  if (part >= 0 && !picksNodes())
    for (const Region& region : m_document.joint().parts[part].regions)
      if (region.surface == wish.surface && trianglesOf(region) == wish.triangles) wish.region = region.id;
  wish.stiffnessPerArea = kPerField * m_stiffness->value();
  wish.stiffnessPerNode = kPerNodeField * m_nodeStiffness->value();
  wish.reason = m_reason->text().toStdString();
  const std::string id = addCoupling(m_document, wish);
  if (id.empty()) return;
  m_reason->clear();
  for (int i = 0; i < m_list->topLevelItemCount(); ++i)
    if (m_list->topLevelItem(i)->data(0, kIdRole).toString() == text(id))
      m_list->setCurrentItem(m_list->topLevelItem(i));
}

void CouplingPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QScrollArea::changeEvent(event);
}

}  // namespace glenoid
