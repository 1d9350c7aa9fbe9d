// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/ToolPanel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/ui/Numbers.h"
#include "editor/ui/Theme.h"

namespace glenoid {
namespace {

QString iconName(ToolKind kind) {
  switch (kind) {
    case ToolKind::Probe: return QStringLiteral("tool-probe");
    case ToolKind::Arthroscope: return QStringLiteral("tool-arthroscope");
    case ToolKind::Finger: return QStringLiteral("tool-finger");
    case ToolKind::Ball: return QStringLiteral("tool-ball");
    case ToolKind::Bar: return QStringLiteral("tool-bar");
  }
  return {};
}

}  // namespace

ToolPanel::ToolPanel(Document& document, PlayLink& link, QWidget* parent)
    : QWidget(parent), m_document(document), m_link(link) {
  m_list = new QWidget;
  m_listLayout = new QVBoxLayout(m_list);
  m_listLayout->setContentsMargins(0, 0, 0, 0);
  m_hint = new QLabel;
  m_hint->setWordWrap(true);
  m_hint->setProperty("role", QStringLiteral("hint"));
  m_follow = new QCheckBox;
  m_follow->setObjectName(QStringLiteral("followRecording"));
  m_follow->setChecked(link.followsRecording());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_list);
  layout->addWidget(m_follow);
  layout->addWidget(m_hint);
  layout->addStretch(1);
  connect(m_follow, &QCheckBox::toggled, &link, &PlayLink::setFollowRecording);
  connect(&link, &PlayLink::followChanged, m_follow, [this] { m_follow->setChecked(m_link.followsRecording()); });
  connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (changes.everything) rebuild();
  });
  connect(&link, &PlayLink::snapshotChanged, this, &ToolPanel::showForces);
  rebuild();
}

void ToolPanel::rebuild() {
  m_buttons.clear();
  m_forces.clear();
  while (QLayoutItem* item = m_listLayout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  m_chosen = -1;
  const auto& tools = m_document.scenario().tools;
  for (int i = 0; i < static_cast<int>(tools.size()); ++i) {
    auto* row = new QWidget;
    auto* rowLayout = new QHBoxLayout(row);
    rowLayout->setContentsMargins(0, 0, 0, 0);
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("tool.") + QString::fromStdString(tools[i].id));
    button->setIcon(themedIcon(iconName(tools[i].kind)));
    button->setText(QString::fromStdString(tools[i].name));
    button->setAccessibleName(button->text());
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, [this, i](bool on) { emit chosen(on ? i : -1); });
    auto* force = new QLabel;
    force->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00.00 N ")));
    force->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    rowLayout->addWidget(button, 1);
    rowLayout->addWidget(force);
    m_listLayout->addWidget(row);
    m_buttons.push_back(button);
    m_forces.push_back(force);
  }
  retranslate();
  showForces();
}

void ToolPanel::setChosen(int tool) {
  m_chosen = tool;
  for (int i = 0; i < static_cast<int>(m_buttons.size()); ++i) m_buttons[i]->setChecked(i == tool);
}

void ToolPanel::showForces() {
  const StepReport& report = m_link.snapshot().report;
  for (std::size_t i = 0; i < m_forces.size(); ++i) {
    const double force = i < report.toolForces.size() ? report.toolForces[i].norm() : 0;
    const QString words = tr("%1 N").arg(number(force, 2));
    if (m_forces[i]->text() != words) m_forces[i]->setText(words);  // a label repaints even for the same text
  }
}

void ToolPanel::retranslate() {
  const bool some = !m_buttons.empty();
  m_hint->setText(some ? tr("Choose a tool, then drag with the left button in the view. The wheel moves it in "
                            "depth while you drag, Ctrl+wheel at any time.")
                       : tr("This scene has no tools."));
  m_follow->setText(tr("&Follow the recorded input"));
  m_follow->setToolTip(tr("Tools that nobody holds move as they were recorded"));
  m_follow->setEnabled(m_link.hasRecording());
  for (QLabel* force : m_forces) force->setToolTip(tr("Contact force on this tool"));
  for (QToolButton* button : m_buttons) button->setToolTip(tr("Move this tool with the mouse"));
}

void ToolPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    showForces();
  }
  QWidget::changeEvent(event);
}

}  // namespace glenoid
