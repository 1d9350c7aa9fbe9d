// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/Theme.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

Theme& theTheme() {
  static Theme theme;
  return theme;
}

QByteArray readResource(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Draws an SVG in whatever colour the theme asks for at the moment of drawing, so that a change of theme
/// needs no new icons.
class ThemedIconEngine : public QIconEngine {
 public:
  ThemedIconEngine(QString name, bool onAccent) : m_name(std::move(name)), m_onAccent(onAccent) {}
  QIconEngine* clone() const override { return new ThemedIconEngine(m_name, m_onAccent); }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const char* word = mode == QIcon::Disabled ? "disabled"
                       : (m_onAccent && state == QIcon::On) || mode == QIcon::Selected ? "accentText" : "text";
    QByteArray svg = readResource(QStringLiteral(":/icons/") + m_name + QStringLiteral(".svg"));
    svg.replace("#000000", currentTheme().color(QLatin1String(word)).name().toLatin1());
    QSvgRenderer renderer(svg);
    renderer.render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

 private:
  QString m_name;
  bool m_onAccent;  ///< "on" stands on the accent colour: a checked button; a tree's open branch does not
};

QPalette paletteOf(const Theme& t) {
  QPalette p;
  const auto set = [&](QPalette::ColorRole role, const char* word) { p.setColor(role, t.color(QLatin1String(word))); };
  set(QPalette::Window, "window");
  set(QPalette::WindowText, "text");
  set(QPalette::Base, "base");
  set(QPalette::AlternateBase, "alternate");
  set(QPalette::Text, "text");
  set(QPalette::Button, "raised");
  set(QPalette::ButtonText, "text");
  set(QPalette::BrightText, "error");
  set(QPalette::ToolTipBase, "raised");
  set(QPalette::ToolTipText, "text");
  set(QPalette::PlaceholderText, "muted");
  set(QPalette::Highlight, "accent");
  set(QPalette::HighlightedText, "accentText");
  set(QPalette::Link, "link");
  set(QPalette::LinkVisited, "link");
  set(QPalette::Mid, "line");
  set(QPalette::Midlight, "line");
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, t.color(QStringLiteral("disabled")));
  }
  return p;
}

}  // namespace

Theme loadTheme(bool dark) {
  Theme theme;
  theme.dark = dark;
  const QString path = dark ? QStringLiteral(":/themes/dark.json") : QStringLiteral(":/themes/light.json");
  const QJsonObject object = QJsonDocument::fromJson(readResource(path)).object();
  for (auto it = object.begin(); it != object.end(); ++it) theme.colors[it.key()] = QColor(it.value().toString());
  return theme;
}

void applyTheme(QApplication& application, const Theme& theme) {
  theTheme() = theme;
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(paletteOf(theme));
  QString sheet = QString::fromUtf8(readResource(QStringLiteral(":/themes/glenoid.qss")));
  QStringList words = theme.colors.keys();
  // Longer words first: "accentText" before "accent".
  std::sort(words.begin(), words.end(), [](const QString& a, const QString& b) { return a.size() > b.size(); });
  for (const QString& word : words) sheet.replace(QLatin1Char('@') + word, theme.color(word).name());
  application.setStyleSheet(sheet);
}

const Theme& currentTheme() { return theTheme(); }

QIcon themedIcon(const QString& name) { return QIcon(new ThemedIconEngine(name, true)); }

QIcon themedTreeIcon(const QString& name) { return QIcon(new ThemedIconEngine(name, false)); }

double contrastRatio(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace glenoid
