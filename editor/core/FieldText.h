// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QLocale>
#include <QString>

#include "editor/render/Layers.h"
#include "simcore/reading/FieldRange.h"

namespace glenoid {

/// What people call a quantity and its values. Works with no QCoreApplication (English then).
QString quantityLabel(Quantity quantity);  ///< of a menu: "Stress"
QString quantityTitle(Quantity quantity);  ///< of a legend, without its unit: "Von Mises stress"

/// The unit in which numbers up to `magnitude` (SI) are read, and how much of SI it is.
struct FieldUnit {
  QString word;  ///< "Pa", "kPa", "MPa", "%"
  double si = 1;
};
FieldUnit fieldUnit(Quantity quantity, double magnitude);

/// A value in a unit with three digits that mean something, and the unit: "23.4 kPa".
QString fieldValue(double value, const FieldUnit& unit, const QLocale& locale);

/// What the view reads out at a place: "Supraspinatus: 23.4 kPa von Mises stress".
QString fieldReading(Quantity quantity, const QString& part, double value, const FieldUnit& unit);
/// The same where there is nothing to read.
QString noFieldReading(Quantity quantity, const QString& part);

/// Values with their scale and its words, for the renderer. The ends say with ≤ and ≥ that there is more beyond them.
FieldLook fieldLook(Quantity quantity, std::shared_ptr<const SurfaceValues> values, const FieldRange& range, const QLocale& locale);

}  // namespace glenoid
