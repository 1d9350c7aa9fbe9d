// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/ImportDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "editor/core/ImportWords.h"
#include "editor/ui/ImportPicture.h"
#include "simcore/import/LengthUnit.h"

namespace glenoid {
namespace {

enum Column { Name, Triangles, Size, Unit, SideColumn, StateColumn };

struct AxisPreset {
  std::array<const char*, 3> words;
};
constexpr std::array<AxisPreset, 5> kAxes{{{{"x", "y", "z"}}, {{"-y", "z", "-x"}}, {{"y", "z", "x"}}, {{"z", "y", "-x"}}, {{"x", "z", "-y"}}}};

AxisMap mapOf(const AxisPreset& preset, bool mirrored) {
  AxisMap map = *axisMapFrom({preset.words[0], preset.words[1], preset.words[2]});
  if (mirrored) map.sign[2] = -map.sign[2];
  return map;
}

}  // namespace

ImportDialog::ImportDialog(Document& document, const QStringList& files, QWidget* parent) : QDialog(parent), m_document(document) {
  setObjectName(QStringLiteral("importDialog"));
  setWindowTitle(tr("Import surfaces"));
  setAcceptDrops(true);
  resize(1280, 760);
  auto* layout = new QVBoxLayout(this);
  auto* top = new QSplitter(Qt::Horizontal);
  auto* left = new QWidget;
  auto* leftLayout = new QVBoxLayout(left);
  leftLayout->setContentsMargins(0, 0, 0, 0);
  leftLayout->addWidget(makeTable(), 1);
  leftLayout->addWidget(makeWishes());
  top->addWidget(left);
  top->addWidget(makeDetails());
  top->setStretchFactor(0, 1);
  top->setStretchFactor(1, 1);
  layout->addWidget(top, 1);

  m_state = new QLabel;
  m_state->setObjectName(QStringLiteral("import.state"));
  m_state->setWordWrap(true);
  m_progress = new QProgressBar;
  m_progress->setRange(0, 0);
  m_progress->setMaximumWidth(160);
  m_stop = new QPushButton(tr("Stop &reading"));
  m_stop->setObjectName(QStringLiteral("import.stop"));
  connect(m_stop, &QPushButton::clicked, &m_session, &ImportSession::cancel);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  m_import = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
  m_import->setObjectName(QStringLiteral("import.accept"));
  buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("import.cancel"));
  connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(m_state, 1);
  bottom->addWidget(m_progress);
  bottom->addWidget(m_stop);
  bottom->addWidget(buttons);
  layout->addLayout(bottom);

  connect(&m_session, &ImportSession::rowsChanged, this, &ImportDialog::refreshTable);
  connect(&m_session, &ImportSession::rowChanged, this, &ImportDialog::refreshRow);
  connect(&m_session, &ImportSession::busyChanged, this, &ImportDialog::refreshState);
  m_session.add(files);
  refreshTable();
}

// ---- Widgets

QWidget* ImportDialog::makeTable() {
  m_table = new QTreeWidget;
  m_table->setObjectName(QStringLiteral("import.table"));
  m_table->setAccessibleName(tr("Surfaces that arrived"));
  m_table->setRootIsDecorated(false);
  m_table->setHeaderLabels({tr("Surface"), tr("Triangles"), tr("Size"), tr("Unit"), tr("Side"), tr("State")});
  m_table->header()->setSectionResizeMode(Name, QHeaderView::Interactive);
  m_table->setColumnWidth(Name, 150);
  m_table->setColumnWidth(Triangles, 70);
  m_table->setColumnWidth(Size, 150);
  m_table->setColumnWidth(Unit, 85);
  m_table->setColumnWidth(SideColumn, 65);
  m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  connect(m_table, &QTreeWidget::currentItemChanged, this, [this] {
    if (!m_filling) refreshDetails();
  });
  connect(m_table, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (m_filling || column != Name) return;
    const int row = m_table->indexOfTopLevelItem(item);
    m_session.setWanted(row, item->checkState(Name) == Qt::Checked);
    m_session.setName(row, item->text(Name));
    refreshRow(row);
  });
  return m_table;
}

QWidget* ImportDialog::makeDetails() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_picture = new ImportPicture;
  m_picture->setObjectName(QStringLiteral("import.picture"));
  m_picture->setAccessibleName(tr("Picture of the surface"));
  layout->addWidget(m_picture, 3);
  m_showResult = new QCheckBox(tr("Show what it &becomes"));
  m_showResult->setObjectName(QStringLiteral("import.showResult"));
  connect(m_showResult, &QCheckBox::toggled, this, &ImportDialog::refreshMarks);
  layout->addWidget(m_showResult);
  m_findings = new QTreeWidget;
  m_findings->setObjectName(QStringLiteral("import.findings"));
  m_findings->setAccessibleName(tr("What was found, and repairs"));
  m_findings->setRootIsDecorated(false);
  m_findings->setWordWrap(true);
  m_findings->setHeaderLabels({tr("Found"), tr("Repair")});
  m_findings->header()->setSectionResizeMode(QHeaderView::Stretch);
  connect(m_findings->header(), &QHeaderView::sectionResized, m_findings, [this] { m_findings->doItemsLayout(); });  // words wrap anew
  connect(m_findings, &QTreeWidget::currentItemChanged, this, [this] {
    if (!m_filling) refreshMarks();
  });
  connect(m_findings, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!m_filling) takeFindings(item);
  });
  layout->addWidget(m_findings, 2);
  m_notes = new QLabel;
  m_notes->setObjectName(QStringLiteral("import.notes"));
  m_notes->setWordWrap(true);
  m_notes->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(m_notes);
  return box;
}

QWidget* ImportDialog::makeWishes() {
  auto* box = new QWidget;
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  m_unit = new QComboBox;
  m_unit->setObjectName(QStringLiteral("import.unit"));
  for (const LengthUnit& unit : kLengthUnits) m_unit->addItem(unitName(unit.metres), unit.metres);
  connect(m_unit, &QComboBox::activated, this, [this](int index) {
    if (chosen() >= 0) m_session.setUnit(chosen(), m_unit->itemData(index).toDouble());
  });
  m_unitReason = new QLabel;
  m_unitReason->setObjectName(QStringLiteral("import.unitReason"));
  m_unitReason->setWordWrap(true);
  form->addRow(tr("&Unit of the file"), m_unit);
  form->addRow(QString(), m_unitReason);
  m_axes = new QComboBox;
  m_axes->setObjectName(QStringLiteral("import.axes"));
  m_axes->addItems({tr("As here: X forward, Y up, Z to the right"), tr("Atlas or scanner (LPS): Z up, Y backward, right is −X"),
                    tr("Scanner (RAS): Z up, Y forward, right is +X"), tr("Figures that face +Z: Y up, right is −X"), tr("Z up, X forward, right is −Y")});
  connect(m_axes, &QComboBox::activated, this, &ImportDialog::wishAxes);
  form->addRow(tr("A&xes of the file"), m_axes);
  m_mirror = new QCheckBox(tr("It is of a &left side: mirror it"));
  m_mirror->setObjectName(QStringLiteral("import.mirror"));
  connect(m_mirror, &QCheckBox::clicked, this, &ImportDialog::wishAxes);
  form->addRow(QString(), m_mirror);
  m_size = new QLabel;
  m_size->setObjectName(QStringLiteral("import.size"));
  form->addRow(tr("Size that results"), m_size);
  m_forAll = new QPushButton(tr("Unit and axes for &all"));
  m_forAll->setObjectName(QStringLiteral("import.forAll"));
  connect(m_forAll, &QPushButton::clicked, this, [this] {
    const int from = chosen();
    if (from < 0) return;
    const ImportSession::Row model = m_session.rows()[from];
    for (int row = 0; row < static_cast<int>(m_session.rows().size()); ++row) {
      m_session.setUnit(row, model.metres);
      m_session.setAxes(row, model.axes);
    }
  });
  form->addRow(QString(), m_forAll);
  m_thin = new QDoubleSpinBox;
  m_thin->setObjectName(QStringLiteral("import.thin"));
  m_thin->setRange(0.1, 20);
  m_thin->setSingleStep(0.1);
  m_thin->setSuffix(tr(" mm"));
  m_thin->setValue(1e3 * m_session.thinLimit());
  m_thin->setKeyboardTracking(false);
  connect(m_thin, &QDoubleSpinBox::valueChanged, this, [this](double mm) { m_session.setThinLimit(1e-3 * mm); });
  form->addRow(tr("&Thin is less than"), m_thin);
  auto* row = new QHBoxLayout;
  for (int k = 0; k < 3; ++k) {
    m_shift[k] = new QDoubleSpinBox;
    m_shift[k]->setObjectName(QStringLiteral("import.shift%1").arg(k));
    m_shift[k]->setRange(-100000, 100000);
    m_shift[k]->setSuffix(tr(" mm"));
    m_shift[k]->setKeyboardTracking(false);
    m_shift[k]->setAccessibleName(QStringList{tr("Shift forward"), tr("Shift up"), tr("Shift to the side")}[k]);
    connect(m_shift[k], &QDoubleSpinBox::valueChanged, this, [this] {
      if (!m_filling) m_session.setShift(1e-3 * Vec3(m_shift[0]->value(), m_shift[1]->value(), m_shift[2]->value()));
    });
    row->addWidget(m_shift[k]);
  }
  auto* centre = new QPushButton(tr("&Centre"));
  centre->setObjectName(QStringLiteral("import.centre"));
  connect(centre, &QPushButton::clicked, this, [this] {
    const Vec3 mm = 1e3 * m_session.centringShift_W();
    for (int k = 0; k < 3; ++k) m_shift[k]->setValue(mm[k]);
  });
  row->addWidget(centre);
  form->addRow(tr("Shift of all"), row);
  return box;
}

// ---- What is shown

int ImportDialog::chosen() const {
  const int row = m_table->indexOfTopLevelItem(m_table->currentItem());
  return row < static_cast<int>(m_session.rows().size()) ? row : -1;
}

void ImportDialog::refreshTable() {
  const int before = std::max(0, chosen());
  m_filling = true;
  m_table->clear();
  for (std::size_t i = 0; i < m_session.rows().size(); ++i) m_table->addTopLevelItem(new QTreeWidgetItem);
  m_filling = false;
  for (std::size_t i = 0; i < m_session.rows().size(); ++i) refreshRow(static_cast<int>(i));
  if (m_table->topLevelItemCount() > 0) m_table->setCurrentItem(m_table->topLevelItem(std::min(before, m_table->topLevelItemCount() - 1)));
  refreshDetails();
}

void ImportDialog::refreshRow(int row) {
  QTreeWidgetItem* item = m_table->topLevelItem(row);
  if (!item || row >= static_cast<int>(m_session.rows().size())) return;
  const ImportSession::Row& from = m_session.rows()[row];
  m_filling = true;
  item->setText(Name, from.name);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable | (from.mesh ? Qt::ItemIsUserCheckable : Qt::NoItemFlags));
  item->setCheckState(Name, from.wanted && from.mesh ? Qt::Checked : Qt::Unchecked);
  item->setText(Triangles, from.mesh ? QLocale().toString(static_cast<qlonglong>((from.result ? from.result : from.mesh)->triangles.size())) : QString());
  item->setText(Size, from.result ? sizeSentence(boundsOf(*from.result)) : QString());
  item->setText(Unit, from.mesh ? unitName(from.metres) : QString());
  item->setText(SideColumn, from.mesh ? sideSentence(from.found.side.side) : QString());
  item->setText(StateColumn, stateSentence(from));
  item->setToolTip(Name, from.file);
  item->setToolTip(StateColumn, from.problem);
  m_filling = false;
  if (row == chosen()) refreshDetails();
  refreshState();
}

void ImportDialog::refreshDetails() {
  const int row = chosen();
  m_filling = true;
  const bool any = row >= 0 && m_session.rows()[row].mesh;
  for (QWidget* widget : {static_cast<QWidget*>(m_unit), static_cast<QWidget*>(m_axes), static_cast<QWidget*>(m_mirror), static_cast<QWidget*>(m_forAll)}) widget->setEnabled(any);
  if (any) {
    const ImportSession::Row& from = m_session.rows()[row];
    int unit = -1;
    for (int i = 0; i < m_unit->count(); ++i)
      if (std::abs(m_unit->itemData(i).toDouble() / from.metres - 1) < 1e-3) unit = i;
    if (unit < 0) {  // a scale of the file's own
      m_unit->addItem(unitName(from.metres), from.metres);
      unit = m_unit->count() - 1;
    }
    m_unit->setCurrentIndex(unit);
    m_unitReason->setText(unitReason(from.guess, from.namedUnit.has_value()));
    for (int i = 0; i < static_cast<int>(kAxes.size()); ++i)
      for (const bool mirrored : {false, true})
        if (mapOf(kAxes[i], mirrored) == from.axes) {
          m_axes->setCurrentIndex(i);
          m_mirror->setChecked(mirrored);
        }
    m_size->setText(from.result ? sizeSentence(boundsOf(*from.result)) : QString());
  } else {
    m_unitReason->clear();
    m_size->clear();
  }
  QStringList notes;
  if (row >= 0) {
    if (!m_session.rows()[row].problem.isEmpty()) notes << m_session.rows()[row].problem;
    for (const NoteCount& note : m_session.rows()[row].notes) notes << noteSentence(note);
  }
  m_notes->setText(notes.join(QLatin1Char(' ')));
  m_filling = false;
  refreshFindings();
}

void ImportDialog::refreshFindings() {
  const int row = chosen(), before = m_findings->indexOfTopLevelItem(m_findings->currentItem());
  m_filling = true;
  m_findings->clear();
  if (row >= 0 && m_session.rows()[row].mesh) {
    const ImportSession::Row& from = m_session.rows()[row];
    for (const Finding& finding : from.found.findings) {
      auto* item = new QTreeWidgetItem({findingSentence(finding, from.metres), repairSentence(finding, from.metres)});
      item->setData(0, Qt::UserRole, static_cast<int>(finding.kind));
      item->setToolTip(0, item->text(0));
      item->setToolTip(1, item->text(1));
      if (!finding.repairs.empty()) item->setCheckState(1, from.repairs.count(finding.kind) ? Qt::Checked : Qt::Unchecked);
      m_findings->addTopLevelItem(item);
    }
    if (from.found.findings.empty()) m_findings->addTopLevelItem(new QTreeWidgetItem({tr("Nothing is wrong with it."), QString()}));
  }
  if (before >= 0 && before < m_findings->topLevelItemCount()) m_findings->setCurrentItem(m_findings->topLevelItem(before));
  m_filling = false;
  refreshMarks();
}

void ImportDialog::refreshMarks() {
  const int row = chosen();
  if (row < 0) return m_picture->show(nullptr);
  const ImportSession::Row& from = m_session.rows()[row];
  m_showResult->setEnabled(from.result != nullptr);
  if (m_showResult->isChecked() && from.result) return m_picture->show(from.result);
  m_picture->show(from.mesh);
  std::vector<int> marked;
  const QTreeWidgetItem* item = m_findings->currentItem();
  // Where nothing is chosen, what is wrong in places; a whole shell in orange says little.
  const auto inPlaces = [](const Finding& finding) {
    return finding.severity == FindingSeverity::Blocks && finding.kind != FindingKind::InsideOut && finding.kind != FindingKind::Sheets;
  };
  for (const Finding& finding : from.found.findings)
    if (item ? item->data(0, Qt::UserRole) == static_cast<int>(finding.kind) : inPlaces(finding))
      marked.insert(marked.end(), finding.triangles.begin(), finding.triangles.end());
  std::sort(marked.begin(), marked.end());
  m_picture->mark(std::move(marked));
}

void ImportDialog::refreshState() {
  const bool busy = m_session.busy();
  m_progress->setVisible(busy);
  m_stop->setVisible(busy);
  const int ready = m_session.ready();
  m_import->setEnabled(!busy && ready > 0);
  int unsound = 0, failed = 0;
  for (const ImportSession::Row& row : m_session.rows()) {
    unsound += row.wanted && row.state == ImportSession::State::Ready && !row.after.healthy();
    failed += row.state == ImportSession::State::Failed;
  }
  QStringList sentences;
  if (busy) sentences << tr("Files are being read and judged…");
  else sentences << tr("%n surface(s) will be added as rigid parts.", nullptr, ready);
  if (failed > 0) sentences << tr("%n could not be read.", nullptr, failed);
  if (unsound > 0) sentences << tr("%n of them are not sound: the joint will not run before that is mended.", nullptr, unsound);
  m_state->setText(sentences.join(QLatin1Char(' ')));
}

// ---- What is wished

void ImportDialog::takeFindings(QTreeWidgetItem* item) {
  if (chosen() < 0 || !item->data(0, Qt::UserRole).isValid()) return;
  const auto kind = static_cast<FindingKind>(item->data(0, Qt::UserRole).toInt());
  const bool on = item->checkState(1) == Qt::Checked;
  // Later: the list is made anew, and the view is still busy with the item that was clicked.
  QMetaObject::invokeMethod(this, [this, row = chosen(), kind, on] {
    if (row < static_cast<int>(m_session.rows().size())) m_session.setRepair(row, kind, on);
  }, Qt::QueuedConnection);
}

void ImportDialog::wishAxes() {
  if (m_filling || chosen() < 0) return;
  m_session.setAxes(chosen(), mapOf(kAxes[static_cast<std::size_t>(std::max(0, m_axes->currentIndex()))], m_mirror->isChecked()));
}

void ImportDialog::accept() {
  const std::vector<std::string> ids = m_session.apply(m_document);
  if (ids.empty()) return;
  QStringList parts;
  for (const std::string& id : ids) parts << QString::fromStdString(id);
  emit imported(parts);
  QDialog::accept();
}

void ImportDialog::reject() {
  m_session.cancel();
  QDialog::reject();
}

void ImportDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ImportDialog::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  m_session.add(files);
  event->acceptProposedAction();
}

}  // namespace glenoid
