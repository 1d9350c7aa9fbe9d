// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/StudyReport.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/TableText.h"
#include "editor/lab/SettingWords.h"
#include "editor/lab/StabilityEntries.h"

namespace glenoid {
namespace {

struct StudyTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::StudyReport)
 public:
  static QString kind(const std::string& kind) {
    if (kind == "accuracy") return tr("What accuracy costs");
    if (kind == "stability") return tr("What stays stable");
    if (kind == "truth") return tr("Truth");
    if (kind == "effects") return tr("What each effect costs");
    return QString::fromStdString(kind);
  }
};

QString cellText(const JsonValue& value) {
  if (value.isText()) return value.text().empty() ? QStringLiteral("–") : QString::fromStdString(value.text());
  if (value.isBoolean()) return value.boolean() ? StudyTexts::tr("yes") : StudyTexts::tr("no");
  if (value.isInteger()) return QLocale().toString(static_cast<qlonglong>(value.integer()));
  if (value.isNumber() && std::isfinite(value.number())) return QLocale().toString(value.number(), 'g', 4);
  return QStringLiteral("–");  // no figure: nothing that could be taken for one
}

void machineTable(const std::vector<StudyFolder>& studies, Report& report) {
  ReportTable table;
  table.caption = StudyTexts::tr("The studies, and the machine and build that their times are of.");
  table.columns = {StudyTexts::tr("Study"), StudyTexts::tr("Scene"), StudyTexts::tr("Extent"), StudyTexts::tr("Processor"), StudyTexts::tr("Build"), StudyTexts::tr("Kernels"), StudyTexts::tr("Threads")};
  for (const StudyFolder& study : studies) {
    const JsonValue& head = study.head();
    const bool quick = head["quick"].boolean() || head["extent"].text() == "quick";
    table.rows.push_back({StudyTexts::kind(study.kind()), sceneOf(study), quick ? StudyTexts::tr("quick") : StudyTexts::tr("whole"), cellText(head["processor"]), cellText(head["build"]),
                          cellText(head["isa"]), cellText(head["threads"])});
  }
  report.table(std::move(table));
}

}  // namespace

QString sceneOf(const StudyFolder& study) {
  const QString word = QString::fromStdString(study.head()["scenario"].text());
  if (word.startsWith(u"builtin:") || word.isEmpty()) return word;
  return QFileInfo(word).fileName();
}

void reportTables(const StudyFolder& study, Report& report) {
  report.heading(2, StudyTexts::tr("%1: %2").arg(StudyTexts::kind(study.kind()), sceneOf(study)));
  namespace fs = std::filesystem;
  std::vector<std::string> pictures;
  std::error_code failed;
  for (fs::directory_iterator it(study.path(), failed), end; !failed && it != end; it.increment(failed))
    if (it->path().extension() == ".png") pictures.push_back(it->path().string());
  std::sort(pictures.begin(), pictures.end());
  constexpr qsizetype kColumnsMost = 9;  // as many as a page has room for
  for (const auto& [id, document] : study.documents()) {
    ReportTable table;
    table.caption = QString::fromStdString(keyWords(id)) + QLatin1Char('.');
    for (const JsonValue& column : document["columns"].items())
      if (table.columns.size() < kColumnsMost) table.columns << QString::fromStdString(keyWords(column.text()));
    if (table.columns.isEmpty()) continue;
    if (static_cast<qsizetype>(document["columns"].items().size()) > kColumnsMost) table.caption += QLatin1Char(' ') + StudyTexts::tr("Further columns are in the file %1.csv.").arg(QString::fromStdString(id));
    for (const JsonValue& row : document["rows"].items()) {
      QStringList cells;
      for (qsizetype c = 0; c < table.columns.size(); ++c) cells << cellText(row[document["columns"][static_cast<std::size_t>(c)].text()]);
      table.rows.push_back(cells);
    }
    for (int c = 0; c < table.columns.size(); ++c)
      if (!document["rows"].items().empty() && document["rows"][0][document["columns"][c].text()].isNumber()) table.figures.push_back(c);
    report.table(std::move(table));
  }
  for (const std::string& picture : pictures) report.figure(QString::fromStdString(fs::path(picture).stem().string()) + QLatin1Char('.'), picture);
}

Report studyReport(const std::vector<StudyFolder>& studies, double budgetMs) {
  Report report;
  QStringList scenes;
  for (const StudyFolder& study : studies)
    if (!scenes.contains(sceneOf(study))) scenes << sceneOf(study);
  report.title = StudyTexts::tr("Studies of %1").arg(scenes.join(QStringLiteral(", ")));
  report.heading(1, report.title);
  report.words(StudyTexts::tr("Written on %1.").arg(QLocale().toString(QDateTime::currentDateTime(), QLocale::LongFormat)));
  report.heading(2, StudyTexts::tr("In short"));
  for (const StudyFolder& study : studies) {
    if (study.kind() == "accuracy") report.words(accuracyAnswer(study, budgetMs), true);
    if (study.kind() == "stability") report.words(StudyTexts::tr("Hard cases of %1: %2").arg(sceneOf(study), verdictSummary(stabilityEntries(study))), true);
    if (!study.isWhole()) report.words(StudyTexts::tr("The study of %1 in %2 did not come to its end; what it had found until then is shown.").arg(sceneOf(study), QString::fromStdString(study.path())));
  }
  machineTable(studies, report);
  report.words(StudyTexts::tr("Times are thread CPU time of one thread. Another machine has others; errors are a function of scene, build and kernels alone."));
  for (const StudyFolder& study : studies) {
    if (study.kind() == "accuracy") reportAccuracy(study, budgetMs, report);
    else if (study.kind() == "stability") reportStability(study, report);
    else reportTables(study, report);
  }
  return report;
}

}  // namespace glenoid
