// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "simcore/body/RigidObject.h"
#include "simcore/coupling/Islands.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/SceneScale.h"
#include "simcore/step/CompileActions.h"
#include "simcore/step/CompileObjects.h"
#include "simcore/step/EffectPlan.h"

namespace glenoid {

namespace {

Result<Done> checkWishes(const Joint& joint, const Scenario& scenario) {
  const auto fault = [](Fault kind, const std::string& pointer, Arguments arguments) {
    return Error{kind, {"", pointer, "", {}}, std::move(arguments), ""};
  };
  if (!(scenario.dt > 0 && scenario.dt <= 0.1)) return fault(Fault::OutOfRange, "/dt", {std::to_string(scenario.dt), "0", "0.1"});
  for (std::size_t i = 0; i < scenario.fixedParts.size(); ++i)
    if (findPart(joint, scenario.fixedParts[i]) < 0)
      return fault(Fault::UnknownId, "/fixedParts/" + std::to_string(i), {scenario.fixedParts[i], "part"});
  const auto rigid = [&](const std::string& id, const std::string& pointer, const char* otherwise) -> Result<Done> {
    const int part = findPart(joint, id);
    if (part < 0) return fault(Fault::UnknownId, pointer, {id, "part"});
    if (joint.parts[part].kind != PartKind::Rigid) return fault(Fault::Unusable, pointer, {std::string(otherwise)});
    return Done{};
  };
  for (std::size_t i = 0; i < scenario.holds.size(); ++i)
    if (auto good = rigid(scenario.holds[i].part, "/holds/" + std::to_string(i), "hold-of-soft-part"); !good) return good;
  if (auto good = checkActions(joint, scenario); !good) return good;
  for (std::size_t i = 0; i < scenario.tools.size(); ++i) {
    const std::string& link = scenario.tools[i].link;
    const int carrier = link.empty() ? -1 : findTool(scenario, link);
    if (!link.empty() && (carrier < 0 || !scenario.tools[carrier].link.empty()))
      return fault(Fault::UnknownId, "/tools/" + std::to_string(i) + "/link", {link, "tool"});
  }
  for (std::size_t i = 0; i < scenario.selfContactParts.size(); ++i)
    if (findPart(joint, scenario.selfContactParts[i]) < 0)
      return fault(Fault::UnknownId, "/selfContactParts/" + std::to_string(i), {scenario.selfContactParts[i], "part"});
  for (std::size_t i = 0; i < scenario.tools.size(); ++i)
    for (const std::string& part : scenario.tools[i].perforates)
      if (findPart(joint, part) < 0) return fault(Fault::UnknownId, "/tools/" + std::to_string(i) + "/perforates", {part, "part"});
  return Done{};
}

BoundPoseSpring toolSpring(const Tool& tool, const RigidObject& body, int object, int index) {
  BoundPoseSpring bound;
  bound.object = object;
  bound.tool = index;
  PoseSpring& spring = bound.spring;
  spring.anchor_B = -body.properties().centre;  // the tip is the origin of the tool's frame
  spring.stiffness = tool.stiffness;
  spring.angularStiffness = tool.angularStiffness;
  spring.damping = 2 * tool.dampingRatio * std::sqrt(tool.stiffness * tool.mass);
  const double inertia = body.properties().inertia.diagonal().maxCoeff() + tool.mass * spring.anchor_B.squaredNorm();
  spring.angularDamping = 2 * tool.dampingRatio * std::sqrt(tool.angularStiffness * inertia);
  spring.forceMax = tool.forceMax;
  spring.torqueMax = tool.forceMax * tool.length;  // a hand at the far end of the shaft
  return bound;
}

BoundPoseSpring holdSpring(const Hold& hold, const RigidObject& body, int object) {
  BoundPoseSpring bound;
  bound.object = object;
  bound.spring = {-body.properties().centre, hold.stiffness, hold.angularStiffness, hold.damping * hold.stiffness,
                  hold.damping * hold.angularStiffness, 1e300, 1e300, hold.axes.mask(), hold.angularAxes.mask()};
  return bound;
}

/// A tool that another one carries hangs on it by zero-length springs at its tip, at the end of its shaft, and beside
/// both: they hold place and turn. Damped as a hand's coupling is.
void appendToolLinks(const Model& model, const StepModel& inside, std::vector<CouplingSpring>& springs) {
  for (int object = 0; object < static_cast<int>(model.objects.size()); ++object) {
    const SceneObject& scene = model.objects[object];
    if (!scene.tool || model.scenario.tools[scene.toolIndex].link.empty()) continue;
    const Tool& tool = model.scenario.tools[scene.toolIndex];
    int carrier = 0;
    while (!model.objects[carrier].tool || model.objects[carrier].id != tool.link) ++carrier;
    const Vec3 ends[] = {{tool.radius, 0, 0}, {-tool.radius, 0, 0}, {0, tool.radius, tool.length}, {0, -tool.radius, tool.length}};
    for (const Vec3& end : ends) {
      const Vec3 at_W = tool.home * end;
      const auto on = [&](int body) {
        const Pose pose = static_cast<const RigidObject&>(*inside.objects[body]).pose(model.start.q);
        return VertexBinding{{}, {}, pose.q_WB.conjugate() * (at_W - pose.p_WB)};
      };
      const double stiffness = tool.linkStiffness / 4;
      springs.push_back({-1, carrier, object, on(carrier), on(object), stiffness, tool.dampingRatio * std::sqrt(stiffness * tool.mass / 4)});
    }
  }
}

/// Groups objects, gives each its blocks, and runs the symbolic phase of every island.
Result<Done> compileIslands(const Model& model, StepModel& inside, const std::vector<CouplingSpring>& springs,
                            const std::vector<Vec3>& centres) {
  const int count = static_cast<int>(model.objects.size());
  std::vector<bool> isFree;
  for (const SceneObject& object : model.objects) isFree.push_back(object.layout.free);
  std::vector<std::array<int, 2>> joined;
  for (const CouplingSpring& spring : springs) joined.push_back({spring.objectA, spring.objectB});
  const CouplingIslands islands = findCouplingIslands(isFree, joined);
  inside.islandOfObject = islands.islandOfObject;
  inside.baseOfObject.assign(count, -1);
  for (const std::vector<int>& members : islands.objects) {
    CouplingIslandModel island;
    island.objects = members;
    for (const int object : members) {
      island.base.push_back(island.blockCount);
      inside.baseOfObject[object] = island.blockCount;
      island.blockCount += inside.objects[object]->blockCount();
    }
    inside.islands.push_back(std::move(island));
  }

  const VecX& q = model.start.q;
  for (const CouplingSpring& spring : springs) {
    BoundSpring bound;
    bound.a = inside.objects[spring.objectA].get();
    bound.b = inside.objects[spring.objectB].get();
    bound.objectA = spring.objectA;
    bound.objectB = spring.objectB;
    bound.pointA = pointAt(spring.a, model.objects[spring.objectA].layout.rigid);
    bound.pointB = pointAt(spring.b, model.objects[spring.objectB].layout.rigid);
    bound.baseA = inside.baseOfObject[spring.objectA];
    bound.baseB = inside.baseOfObject[spring.objectB];
    bound.stiffness = spring.stiffness;
    bound.damping = spring.damping;
    const int island = std::max(inside.islandOfObject[spring.objectA], inside.islandOfObject[spring.objectB]);
    if (island >= 0) inside.islands[island].springs.push_back(std::move(bound));
  }

  for (int object = 0; object < count; ++object) {
    const SceneObject& scene = model.objects[object];
    if (!scene.tool || !model.scenario.tools[scene.toolIndex].link.empty()) continue;
    const auto& body = static_cast<const RigidObject&>(*inside.objects[object]);
    inside.islands[inside.islandOfObject[object]].poseSprings.push_back(
        toolSpring(model.scenario.tools[scene.toolIndex], body, object, scene.toolIndex));
  }
  for (const Hold& hold : model.scenario.holds) {
    const int object = findPart(model.joint, hold.part);  // parts come first, in the joint's order
    if (inside.islandOfObject[object] < 0) continue;      // a fixed part needs no holding
    const auto& body = static_cast<const RigidObject&>(*inside.objects[object]);
    inside.islands[inside.islandOfObject[object]].poseSprings.push_back(holdSpring(hold, body, object));
  }
  if (Result<Done> done = compileActions(model, inside, centres); !done) return done;

  for (CouplingIslandModel& island : inside.islands) {
    std::vector<std::array<int, 2>> pairs;
    for (std::size_t i = 0; i < island.objects.size(); ++i) inside.objects[island.objects[i]]->appendBlockPairs(island.base[i], pairs);
    for (const BoundSpring& spring : island.springs) appendSpringPairs(spring, q, pairs);
    for (BoundPoseSpring& bound : island.poseSprings) {
      bound.base = inside.baseOfObject[bound.object];
      pairs.push_back({bound.base + 1, bound.base});
    }
    for (const BoundSupport& support : island.supports) appendSupportPairs(support, q, pairs);
    island.symbolic = std::make_shared<BlockSymbolic>(island.blockCount, pairs);
    for (std::size_t i = 0; i < island.objects.size(); ++i)
      island.entries.push_back(inside.objects[island.objects[i]]->blockEntries(*island.symbolic, island.base[i]));
    for (BoundSpring& spring : island.springs) bindSpring(spring, q, *island.symbolic);
    for (BoundPoseSpring& bound : island.poseSprings)
      bound.entries = {island.symbolic->entry(bound.base, bound.base), island.symbolic->entry(bound.base + 1, bound.base + 1),
                       island.symbolic->entry(bound.base + 1, bound.base)};
    for (BoundSupport& support : island.supports) bindSupport(support, q, *island.symbolic);
  }
  return Done{};
}

EffectGrounds groundsOf(const Model& model) {
  EffectGrounds grounds;
  const bool anyFree = std::any_of(model.objects.begin(), model.objects.end(),
                                   [](const SceneObject& object) { return object.layout.free && !object.tool; });
  grounds.gravity = anyFree && model.scenario.gravity_W.norm() > 0;
  grounds.couplings = !model.joint.couplings.empty();
  grounds.contact = !model.collisionPairs.empty() || !model.joint.bursae.empty();
  grounds.selfContact = std::any_of(model.collisionPairs.begin(), model.collisionPairs.end(), [](const CollisionPair& pair) { return pair.self(); });
  for (const Material& material : model.joint.materials)
    grounds.damping = grounds.damping || material.massDamping > 0 || material.stiffnessDamping > 0;
  for (const Coupling& coupling : model.joint.couplings) grounds.damping = grounds.damping || coupling.damping > 0;
  return grounds;
}

}  // namespace

Result<std::shared_ptr<const Model>> compileModel(const Joint& joint, const Scenario& scenario) {
  if (Result<Done> checked = checkWishes(joint, scenario); !checked) return checked.error();
  auto model = std::make_shared<Model>();
  auto inside = std::make_shared<StepModel>();
  model->joint = joint;
  model->scenario = scaled(joint, scenario);
  model->jointHash = jointHash(joint);
  std::vector<Vec3> centres;
  if (Result<Done> done = compileObjects(*model, *inside, centres); !done) return done.error();
  compileMotions(*model, *inside);
  if (scenario.effects.contact != Wish::Off) compileContacts(*model);
  EffectGrounds grounds = groundsOf(*model);
  grounds.friction = scenario.effects.friction != Wish::Off && compileFriction(*model);
  std::vector<FilmModel> films;
  if (scenario.effects.contact != Wish::Off && scenario.effects.bursa != Wish::Off) films = compileFilms(*model);
  grounds.bursa = !films.empty();
  std::vector<DentModel> dents;
  if (scenario.effects.contact != Wish::Off && scenario.effects.dent != Wish::Off) dents = compileDents(*model);
  grounds.dent = !dents.empty();
  model->effects = planEffects(scenario.effects, grounds);
  inside->contact = model->effectOn("contact");
  inside->friction = inside->contact && model->effectOn("friction");
  if (inside->contact && model->effectOn("bursa")) inside->films = std::move(films);
  if (inside->contact && model->effectOn("dent")) inside->dents = std::move(dents);
  if (!inside->friction)
    for (SceneObject& object : model->objects) object.friction = {};
  inside->settings.dt = scenario.dt;
  inside->settings.damping = model->effectOn("damping");
  inside->settings.gravity_W = model->effectOn("gravity") ? scenario.gravity_W : Vec3::Zero().eval();

  std::vector<CouplingSpring> springs;
  if (model->effectOn("couplings")) {
    std::vector<CoupledPart> parts;
    for (std::size_t i = 0; i < joint.parts.size(); ++i) parts.push_back({&model->joint.parts[i], centres[i], model->objects[i].authored.get()});
    for (std::size_t c = 0; c < joint.couplings.size(); ++c) {
      Result<std::vector<CouplingSpring>> derived = deriveSprings(model->joint, static_cast<int>(c), parts);
      if (!derived) return derived.error();
      for (CouplingSpring& spring : *derived) {
        if (!inside->settings.damping) spring.damping = 0;
        model->springs.push_back({spring.coupling, spring.objectA, spring.objectB, spring.a, spring.b, spring.stiffness, spring.damping});
        springs.push_back(std::move(spring));
      }
    }
  }
  appendToolLinks(*model, *inside, springs);
  if (Result<Done> done = compileIslands(*model, *inside, springs, centres); !done) return done.error();
  bindDents(*model, *inside);
  for (CouplingIslandModel& island : inside->islands)
    for (BoundPoseSpring& bound : island.poseSprings)
      if (bound.tool < 0) {
        const auto& body = static_cast<const RigidObject&>(*inside->objects[bound.object]);
        const Pose pose = body.pose(model->start.q);
        bound.rest.anchor_W = pose * bound.spring.anchor_B;
        bound.rest.q_WB = pose.q_WB;
      }
  model->couplingIslandOfObject = inside->islandOfObject;
  model->couplingIslandCount = static_cast<int>(inside->islands.size());
  model->inside = inside;
  return std::shared_ptr<const Model>(model);
}

}  // namespace glenoid
