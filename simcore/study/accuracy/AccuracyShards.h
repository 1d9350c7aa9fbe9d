// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/file/JsonValue.h"
#include "simcore/study/accuracy/AccuracyStudy.h"

namespace glenoid {

/// A study that several processes or machines share. Each takes every n-th setting, and makes the windows and references for itself:
/// their bits are the same everywhere, which merging checks. Times are those of the machine that a row names.

/// Everything of a result but the windows' states and the settings themselves, which the scene tells; numbers come back bit for bit.
JsonValue toJson(const AccuracyResult& result);

/// What toJson wrote, for the settings of the same scene. Fails with Unusable where it is of other settings or no such document.
Result<AccuracyResult> accuracyResult(const JsonValue& json, const AccuracySetting& scene, const std::vector<AccuracySetting>& settings);

/// Whether windows and references are the same bit for bit: then rows of one stand beside those of the other.
bool sameGround(const AccuracyResult& a, const AccuracyResult& b);

/// All shards as one study, rows in the order of the settings. Fails with Unusable, saying why, where a row
/// is missing or there twice, and where windows or references differ in a bit: then build, instruction set or
/// scene were not the same.
Result<AccuracyResult> mergedShards(std::span<const AccuracyResult> shards, std::size_t settings);

}  // namespace glenoid
