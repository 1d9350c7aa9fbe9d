// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of couplings does where nodes are picked instead of triangles.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <algorithm>

#include "editor/core/AuthorEdits.h"
#include "editor/ui/CouplingPanel.h"
#include "editor/ui/Numbers.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

bool CouplingPanel::isByNodes(const std::string& id) const {
  const auto& all = m_document.joint().couplings;
  return std::any_of(all.begin(), all.end(), [&](const Coupling& c) { return c.id == id && c.byNodes(); });
}

/// Which rows and groups belong to what is picked.
void CouplingPanel::refreshPicking() {
  const bool nodes = picksNodes();
  {
    const QScopedValueRollback guard(m_showing, true);
    m_what->setCurrentIndex(nodes ? 1 : 0);
  }
  m_pickForm->setRowVisible(m_surface, !nodes);
  m_bondForm->setRowVisible(m_stiffness, !nodes);
  m_bondForm->setRowVisible(m_nodeStiffness, nodes);
  m_groups[1]->setVisible(!nodes);  // regions
  m_couple->setText(nodes ? tr("Couple at the selected nodes") : tr("Couple over the selection"));
  refreshSelection();
  showMeaning();
}

void CouplingPanel::refreshNodeSelection() {
  const auto cells = m_authoring.cells();
  const std::vector<int>& nodes = m_authoring.selectedNodes();
  Coupling wish;
  wish.partA = m_authoring.part();
  wish.partB = partB();
  wish.nodesA = nodes;
  const bool pair = !wish.partB.empty() && wish.partB != wish.partA;
  const bool holds = cells && pair && canHoldAt(m_document.joint(), wish);
  const QString count = tr("%n node(s) selected", nullptr, static_cast<int>(nodes.size()));
  if (!cells) m_selected->setText(tr("This part is rigid and has no nodes. Pick on a soft part."));
  else if (nodes.empty()) m_selected->setText(tr("Nothing is selected. Paint over the dots in the view, or take what is near."));
  else if (pair && !holds) m_selected->setText(tr("%1: too few, or in a line. Three that do not lie in a line are needed.").arg(count));
  else m_selected->setText(tr("%1 of %2.").arg(count, number(static_cast<long>(usedNodes(*cells).size()))));
  m_couple->setEnabled(holds);
  showMeaning();
  refreshDetail();
}

void CouplingPanel::askNearNodes(bool select) {
  const auto cells = m_authoring.cells();
  const int other = findPart(m_document.joint(), partB());
  if (!cells || other < 0 || partB() == m_authoring.part()) return;
  const auto surface = m_document.joint().parts[other].visual;
  if (!surface) return;
  m_nearJob.ask([this, cells, surface, select, distance = 1e-3 * m_within->value(), target = m_authoring.part(), limited = m_inSelection->isChecked(),
                 selected = m_authoring.selectedNodes()](const std::atomic<bool>&) -> LatestJob::Answer {
    std::vector<int> near = common(pointsNear(cells->nodes, TriangleTree(*surface), distance), usedNodes(*cells));
    if (limited) near = common(near, selected);
    return [=, this] {
      if (target != m_authoring.part() || cells != m_authoring.cells() || !picksNodes()) return;
      if (!select) return m_authoring.preview(near);
      m_authoring.preview({});
      m_authoring.selectNodes(near, tr("Select what is within %1 mm").arg(number(1e3 * distance, 2)));
    };
  });
}

void CouplingPanel::takeNodes() {
  const auto& all = m_document.joint().couplings;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Coupling& c) { return c.id == currentCoupling(); });
  if (found == all.end() || !found->byNodes()) return;
  const Coupling coupling = *found;
  m_authoring.setTarget(coupling.partA, m_authoring.surface());
  std::vector<int> nodes = coupling.nodesA;
  std::sort(nodes.begin(), nodes.end());
  m_authoring.selectNodes(nodes, tr("Select the nodes of a coupling"));
  m_authoring.setTool(Authoring::Tool::Select);
}

void CouplingPanel::replaceNodes() {
  if (!setCouplingNodes(m_document, currentCoupling(), m_authoring.selectedNodes()))
    m_detail->setText(tr("These nodes cannot hold: three that do not lie in a line are needed."));
}

}  // namespace glenoid
