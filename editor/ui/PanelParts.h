// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QString>

/// Pieces that the author's panels are made of. Every one has an object name, so that tests and style sheets
/// find it.
namespace glenoid::panel {

inline QString text(const std::string& words) {
  return QString::fromStdString(words);
}

/// Takes a value when the person is done with it; the wheel scrolls the panel, not the values it passes over.
inline QDoubleSpinBox* field(const QString& name, double low, double high, int decimals) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setMinimumWidth(70);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

inline QPushButton* button(const char* name) {
  auto* made = new QPushButton;
  made->setObjectName(QLatin1String(name));
  return made;
}

/// `role`: of the style sheet, or null.
inline QLabel* words(const char* name, const char* role = nullptr) {
  auto* made = new QLabel;
  made->setObjectName(QLatin1String(name));
  made->setWordWrap(true);
  if (role) made->setProperty("role", QLatin1String(role));
  return made;
}

}  // namespace glenoid::panel
