// SPDX-License-Identifier: GPL-3.0-or-later
// The records hold what was promised in both databases: there and back, kills, stations at once, a server that restarts, a
// person taken out. GLENOID_LONG=1: fifty kills, eight stations with a thousand runs.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QProcess>
#include <QSqlQuery>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <thread>

#include "app/records/RecordStore.h"
#include "app/records/RunRecorder.h"
#include "simcore/file/Json.h"
#include "tests/app/PostgresServer.h"
#include "tests/app/Program.h"

namespace glenoid {
namespace {

using namespace glenoid::testing;

constexpr const char* kStation = "--station";

RunReport someReport(double score) {
  RunReport report;
  report.scenario = "builtin:tour";
  report.seconds = 12;
  report.stateHash = "ffffffffffffffffffffffffffffffff";
  TrainingReport training;
  TaskResult done, open;
  done.id = "biceps";
  done.record.outcome = TaskOutcome::Done;
  done.record.opened = 0;
  done.record.ended = 3.5;
  done.record.errors = 2;
  done.score = 0.5;
  open.id = "labrum";
  open.record.outcome = TaskOutcome::Open;
  training.tasks = {done, open};
  training.metrics = {{"time", 12.0}, {"probe.path", 0.75}, {"probe.jerk", {}}, {"probe.economy", std::numeric_limits<double>::quiet_NaN()}};
  training.score = score;
  report.training = training;
  return report;
}

/// Runs of one station, begun and finished one by one; exit status 0 when all were acknowledged.
int station(const std::string& place, const std::string& person, int runs) {
  const auto store = RecordStore::open(place);
  if (!store) return std::fprintf(stderr, "%s\n", toLogLine(store.error()).c_str()), 1;
  for (int i = 0; i < runs; ++i) {
    const auto id = (*store)->begin(person, "builtin:tour", "build", "hash");
    if (!id) return std::fprintf(stderr, "%s\n", toLogLine(id.error()).c_str()), 1;
    if (const auto finished = (*store)->finish(*id, someReport(i)); !finished) return std::fprintf(stderr, "%s\n", toLogLine(finished.error()).c_str()), 1;
  }
  return 0;
}

PostgresServer& server() {
  static PostgresServer only;
  return only;
}

class Records : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    folder = freshFolder();
    place = (folder / "records.sqlite").string();
    if (std::string(GetParam()) == "sqlite") return;
    ASSERT_TRUE(server().isUp()) << server().said().toStdString();
    place = server().place().toStdString();
    // A server for all tests: everybody out first.
    const auto store = RecordStore::open(place);
    ASSERT_TRUE(store) << toLogLine(store.error());
    const auto runs = (*store)->list("");
    for (const RecordedRun& run : *runs) (void)(*store)->erase(run.person);
  }
  std::filesystem::path folder;
  std::string place;
};

TEST_P(Records, holdARunAsItWas) {
  const std::string name = "Ana “la rápida” O'Neill; DROP TABLE run";
  {
    const auto store = RecordStore::open(place);
    ASSERT_TRUE(store) << toLogLine(store.error());
    const auto id = (*store)->begin(name, "builtin:tour", "b", "h");
    ASSERT_TRUE(id) << toLogLine(id.error());
    auto runs = (*store)->list(name);
    ASSERT_TRUE(runs);
    ASSERT_EQ(runs->size(), 1u);
    EXPECT_FALSE(runs->at(0).ended);
    ASSERT_TRUE((*store)->progress(*id, 4, *someReport(0).training));
    ASSERT_TRUE((*store)->finish(*id, someReport(61.5)));
  }
  const auto store = RecordStore::open(place);  // another connection
  ASSERT_TRUE(store);
  const auto runs = (*store)->list("");
  ASSERT_TRUE(runs);
  ASSERT_EQ(runs->size(), 1u);
  const RecordedRun& run = runs->at(0);
  EXPECT_EQ(run.person, name);
  EXPECT_TRUE(run.ended);
  EXPECT_DOUBLE_EQ(run.score.value_or(0), 61.5);
  EXPECT_EQ(run.done, 1);
  EXPECT_EQ(run.tasks, 2);
  const QDateTime begun = QDateTime::fromString(QString::fromStdString(run.begun), Qt::ISODateWithMs);
  EXPECT_LT(std::abs(begun.msecsTo(QDateTime::currentDateTimeUtc())), 60000) << run.begun;
  const auto text = (*store)->exportPerson(name);
  ASSERT_TRUE(text);
  const auto json = parseJson(*text, "export");
  ASSERT_TRUE(json);
  const JsonValue& entry = (*json)["runs"][0];
  EXPECT_EQ(entry["report"]["stateHash"].text(), std::string(32, 'f'));
  ASSERT_EQ(entry["metrics"].items().size(), 4u);
  EXPECT_TRUE(entry["metrics"][0]["value"].isNull()) << "NaN is no number";
  EXPECT_DOUBLE_EQ(entry["tasks"][0]["seconds"].number(), 3.5);
}

TEST_P(Records, whoIsTakenOutIsGoneAndNobodyElse) {
  const auto store = RecordStore::open(place);
  ASSERT_TRUE(store);
  for (const char* person : {"ana", "ana", "bob"}) {
    const auto id = (*store)->begin(person, "s", "b", "h");
    ASSERT_TRUE(id && (*store)->finish(*id, someReport(50)));
  }
  const auto erased = (*store)->erase("ana");
  ASSERT_TRUE(erased);
  EXPECT_EQ(*erased, 2);
  EXPECT_FALSE((*store)->list("ana"));
  EXPECT_FALSE((*store)->exportPerson("ana"));
  EXPECT_EQ((*store)->list("")->size(), 1u);
  EXPECT_EQ((*store)->erase("ana").error().fault, Fault::UnknownId);
  if (std::string(GetParam()) == "sqlite") {  // not in a free page, not in the log
    for (const char* ending : {"", "-wal"}) EXPECT_EQ(readText(place + ending).find("ana"), std::string::npos) << ending;
  }
}

TEST_P(Records, stationsWriteAtOnceAndNoneIsLost) {
  const int runs = std::getenv("GLENOID_LONG") ? 125 : 10;
  const auto begun = std::chrono::steady_clock::now();
  std::vector<std::unique_ptr<QProcess>> stations;
  for (int s = 0; s < 8; ++s) {  // the first open makes the tables, all try
    auto& process = stations.emplace_back(std::make_unique<QProcess>());
    process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process->start(QCoreApplication::applicationFilePath(),
                   {QLatin1String(kStation), QString::fromStdString(place), QStringLiteral("trainee %1").arg(s % 3), QString::number(runs)});
  }
  for (auto& process : stations) {
    ASSERT_TRUE(process->waitForFinished(250000));
    EXPECT_EQ(process->exitCode(), 0);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  std::printf("%s: %d runs of 8 stations in %.1f s\n", GetParam(), 8 * runs, taken.count());
  const auto store = RecordStore::open(place);
  ASSERT_TRUE(store);
  const auto list = (*store)->list("");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->size(), static_cast<std::size_t>(8 * runs));
  EXPECT_TRUE(std::all_of(list->begin(), list->end(), [](const RecordedRun& run) { return run.ended && run.tasks == 2; }));
}

TEST_P(Records, aKilledRunLosesLessThanASecond) {
  const int kills = std::getenv("GLENOID_LONG") ? 50 : 2;
  for (int k = 0; k < kills; ++k) {
    const std::string person = "killed " + std::to_string(k);
    QProcess process;
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(QStringLiteral(GLENOID_PROGRAM), {QStringLiteral("run"), QStringLiteral("builtin:tour"), QStringLiteral("--trainee"), QString::fromStdString(person),
                                                    QStringLiteral("--records"), QString::fromStdString(place)});
    const auto store = RecordStore::open(place);
    ASSERT_TRUE(store) << toLogLine(store.error());
    // Once it runs, and a while that is another each time.
    std::vector<RecordedRun> runs;
    for (int i = 0; i < 600 && (runs.empty() || !(runs[0].seconds > 0)); ++i) {
      QThread::msleep(50);
      if (const auto list = (*store)->list(person)) runs = *list;
    }
    ASSERT_FALSE(runs.empty());
    QThread::msleep(static_cast<unsigned long>(137 * k % 1100));
    process.kill();
    const QDateTime end = QDateTime::currentDateTimeUtc();
    process.waitForFinished();
    const auto left = RecordStore::open(place);
    ASSERT_TRUE(left) << toLogLine(left.error());
    const auto list = (*left)->list(person);
    ASSERT_TRUE(list && list->size() == 1);
    const RecordedRun& run = list->at(0);
    EXPECT_FALSE(run.ended);
    EXPECT_EQ(run.tasks, 10);
    EXPECT_LT(QDateTime::fromString(QString::fromStdString(run.seen), Qt::ISODateWithMs).msecsTo(end), 1000) << run.seen;
  }
}

INSTANTIATE_TEST_SUITE_P(Databases, Records, ::testing::Values("sqlite", "postgresql"));

TEST(RecordsOfALab, aServerThatRestartsCostsARetry) {
  ASSERT_TRUE(server().isUp()) << server().said().toStdString();
  const std::string place = server().place().toStdString();
  const auto store = RecordStore::open(place);
  ASSERT_TRUE(store);
  if ((*store)->list("restart")) (void)(*store)->erase("restart");
  std::atomic<bool> goOn{true};
  std::atomic<int> written{0};
  std::thread writer([&] {
    const auto own = RecordStore::open(place);
    while (own && goOn) {
      const auto id = (*own)->begin("restart", "s", "b", "h");
      if (!id || !(*own)->finish(*id, someReport(1))) return;
      ++written;
    }
  });
  while (written < 5) QThread::msleep(5);
  ASSERT_TRUE(server().restart());
  const int then = written;
  for (int i = 0; i < 400 && written < then + 5; ++i) QThread::msleep(50);
  goOn = false;
  writer.join();
  EXPECT_GE(written, then + 5) << "it writes on after the restart";
  const auto runs = (*store)->list("restart");  // this connection was cut too
  ASSERT_TRUE(runs) << toLogLine(runs.error());
  const auto ended = std::count_if(runs->begin(), runs->end(), [](const RecordedRun& run) { return run.ended; });
  EXPECT_GE(ended, written);
  EXPECT_EQ(runs->size(), static_cast<std::size_t>(written.load())) << "none twice, where an answer was lost";
}

TEST(RecordsFile, refusesWhatItCannotUse) {
  const std::filesystem::path folder = freshFolder();
  const auto secret = RecordStore::open("postgresql://me:secret@host/db");
  ASSERT_FALSE(secret);
  EXPECT_EQ(secret.error().arguments.at(0).find("secret"), std::string::npos) << "not even in the sentence";
  EXPECT_FALSE(RecordStore::open("mysql://host/db"));
  EXPECT_FALSE(RecordStore::open((folder / "missing" / "x.sqlite").string()));
  writeText(folder / "no.sqlite", "not a database, but long enough to look like something that somebody wanted to keep\n");
  EXPECT_FALSE(RecordStore::open((folder / "no.sqlite").string()));
  EXPECT_EQ(readText(folder / "no.sqlite").substr(0, 3), "not");
}

TEST(RecordsFile, aNewerOneIsRefused) {
  const std::string place = (freshFolder() / "newer.sqlite").string();
  ASSERT_TRUE(RecordStore::open(place));
  {
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("newer"));
    database.setDatabaseName(QString::fromStdString(place));
    ASSERT_TRUE(database.open());
    ASSERT_TRUE(QSqlQuery(database).exec(QStringLiteral("UPDATE schema_version SET version = 99")));
    database.close();
  }
  QSqlDatabase::removeDatabase(QStringLiteral("newer"));
  const auto newer = RecordStore::open(place);
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().fault, Fault::NewerSchema);
}

TEST(RecordsCommand, keepsListsExportsAndErases) {
  const std::filesystem::path folder = freshFolder();
  const std::string records = " --records '" + (folder / "r.sqlite").string() + "'";
  const Outcome run = glenoidProgram("run builtin:landmarks --seconds 1 --trainee Ana" + records);
  EXPECT_EQ(run.status, 0) << run.err;
  const Outcome list = glenoidProgram("records list --trainee Ana" + records);
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("builtin:landmarks"), std::string::npos);
  EXPECT_NE(list.out.find("1 run in"), std::string::npos) << list.out;
  EXPECT_EQ(glenoidProgram("records list" + records).status, 2);
  EXPECT_EQ(glenoidProgram("records export --trainee Ana --out '" + (folder / "ana.json").string() + "'" + records).status, 0);
  EXPECT_NE(readText(folder / "ana.json").find("acromial-angle"), std::string::npos);
  EXPECT_EQ(glenoidProgram("records erase --trainee Ana" + records).status, 2) << "only with --yes";
  EXPECT_EQ(glenoidProgram("records erase --trainee Ana --yes" + records).status, 0);
  EXPECT_EQ(glenoidProgram("records list --trainee Ana" + records).status, 2);
  EXPECT_EQ(glenoidProgram("run builtin:arthroscopy --seconds 1 --trainee Ana" + records).status, 2) << "it has no tasks";
  EXPECT_EQ(glenoidProgram("run builtin:landmarks --seconds 1" + records).status, 2) << "for whom?";
}

}  // namespace
}  // namespace glenoid

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  if (argc == 5 && std::string(argv[1]) == glenoid::kStation) return glenoid::station(argv[2], argv[3], std::atoi(argv[4]));
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
