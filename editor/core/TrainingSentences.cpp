// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/TrainingSentences.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace glenoid {
namespace {

struct TrainingSentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::TrainingSentences)
};

QString kindWords(const std::string& word) {
  if (word == "tasks") return TrainingSentences::tr("tasks done, by their score");
  if (word == "errors") return TrainingSentences::tr("errors");
  if (word == "order") return TrainingSentences::tr("tasks out of order");
  if (word == "time") return TrainingSentences::tr("time");
  if (word == "path") return TrainingSentences::tr("length of the path");
  if (word == "economy") return TrainingSentences::tr("economy of the path");
  if (word == "jerk") return TrainingSentences::tr("jerk (smaller is smoother)");
  if (word == "speed") return TrainingSentences::tr("mean speed");
  if (word == "forceMax") return TrainingSentences::tr("largest force");
  if (word == "forceMean") return TrainingSentences::tr("mean force while touching");
  if (word == "touchSeconds") return TrainingSentences::tr("time touching");
  if (word == "tooHardSeconds") return TrainingSentences::tr("time pressed too hard");
  if (word == "tooHard") return TrainingSentences::tr("times pressed too hard");
  if (word == "steadiness") return TrainingSentences::tr("turning of the view");
  if (word == "inView") return TrainingSentences::tr("sought place in view");
  if (word == "distance") return TrainingSentences::tr("distance of what was found");
  if (word == "depth") return TrainingSentences::tr("depth of what was found");
  return QString::fromStdString(word);
}

}  // namespace

QString metricWords(const std::string& metric, const Scenario& scenario) {
  const auto dot = metric.rfind('.');
  const QString kind = kindWords(dot == std::string::npos ? metric : metric.substr(dot + 1));
  if (dot == std::string::npos) return kind.left(1).toUpper() + kind.mid(1);
  const std::string owner = metric.substr(0, dot);
  QString name = QString::fromStdString(owner);
  if (const int tool = findTool(scenario, owner); tool >= 0 && !scenario.tools[static_cast<std::size_t>(tool)].name.empty())
    name = QString::fromStdString(scenario.tools[static_cast<std::size_t>(tool)].name);
  for (const ForceLimit& limit : scenario.training.limits)
    if (limit.id == owner && !limit.name.empty()) name = QString::fromStdString(limit.name);
  return TrainingSentences::tr("%1: %2").arg(name, kind);
}

QString metricFigure(const std::string& metric, const std::optional<double>& value) {
  if (!value) return QStringLiteral("–");
  const MetricKind* kind = metricKind(metric);
  const QString unit = kind ? QString::fromUtf8(kind->unit) : QStringLiteral("1");
  const QLocale locale;
  if (unit == u"m") return TrainingSentences::tr("%1 mm").arg(locale.toString(*value * 1e3, 'f', *value < 0.1 ? 1 : 0));
  if (unit == u"m/s") return TrainingSentences::tr("%1 mm/s").arg(locale.toString(*value * 1e3, 'f', 1));
  if (unit == u"1") return locale.toString(*value, 'g', 4);
  return QStringLiteral("%1 %2").arg(locale.toString(*value, 'f', 2), unit);
}

QString metricFormula(const std::string& metric) {
  const MetricKind* kind = metricKind(metric);
  if (!kind) return {};
  return *kind->evidence ? TrainingSentences::tr("%1\nValidated: %2").arg(QString::fromUtf8(kind->formula), QString::fromUtf8(kind->evidence))
                         : TrainingSentences::tr("%1\nExperimental: nobody has shown with this program that it tells skilled people from others.").arg(QString::fromUtf8(kind->formula));
}

QString outcomeWord(TaskOutcome outcome) {
  switch (outcome) {
    case TaskOutcome::Waiting: return TrainingSentences::tr("later");
    case TaskOutcome::Open: return TrainingSentences::tr("to do");
    case TaskOutcome::Done: return TrainingSentences::tr("done");
    case TaskOutcome::Missed: return TrainingSentences::tr("missed");
  }
  return {};
}

QString taskName(const TaskResult& task) { return QString::fromStdString(task.name.empty() ? task.id : task.name); }

QString trainingSentence(const TrainingReport& report) {
  const auto done = std::count_if(report.tasks.begin(), report.tasks.end(), [](const TaskResult& task) { return task.record.outcome == TaskOutcome::Done; });
  const QString count = TrainingSentences::tr("%1 of %2 tasks done").arg(done).arg(report.tasks.size());
  if (!report.finished) return count;
  return report.passed ? TrainingSentences::tr("%1. %2 of 100 points: passed.").arg(count, QLocale().toString(report.score, 'f', 0))
                       : TrainingSentences::tr("%1. %2 of 100 points: not passed.").arg(count, QLocale().toString(report.score, 'f', 0));
}

}  // namespace glenoid
