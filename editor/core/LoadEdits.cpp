// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/LoadEdits.h"

#include <QCoreApplication>
#include <cmath>

#include "editor/core/PartName.h"
#include "simcore/scene/ScenarioFile.h"

namespace glenoid {
namespace {

/// Texts of this file.
struct LoadEdits {
  Q_DECLARE_TR_FUNCTIONS(glenoid::LoadEdits)
};

/// By the schema and by what the joint's parts can bear; whatever else the scenario holds is not asked about.
bool sound(const Joint& joint, const Scenario& scenario) {
  Scenario loads;
  loads.id = loads.name = "loads";
  loads.joint = "a.joint";
  loads.fixedParts = scenario.fixedParts;
  loads.loads = scenario.loads;
  loads.loadRise = scenario.loadRise;
  return checkScenario(loads, {}).ok() && checkScenario(loads, joint, {}).ok();
}

template <class Change>
bool change(Document& document, const QString& text, const std::string& part, Change&& how, const QString& gesture = {}) {
  Scenario after = document.scenario();
  how(after);
  if ((after.loads == document.scenario().loads && after.loadRise == document.scenario().loadRise) || !sound(document.joint(), after)) return false;
  ChangeSet changes;
  changes.model = changes.settings = true;
  if (!part.empty()) changes.parts = {part};
  document.edit(text, changes, [&](Scene& scene) { scene.scenario = std::move(after); }, gesture);
  return true;
}

bool has(const Document& document, int index) { return index >= 0 && index < static_cast<int>(document.scenario().loads.size()); }

}  // namespace

bool setLoadRise(Document& document, double seconds) {
  return std::isfinite(seconds) && change(document, LoadEdits::tr("Change the time in which loads rise"), {},
                                          [&](Scenario& scenario) { scenario.loadRise = seconds; }, QStringLiteral("loadRise"));
}

bool setLoad(Document& document, int index, const Load& load) {
  const bool finite = load.force_W.allFinite() && load.torque_W.allFinite() && (!load.point_W || load.point_W->allFinite());
  if (!has(document, index) || !finite) return false;
  return change(document, LoadEdits::tr("Change a load on “%1”").arg(partName(document.joint(), load.part)), load.part,
                [&](Scenario& scenario) { scenario.loads[index] = load; }, QStringLiteral("load:%1").arg(index));
}

bool addLoad(Document& document, const std::string& part) {
  Load load;
  load.part = part;
  load.force_W = -Vec3::UnitY();
  return change(document, LoadEdits::tr("Add a load on “%1”").arg(partName(document.joint(), part)), part,
                [&](Scenario& scenario) { scenario.loads.push_back(load); });
}

bool removeLoad(Document& document, int index) {
  if (!has(document, index)) return false;
  const std::string part = document.scenario().loads[index].part;
  return change(document, LoadEdits::tr("Remove a load from “%1”").arg(partName(document.joint(), part)), part,
                [&](Scenario& scenario) { scenario.loads.erase(scenario.loads.begin() + index); });
}

}  // namespace glenoid
