// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/file/JsonValue.h"
#include "simcore/scene/training/Training.h"

/// A training and its part of the scenario's document.
namespace glenoid::scene_json {

/// An object; members that hold their default are left out.
JsonValue fromTraining(const Training& training);

/// Expects a document that fits the scenario's schema; an absent member leaves the struct's default.
Training toTraining(const JsonValue& json);

}  // namespace glenoid::scene_json
