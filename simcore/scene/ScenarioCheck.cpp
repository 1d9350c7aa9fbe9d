// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "simcore/file/Schema.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/ScenarioJson.h"
#include "simcore/scene/SceneJson.h"

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

Result<Done> checkOwnValues(const Scenario& scenario, const std::string& file) {
  if (const auto ids = checkIds(scenario.tools, &Tool::id, "tools", "id", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.cameras, &Camera::id, "cameras", "id", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.holds, &Hold::part, "holds", "part", file); !ids) return ids;
  if (const auto ids = checkIds(scenario.loads, &Load::part, "loads", "part", file); !ids) return ids;
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
  return Done{};
}

Result<Done> checkPartNamed(const Joint& joint, const std::string& id, const Place& place,
                            const std::string& pointer, const std::string& owner) {
  if (findPart(joint, id) >= 0) return Done{};
  return Error{Fault::UnknownId, {place.file, place.pointer + pointer, owner, {}}, {id, "part"}, {}};
}

/// A hold or a load: on a rigid part that can move.
Result<Done> checkFreeRigid(const Scenario& scenario, const Joint& joint, const std::string& id, const Place& place,
                            const std::string& pointer, const std::string& what) {
  if (const auto known = checkPartNamed(joint, id, place, pointer, {}); !known) return known;
  const bool fixed = std::find(scenario.fixedParts.begin(), scenario.fixedParts.end(), id) != scenario.fixedParts.end();
  if (!fixed && joint.parts[findPart(joint, id)].kind == PartKind::Rigid) return Done{};
  return Error{Fault::BadReference,
               {place.file, place.pointer + pointer, id, {}},
               {id},
               fixed ? "a fixed part needs no " + what : "only a rigid part can have a " + what};
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
  for (std::size_t i = 0; i < scenario.holds.size(); ++i)
    if (const auto good = checkFreeRigid(scenario, joint, scenario.holds[i].part, place, under("holds", i, "part"), "hold"); !good)
      return good;
  for (std::size_t i = 0; i < scenario.loads.size(); ++i)
    if (const auto good = checkFreeRigid(scenario, joint, scenario.loads[i].part, place, under("loads", i, "part"), "load"); !good)
      return good;
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const Tool& tool = scenario.tools[t];
    for (std::size_t i = 0; i < tool.perforates.size(); ++i) {
      const std::string pointer = pointerTo(under("tools", t, "perforates"), i);
      if (const auto known = checkPartNamed(joint, tool.perforates[i], place, pointer, tool.id); !known)
        return known;
    }
  }
  return Done{};
}

}  // namespace glenoid
