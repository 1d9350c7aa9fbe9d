// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QStringList>
#include <string>
#include <variant>
#include <vector>

#include "app/plot/LogLogPlot.h"
#include "simcore/base/Error.h"

namespace glenoid {

/// A document before it has a layout: what stands in it, in order. Figures and tables are numbered by their order.
struct ReportHeading {
  int level = 1;  ///< 1: the title, once
  QString text;
};
struct ReportWords {
  QString text;
  bool important = false;
};
struct ReportFigure {
  int number = 0;
  QString caption;
  std::variant<LogLogPlot, std::string> content;  ///< a plot, or the path of a picture
};
struct ReportTable {
  int number = 0;
  QString caption;
  QStringList columns;
  std::vector<QStringList> rows;
  std::vector<int> figures;  ///< columns that hold figures: to the right
};
using ReportBlock = std::variant<ReportHeading, ReportWords, ReportFigure, ReportTable>;

struct Report {
  QString title;
  std::vector<ReportBlock> blocks;

  void heading(int level, const QString& text);
  void words(const QString& text, bool important = false);
  int figure(const QString& caption, std::variant<LogLogPlot, std::string> content);  ///< answers its number
  int table(ReportTable table);

 private:
  int m_figures = 0, m_tables = 0;
};

/// One file with all in it: pictures inlined, plots as graphics whose letters can be searched for; nothing is fetched.
QByteArray reportHtml(const Report& report);

/// A4, pages numbered, letters that can be searched for. Fails as writeWholeFile does. Needs a QGuiApplication.
Result<Done> writeReportPdf(const Report& report, const std::string& path);

/// "Figure 3. Caption."
QString captionOf(const ReportFigure& figure);
QString captionOf(const ReportTable& table);

}  // namespace glenoid
