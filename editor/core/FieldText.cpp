// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/FieldText.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

struct FieldText {
  Q_DECLARE_TR_FUNCTIONS(glenoid::FieldText)
 public:
  static QString label(Quantity quantity) {
    switch (quantity) {
      case Quantity::Stress: return tr("Stress");
      case Quantity::Strain: return tr("Strain");
      case Quantity::Pressure: return tr("Pressure");
      case Quantity::Contact: return tr("Contact force");
    }
    return {};
  }
  static QString title(Quantity quantity) {
    switch (quantity) {
      case Quantity::Stress: return tr("Von Mises stress");
      case Quantity::Strain: return tr("Largest strain");
      case Quantity::Pressure: return tr("Pressure in tissue");
      case Quantity::Contact: return tr("Contact force per area");
    }
    return {};
  }
  static QString reading(Quantity quantity, const QString& part, const QString& value) {
    switch (quantity) {
      case Quantity::Stress: return tr("%1: %2 von Mises stress").arg(part, value);
      case Quantity::Strain: return tr("%1: %2 largest strain").arg(part, value);
      case Quantity::Pressure: return tr("%1: %2 pressure in tissue").arg(part, value);
      case Quantity::Contact: return tr("%1: %2 contact force per area").arg(part, value);
    }
    return {};
  }
  static QString none(Quantity quantity, const QString& part) {
    return quantity == Quantity::Contact ? tr("%1: contact force is not read on tools").arg(part) : tr("%1: rigid, so nothing to read inside").arg(part);
  }
};

/// Digits after the point with which multiples of a step are exact.
int decimalsOf(double step) {
  int decimals = 0;
  for (double rest = step; decimals < 6 && std::abs(rest - std::round(rest)) > 1e-6 * std::max(1.0, std::abs(rest)); rest *= 10) ++decimals;
  return decimals;
}

/// Smallest and largest of all values.
std::pair<double, double> extremes(const SurfaceValues& values) {
  double low = INFINITY, high = -INFINITY;
  for (const auto& own : values)
    for (const float value : own)
      if (std::isfinite(value)) low = std::min(low, double{value}), high = std::max(high, double{value});
  return {low, high};
}

}  // namespace

QString quantityLabel(Quantity quantity) { return FieldText::label(quantity); }
QString quantityTitle(Quantity quantity) { return FieldText::title(quantity); }

FieldUnit fieldUnit(Quantity quantity, double magnitude) {
  if (quantity == Quantity::Strain) return {QStringLiteral("%"), 0.01};
  if (magnitude >= 0.9995e6) return {QStringLiteral("MPa"), 1e6};
  if (magnitude >= 999.5) return {QStringLiteral("kPa"), 1e3};
  return {QStringLiteral("Pa"), 1};
}

QString fieldValue(double value, const FieldUnit& unit, const QLocale& locale) {
  const double shown = value / unit.si;
  const int decimals = shown == 0 || !std::isfinite(shown) ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(shown)))), 0, 3);
  // A no-break space: number and unit stay together.
  return locale.toString(shown, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212)) + QChar(0xa0) + unit.word;
}

QString fieldReading(Quantity quantity, const QString& part, double value, const FieldUnit& unit) {
  return FieldText::reading(quantity, part, fieldValue(value, unit, QLocale()));
}

QString noFieldReading(Quantity quantity, const QString& part) { return FieldText::none(quantity, part); }

FieldLook fieldLook(Quantity quantity, std::shared_ptr<const SurfaceValues> values, const FieldRange& range, const QLocale& locale) {
  FieldLook look;
  look.low = range.low;
  look.high = range.high;
  look.zeroIsNone = quantity == Quantity::Contact && range.low == 0;
  const FieldUnit unit = fieldUnit(quantity, std::max(std::abs(range.low), std::abs(range.high)));
  look.title = QStringLiteral("%1 (%2)").arg(quantityTitle(quantity), unit.word).toStdString();
  const auto [low, high] = values ? extremes(*values) : std::pair<double, double>{INFINITY, -INFINITY};
  std::vector<double> ticks = ticksIn({range.low / unit.si, range.high / unit.si});
  if (ticks.size() < 2) ticks = {range.low / unit.si, range.high / unit.si};
  const double step = ticks[1] - ticks[0];
  for (const double tick : ticks) {
    QString text = locale.toString(tick, 'f', decimalsOf(step)).replace(QLatin1Char('-'), QChar(0x2212));
    if (std::abs(tick * unit.si - range.high) < 1e-6 * (range.high - range.low) && high > range.high) text = QStringLiteral("≥ ") + text;
    if (std::abs(tick * unit.si - range.low) < 1e-6 * (range.high - range.low) && low < range.low) text = QStringLiteral("≤ ") + text;
    look.ticks.push_back({tick * unit.si, text.toStdString()});
  }
  look.values = std::move(values);
  return look;
}

}  // namespace glenoid
