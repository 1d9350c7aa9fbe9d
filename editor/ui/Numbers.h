// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QLocale>
#include <QString>

namespace glenoid {

/// A number as people read it in their language, with `decimals` digits after the point.
inline QString number(double value, int decimals = 0) { return QLocale().toString(value, 'f', decimals); }
inline QString number(long value) { return QLocale().toString(static_cast<qlonglong>(value)); }
inline QString number(std::size_t value) { return QLocale().toString(static_cast<qulonglong>(value)); }

}  // namespace glenoid
