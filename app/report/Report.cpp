// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/Report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QImage>

#include "app/plot/PlotFile.h"

namespace glenoid {
namespace {

struct ReportTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::Report)
};

constexpr const char* kSheet =
    "body{font:15px/1.5 'DejaVu Sans',Verdana,sans-serif;color:#1c1f23;max-width:1060px;margin:32px auto;padding:0 20px}"
    "h1{font-size:27px}h2{font-size:21px;margin-top:40px;border-bottom:1px solid #ccd}h3{font-size:17px;margin-top:28px}"
    "p.answer{background:#eaf4f6;border-left:4px solid #1f7a8c;padding:10px 14px}"
    "figure{margin:22px 0;break-inside:avoid}figure svg,figure img{max-width:100%;height:auto}"
    "figcaption,caption{font-size:13px;color:#444;text-align:left;padding:4px 0}"
    "table{border-collapse:collapse;font-size:13px;margin:18px 0;display:block;overflow-x:auto}"
    "th,td{border-bottom:1px solid #ccd;padding:4px 9px;text-align:left;vertical-align:top}th{border-bottom:2px solid #99a}"
    "td.figure,th.figure{text-align:right;white-space:nowrap}";

QString escaped(const QString& text) { return text.toHtmlEscaped(); }

QString contentHtml(const ReportFigure& figure) {
  if (const auto* plot = std::get_if<LogLogPlot>(&figure.content)) {
    const QString svg = QString::fromUtf8(plotSvg(*plot));
    return svg.mid(std::max<qsizetype>(0, svg.indexOf(u"<svg")));  // what stands before it belongs to a file of its own
  }
  QFile file(QString::fromStdString(std::get<std::string>(figure.content)));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QStringLiteral("<img alt=\"%1\" src=\"data:image/png;base64,%2\">").arg(escaped(figure.caption), QString::fromLatin1(file.readAll().toBase64()));
}

QString tableHtml(const ReportTable& table) {
  const auto kind = [&](int column) {
    return std::find(table.figures.begin(), table.figures.end(), column) == table.figures.end() ? QString() : QStringLiteral(" class=\"figure\"");
  };
  QString out = QStringLiteral("<table><caption>%1</caption><thead><tr>").arg(escaped(captionOf(table)));
  for (int c = 0; c < table.columns.size(); ++c) out += QStringLiteral("<th%1>%2</th>").arg(kind(c), escaped(table.columns[c]));
  out += QStringLiteral("</tr></thead><tbody>\n");
  for (const QStringList& row : table.rows) {
    out += QStringLiteral("<tr>");
    for (int c = 0; c < row.size(); ++c) out += QStringLiteral("<td%1>%2</td>").arg(kind(c), escaped(row[c]));
    out += QStringLiteral("</tr>\n");
  }
  return out + QStringLiteral("</tbody></table>\n");
}

}  // namespace

void Report::heading(int level, const QString& text) { blocks.push_back(ReportHeading{level, text}); }

void Report::words(const QString& text, bool important) {
  if (!text.isEmpty()) blocks.push_back(ReportWords{text, important});
}

int Report::figure(const QString& caption, std::variant<LogLogPlot, std::string> content) {
  blocks.push_back(ReportFigure{++m_figures, caption, std::move(content)});
  return m_figures;
}

int Report::table(ReportTable table) {
  table.number = ++m_tables;
  blocks.push_back(std::move(table));
  return m_tables;
}

QString captionOf(const ReportFigure& figure) { return ReportTexts::tr("Figure %1. %2").arg(figure.number).arg(figure.caption); }

QString captionOf(const ReportTable& table) { return ReportTexts::tr("Table %1. %2").arg(table.number).arg(table.caption); }

QByteArray reportHtml(const Report& report) {
  QString out = QStringLiteral("<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1</title><style>%2</style></head><body>\n").arg(escaped(report.title), QLatin1String(kSheet));
  for (const ReportBlock& block : report.blocks) {
    if (const auto* heading = std::get_if<ReportHeading>(&block)) out += QStringLiteral("<h%1>%2</h%1>\n").arg(heading->level).arg(escaped(heading->text));
    if (const auto* words = std::get_if<ReportWords>(&block))
      out += QStringLiteral("<p%1>%2</p>\n").arg(words->important ? QStringLiteral(" class=\"answer\"") : QString(), escaped(words->text));
    if (const auto* figure = std::get_if<ReportFigure>(&block))
      out += QStringLiteral("<figure>%1<figcaption>%2</figcaption></figure>\n").arg(contentHtml(*figure), escaped(captionOf(*figure)));
    if (const auto* table = std::get_if<ReportTable>(&block)) out += tableHtml(*table);
  }
  return (out + QStringLiteral("</body></html>\n")).toUtf8();
}

}  // namespace glenoid
