// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ImportSession.h"

#include <QFileInfo>
#include <QThreadPool>
#include <algorithm>

#include "editor/core/AuthorEdits.h"
#include "editor/core/Sentences.h"
#include "simcore/repair/GuessUnit.h"

namespace glenoid {
namespace {

DiagnosisOptions optionsFor(const QString& file, const std::string& surface, std::optional<double> metres, double thinLimit) {
  DiagnosisOptions options;
  options.name = surface + " " + QFileInfo(file).completeBaseName().toStdString();
  options.metresPerUnit = metres;
  options.thinLimit = thinLimit;
  return options;
}

/// Letters, digits and hyphens of a name, and a number where that is taken.
std::string partIdFor(const QString& name, const Joint& joint) {
  std::string id;
  for (const QChar c : name.toLower().normalized(QString::NormalizationForm_D)) {
    if (c.unicode() < 128 && c.isLetterOrNumber()) id += static_cast<char>(c.unicode());
    else if (c.category() != QChar::Mark_NonSpacing && !id.empty() && id.back() != '-') id += '-';
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  if (id.empty()) id = "part";
  if (id.size() > 60) id.resize(60);
  std::string fresh = id;
  for (int i = 2; findPart(joint, fresh) >= 0; ++i) fresh = id + "-" + std::to_string(i);
  return fresh;
}

/// What bones are made of: the joint's own, or a new one of the literature's figures.
std::string boneOf(Joint& joint) {
  for (const Material& material : joint.materials)
    if (material.appearance == Appearance::Bone) return material.id;
  if (const int index = findMaterial(joint, "bone"); index >= 0) return "bone";
  Material bone;
  bone.id = "bone";
  bone.name = "Cortical bone";
  bone.appearance = Appearance::Bone;
  bone.density = 1900;
  bone.youngsModulus = 15e9;
  bone.poissonRatio = 0.3;
  bone.friction = 0.01;
  bone.source = "Rho, Ashman and Turner 1993, doi 10.1016/0021-9290(93)90042-D";
  joint.materials.push_back(bone);
  return bone.id;
}

}  // namespace

ImportSession::ImportSession(ImportLimits limits, QObject* parent)
    : QObject(parent), m_limits(std::move(limits)), m_mailbox(std::make_shared<Mailbox>()) {
  m_mailbox->session = this;
}

ImportSession::~ImportSession() {
  m_mailbox->stop = true;
  const std::lock_guard lock(m_mailbox->mutex);
  m_mailbox->session = nullptr;
}

/// `work` answers what is to be done with its result on the GUI thread; that is left out when the session is gone.
template <class Work>
void ImportSession::onWorker(Work work) {
  if (m_working++ == 0) emit busyChanged();
  QThreadPool::globalInstance()->start([mailbox = m_mailbox, work = std::move(work)] {
    auto answer = work(mailbox->stop);
    const std::lock_guard lock(mailbox->mutex);
    if (!mailbox->session) return;
    QMetaObject::invokeMethod(
        mailbox->session,
        [session = mailbox->session, answer = std::move(answer)]() mutable {
          if (--session->m_working == 0) emit session->busyChanged();
          answer(*session);
        },
        Qt::QueuedConnection);
  });
}

bool ImportSession::busy() const { return m_working > 0; }

int ImportSession::rowOf(long key) const {
  const auto found = std::find(m_keys.begin(), m_keys.end(), key);
  return found == m_keys.end() ? -1 : static_cast<int>(found - m_keys.begin());
}

void ImportSession::add(const QStringList& files) {
  for (const QString& file : files) {
    m_keys.push_back(++m_lastKey);
    m_rows.emplace_back();
    m_rows.back().file = file;
    m_rows.back().name = QFileInfo(file).completeBaseName();
    read(file, m_lastKey);
  }
  if (!files.isEmpty()) emit rowsChanged();
}

void ImportSession::read(const QString& file, long key) {
  onWorker([file, key, limits = m_limits, thinLimit = m_thinLimit](const std::atomic<bool>& stop) {
    ImportLimits own = limits;
    own.cancelled = [&stop] { return stop.load(); };
    auto read = std::make_shared<Result<ImportedFile>>(importSurfaces(file.toStdString(), own));
    auto found = std::make_shared<std::vector<SurfaceDiagnosis>>();
    if (*read) {
      DiagnosisOptions options;
      options.thinLimit = thinLimit;
      options.cancelled = own.cancelled;
      *found = diagnoseFile(**read, QFileInfo(file).completeBaseName().toStdString(), options);
    }
    return [key, read, found](ImportSession& session) { session.took(key, std::move(*read), std::move(*found)); };
  });
}

void ImportSession::took(long key, Result<ImportedFile> file, std::vector<SurfaceDiagnosis> found) {
  const int at = rowOf(key);
  if (at < 0 || m_rows[at].state != State::Reading) return;
  if (!file) {
    m_rows[at].state = State::Failed;
    m_rows[at].wanted = false;
    m_rows[at].problem = sentenceOf(file.error());
    emit rowChanged(at);
    return;
  }
  const Row whole = m_rows[at];
  std::vector<Row> rows;
  for (std::size_t i = 0; i < file->surfaces.size(); ++i) {
    Row row = whole;
    row.state = State::Working;
    row.format = QString::fromStdString(file->format);
    row.notes = file->notes;
    row.namedUnit = file->metresPerUnit;
    row.axes = proposedAxes(file->axes);
    const QString name = QString::fromStdString(file->surfaces[i].name).trimmed();
    if (file->surfaces.size() > 1 && !name.isEmpty()) row.name = name;
    row.mesh = std::make_shared<const TriMesh>(std::move(file->surfaces[i].mesh));
    row.found = std::move(found[i]);
    row.guess = row.found.unit;
    if (row.found.unit.metres > 0) row.metres = row.found.unit.metres;
    row.wanted = !row.found.find(FindingKind::CannotBeRead);
    for (const Finding& finding : row.found.findings)
      if (finding.harmless) row.repairs.insert(finding.kind);
    rows.push_back(std::move(row));
  }
  m_rows.erase(m_rows.begin() + at);
  m_keys.erase(m_keys.begin() + at);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    m_keys.insert(m_keys.begin() + at + static_cast<std::ptrdiff_t>(i), ++m_lastKey);
    m_rows.insert(m_rows.begin() + at + static_cast<std::ptrdiff_t>(i), std::move(rows[i]));
  }
  emit rowsChanged();
  for (std::size_t i = 0; i < rows.size(); ++i) remake(at + static_cast<int>(i), false);
}

void ImportSession::remake(int row, bool judgeAgain) {
  Row& made = m_rows[row];
  if (!made.mesh) return;
  made.state = State::Working;
  made.result = nullptr;
  const long generation = ++made.generation, key = m_keys[row];
  const DiagnosisOptions options = optionsFor(made.file, made.name.toStdString(), made.metres, m_thinLimit);
  onWorker([=, mesh = made.mesh, found = made.found, chosen = made.repairs, metres = made.metres, axes = made.axes](const std::atomic<bool>& stop) {
    struct Made {
      SurfaceDiagnosis found, after;
      std::vector<RepairChange> changes;
      std::shared_ptr<const TriMesh> result;
      QString problem;
    };
    auto out = std::make_shared<Made>();
    DiagnosisOptions own = options;
    own.cancelled = [&stop] { return stop.load(); };
    out->found = judgeAgain ? diagnose(*mesh, own) : found;
    auto outcome = repair(*mesh, repairsFor(out->found, chosen));
    if (outcome) {
      out->changes = std::move(outcome->changes);
      out->result = std::make_shared<const TriMesh>(placed(outcome->mesh, metres, axes, Vec3::Zero()));
      own.metresPerUnit = 1;
      out->after = diagnose(*out->result, own);
    } else {
      out->problem = sentenceOf(outcome.error());
    }
    return [=](ImportSession& session) {
      const int at = session.rowOf(key);
      if (at < 0 || session.m_rows[at].generation != generation) return;  // a newer decision is being worked on
      Row& now = session.m_rows[at];
      now.found = std::move(out->found);
      now.after = std::move(out->after);
      now.changes = std::move(out->changes);
      now.result = std::move(out->result);
      now.problem = out->problem;
      now.state = now.result ? State::Ready : State::Failed;
      emit session.rowChanged(at);
    };
  });
  emit rowChanged(row);
}

void ImportSession::cancel() {
  {
    const std::lock_guard lock(m_mailbox->mutex);
    m_mailbox->stop = true;
    m_mailbox->session = nullptr;  // answers that are on their way stay there
  }
  m_mailbox = std::make_shared<Mailbox>();
  m_mailbox->session = this;
  const bool was = m_working > 0;
  m_working = 0;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    Row& row = m_rows[i];
    if (row.state != State::Reading && row.state != State::Working) continue;
    row.state = State::Failed;
    row.wanted = false;
    row.problem = sentenceOf({Fault::Cancelled, {row.file.toStdString(), {}, {}, {}}, {}, {}});
    ++row.generation;
    emit rowChanged(static_cast<int>(i));
  }
  if (was) emit busyChanged();
}

void ImportSession::setWanted(int row, bool wanted) {
  if (m_rows[row].wanted == wanted || !m_rows[row].mesh) return;
  m_rows[row].wanted = wanted;
  emit rowChanged(row);
}

void ImportSession::setName(int row, const QString& name) {
  if (m_rows[row].name == name || name.trimmed().isEmpty()) return;
  m_rows[row].name = name.trimmed();
  emit rowChanged(row);
}

void ImportSession::setUnit(int row, double metres) {
  if (m_rows[row].metres == metres || !(metres > 0)) return;
  m_rows[row].metres = metres;
  remake(row, true);  // what is thin depends on it
}

void ImportSession::setAxes(int row, const AxisMap& axes) {
  if (m_rows[row].axes == axes) return;
  m_rows[row].axes = axes;
  remake(row, false);
}

void ImportSession::setRepair(int row, FindingKind kind, bool on) {
  if (m_rows[row].repairs.count(kind) == static_cast<std::size_t>(on)) return;
  if (on) m_rows[row].repairs.insert(kind);
  else m_rows[row].repairs.erase(kind);
  remake(row, false);
}

void ImportSession::setThinLimit(double metres) {
  if (m_thinLimit == metres || !(metres > 0)) return;
  m_thinLimit = metres;
  for (std::size_t i = 0; i < m_rows.size(); ++i) remake(static_cast<int>(i), true);
}

void ImportSession::setShift(const Vec3& shift_W) {
  m_shift_W = shift_W;
  for (std::size_t i = 0; i < m_rows.size(); ++i) emit rowChanged(static_cast<int>(i));
}

Vec3 ImportSession::centringShift_W() const {
  Box3 box;
  for (const Row& row : m_rows)
    if (row.wanted && row.result) box.extend(boundsOf(*row.result));
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(-box.center());
}

int ImportSession::ready() const {
  return static_cast<int>(std::count_if(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.wanted && row.state == State::Ready; }));
}

std::vector<std::string> ImportSession::apply(Document& document) const {
  if (ready() == 0) return {};
  Scene after = document.scene();
  if (after.joint.id.empty()) after.joint.id = after.joint.name = "joint";
  if (after.scenario.id.empty()) after.scenario.id = after.scenario.name = after.joint.id;
  const std::string bone = boneOf(after.joint);
  int number = 0;
  for (const Part& part : after.joint.parts) number = std::max(number, part.number);
  std::vector<std::string> ids;
  ChangeSet changes;
  changes.model = true;
  for (const Row& row : m_rows) {
    if (!row.wanted || row.state != State::Ready) continue;
    Part part;
    part.id = partIdFor(row.name, after.joint);
    part.number = ++number;
    part.name = row.name.toStdString();
    part.color = usualColor(Appearance::Bone);
    part.materials = {{bone, {}}};
    part.visual = m_shift_W.isZero(0) ? row.result : std::make_shared<const TriMesh>(placed(*row.result, 1, {}, m_shift_W));
    part.collision = part.visual;
    ids.push_back(part.id);
    changes.parts.insert(part.id);
    after.scenario.fixedParts.push_back(part.id);
    after.joint.parts.push_back(std::move(part));
  }
  changes.materials = {bone};
  changes.settings = true;
  const bool first = document.isEmpty();
  if (first) changes.everything = true;
  document.edit(tr("Import %n surface(s)", nullptr, static_cast<int>(ids.size())), changes, [&](Scene& scene) { scene = after; });
  return ids;
}

}  // namespace glenoid
