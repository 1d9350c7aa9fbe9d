// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <cstdio>
#include <memory>

#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/StudyCommand.h"
#include "app/report/StudyReport.h"
#include "simcore/file/AtomicWrite.h"

static void initReportTranslations() { Q_INIT_RESOURCE(glenoid_translations); }  // wants the global namespace

namespace glenoid {
namespace {

struct Wishes {
  std::vector<std::string> folders;
  std::string out, language = "en", budget = "5ms";
};

bool endsWith(const std::string& path, const char* ending) { return QString::fromStdString(path).endsWith(QLatin1String(ending), Qt::CaseInsensitive); }

Result<Done> report(const Wishes& wishes) {
  const bool pdf = endsWith(wishes.out, ".pdf");
  if (!pdf && !endsWith(wishes.out, ".html")) return usageError("--out wants a file that ends with .html or .pdf, not “" + wishes.out + "”");
  const Result<double> budget = durationNamed("--budget", wishes.budget);
  if (!budget) return usageError("--budget wants a time above zero, such as 5ms or 0.005s, not “" + wishes.budget + "”");
  initReportTranslations();
  QTranslator translator;
  if (translator.load(QStringLiteral(":/translations/glenoid_%1.qm").arg(QString::fromStdString(wishes.language)))) QCoreApplication::installTranslator(&translator);
  QLocale::setDefault(QLocale(QString::fromStdString(wishes.language)));
  std::vector<StudyFolder> studies;
  for (const std::string& folder : wishes.folders) {
    Result<StudyFolder> study = StudyFolder::open(folder);
    if (!study) return study.error();
    studies.push_back(std::move(*study));
  }
  if (const auto good = checkWritable(wishes.out); !good) return good;
  const Report written = studyReport(studies, 1e3 * *budget);
  if (pdf) return writeReportPdf(written, wishes.out);
  const QByteArray html = reportHtml(written);
  return writeWholeFile(wishes.out, std::string_view(html.constData(), static_cast<std::size_t>(html.size())));
}

}  // namespace

void addStudyReport(CLI::App& study, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = study.add_subcommand("report", "Studies as one document: which setting to use, figures, tables, the machine");
  command->add_option("DIR", wishes->folders, "Folders of studies, as --out of each named them")->required();
  command->add_option("--out", wishes->out, "FILE.html, with all pictures in it, or FILE.pdf")->required();
  command->add_option("--budget", wishes->budget, "Computing time for one of the scene's time steps' worth, for which a setting is named [5ms]");
  command->add_option("--language", wishes->language, "Of the document: en or es [en]")->check(CLI::IsMember({"en", "es"}));
  command->callback([wishes, &status] {
    const Result<Done> done = report(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
