// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/coupling/CarryNodes.h"

namespace glenoid {

/// What became of picked nodes when a part got other cells, as a sentence; empty where there were none.
QString carriedText(const CarriedNodes& carried);

/// A step's name with that sentence behind it.
QString withCarried(const QString& step, const CarriedNodes& carried);

}  // namespace glenoid
