// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QTemporaryDir>

namespace glenoid::testing {

/// A real PostgreSQL with a data folder of its own, on a socket in that folder and on no port. Its programs refuse to run as root, so
/// root starts them as the user "postgres" that Debian's package makes.
class PostgresServer {
 public:
  PostgresServer();   ///< starts it; isUp() is false where that failed
  ~PostgresServer();
  bool isUp() const { return m_up; }
  QString place() const;  ///< for RecordStore
  bool restart();         ///< fast: connections are cut
  const QString& said() const { return m_said; }  ///< why not

 private:
  bool call(const QString& program, const QStringList& arguments);
  bool start();
  QTemporaryDir m_folder;
  QString m_bin, m_said;
  bool m_up = false;
};

}  // namespace glenoid::testing
