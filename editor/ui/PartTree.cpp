// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/PartTree.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSlider>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/core/AnatomyNames.h"
#include "editor/ui/Numbers.h"
#include "editor/ui/Theme.h"

namespace glenoid {
namespace {

constexpr int kIdRole = Qt::UserRole;

QIcon colorIcon(const std::array<float, 3>& color) {
  QPixmap pixmap(32, 32);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(128, 128, 128), 1.5));
  painter.setBrush(QColor::fromRgbF(color[0], color[1], color[2]));
  painter.drawEllipse(5, 5, 22, 22);
  return QIcon(pixmap);
}

const char* toolIcon(ToolKind kind) {
  switch (kind) {
    case ToolKind::Probe: return "tool-probe";
    case ToolKind::Arthroscope: return "tool-arthroscope";
    case ToolKind::Finger: return "tool-finger";
    case ToolKind::Ball: return "tool-ball";
    case ToolKind::Bar: return "tool-bar";
  }
  return "tool-probe";
}

}  // namespace

PartTree::PartTree(Document& document, DisplayState& display, Selection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_display(display), m_selection(selection) {
  m_tree = new QTreeWidget;
  m_tree->setObjectName(QStringLiteral("partTree"));
  m_tree->setHeaderHidden(true);
  m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_tree->setRootIsDecorated(true);
  m_tree->setIndentation(14);
  m_tree->setUniformRowHeights(true);
  m_opacityLabel = new QLabel;
  m_opacity = new QSlider(Qt::Horizontal);
  m_opacity->setObjectName(QStringLiteral("opacity"));
  m_opacity->setRange(0, 100);
  m_opacity->setPageStep(25);
  m_opacityLabel->setBuddy(m_opacity);
  m_solo = new QPushButton(themedIcon(QStringLiteral("solo")), {});
  m_solo->setObjectName(QStringLiteral("solo"));
  m_solo->setCheckable(true);
  m_showAll = new QPushButton(themedIcon(QStringLiteral("eye")), {});
  m_showAll->setObjectName(QStringLiteral("showAll"));

  auto* opacityRow = new QHBoxLayout;
  opacityRow->addWidget(m_opacityLabel);
  opacityRow->addWidget(m_opacity, 1);
  auto* buttonRow = new QHBoxLayout;
  buttonRow->addWidget(m_solo);
  buttonRow->addWidget(m_showAll);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_tree, 1);
  layout->addLayout(opacityRow);
  layout->addLayout(buttonRow);

  connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (changes.everything || !changes.parts.empty()) rebuild();
  });
  connect(&display, &DisplayState::changed, this, &PartTree::showDisplay);
  connect(&selection, &Selection::changed, this, &PartTree::showSelection);
  connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    const std::string id = item->data(0, kIdRole).toString().toStdString();
    if (!m_showing && !id.empty()) m_display.setVisible(id, item->checkState(0) == Qt::Checked);
  });
  connect(m_tree, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (m_showing) return;
    std::set<std::string> ids;
    for (const QTreeWidgetItem* item : m_tree->selectedItems()) {
      const std::string id = item->data(0, kIdRole).toString().toStdString();
      if (!id.empty()) ids.insert(id);
    }
    const QTreeWidgetItem* current = m_tree->currentItem();
    std::string currentId = current ? current->data(0, kIdRole).toString().toStdString() : std::string();
    if (ids.count(currentId) == 0) currentId = ids.empty() ? std::string() : *ids.begin();
    m_selection.assign(std::move(ids), currentId);
  });
  connect(m_opacity, &QSlider::valueChanged, this, [this](int percent) {
    if (m_showing) return;
    for (const std::string& id : m_selection.ids()) m_display.setOpacity(id, percent / 100.0);
  });
  connect(m_solo, &QPushButton::clicked, this, [this](bool on) {
    m_display.solo(on ? m_selection.ids() : std::set<std::string>{});
  });
  connect(m_showAll, &QPushButton::clicked, &display, &DisplayState::showAll);
  rebuild();
}

QTreeWidgetItem* PartTree::group(const QString& key, const char* icon) {
  auto* item = new QTreeWidgetItem(m_tree, {key});
  item->setIcon(0, themedTreeIcon(QLatin1String(icon)));
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
  QFont font = item->font(0);
  font.setBold(true);
  item->setFont(0, font);
  item->setExpanded(true);
  return item;
}

void PartTree::rebuild() {
  const QScopedValueRollback guard(m_showing, true);
  m_tree->clear();
  m_items.clear();
  QTreeWidgetItem* rigid = group(tr("Rigid parts"), "bone");
  QTreeWidgetItem* soft = group(tr("Soft parts"), "soft");
  QTreeWidgetItem* tools = group(tr("Tools"), "tool-probe");
  const auto add = [this](QTreeWidgetItem* parent, const std::string& id, const QString& name, const QIcon& icon) {
    auto* item = new QTreeWidgetItem(parent, {name});
    item->setData(0, kIdRole, QString::fromStdString(id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setIcon(0, icon);
    item->setCheckState(0, Qt::Checked);
    m_items[id] = item;
  };
  for (const Part& part : m_document.joint().parts) {
    add(part.kind == PartKind::Rigid ? rigid : soft, part.id,
        QStringLiteral("%1  %2").arg(part.number).arg(anatomyName(part.name)), colorIcon(part.color));
  }
  for (const Tool& tool : m_document.scenario().tools) {
    add(tools, tool.id, QString::fromStdString(tool.name), themedTreeIcon(QLatin1String(toolIcon(tool.kind))));
  }
  for (QTreeWidgetItem* item : {rigid, soft, tools}) item->setHidden(item->childCount() == 0);
  retranslate();
  showDisplay();
  showSelection();
}

void PartTree::retranslate() {
  const QScopedValueRollback guard(m_showing, true);
  const QStringList names = {tr("Rigid parts"), tr("Soft parts"), tr("Tools")};
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) m_tree->topLevelItem(i)->setText(0, names.value(i));
  m_tree->setAccessibleName(tr("Parts and tools"));
  m_tree->setStatusTip(tr("Check a part to see it; click selects, Ctrl and Shift select several."));
  m_opacityLabel->setText(tr("&Opacity"));
  m_opacity->setAccessibleName(tr("Opacity of the selected parts"));
  m_opacity->setToolTip(tr("How solid the selected parts are drawn"));
  m_solo->setText(tr("S&olo"));
  m_solo->setToolTip(tr("Show only the selected parts"));
  m_showAll->setText(tr("Show &all"));
  m_showAll->setToolTip(tr("Make every part visible and solid again"));
}

void PartTree::showDisplay() {
  const QScopedValueRollback guard(m_showing, true);
  for (const auto& [id, item] : m_items) {
    item->setCheckState(0, m_display.isVisible(id) ? Qt::Checked : Qt::Unchecked);
  }
  m_solo->setChecked(!m_display.soloed().empty());
  m_solo->setEnabled(!m_selection.ids().empty() || m_solo->isChecked());
  const bool some = !m_selection.current().empty();
  m_opacity->setEnabled(some);
  m_opacity->setValue(some ? static_cast<int>(100 * m_display.opacity(m_selection.current()) + 0.5) : 100);
}

void PartTree::showSelection() {
  {
    const QScopedValueRollback guard(m_showing, true);
    for (const auto& [id, item] : m_items) item->setSelected(m_selection.contains(id));
    if (QTreeWidgetItem* current = itemOf(m_selection.current())) {
      m_tree->setCurrentItem(current, 0, QItemSelectionModel::NoUpdate);
      m_tree->scrollToItem(current);
    }
  }
  showDisplay();
}

QTreeWidgetItem* PartTree::itemOf(const std::string& id) const {
  const auto found = m_items.find(id);
  return found == m_items.end() ? nullptr : found->second;
}

void PartTree::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) rebuild();  // names of parts too
  QWidget::changeEvent(event);
}

}  // namespace glenoid
