// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/PostgresServer.h"

#include <unistd.h>

#include <QDir>
#include <QProcess>

namespace glenoid::testing {

PostgresServer::PostgresServer() {
  const QStringList versions = QDir(QStringLiteral("/usr/lib/postgresql")).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
  if (versions.isEmpty()) {
    m_said = QStringLiteral("no PostgreSQL is installed (Debian: postgresql)");
    return;
  }
  m_bin = QStringLiteral("/usr/lib/postgresql/") + versions.last() + QStringLiteral("/bin/");
  if (::getuid() == 0) {
    QProcess own;
    own.start(QStringLiteral("chown"), {QStringLiteral("postgres"), m_folder.path()});
    own.waitForFinished();
  }
  m_up = call(QStringLiteral("initdb"), {QStringLiteral("-D"), m_folder.path() + QStringLiteral("/data"), QStringLiteral("-A"), QStringLiteral("trust"), QStringLiteral("-U"), QStringLiteral("station"),
                                         QStringLiteral("-E"), QStringLiteral("UTF8"), QStringLiteral("--no-sync")}) &&
         start();
}

PostgresServer::~PostgresServer() {
  if (m_up) call(QStringLiteral("pg_ctl"), {QStringLiteral("-D"), m_folder.path() + QStringLiteral("/data"), QStringLiteral("-m"), QStringLiteral("immediate"), QStringLiteral("stop")});
  if (::getuid() == 0 && !m_bin.isEmpty()) {  // files of another user
    QProcess gone;
    gone.start(QStringLiteral("rm"), {QStringLiteral("-rf"), m_folder.path()});
    gone.waitForFinished();
  }
}

QString PostgresServer::place() const { return QStringLiteral("postgresql://station@localhost/postgres?host=%1").arg(m_folder.path()); }

bool PostgresServer::start() {
  return call(QStringLiteral("pg_ctl"), {QStringLiteral("-D"), m_folder.path() + QStringLiteral("/data"), QStringLiteral("-w"), QStringLiteral("-l"), m_folder.path() + QStringLiteral("/log"),
                                         QStringLiteral("-o"), QStringLiteral("-k %1 -c listen_addresses='' -c max_connections=40").arg(m_folder.path()), QStringLiteral("start")});
}

bool PostgresServer::restart() {
  return call(QStringLiteral("pg_ctl"), {QStringLiteral("-D"), m_folder.path() + QStringLiteral("/data"), QStringLiteral("-m"), QStringLiteral("fast"), QStringLiteral("-w"), QStringLiteral("stop")}) && start();
}

bool PostgresServer::call(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.setWorkingDirectory(m_folder.path());
  // A server that goes on keeps its starter's outputs open.
  process.setStandardOutputFile(QProcess::nullDevice());
  process.setStandardErrorFile(QProcess::nullDevice());
  if (::getuid() == 0)
    process.start(QStringLiteral("runuser"), QStringList{QStringLiteral("-u"), QStringLiteral("postgres"), QStringLiteral("--"), m_bin + program} + arguments);
  else
    process.start(m_bin + program, arguments);
  const bool done = process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
  if (!done) m_said = program + QStringLiteral(" failed");
  return done;
}

}  // namespace glenoid::testing
