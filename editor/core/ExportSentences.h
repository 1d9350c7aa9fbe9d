// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/export/ExportJoint.h"

namespace glenoid {

/// What a format loses of a joint, for people; one sentence. Works with no QCoreApplication.
QString sentenceOf(const Loss& loss);

/// What the tetrahedra of a part are like, beside the part; one sentence.
QString sentenceOf(const SolidFigures& solid, ExportMesh mesh);

/// A format as a dialog names it, e.g. "SOFA scene".
QString exportName(ExportFormat format);

}  // namespace glenoid
