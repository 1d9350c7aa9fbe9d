// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextObjectInterface>
#include <QTextTable>
#include <algorithm>

#include "app/report/Report.h"
#include "simcore/file/AtomicWrite.h"

namespace glenoid {

constexpr int kFigureObject = QTextFormat::UserObject + 1, kFigureIndex = QTextFormat::UserProperty + 1;

/// Ligatures could not be searched for in a PDF; without shaping there are none.
static QFont reportFont(double points, bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setStyleStrategy(QFont::PreferNoShaping);
  font.setPointSizeF(points);
  font.setBold(bold);
  return font;
}

/// A figure with its caption as one large letter of a line, so that no page parts them: plots are drawn and not rasterized.
class FigureObject : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
 public:
  explicit FigureObject(std::vector<const ReportFigure*> figures) : m_figures(std::move(figures)) {}

  QSizeF intrinsicSize(QTextDocument* document, int, const QTextFormat& format) override {
    const ReportFigure& figure = of(format);
    const QSizeF shape = std::holds_alternative<LogLogPlot>(figure.content) ? QSizeF(kPlotWidth, kPlotHeight) : QSizeF(imageOf(figure).size());
    const QSizeF page = document->pageSize();
    if (page.width() <= 0) return {120, 82};  // not laid out for a page yet
    const double width = page.width() - 2 * document->rootFrame()->frameFormat().leftMargin() - 4;
    const QSizeF size = shape.isEmpty() ? QSizeF(1, 1) : shape.scaled(width, 0.36 * page.height(), Qt::KeepAspectRatio);
    return {width, size.height() + captionHeight(document)};
  }

  void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document, int, const QTextFormat& format) override {
    const ReportFigure& figure = of(format);
    const double height = rect.height() - captionHeight(document);
    painter->save();
    painter->setPen(Qt::black);
    painter->setFont(reportFont(kCaption, false));
    painter->drawText(QRectF(rect.left(), rect.top() + height, rect.width(), rect.height() - height), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, captionOf(figure));
    painter->translate(rect.topLeft());
    if (const auto* plot = std::get_if<LogLogPlot>(&figure.content)) {
      painter->scale(height / kPlotHeight, height / kPlotHeight);
      draw(*painter, *plot);
    } else {
      const QImage image = imageOf(figure);
      painter->setRenderHint(QPainter::SmoothPixmapTransform);
      painter->drawImage(QRectF(QPointF(), QSizeF(image.size()).scaled(rect.width(), height, Qt::KeepAspectRatio)), image);
    }
    painter->restore();
  }

 private:
  static constexpr double kCaption = 8.5;  // points; there is room for two lines

  static double captionHeight(QTextDocument* document) {
    const QPaintDevice* device = document->documentLayout()->paintDevice();
    return 2.9 * kCaption * (device ? device->logicalDpiY() : 96) / 72;
  }
  const ReportFigure& of(const QTextFormat& format) const { return *m_figures[static_cast<std::size_t>(format.intProperty(kFigureIndex))]; }
  static QImage imageOf(const ReportFigure& figure) { return QImage(QString::fromStdString(std::get<std::string>(figure.content))); }

  std::vector<const ReportFigure*> m_figures;
};

namespace {

class Writer {
 public:
  explicit Writer(QTextDocument& document) : m_cursor(&document) {}

  void heading(const ReportHeading& heading) {
    QTextBlockFormat block;
    block.setHeadingLevel(heading.level);
    block.setTopMargin(heading.level == 1 ? 0 : 16);
    block.setBottomMargin(5);
    begin(block);
    m_cursor.insertText(heading.text, letters(heading.level == 1 ? 19 : heading.level == 2 ? 14 : 11.5, true));
  }
  void words(const ReportWords& words) {
    QTextBlockFormat block;
    block.setTopMargin(4);
    block.setBottomMargin(6);
    if (words.important) block.setBackground(QColor(234, 244, 246));
    begin(block);
    m_cursor.insertText(words.text, letters(9.5, false));
  }
  void figure(int index) {
    QTextBlockFormat block;
    block.setTopMargin(8);
    block.setBottomMargin(8);
    begin(block);
    QTextCharFormat object = letters(9, false);
    object.setObjectType(kFigureObject);
    object.setProperty(kFigureIndex, index);
    m_cursor.insertText(QString(QChar::ObjectReplacementCharacter), object);
  }
  void table(const ReportTable& table) {
    QTextBlockFormat above;
    above.setTopMargin(8);
    begin(above);
    m_cursor.insertText(captionOf(table), letters(8.5, false));
    QTextTableFormat format;
    format.setHeaderRowCount(1);
    format.setCellPadding(2.5);
    format.setCellSpacing(0);
    format.setBorder(0.4);
    format.setBorderBrush(QColor(190, 195, 205));
    format.setBorderCollapse(true);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    QTextTable* made = m_cursor.insertTable(static_cast<int>(table.rows.size()) + 1, static_cast<int>(table.columns.size()), format);
    const double size = table.columns.size() > 7 ? 6.5 : 7.5;
    for (int c = 0; c < table.columns.size(); ++c) cell(*made, 0, c, table.columns[c], letters(size, true), isFigure(table, c));
    for (std::size_t r = 0; r < table.rows.size(); ++r)
      for (int c = 0; c < table.rows[r].size(); ++c) cell(*made, static_cast<int>(r) + 1, c, table.rows[r][c], letters(size, false), isFigure(table, c));
    m_cursor.movePosition(QTextCursor::End);
  }

 private:
  static bool isFigure(const ReportTable& table, int column) { return std::find(table.figures.begin(), table.figures.end(), column) != table.figures.end(); }

  static QTextCharFormat letters(double points, bool bold) {
    QTextCharFormat format;
    format.setFont(reportFont(points, bold));
    return format;
  }
  void begin(const QTextBlockFormat& format) {
    if (m_begun) m_cursor.insertBlock(format, letters(9.5, false));
    else m_cursor.setBlockFormat(format);
    m_begun = true;
  }
  static void cell(QTextTable& table, int row, int column, const QString& text, const QTextCharFormat& format, bool right) {
    QTextCursor cursor = table.cellAt(row, column).firstCursorPosition();
    QTextBlockFormat block;
    block.setAlignment(right ? Qt::AlignRight : Qt::AlignLeft);
    cursor.setBlockFormat(block);
    cursor.insertText(text, format);
  }

  QTextCursor m_cursor;
  bool m_begun = false;
};

}  // namespace

Result<Done> writeReportPdf(const Report& report, const std::string& path) {
  QTextDocument document;
  document.setDefaultFont(reportFont(9, false));
  std::vector<const ReportFigure*> figures;
  for (const ReportBlock& block : report.blocks)
    if (const auto* figure = std::get_if<ReportFigure>(&block)) figures.push_back(figure);
  FigureObject object(figures);
  document.documentLayout()->registerHandler(kFigureObject, &object);
  Writer writer(document);
  int index = 0;
  for (const ReportBlock& block : report.blocks) {
    if (const auto* heading = std::get_if<ReportHeading>(&block)) writer.heading(*heading);
    if (const auto* words = std::get_if<ReportWords>(&block)) writer.words(*words);
    if (std::holds_alternative<ReportFigure>(block)) writer.figure(index++);
    if (const auto* table = std::get_if<ReportTable>(&block)) writer.table(*table);
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter pdf(&buffer);
    pdf.setTitle(report.title);
    pdf.setCreator(QStringLiteral("Glenoid Studio"));
    pdf.setResolution(300);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    document.print(&pdf);  // with margins and numbers of pages
  }
  const QByteArray& bytes = buffer.data();
  return writeWholeFile(path, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace glenoid

#include "ReportPdf.moc"
