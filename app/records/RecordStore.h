// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QSqlDatabase>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/live/RunReport.h"

class QSqlQuery;

namespace glenoid {

/// A run of somebody, as a list shows it.
struct RecordedRun {
  long long id = 0;
  std::string person, scenario;
  std::string begun, seen;           ///< ISO 8601, UTC: when it began, and when it was last written of
  double seconds = 0;                ///< s, simulated so far
  bool ended = false;                ///< false: still going on, or killed
  std::optional<double> score;       ///< of 100; of a run that ended
  bool passed = false;
  int done = 0, tasks = 0;
};

/// Who did what and how well: people, runs, their tasks and metrics, in SQLite or PostgreSQL with one schema (README.md).
/// A run stands in it from its first step, and what is written is there after a kill. Where a server goes away, a call
/// tries again for `patience` s; every try is a transaction of its own, so nothing is written twice. One thread.
/// Fails with BadUsage (a place that is none, holds a password, cannot be opened or written, and why), NewerSchema, or UnknownId (a
/// person or run that is not there).
class RecordStore {
 public:
  /// `place`: "" the user's own file; a path; or postgresql://[USER@]HOST[:PORT]/DATABASE[?host=FOLDER&sslmode=…] as libpq has it,
  /// FOLDER of the server's socket. A password is for libpq's own file or PGPASSWORD, never for a place. `goOn`: asked before each
  /// try again.
  static Result<std::unique_ptr<RecordStore>> open(const std::string& place, double patience = 30, std::function<bool()> goOn = {});
  ~RecordStore();
  RecordStore(const RecordStore&) = delete;
  RecordStore& operator=(const RecordStore&) = delete;

  /// A run that begins; who is not known yet is added.
  Result<long long> begin(const std::string& person, const std::string& scenario, const std::string& build, const std::string& jointHash);
  /// How far it is: replaces what the last call said.
  Result<Done> progress(long long run, double seconds, const TrainingReport& training);
  /// Its end: report, score, tasks and metrics.
  Result<Done> finish(long long run, const RunReport& report);

  /// Newest first; `person` empty: of all.
  Result<std::vector<RecordedRun>> list(const std::string& person);
  /// All that is known of a person, as JSON that schemas/records.schema.json describes.
  Result<std::string> exportPerson(const std::string& person);
  /// Takes a person and all their runs out; answers how many runs.
  Result<int> erase(const std::string& person);

  /// The place as people read it; holds no secret.
  const std::string& where() const { return m_where; }

 private:
  struct Wish;
  explicit RecordStore(QString connection);
  Result<Done> connect();
  Result<Done> migrate();
  /// In one transaction that writes; again where the connection was lost.
  Result<Done> write(const std::function<bool(QSqlQuery&)>& statements);
  Result<Done> transaction(const std::function<bool(QSqlQuery&)>& statements, bool& lost);
  Error failed(const QSqlQuery& query) const;
  QSqlDatabase database() const;
  Result<long long> personId(const std::string& person);

  QString m_connection;   ///< Qt's name of it
  QString m_options, m_host, m_database, m_user;
  int m_port = -1;
  bool m_postgres = false;
  double m_patience = 30;
  std::function<bool()> m_goOn;
  std::string m_where;
};

}  // namespace glenoid
