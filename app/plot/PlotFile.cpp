// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plot/PlotFile.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPageLayout>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <string_view>

#include "simcore/file/AtomicWrite.h"

namespace glenoid {
namespace {

Result<Done> write(const std::string& path, const QByteArray& bytes) {
  return writeWholeFile(path, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

template <class Plot>
QByteArray pngOf(const Plot& plot) {
  constexpr int kScale = 2;
  QImage image(kScale * kPlotWidth, kScale * kPlotHeight, QImage::Format_RGB32);
  {
    QPainter painter(&image);
    painter.scale(kScale, kScale);
    draw(painter, plot);
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

template <class Plot>
QByteArray svgOf(const Plot& plot) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(QSize(kPlotWidth, kPlotHeight));
  generator.setViewBox(QRect(0, 0, kPlotWidth, kPlotHeight));
  generator.setTitle(QString::fromStdString(plot.title));
  {
    QPainter painter(&generator);
    draw(painter, plot);
  }
  return buffer.data();
}

template <class Plot>
QByteArray pdfOf(const Plot& plot) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(plot.title));
    writer.setResolution(288);
    // As wide as A4 lies, as high as the plot asks.
    writer.setPageSize(QPageSize(QSizeF(297, 297.0 * kPlotHeight / kPlotWidth), QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    QPainter painter(&writer);
    const double scale = static_cast<double>(writer.width()) / kPlotWidth;
    painter.scale(scale, scale);
    draw(painter, plot);
  }
  return buffer.data();
}

template <class Plot>
Result<Done> writeAll(const Plot& plot, const std::string& stem) {
  if (const auto done = write(stem + ".png", pngOf(plot)); !done) return done;
  if (const auto done = write(stem + ".svg", svgOf(plot)); !done) return done;
  return write(stem + ".pdf", pdfOf(plot));
}

}  // namespace

QByteArray plotSvg(const LogLogPlot& plot) { return svgOf(plot); }

Result<Done> writePlot(const LogLogPlot& plot, const std::string& stem) {
  return writeAll(plot, stem);
}
Result<Done> writePlot(const BarPlot& plot, const std::string& stem) {
  return writeAll(plot, stem);
}

}  // namespace glenoid
