// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "simcore/file/Schema.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/ScenarioJson.h"
#include "simcore/scene/SceneJson.h"
#include "simcore/scene/training/TrainingCheck.h"

namespace glenoid {
namespace {

using namespace scene_json;

std::string under(const char* list, std::size_t index, const char* member) {
  return pointerTo(pointerTo(pointerTo(std::string(), list), index), member);
}

template <class T>
Result<Done> checkIds(const std::vector<T>& things, std::string T::*id, const char* list, const char* member,
                      const std::string& file) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (!seen.insert(things[i].*id).second)
      return Error{Fault::DuplicateId, {file, under(list, i, member), {}, {}}, {things[i].*id}, {}};
  return Done{};
}

/// Holds that hold something and motions that a clock can follow.
Result<Done> checkActions(const Scenario& scenario, const std::string& file) {
  for (std::size_t i = 0; i < scenario.holds.size(); ++i) {
    const Hold& hold = scenario.holds[i];
    if (!(hold.stiffness > 0) && !(hold.angularStiffness > 0))
      return Error{Fault::Unusable, {file, pointerTo("/holds", i), hold.part, {}}, {"a hold without any stiffness"}, {}};
  }
  for (std::size_t m = 0; m < scenario.motions.size(); ++m) {
    const Motion& motion = scenario.motions[m];
    for (std::size_t k = 0; k < motion.keys.size(); ++k) {
      const Place place{file, pointerTo(under("motions", m, "keys"), k), motion.part, {}};
      if (!isUnit(motion.keys[k].turn_W))
        return Error{Fault::OutOfRange,
                     {file, place.pointer + "/rotation", motion.part, {}},
                     {std::to_string(motion.keys[k].turn_W.norm()), "1", "1"},
                     "length of the quaternion"};
      if (k > 0 && !(motion.keys[k].time > motion.keys[k - 1].time))
        return Error{Fault::Unusable, place, {"the keys of a motion do not ascend in time"}, {}};
    }
  }
  return Done{};
}

Result<Done> checkOwnValues(const Scenario& scenario, const std::string& file) {
  if (const auto ids = checkIds(scenario.tools, &Tool::id, "tools", "id", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.cameras, &Camera::id, "cameras", "id", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.holds, &Hold::part, "holds", "part", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.motions, &Motion::part, "motions", "part", file); !ids) return ids;
  if (const auto good = checkActions(scenario, file); !good) return good;
  for (std::size_t i = 0; i < scenario.tools.size(); ++i) {
    const Quat& q = scenario.tools[i].home.q_WB;
    if (!isUnit(q))
      return Error{Fault::OutOfRange,
                   {file, under("tools", i, "home") + "/rotation", scenario.tools[i].id, {}},
                   {std::to_string(q.norm()), "1", "1"},
                   "length of the quaternion"};
  }
  for (std::size_t i = 0; i < scenario.tools.size(); ++i) {
    const Tool& tool = scenario.tools[i];
    if (tool.link.empty()) continue;
    const Place place{file, under("tools", i, "link"), tool.id, {}};
    const int carrier = findTool(scenario, tool.link);
    if (carrier < 0) return Error{Fault::UnknownId, place, {tool.link, "tool"}, {}};
    if (!scenario.tools[carrier].link.empty())
      return Error{Fault::BadReference, place, {tool.link}, "a tool is carried by one that a hand holds"};
  }
  for (std::size_t i = 0; i < scenario.cameras.size(); ++i) {
    const Camera& camera = scenario.cameras[i];
    // What a view needs: a direction to look and one that is up, not the same.
    const Vec3 forward = camera.target_W - camera.eye_W;
    if (!(forward.cross(camera.up_W).norm() > 1e-9 * forward.norm() * camera.up_W.norm()))
      return Error{Fault::Unusable,
                   {file, pointerTo("/cameras", i), {}, {}},
                   {"a camera that looks nowhere or along its own up direction"},
                   {}};
  }
  return checkTraining(scenario, file);
}

bool isFixed(const Scenario& scenario, const std::string& part) {
  return std::find(scenario.fixedParts.begin(), scenario.fixedParts.end(), part) != scenario.fixedParts.end();
}

Result<Done> checkPartNamed(const Joint& joint, const std::string& id, const Place& place,
                            const std::string& pointer, const std::string& owner) {
  if (findPart(joint, id) >= 0) return Done{};
  return Error{Fault::UnknownId, {place.file, place.pointer + pointer, owner, {}}, {id, "part"}, {}};
}

/// What acts on a part: on one that can move, of the right kind.
Result<Done> checkFree(const Scenario& scenario, const Joint& joint, const std::string& id, const Place& place,
                       const std::string& pointer, const std::string& what, bool rigidOnly) {
  if (const auto known = checkPartNamed(joint, id, place, pointer, {}); !known) return known;
  const bool fixed = isFixed(scenario, id);
  if (!fixed && (!rigidOnly || joint.parts[findPart(joint, id)].kind == PartKind::Rigid)) return Done{};
  return Error{Fault::BadReference,
               {place.file, place.pointer + pointer, id, {}},
               {id},
               fixed ? "a fixed part needs no " + what : "only a rigid part can have a " + what};
}

template <class T>
Result<Done> checkOnRegions(const Scenario& scenario, const Joint& joint, const std::vector<T>& actions, const char* list,
                            const std::string& what, const Place& place) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const T& action = actions[i];
    if (const auto good = checkFree(scenario, joint, action.part, place, under(list, i, "part"), what, false); !good) return good;
    if (!findRegion(joint.parts[findPart(joint, action.part)], action.region))
      return Error{Fault::UnknownId, {place.file, place.pointer + under(list, i, "region"), action.part, {}}, {action.region, "region"}, {}};
  }
  return Done{};
}

/// What pushes, holds or moves parts.
Result<Done> checkActionsOn(const Scenario& scenario, const Joint& joint, const Place& place) {
  for (std::size_t i = 0; i < scenario.holds.size(); ++i)
    if (const auto good = checkFree(scenario, joint, scenario.holds[i].part, place, under("holds", i, "part"), "hold", true); !good)
      return good;
  for (std::size_t i = 0; i < scenario.loads.size(); ++i) {
    const Load& load = scenario.loads[i];
    const bool turns = !load.torque_W.isZero(0);
    if (const auto good = checkFree(scenario, joint, load.part, place, under("loads", i, "part"), turns ? "torque" : "load", turns); !good)
      return good;
  }
  if (const auto good = checkOnRegions(scenario, joint, scenario.pressures, "pressures", "pressure", place); !good) return good;
  if (const auto good = checkOnRegions(scenario, joint, scenario.supports, "supports", "support", place); !good) return good;
  for (std::size_t i = 0; i < scenario.motions.size(); ++i) {
    const std::string& id = scenario.motions[i].part;
    if (const auto known = checkPartNamed(joint, id, place, under("motions", i, "part"), {}); !known) return known;
    if (!isFixed(scenario, id))
      return Error{Fault::Unusable,
                   {place.file, place.pointer + under("motions", i, "part"), id, {}},
                   {"a motion of a part that is not among fixedParts"},
                   {}};
  }
  return Done{};
}

}  // namespace

Result<Done> checkScenario(const Scenario& scenario, const std::string& file) {
  const JsonValue json = fromScenario(scenario);
  if (const auto pointer = notFiniteIn(json))
    return Error{Fault::NotFinite, {file, *pointer, {}, {}}, {}, {}};
  if (const auto valid = validate(json, Schema::Scenario, file); !valid) return valid;
  return checkOwnValues(scenario, file);
}

Result<Done> checkScenario(const Scenario& scenario, const Joint& joint, const Place& place) {
  for (std::size_t i = 0; i < scenario.fixedParts.size(); ++i)
    if (const auto known =
            checkPartNamed(joint, scenario.fixedParts[i], place, pointerTo("/fixedParts", i), {});
        !known)
      return known;
  for (std::size_t i = 0; i < scenario.selfContactParts.size(); ++i)
    if (const auto known = checkPartNamed(joint, scenario.selfContactParts[i], place, pointerTo("/selfContactParts", i), {}); !known)
      return known;
  if (const auto good = checkActionsOn(scenario, joint, place); !good) return good;
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const Tool& tool = scenario.tools[t];
    for (std::size_t i = 0; i < tool.perforates.size(); ++i) {
      const std::string pointer = pointerTo(under("tools", t, "perforates"), i);
      if (const auto known = checkPartNamed(joint, tool.perforates[i], place, pointer, tool.id); !known)
        return known;
    }
  }
  return checkTraining(scenario, joint, place);
}

}  // namespace glenoid
