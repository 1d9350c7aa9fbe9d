// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/CarriedText.h"

#include <QCoreApplication>
#include <QLocale>

namespace glenoid {
namespace {

/// Texts of this file.
struct CarriedText {
  Q_DECLARE_TR_FUNCTIONS(glenoid::CarriedText)
};

}  // namespace

QString carriedText(const CarriedNodes& carried) {
  if (carried.couplings == 0) return {};
  return CarriedText::tr("Picked nodes of couplings became the nearest ones of the new cells: %1 now %2, moved by %3 mm at most.")
      .arg(carried.picked)
      .arg(carried.now)
      .arg(QLocale().toString(1e3 * carried.farthest, 'g', 3));
}

QString withCarried(const QString& step, const CarriedNodes& carried) {
  const QString text = carriedText(carried);
  return text.isEmpty() ? step : step + QStringLiteral(". ") + text;
}

}  // namespace glenoid
