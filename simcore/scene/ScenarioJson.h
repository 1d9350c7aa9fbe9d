// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/file/JsonValue.h"
#include "simcore/scene/Scenario.h"

/// Scenario and its document; shared by the files of this folder.
namespace glenoid::scene_json {

JsonValue fromScenario(const Scenario& scenario);

/// Expects a document that fits the schema; an absent member leaves the struct's default.
Scenario toScenario(const JsonValue& json);

}  // namespace glenoid::scene_json
