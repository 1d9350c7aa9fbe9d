// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "simcore/import/ImportedFile.h"
#include "simcore/repair/Diagnose.h"

namespace glenoid {

/// What a unit is guessed from: how large a surface is in the file's numbers, where it stands, and what it is called.
struct NamedBox {
  Box3 box;
  std::string name;
};

/// Metres per unit of surfaces that share one: one file's, say. Each votes by its size, place and name, whole or as the part of a
/// bone that its name says; a vote that fits nothing does not outvote the others. One alone is guessUnit of Diagnose.h.
UnitGuess guessUnit(std::span<const NamedBox> surfaces);

/// All surfaces of a file looked at, with one unit for all where the file does not say it. `fileName`: for surfaces whose own
/// name says nothing. `options.name` and `options.metresPerUnit` are set here.
std::vector<SurfaceDiagnosis> diagnoseFile(const ImportedFile& file, const std::string& fileName, DiagnosisOptions options = {});

}  // namespace glenoid
