// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QColor>
#include <QHash>
#include <QIcon>
#include <QString>

class QApplication;

namespace glenoid {

/// The colours of one look, by the words of resources/themes/*.json ("window", "text", "accent" …).
struct Theme {
  bool dark = false;
  QHash<QString, QColor> colors;
  QColor color(const QString& word) const { return colors.value(word, Qt::magenta); }
};

/// From the program's resources. "dark" or "light".
Theme loadTheme(bool dark);

/// Fusion, palette and style sheet for the whole program, at once.
void applyTheme(QApplication& application, const Theme& theme);

/// The theme in use; that of applyTheme.
const Theme& currentTheme();

/// resources/icons/NAME.svg in the current theme's text colour, sharp at any scale; white where it is checked.
QIcon themedIcon(const QString& name);
/// The same for rows of a tree, where "on" only means an open branch.
QIcon themedTreeIcon(const QString& name);

/// Contrast of two colours, 1…21. Source: WCAG 2.1, relative luminance and contrast ratio.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace glenoid
