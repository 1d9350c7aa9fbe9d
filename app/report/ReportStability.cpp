// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/report/StudyReport.h"
#include "editor/lab/StabilityEntries.h"

namespace glenoid {
namespace {

struct StabilityReportTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::ReportStability)
};

QString figureText(double value, int digits) { return std::isfinite(value) ? QLocale().toString(value, 'f', digits) : QStringLiteral("–"); }

/// The larger; what has no figure does not count, and where none has one there is none.
double worse(double a, double b) { return std::isnan(a) ? b : std::isnan(b) ? a : std::max(a, b); }

void casesTable(const std::vector<StabilityEntry>& entries, Report& report) {
  ReportTable table;
  table.caption = StabilityReportTexts::tr("Cases of the gauntlet, with the worst figures of their trials. Energy: gained beyond what there was and what was put in. Recovery: from the end of the load to rest.");
  table.columns = {StabilityReportTexts::tr("Case"),         StabilityReportTexts::tr("Held"),        StabilityReportTexts::tr("Energy, %"), StabilityReportTexts::tr("Depth, mm"),
                   StabilityReportTexts::tr("Of its bound"), StabilityReportTexts::tr("Recovery, s"), StabilityReportTexts::tr("Inside out at the end")};
  table.figures = {1, 2, 3, 4, 5, 6};
  std::vector<std::string> cases;
  for (const StabilityEntry& entry : entries)
    if (std::find(cases.begin(), cases.end(), entry.what) == cases.end()) cases.push_back(entry.what);
  for (const std::string& one : cases) {
    long trials = 0, held = 0, insideOut = 0;
    double energy = std::nan(""), depth = energy, share = energy, recovery = energy;
    for (const StabilityEntry& entry : entries) {
      if (entry.what != one || !entry.counts) continue;
      ++trials;
      held += entry.held;
      energy = worse(energy, 100 * entry.energyExcess);
      depth = worse(depth, entry.depthMm);
      share = worse(share, entry.depthOfBound);
      recovery = worse(recovery, entry.recoveryS);
      insideOut = std::max(insideOut, entry.insideOutEnd);
    }
    if (trials == 0) continue;
    table.rows.push_back({trialWords(one), StabilityReportTexts::tr("%1 of %2").arg(held).arg(trials), figureText(energy, 2), figureText(depth, 3), figureText(share, 2), figureText(recovery, 2),
                          QLocale().toString(static_cast<qlonglong>(insideOut))});
  }
  report.table(std::move(table));
}

}  // namespace

void reportStability(const StudyFolder& study, Report& report) {
  const std::vector<StabilityEntry> entries = stabilityEntries(study);
  report.heading(2, StabilityReportTexts::tr("What stays stable: %1").arg(sceneOf(study)));
  report.words(verdictSummary(entries));
  casesTable(entries, report);
  bool first = true;
  for (const bool counts : {true, false})
    for (const StabilityEntry& entry : entries) {
      if (entry.held || entry.counts != counts) continue;
      if (std::exchange(first, false)) report.heading(3, StabilityReportTexts::tr("What did not hold"));
      const QString name = QStringLiteral("%1 (%2)").arg(trialWords(entry.what), QString::fromStdString(entry.id)) + (counts ? QString() : StabilityReportTexts::tr(", as published"));
      report.words(QStringLiteral("%1: %2").arg(name, verdictSentence(entry)));
      if (counts && !entry.picture.empty()) report.figure(StabilityReportTexts::tr("The end of %1.").arg(name), entry.picture);
    }
}

}  // namespace glenoid
