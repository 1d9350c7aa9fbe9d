// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records/RecordSchema.h"

namespace glenoid {

std::vector<QStringList> recordMigrations(bool postgres) {
  const QString id = postgres ? QStringLiteral("bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY") : QStringLiteral("integer PRIMARY KEY AUTOINCREMENT");
  const QString time = postgres ? QStringLiteral("timestamptz") : QStringLiteral("text");
  const QString real = postgres ? QStringLiteral("double precision") : QStringLiteral("real");
  return {
      {QStringLiteral("CREATE TABLE person (id %1, name text NOT NULL UNIQUE)").arg(id),
       QStringLiteral("CREATE TABLE run (id %1, ticket text NOT NULL UNIQUE, person bigint NOT NULL REFERENCES person(id) ON DELETE CASCADE, scenario text NOT NULL, build text NOT NULL,"
                      " joint_hash text NOT NULL, begun %2 NOT NULL, seen %2 NOT NULL, ended %2, seconds %3 NOT NULL DEFAULT 0, score %3, passed boolean, state_hash text, report text)")
           .arg(id, time, real),
       QStringLiteral("CREATE INDEX run_of_person ON run(person)"),
       QStringLiteral("CREATE TABLE task (run bigint NOT NULL REFERENCES run(id) ON DELETE CASCADE, place integer NOT NULL, name text NOT NULL, outcome text NOT NULL,"
                      " score %1 NOT NULL, errors integer NOT NULL, seconds %1, PRIMARY KEY (run, place))")
           .arg(real),
       QStringLiteral("CREATE TABLE metric (run bigint NOT NULL REFERENCES run(id) ON DELETE CASCADE, name text NOT NULL, value %1, unit text NOT NULL,"
                      " PRIMARY KEY (run, name))")
           .arg(real)},
  };
}

}  // namespace glenoid
