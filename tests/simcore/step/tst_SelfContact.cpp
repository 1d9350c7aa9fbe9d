// SPDX-License-Identifier: GPL-3.0-or-later
// A part that folds onto itself does not go through itself. Depths are those of PenetrationCheck, which shares nothing with
// the search; forces are held to Newton's third law and to what presses.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <map>

#include "simcore/body/State.h"
#include "simcore/collide/Penetration.h"
#include "simcore/step/StepModel.h"
#include "simcore/step/StepWork.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/FoldScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

using namespace scenes;

/// How deep a soft object lies in itself, whether the model has the effect or not.
class SelfDepth {
 public:
  SelfDepth(const Model& model, int object)
      : m_model(model), m_object(object), m_check({makeCollisionSurface(*model.objects[object].collision.mesh)}, {{0, 0, {}, {}}}),
        m_x(model.objects[object].collision.vertices.size()) {}
  double at(const State& state) {
    const SceneObject& object = m_model.objects[m_object];
    surfacePositions(object.collision, object.layout, state.q, m_x);
    const std::span<const Vec3> spans[] = {m_x};
    const Penetration found = m_check.deepest(spans);
    where = found.point;
    return found.depth;
  }

 Vec3 where = Vec3::Zero();

 private:
  const Model& m_model;
  int m_object;
  PenetrationCheck m_check;
  std::vector<Vec3> m_x;
};

struct Outcome {
  std::shared_ptr<const Model> model;
  State state;
  double deepest = 0;          ///< m, of all steps
  double at = 0;               ///< s
  Vec3 where = Vec3::Zero();
  double last = 0;             ///< m, at the end
  double normal = 0;           ///< N, sum of the part's forces on itself at the end
  int contacts = 0, pressing = 0;  ///< of the part with itself, most
  int refused = 0;
  double ms = 0, speed = 0;
  std::array<double, kStageCount> stages{};
  Vec3 net = Vec3::Zero();
  std::vector<ContactView> views;
};

Outcome runScene(const Joint& joint, Scenario scenario, double seconds, bool effect, int threads = 1) {
  scenario.effects.selfContact = effect ? Wish::Auto : Wish::Off;
  Outcome out;
  auto compiled = compileModel(joint, scenario);
  EXPECT_TRUE(compiled.ok());
  if (!compiled.ok()) return out;
  out.model = *compiled;
  EXPECT_EQ(out.model->effectOn("selfContact"), effect);
  Stepper stepper(out.model, {.threads = threads});
  out.state = out.model->start;
  SelfDepth depth(*out.model, 0);
  const long steps = std::lround(seconds / scenario.dt);
  for (long i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({}, out.state);
    out.refused += !report.taken;
    out.ms += report.stepCpuMs / static_cast<double>(steps);
    int mine = 0, pressing = 0;
    for (const ContactView& view : report.contactViews)
      if (view.objectA == view.objectB) ++mine, pressing += view.force > 1e-3;
    out.contacts = std::max(out.contacts, mine);
    out.pressing = std::max(out.pressing, pressing);
    out.last = depth.at(out.state);
    if (out.last > out.deepest) {
      out.deepest = out.last;
      out.at = out.state.time;
      out.where = depth.where;
    }
    if (std::getenv("GLENOID_TALK") && i % 20 == 19)
      std::printf("   %.3f s: depth %.4f mm, self rows %d (%d press), parts %d, speed %.4f\n", out.state.time, 1e3 * out.last, mine, pressing, report.parts, out.state.v.cwiseAbs().maxCoeff());
    for (int k = 0; k < kStageCount; ++k) out.stages[k] += report.cpuMs[k] / static_cast<double>(steps);
    if (i == steps - 1) out.views = report.contactViews;
  }
  for (const ContactView& view : out.views)
    if (view.objectA == view.objectB) out.normal += view.force;
  out.speed = out.state.v.cwiseAbs().maxCoeff();
  return out;
}

void tell(const char* name, const Outcome& o) {
  std::printf("%-28s deepest %.4f mm (%.3f s, at %.2f %.2f %.2f mm), last %.4f mm; %d rows (%d press), %.3f N on itself; %.2f ms a step, %.2e m/s at the end, %d refused\n", name,
              1e3 * o.deepest, o.at, 1e3 * o.where.x(), 1e3 * o.where.y(), 1e3 * o.where.z(), 1e3 * o.last, o.contacts, o.pressing, o.normal, o.ms, o.speed, o.refused);
  if (std::getenv("GLENOID_TALK"))
    for (int k = 0; k < kStageCount; ++k) std::printf("   %s %.3f", stageName(static_cast<Stage>(k)), o.stages[k]);
  std::printf("\n");
}

TEST(SelfContact, aPressedHairpinDoesNotGoThroughItself) {
  const Joint joint = hairpinJoint({});
  const Scenario scenario = pressedHairpin(1.0);
  const Outcome on = runScene(joint, scenario, 2, true), off = runScene(joint, scenario, 2, false);
  tell("hairpin", on);
  tell("hairpin, effect off", off);
}

TEST(SelfContact, aSheetFoldedOverItselfDoesNotGoThroughItself) {
  const Joint joint = sheetJoint();
  const Outcome on = runScene(joint, foldedSheet(), 2.5, true), off = runScene(joint, foldedSheet(), 2.5, false);
  tell("folded sheet", on);
  tell("folded sheet, effect off", off);
}

TEST(SelfContact, aSqueezedRingMeetsItself) {
  const Joint joint = ringJoint(0.02, 0.004, 40);
  const Scenario scenario = squeezedRing(0.0362);
  const Outcome on = runScene(joint, scenario, 2, true), off = runScene(joint, scenario, 2, false);
  tell("ring", on);
  tell("ring, effect off", off);
}

TEST(SelfContact, threeLayersRestOnEachOther) {
  Scenario scenario;
  scenario.id = scenario.name = "zigzag";
  scenario.fixedParts = {"floor"};
  scenario.selfContactParts = {"zigzag"};
  const Outcome on = runScene(zigzagJoint(0.004), scenario, 3, true), off = runScene(zigzagJoint(0.004), scenario, 3, false);
  tell("zigzag", on);
  tell("zigzag, effect off", off);
}

TEST(SelfContact, zzTwoLegsApart) {
  Joint joint;
  joint.id = joint.name = "legs";
  addMaterials(joint);
  for (int leg = 0; leg < 2; ++leg) {
    const double low = leg * 0.0045;
    Part part = bandPart(leg ? "upper" : "hairpin", leg + 1, 12, 2, 4, false,
                         [=](const Vec3& u) { return Vec3(0.06 * u.x(), low + 0.004 * u.y(), 0.016 * (u.z() - 0.5)); });
    part.regions.push_back(regionIn(part, "below", Box3(Vec3(-1, -1e-6, -1), Vec3(1, 1e-6, 1))));
    part.regions.push_back(regionIn(part, "above", Box3(Vec3(-1, 0.0085 - 1e-6, -1), Vec3(1, 0.0085 + 1e-6, 1))));
    joint.parts.push_back(part);
  }
  Scenario scenario = pressedHairpin(1.0);
  scenario.pressures[0].part = "upper";
  scenario.selfContactParts.clear();
  const Outcome on = runScene(joint, scenario, 1, false);
  tell("two legs", on);
}

TEST(SelfContact, zzRowsThatFlip) {
  const Joint joint = hairpinJoint({});
  Scenario scenario = pressedHairpin(1.0);
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 200; ++i) stepper.step({}, state);
  ProximityFinder finder(model->collisionSurfaces, model->collisionPairs);
  std::map<std::uint64_t, Proximity> before;
  for (int i = 0; i < 12; ++i) {
    const SceneObject& object = model->objects[0];
    std::vector<Vec3> x(object.collision.vertices.size()), v(x.size());
    surfacePositions(object.collision, object.layout, state.q, x);
    surfaceVelocities(object.collision, object.layout, state.q, state.v, v);
    const std::span<const Vec3> xs[] = {x}, vs[] = {v};
    std::map<std::uint64_t, Proximity> now;
    for (const Proximity& p : finder.find(xs, vs, scenario.contactDistance, scenario.dt)) now[p.key] = p;
    int gone = 0, fresh = 0;
    const auto say = [&](const char* word, const Proximity& p) {
      if (std::abs(p.gap) > 2e-6 && p.gap > 0) return;
      Vec3 at = Vec3::Zero(), bt = Vec3::Zero();
      for (int k = 0; k < p.a.count; ++k) at += p.a.weight[k] * x[p.a.vertex[k]];
      for (int k = 0; k < p.b.count; ++k) bt += p.b.weight[k] * x[p.b.vertex[k]];
      std::printf("  %s %d-%d at %.2f %.3f %.2f gap %.6f mm normal %.3f %.3f %.3f\n", word, p.a.count, p.b.count, 1e3 * at.x(), 1e3 * at.y(), 1e3 * at.z(), 1e3 * p.gap, p.normal_W.x(), p.normal_W.y(), p.normal_W.z());
    };
    for (const auto& [key, p] : now) if (!before.count(key)) ++fresh, say("new ", p);
    for (const auto& [key, p] : before) if (!now.count(key)) ++gone, say("gone", p);
    double least = 1;
    for (const auto& [key, p] : now) least = std::min(least, p.gap);
    const StepReport& report = stepper.step({}, state);
    std::printf("step %d: %zu rows, %d new, %d gone, least gap %.6f mm; pressing %d, pivots exhausted %d, compl %.2e, speed %.5f\n", i, now.size(), fresh, gone, 1e3 * least, report.pressing, report.pivotsExhausted, report.complementarity, state.v.cwiseAbs().maxCoeff());
    before = now;
  }
}

}  // namespace
}  // namespace glenoid
