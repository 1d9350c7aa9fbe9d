// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records/RecordStore.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSqlError>
#include <QSqlQuery>
#include <QStandardPaths>
#include <QThread>
#include <QUrl>
#include <QUrlQuery>
#include <QUuid>
#include <QVariant>
#include <atomic>
#include <chrono>
#include <cmath>

#include "app/records/RecordSchema.h"
#include "simcore/file/Json.h"

namespace glenoid {
namespace {

QString words(const std::string& text) { return QString::fromStdString(text); }

QString now() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs); }

/// An instant, from whichever type the driver gives.
std::string isoTime(const QVariant& value) {
  return (value.typeId() == QMetaType::QDateTime ? value.toDateTime().toUTC().toString(Qt::ISODateWithMs) : value.toString()).toStdString();
}

/// NaN and infinity have no place in a table.
QVariant numberOrNull(const std::optional<double>& value) { return value && std::isfinite(*value) ? QVariant(*value) : QVariant(QMetaType::fromType<double>()); }

QString inOneLine(const QString& text) { return text.simplified().remove(u'\n'); }

Error badPlace(const std::string& place, const std::string& what) { return {Fault::BadUsage, {}, {"the records “" + place + "”: " + what}, "records"}; }

/// Prepares, binds in order and runs.
bool run(QSqlQuery& query, const QString& statement, const QVariantList& values = {}) {
  if (!query.prepare(statement)) return false;
  for (const QVariant& value : values) query.addBindValue(value);
  return query.exec();
}

bool writeTasks(QSqlQuery& query, long long id, const TrainingReport& training) {
  if (!run(query, QStringLiteral("DELETE FROM task WHERE run = ?"), {id})) return false;
  for (std::size_t i = 0; i < training.tasks.size(); ++i) {
    const TaskResult& task = training.tasks[i];
    const TaskRecord& record = task.record;
    const std::optional<double> seconds = record.ended ? std::optional(*record.ended - *record.opened) : std::nullopt;
    if (!run(query, QStringLiteral("INSERT INTO task (run, place, name, outcome, score, errors, seconds) VALUES (?, ?, ?, ?, ?, ?, ?)"),
             {id, static_cast<int>(i), words(task.id), QString::fromLatin1(outcomeName(record.outcome)), task.score, record.errors, numberOrNull(seconds)}))
      return false;
  }
  return true;
}

}  // namespace

RecordStore::RecordStore(QString connection) : m_connection(std::move(connection)) {}

RecordStore::~RecordStore() {
  database().close();
  QSqlDatabase::removeDatabase(m_connection);
}

QSqlDatabase RecordStore::database() const { return QSqlDatabase::database(m_connection, false); }

Result<std::unique_ptr<RecordStore>> RecordStore::open(const std::string& place, double patience, std::function<bool()> goOn) {
  static std::atomic<int> count{0};
  std::unique_ptr<RecordStore> store(new RecordStore(QStringLiteral("records-%1").arg(count++)));
  store->m_patience = patience;
  store->m_goOn = std::move(goOn);
  const QString text = words(place);
  store->m_postgres = text.startsWith(u"postgresql://") || text.startsWith(u"postgres://");
  if (store->m_postgres) {
    const QUrl url(text, QUrl::StrictMode);
    if (!url.isValid() || url.path().size() < 2) return badPlace(url.toDisplayString().toStdString(), "wanted is postgresql://USER@HOST/DATABASE");
    const QUrlQuery query(url);
    if (!url.password().isEmpty() || query.hasQueryItem(QStringLiteral("password")))
      return badPlace(url.toDisplayString(QUrl::RemovePassword | QUrl::RemoveQuery).toStdString(),
                      "a password belongs into libpq's password file (~/.pgpass) or PGPASSWORD, not into a place that logs and histories keep");
    store->m_database = url.path().mid(1);
    store->m_user = url.userName();
    store->m_host = url.host();
    store->m_port = url.port();
    QStringList options;
    if (!query.hasQueryItem(QStringLiteral("connect_timeout"))) options << QStringLiteral("connect_timeout=5");
    // A network that fell silent is given up too, not only a server that says no.
    if (!query.hasQueryItem(QStringLiteral("tcp_user_timeout"))) options << QStringLiteral("tcp_user_timeout=5000");
    for (const auto& [key, value] : query.queryItems(QUrl::FullyDecoded)) {
      if (key == u"host") store->m_host = value;
      else options << key + u'=' + value;
    }
    store->m_options = options.join(u';');
    store->m_where = url.toDisplayString().toStdString();
  } else {
    if (text.contains(u"://")) return badPlace(place, "wanted is a file or postgresql://USER@HOST/DATABASE");
    store->m_database = text;
    if (text.isEmpty()) {
      const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/glenoid");
      if (!QDir().mkpath(folder)) return Error{Fault::FileUnwritable, {folder.toStdString(), "", "", {}}, {}, "records"};
      store->m_database = folder + QStringLiteral("/records.sqlite");
    }
    store->m_where = store->m_database.toStdString();
  }
  const QString driver = store->m_postgres ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE");
  if (!QSqlDatabase::isDriverAvailable(driver))
    return badPlace(store->m_where, store->m_postgres ? "Qt's PostgreSQL driver is not installed (Debian: libqt6sql6-psql)" : "Qt's SQLite driver is not installed (Debian: libqt6sql6-sqlite)");
  QSqlDatabase::addDatabase(driver, store->m_connection);
  if (const auto connected = store->connect(); !connected) return connected.error();
  if (const auto migrated = store->migrate(); !migrated) return migrated.error();
  return store;
}

Result<Done> RecordStore::connect() {
  QSqlDatabase database = this->database();
  database.close();
  database.setDatabaseName(m_database);
  if (m_postgres) {
    database.setHostName(m_host);
    database.setUserName(m_user);
    if (m_port > 0) database.setPort(m_port);
    database.setConnectOptions(m_options);
  }
  if (!database.open())
    return badPlace(m_where, "they cannot be opened: " + inOneLine(database.lastError().text()).toStdString());
  QSqlQuery query(database);
  if (m_postgres) {  // tables that are there already are no news
    if (!query.exec(QStringLiteral("SET client_min_messages = warning"))) return failed(query);
    return Done{};
  }
  // Another process may write; what was acknowledged is on disk.
  for (const char* pragma : {"PRAGMA busy_timeout = 10000", "PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON", "PRAGMA secure_delete = ON"})
    if (!query.exec(QString::fromLatin1(pragma))) return failed(query);
  return Done{};
}

Error RecordStore::failed(const QSqlQuery& query) const {
  const QString said = query.lastError().text().trimmed().isEmpty() ? database().lastError().text() : query.lastError().text();
  return badPlace(m_where, "nothing could be written or read: " + inOneLine(said).toStdString());
}

/// Several processes may open a new database at once: who comes second finds the version written.
Result<Done> RecordStore::migrate() {
  const std::vector<QStringList> migrations = recordMigrations(m_postgres);
  int found = 0;
  const auto done = write([&](QSqlQuery& query) {
    if (m_postgres && !query.exec(QStringLiteral("SELECT pg_advisory_xact_lock(7301642)"))) return false;
    if (!query.exec(QStringLiteral("CREATE TABLE IF NOT EXISTS schema_version (version integer NOT NULL)"))) return false;
    if (!query.exec(QStringLiteral("SELECT version FROM schema_version"))) return false;
    const bool any = query.next();
    found = any ? query.value(0).toInt() : 0;
    query.finish();
    if (found >= static_cast<int>(migrations.size())) return true;
    for (std::size_t m = static_cast<std::size_t>(found); m < migrations.size(); ++m)
      for (const QString& statement : migrations[m])
        if (!query.exec(statement)) return false;
    return run(query, any ? QStringLiteral("UPDATE schema_version SET version = ?") : QStringLiteral("INSERT INTO schema_version (version) VALUES (?)"),
               {static_cast<int>(migrations.size())});
  });
  if (!done) return done;
  if (found > static_cast<int>(migrations.size()))
    return Error{Fault::NewerSchema, {m_where, "", "", {}}, {std::to_string(found), std::to_string(migrations.size())}, "records"};
  return Done{};
}

Result<Done> RecordStore::transaction(const std::function<bool(QSqlQuery&)>& statements, bool& lost) {
  QSqlDatabase database = this->database();
  QSqlQuery query(database);
  // SQLite: at once, since a reading that turns into a writing after another's commit fails without waiting.
  if (query.exec(m_postgres ? QStringLiteral("BEGIN") : QStringLiteral("BEGIN IMMEDIATE")) && statements(query) && query.exec(QStringLiteral("COMMIT"))) return Done{};
  const Error error = failed(query);
  const QString code = query.lastError().nativeErrorCode();
  // 57P01 to 57P03: the server shuts down or starts; 08…: connection; 40…: another's transaction was first.
  lost = !database.isOpen() || query.lastError().type() == QSqlError::ConnectionError || code.startsWith(u"57P") || code.startsWith(u"08") || code.startsWith(u"40") ||
         (m_postgres && code.isEmpty());
  query.exec(QStringLiteral("ROLLBACK"));
  return error;
}

Result<Done> RecordStore::write(const std::function<bool(QSqlQuery&)>& statements) {
  const auto begun = std::chrono::steady_clock::now();
  for (unsigned long pause = 50;; pause = std::min(1000ul, 2 * pause)) {
    bool lost = false;
    const auto done = transaction(statements, lost);
    if (done || !lost) return done;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count() > m_patience || (m_goOn && !m_goOn())) return done;
    QThread::msleep(pause);
    (void)connect();  // prepared statements died with the connection; the next try says whether it is there again
  }
}

Result<long long> RecordStore::begin(const std::string& person, const std::string& scenario, const std::string& build, const std::string& jointHash) {
  long long id = 0;
  // A commit whose answer was lost is found again by its ticket.
  const QString begun = now(), ticket = QUuid::createUuid().toString(QUuid::WithoutBraces);
  const auto done = write([&](QSqlQuery& query) {
    if (!run(query, QStringLiteral("INSERT INTO person (name) VALUES (?) ON CONFLICT (name) DO NOTHING"), {words(person)})) return false;
    if (!run(query,
             QStringLiteral("INSERT INTO run (ticket, person, scenario, build, joint_hash, begun, seen) SELECT ?, id, ?, ?, ?, ?, ? FROM person WHERE name = ?"
                            " ON CONFLICT (ticket) DO NOTHING"),
             {ticket, words(scenario), words(build), words(jointHash), begun, begun, words(person)}) ||
        !run(query, QStringLiteral("SELECT id FROM run WHERE ticket = ?"), {ticket}) || !query.next())
      return false;
    id = query.value(0).toLongLong();
    query.finish();
    return true;
  });
  if (!done) return done.error();
  return id;
}

Result<Done> RecordStore::progress(long long run, double seconds, const TrainingReport& training) {
  return write([&](QSqlQuery& query) {
    return glenoid::run(query, QStringLiteral("UPDATE run SET seconds = ?, seen = ? WHERE id = ?"), {seconds, now(), run}) && writeTasks(query, run, training);
  });
}

Result<Done> RecordStore::finish(long long run, const RunReport& report) {
  const TrainingReport training = report.training.value_or(TrainingReport{});
  const QVariant score = numberOrNull(report.training ? std::optional(training.score) : std::nullopt);
  bool there = true;
  const QString end = now();
  const auto done = write([&](QSqlQuery& query) {
    if (!glenoid::run(query, QStringLiteral("UPDATE run SET ended = ?, seen = ?, seconds = ?, score = ?, passed = ?, state_hash = ?, report = ? WHERE id = ?"),
                      {end, end, report.seconds, score, training.passed, words(report.stateHash), words(toJson(report)), run}))
      return false;
    there = query.numRowsAffected() == 1;
    if (!there) return true;
    if (!writeTasks(query, run, training) || !glenoid::run(query, QStringLiteral("DELETE FROM metric WHERE run = ?"), {run})) return false;
    for (const Metric& metric : training.metrics) {
      const MetricKind* kind = metricKind(metric.name);
      if (!glenoid::run(query, QStringLiteral("INSERT INTO metric (run, name, value, unit) VALUES (?, ?, ?, ?)"),
                        {run, words(metric.name), numberOrNull(metric.value), QString::fromUtf8(kind ? kind->unit : "")}))
        return false;
    }
    return true;
  });
  if (!done || there) return done;
  return Error{Fault::UnknownId, {m_where, "", "", {}}, {std::to_string(run), "run"}, "records"};
}

Result<long long> RecordStore::personId(const std::string& person) {
  long long id = -1;
  const auto done = write([&](QSqlQuery& query) {
    if (!run(query, QStringLiteral("SELECT id FROM person WHERE name = ?"), {words(person)})) return false;
    if (query.next()) id = query.value(0).toLongLong();
    query.finish();
    return true;
  });
  if (!done) return done.error();
  if (id < 0) return Error{Fault::UnknownId, {m_where, "", "", {}}, {person, "person"}, "records"};
  return id;
}

Result<std::vector<RecordedRun>> RecordStore::list(const std::string& person) {
  if (!person.empty())
    if (const auto known = personId(person); !known) return known.error();
  std::vector<RecordedRun> runs;
  const auto done = write([&](QSqlQuery& query) {
    runs.clear();
    const QString which = person.empty() ? QString() : QStringLiteral(" WHERE person.name = ?");
    if (!run(query,
             QStringLiteral("SELECT run.id, person.name, run.scenario, run.begun, run.seen, run.seconds, run.ended, run.score, run.passed,"
                            " (SELECT count(*) FROM task WHERE task.run = run.id AND task.outcome = 'done'), (SELECT count(*) FROM task WHERE task.run = run.id)"
                            " FROM run JOIN person ON person.id = run.person%1 ORDER BY run.begun DESC, run.id DESC")
                 .arg(which),
             person.empty() ? QVariantList() : QVariantList{words(person)}))
      return false;
    while (query.next()) {
      RecordedRun entry;
      entry.id = query.value(0).toLongLong();
      entry.person = query.value(1).toString().toStdString();
      entry.scenario = query.value(2).toString().toStdString();
      entry.begun = isoTime(query.value(3));
      entry.seen = isoTime(query.value(4));
      entry.seconds = query.value(5).toDouble();
      entry.ended = !query.value(6).isNull();
      if (!query.value(7).isNull()) entry.score = query.value(7).toDouble();
      entry.passed = query.value(8).toBool();
      entry.done = query.value(9).toInt();
      entry.tasks = query.value(10).toInt();
      runs.push_back(std::move(entry));
    }
    query.finish();
    return true;
  });
  if (!done) return done.error();
  return runs;
}

Result<std::string> RecordStore::exportPerson(const std::string& person) {
  const auto runs = list(person);
  if (!runs) return runs.error();
  JsonValue list = JsonValue::array();
  for (const RecordedRun& entry : *runs) {
    std::string report;
    JsonValue tasks = JsonValue::array(), metrics = JsonValue::array();
    const auto done = write([&](QSqlQuery& query) {
      tasks = metrics = JsonValue::array();
      if (!run(query, QStringLiteral("SELECT report FROM run WHERE id = ?"), {entry.id}) || !query.next()) return false;
      report = query.value(0).toString().toStdString();
      if (!run(query, QStringLiteral("SELECT name, outcome, score, errors, seconds FROM task WHERE run = ? ORDER BY place"), {entry.id})) return false;
      while (query.next()) {
        JsonValue task = JsonValue::object();
        task.set("id", query.value(0).toString().toStdString());
        task.set("outcome", query.value(1).toString().toStdString());
        task.set("score", query.value(2).toDouble());
        task.set("errors", query.value(3).toInt());
        task.set("seconds", query.value(4).isNull() ? JsonValue() : JsonValue(query.value(4).toDouble()));
        tasks.append(std::move(task));
      }
      if (!run(query, QStringLiteral("SELECT name, value, unit FROM metric WHERE run = ? ORDER BY name"), {entry.id})) return false;
      while (query.next()) {
        JsonValue metric = JsonValue::object();
        metric.set("name", query.value(0).toString().toStdString());
        metric.set("value", query.value(1).isNull() ? JsonValue() : JsonValue(query.value(1).toDouble()));
        metric.set("unit", query.value(2).toString().toStdString());
        metrics.append(std::move(metric));
      }
      query.finish();
      return true;
    });
    if (!done) return done.error();
    JsonValue json = JsonValue::object();
    json.set("id", entry.id);
    json.set("scenario", entry.scenario);
    json.set("begun", entry.begun);
    json.set("seconds", entry.seconds);
    json.set("ended", entry.ended);
    json.set("score", entry.score ? JsonValue(*entry.score) : JsonValue());
    json.set("passed", entry.passed);
    json.set("tasks", std::move(tasks));
    json.set("metrics", std::move(metrics));
    if (const Result<JsonValue> whole = report.empty() ? Result<JsonValue>(JsonValue()) : parseJson(report, m_where); whole) json.set("report", *whole);
    list.append(std::move(json));
  }
  JsonValue json = JsonValue::object();
  json.set("schemaVersion", 1);
  json.set("person", person);
  json.set("runs", std::move(list));
  return toText(json);
}

Result<int> RecordStore::erase(const std::string& person) {
  const Result<long long> id = personId(person);
  if (!id) return id.error();
  int runs = 0;
  const auto done = write([&](QSqlQuery& query) {
    if (!run(query, QStringLiteral("DELETE FROM run WHERE person = ?"), {*id})) return false;
    runs = query.numRowsAffected();
    return run(query, QStringLiteral("DELETE FROM person WHERE id = ?"), {*id});
  });
  if (!done) return done.error();
  if (!m_postgres) {  // what was taken out must not lie in free pages either
    QSqlQuery query(database());
    query.exec(QStringLiteral("VACUUM"));
    query.exec(QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)"));
  }
  return runs;
}

}  // namespace glenoid
