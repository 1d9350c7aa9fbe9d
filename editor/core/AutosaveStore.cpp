// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/AutosaveStore.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <algorithm>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/scene/DraftFile.h"
#include "simcore/scene/RecordingFile.h"

namespace glenoid {
namespace {

constexpr int kKeepDays = 30, kKeepSessions = 20;

Error unwritable(const QString& path) { return {Fault::FileUnwritable, {path.toStdString(), {}, {}, {}}, {}, "autosave"}; }

QString generationName(int number) { return QStringLiteral("g%1").arg(number, 6, 10, QLatin1Char('0')); }

/// Generations that are whole, newest first.
std::vector<Generation> generationsIn(const QString& session) {
  std::vector<Generation> generations;
  const QStringList names = QDir(session).entryList({QStringLiteral("g??????")}, QDir::Dirs, QDir::Name | QDir::Reversed);
  for (const QString& name : names) {
    QFile about(QStringLiteral("%1/%2/about.json").arg(session, name));
    if (!about.open(QIODevice::ReadOnly)) continue;
    const QJsonObject json = QJsonDocument::fromJson(about.readAll()).object();
    generations.push_back({QStringLiteral("%1/%2").arg(session, name), json.value(u"name").toString(),
                           json.value(u"origin").toString(),
                           QDateTime::fromString(json.value(u"saved").toString(), Qt::ISODateWithMs)});
  }
  return generations;
}

}  // namespace

QString AutosaveSession::defaultRoot() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/autosave");
}

AutosaveSession::AutosaveSession(const QString& root)
    : m_root(root), m_folder(QStringLiteral("%1/%2-%3-%4")
                                 .arg(root, QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss")))
                                 .arg(QCoreApplication::applicationPid())
                                 .arg(QRandomGenerator::global()->generate() % 1000000)) {}

AutosaveSession::~AutosaveSession() = default;

bool AutosaveSession::prepare() {
  if (m_lock) return true;
  if (!QDir().mkpath(m_folder)) return false;
  QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  auto lock = std::make_unique<QLockFile>(m_folder + QStringLiteral("/lock"));
  lock->setStaleLockTime(0);  // it is held for as long as the program runs
  if (!lock->tryLock(0)) return false;
  m_lock = std::move(lock);
  return true;
}

Result<Done> AutosaveSession::write(const Scene& scene, const QString& origin) {
  if (!prepare()) return unwritable(m_folder);
  const QString begun = m_folder + QStringLiteral("/.begun"), whole = QStringLiteral("%1/%2").arg(m_folder, generationName(m_next));
  QDir(begun).removeRecursively();  // of a write that failed
  if (!QDir().mkpath(begun)) return unwritable(begun);
  const QDateTime now = QDateTime::currentDateTimeUtc();
  const auto saved = saveDraft({scene.joint, scene.scenario}, begun.toStdString(), (m_folder + QStringLiteral("/blobs")).toStdString());
  if (!saved) return saved;
  if (scene.input) {
    const auto blob = [&] { return QStringLiteral("%1/blobs/input-%2.recording").arg(m_folder).arg(m_inputs); };
    if (scene.input != m_input) {
      ++m_inputs;
      if (const auto input = saveRecording(*scene.input, blob().toStdString()); !input) return input;
      m_input = scene.input;
    }
    std::error_code refused;
    const std::string to = (begun + QStringLiteral("/input.recording")).toStdString();
    std::filesystem::create_hard_link(blob().toStdString(), to, refused);
    if (refused) std::filesystem::copy_file(blob().toStdString(), to, refused);
    if (refused) return unwritable(QString::fromStdString(to));
  }
  const std::string& name = scene.scenario.name.empty() ? scene.joint.name : scene.scenario.name;
  const QJsonObject about{{QStringLiteral("name"), QString::fromStdString(name)}, {QStringLiteral("origin"), origin},
                          {QStringLiteral("saved"), now.toString(Qt::ISODateWithMs)}};
  const auto written = writeWholeFile((begun + QStringLiteral("/about.json")).toStdString(), QJsonDocument(about).toJson().toStdString());
  if (!written) return written;
  if (!QDir().rename(begun, whole)) return unwritable(whole);
  ++m_next;
  QFile::remove(m_folder + QStringLiteral("/declined"));
  const auto generations = generationsIn(m_folder);
  std::vector<QDateTime> times;
  for (const Generation& generation : generations) times.push_back(generation.saved);
  for (const int index : generationsToDrop(times)) QDir(generations[index].folder).removeRecursively();
  return Done{};
}

void AutosaveSession::clear() {
  // Newest last: a program that dies meanwhile leaves the newest.
  auto generations = generationsIn(m_folder);
  std::reverse(generations.begin(), generations.end());
  for (const Generation& generation : generations) QDir(generation.folder).removeRecursively();
  m_lock.reset();
  QDir(m_folder).removeRecursively();
  m_input.reset();
  m_inputs = 0;
}

void AutosaveSession::decline() {
  if (m_lock) declineSession(m_folder);
}

std::vector<AbandonedSession> abandonedSessions(const QString& root) {
  std::vector<AbandonedSession> sessions;
  for (const QString& name : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = QStringLiteral("%1/%2").arg(root, name);
    QLockFile lock(folder + QStringLiteral("/lock"));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // its program runs
    AbandonedSession session{folder, QFile::exists(folder + QStringLiteral("/declined")), generationsIn(folder)};
    const bool old = !session.generations.empty() &&
                     session.generations[0].saved.daysTo(QDateTime::currentDateTimeUtc()) > kKeepDays;
    if (session.generations.empty() || old) {
      lock.unlock();
      removeSession(folder);
    } else {
      sessions.push_back(std::move(session));
    }
  }
  std::sort(sessions.begin(), sessions.end(), [](const AbandonedSession& a, const AbandonedSession& b) {
    return a.generations[0].saved > b.generations[0].saved;
  });
  while (static_cast<int>(sessions.size()) > kKeepSessions) {
    removeSession(sessions.back().folder);
    sessions.pop_back();
  }
  return sessions;
}

Result<Scene> loadGeneration(const QString& folder) {
  auto draft = loadDraft(folder.toStdString());
  if (!draft) return draft.error();
  Scene scene{std::move(draft->joint), std::move(draft->scenario), nullptr};
  const QString input = folder + QStringLiteral("/input.recording");
  if (QFile::exists(input)) {
    auto recording = loadRecording(input.toStdString());
    if (!recording) return recording.error();
    scene.input = std::make_shared<const Recording>(std::move(*recording));
  }
  return scene;
}

void declineSession(const QString& folder) {
  QFile mark(folder + QStringLiteral("/declined"));
  if (!mark.open(QIODevice::WriteOnly)) return;  // it will be offered again, which does no harm
}

void removeSession(const QString& folder) { QDir(folder).removeRecursively(); }

std::vector<int> generationsToDrop(const std::vector<QDateTime>& saved) {
  constexpr int kNewest = 4, kOlder = 4;
  constexpr qint64 kApart = 60;  // s
  std::vector<int> drop;
  int older = 0;
  QDateTime last;
  for (int i = 0; i < static_cast<int>(saved.size()); ++i) {
    if (i < kNewest) {
      last = saved[i];
    } else if (older < kOlder && saved[i].secsTo(last) >= kApart) {
      last = saved[i];
      ++older;
    } else {
      drop.push_back(i);
    }
  }
  return drop;
}

}  // namespace glenoid
