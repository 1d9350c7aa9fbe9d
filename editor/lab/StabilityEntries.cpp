// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StabilityEntries.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

struct StabilityTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::StabilityEntries)
 public:
  static QString trial(const std::string& what) {
    struct Word {
      const char* id;
      const char* text;
    };
    static constexpr Word kWords[] = {
        {"left-alone", QT_TR_NOOP("Left alone")},
        {"press", QT_TR_NOOP("A tool presses")},
        {"hand-inside", QT_TR_NOOP("The hand is suddenly inside")},
        {"impact", QT_TR_NOOP("Impact")},
        {"fast-drag", QT_TR_NOOP("Fast drag")},
        {"squeezed", QT_TR_NOOP("Squeezed by a strong hand")},
        {"silent-device", QT_TR_NOOP("The device falls silent")},
        {"wild-device", QT_TR_NOOP("The device goes wild")},
        {"blow", QT_TR_NOOP("A blow on a bone")},
        {"end-of-range", QT_TR_NOOP("End of range")},
        {"start-at-speed", QT_TR_NOOP("Start at speed")},
        {"random-loads", QT_TR_NOOP("Random loads")},
        {"gravity-turned", QT_TR_NOOP("Gravity turned")},
        {"gravity-gone", QT_TR_NOOP("Gravity gone")},
        {"scattered", QT_TR_NOOP("Nodes scattered")},
        {"collapsed-to-plane", QT_TR_NOOP("Collapsed to a plane")},
        {"collapsed-to-point", QT_TR_NOOP("Collapsed to a point")},
        {"mirrored", QT_TR_NOOP("Mirrored")},
        {"inside-out", QT_TR_NOOP("Turned inside out")},
        {"flattened", QT_TR_NOOP("Flattened")},
        {"thousand-times-stiffer", QT_TR_NOOP("A thousand times stiffer")},
        {"thousand-times-softer", QT_TR_NOOP("A thousand times softer")},
        {"poisson-0.49", QT_TR_NOOP("Poisson’s ratio 0.49")},
        {"poisson-0.4999", QT_TR_NOOP("Poisson’s ratio 0.4999")}};
    for (const Word& word : kWords)
      if (what == word.id) return tr(word.text);
    return QString::fromStdString(what);
  }
  static QString broken(const std::string& word) {
    if (word == "not-finite") return tr("not finite");
    if (word == "rejected-steps") return tr("steps not taken");
    if (word == "energy") return tr("energy gained");
    if (word == "depth") return tr("too deep");
    if (word == "inside-out") return tr("left inside out");
    if (word == "too-deep-at-end") return tr("too deep at the end");
    if (word == "not-at-rest") return tr("does not come to rest");
    if (word == "time-up") return tr("took too long");
    return QString::fromStdString(word);
  }
  static QString digits(double value, char format = 'g', int count = 3) { return std::isfinite(value) ? QLocale().toString(value, format, count) : QStringLiteral("–"); }
  static QString sentence(const StabilityEntry& entry, const std::string& word) {
    if (word == "not-finite") return tr("After %1 steps the state is not finite.").arg(entry.steps);
    if (word == "rejected-steps") return tr("%1 of %2 steps were not finite and not taken.").arg(entry.rejected).arg(entry.steps);
    if (word == "energy") return tr("It holds %1 % more energy than what it had and what was done to it.").arg(digits(100 * entry.energyExcess));
    if (word == "depth")
      return tr("%1 lie %2 mm in each other, %3 times as deep as they may.").arg(QString::fromStdString(entry.depthPair), digits(entry.depthMm), digits(entry.depthOfBound));
    if (word == "inside-out") return tr("%1 elements are still inside out.").arg(entry.insideOutEnd);
    if (word == "too-deep-at-end") return tr("At the end surfaces still lie too deep in each other.");
    if (word == "not-at-rest")
      return tr("%1 s after the load it was not at rest; at the end its fastest point moves at %2 mm/s.").arg(digits(entry.recoveryS), digits(1e3 * entry.endSpeed));
    if (word == "time-up") return tr("It took too long and was stopped after %1 s of simulated time.").arg(digits(1e-3 * entry.stepMs * static_cast<double>(entry.steps)));
    return {};
  }
};

bool fileIsThere(const std::string& path) { return QFileInfo::exists(QString::fromStdString(path)); }

}  // namespace

std::vector<StabilityEntry> stabilityEntries(const StudyFolder& study) {
  std::vector<StabilityEntry> entries;
  for (const JsonValue& row : study.rows("stability")) {
    StabilityEntry& entry = entries.emplace_back();
    entry.id = row["trial"].text();
    entry.what = row["case"].text();
    entry.subject = row["subject"].text();
    entry.profile = row["profile"].text();
    entry.stepMs = figureOf(row, "stepMs");
    entry.counts = row["counts"].boolean(true);
    const std::string& verdict = row["verdict"].text();
    entry.held = verdict.rfind("held", 0) == 0;
    if (!entry.held)
      for (const QString& word : QString::fromStdString(verdict).split(QStringLiteral(", "))) entry.broken.push_back(word.toStdString());
    entry.carries = !(figureOf(row, "carriedShare") > 1);
    entry.energyExcess = figureOf(row, "energyExcess");
    entry.depthMm = figureOf(row, "depthMm");
    entry.depthOfBound = figureOf(row, "depthOfBound");
    entry.depthPair = row["depthPair"].text();
    entry.recoveryS = figureOf(row, "recoveryS");
    entry.endSpeed = figureOf(row, "endSpeedMPerS");
    entry.insideOutMost = static_cast<long>(row["insideOutMost"].integer());
    entry.insideOutEnd = static_cast<long>(row["insideOutEnd"].integer());
    entry.steps = static_cast<long>(row["steps"].integer());
    entry.rejected = static_cast<long>(row["rejectedSteps"].integer());
    if (entry.held) continue;
    const std::string stem = study.path() + "/" + entry.id + (entry.counts ? "" : "." + entry.profile);
    if (fileIsThere(stem + ".recording")) entry.recording = stem + ".recording";
    if (fileIsThere(stem + ".png")) entry.picture = stem + ".png";
  }
  std::stable_sort(entries.begin(), entries.end(), [](const StabilityEntry& a, const StabilityEntry& b) { return a.counts > b.counts; });
  return entries;
}

QString trialWords(const std::string& what) { return StabilityTexts::trial(what); }

QString verdictWords(const StabilityEntry& entry) {
  if (entry.held) return entry.carries ? StabilityTexts::tr("held") : StabilityTexts::tr("held; cannot carry itself");
  QStringList words;
  for (const std::string& word : entry.broken) words << StabilityTexts::broken(word);
  return words.join(QStringLiteral(", "));
}

QString verdictSentence(const StabilityEntry& entry) {
  QStringList words;
  for (const std::string& word : entry.broken) words << StabilityTexts::sentence(entry, word);
  if (entry.held) words << StabilityTexts::tr("It held.");
  if (!entry.carries) words << StabilityTexts::tr("Its matter cannot carry its weight and its loads: it need not come to rest.");
  return words.join(QLatin1Char(' '));
}

QString verdictSummary(const std::vector<StabilityEntry>& entries) {
  long counted = 0, held = 0, beside = 0, besideHeld = 0;
  for (const StabilityEntry& entry : entries) {
    (entry.counts ? counted : beside) += 1;
    (entry.counts ? held : besideHeld) += entry.held;
  }
  QString sentence = StabilityTexts::tr("%1 of %2 trials held.").arg(held).arg(counted);
  if (beside > 0) sentence += QLatin1Char(' ') + StabilityTexts::tr("Of the published method, which does not count: %1 of %2.").arg(besideHeld).arg(beside);
  return sentence;
}

}  // namespace glenoid
