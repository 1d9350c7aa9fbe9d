// SPDX-License-Identifier: GPL-3.0-or-later
// A part that folds onto itself does not go through itself. Depths are those of PenetrationCheck, which shares nothing with
// the search; forces are held to weights, momentum and energy.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <set>

#include "simcore/collide/Penetration.h"
#include "simcore/collide/ProximityFinder.h"
#include "simcore/contact/ContactRows.h"
#include "simcore/contact/ImpulseResponse.h"
#include "simcore/step/StepModel.h"
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
      : m_object(model.objects[object]), m_check({makeCollisionSurface(*m_object.collision.mesh)}, {{0, 0, {}, {}}}),
        m_x(m_object.collision.vertices.size()) {}
  double at(const State& state) {
    surfacePositions(m_object.collision, m_object.layout, state.q, m_x);
    const std::span<const Vec3> spans[] = {m_x};
    return m_check.deepest(spans).depth;
  }

 private:
  const SceneObject& m_object;
  PenetrationCheck m_check;
  std::vector<Vec3> m_x;
};

struct Outcome {
  std::shared_ptr<const Model> model;
  State state;
  double deepest = 0, last = 0;    ///< m, of all steps and at the end
  int rows = 0, refused = 0;       ///< of the part with itself, most; steps not taken
  double ms = 0, selfMs = 0;       ///< of a step and of the search, mean
  double speed = 0;                ///< m/s, at the end
  std::vector<ContactView> views;  ///< of the last step

  double forceBetween(int a, int b) const {
    double sum = 0;
    for (const ContactView& view : views)
      if ((view.objectA == a && view.objectB == b) || (view.objectA == b && view.objectB == a)) sum += view.force;
    return sum;
  }
};

/// The first part is looked at.
Outcome runScene(const char* name, const Joint& joint, Scenario scenario, double seconds, bool effect) {
  scenario.effects.selfContact = effect ? Wish::Auto : Wish::Off;
  Outcome out;
  out.model = compileModel(joint, scenario).value();
  EXPECT_EQ(out.model->effectOn("selfContact"), effect);
  Stepper stepper(out.model, {});
  out.state = out.model->start;
  SelfDepth depth(*out.model, 0);
  const long steps = std::lround(seconds / scenario.dt);
  for (long i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({}, out.state);
    out.refused += !report.taken;
    out.ms += report.stepCpuMs / static_cast<double>(steps);
    out.selfMs += report.cpuMs[static_cast<int>(Stage::SelfContact)] / static_cast<double>(steps);
    int rows = 0;
    for (const ContactView& view : report.contactViews) rows += view.objectA == view.objectB;
    out.rows = std::max(out.rows, rows);
    out.last = depth.at(out.state);
    out.deepest = std::max(out.deepest, out.last);
    if (i == steps - 1) out.views = report.contactViews;
  }
  out.speed = out.state.v.cwiseAbs().maxCoeff();
  std::printf("%-22s %-4s deepest %.4f mm, at the end %.4f mm and %.1e m/s; %d rows, %.3f N on itself; a step %.2f ms, its search %.2f ms\n",
              name, effect ? "on:" : "off:", 1e3 * out.deepest, 1e3 * out.last, out.speed, out.rows, out.forceBetween(0, 0), out.ms, out.selfMs);
  return out;
}

constexpr double kMicron = 1e-6;

TEST(SelfContact, aPressedHairpinDoesNotGoThroughItself) {
  const Joint joint = hairpinJoint({});
  const Outcome on = runScene("pressed hairpin", joint, pressedHairpin(1.0), 2, true);
  // It comes down at 0.6 m/s, 3 mm in a step; what blows leave is taken out at once.
  EXPECT_LT(on.deepest, 30 * kMicron);
  EXPECT_LT(on.last, kMicron);
  EXPECT_LT(on.speed, 1e-6);
  EXPECT_EQ(on.refused, 0);
  // What presses is what the upper leg is pressed with, but for what the bend carries.
  EXPECT_GT(on.forceBetween(0, 0), 0.8);
  EXPECT_LT(on.forceBetween(0, 0), 1.05);
  const Outcome off = runScene("pressed hairpin", joint, pressedHairpin(1.0), 0.05, false);
  EXPECT_GT(off.deepest, 1e-3);
  EXPECT_EQ(off.rows, 0);
}

TEST(SelfContact, aSheetFoldedOverItselfDoesNotGoThroughItself) {
  const Outcome on = runScene("folded sheet", sheetJoint(), foldedSheet(), 2.5, true);
  EXPECT_LT(on.deepest, 10 * kMicron);
  EXPECT_GT(on.forceBetween(0, 0), 1.0);
  EXPECT_LT(on.speed, 1e-4);
  EXPECT_EQ(on.refused, 0);
  const Outcome off = runScene("folded sheet", sheetJoint(), foldedSheet(), 2.5, false);
  EXPECT_GT(off.deepest, 1e-3);
}

TEST(SelfContact, aSqueezedRingMeetsItself) {
  const Joint joint = ringJoint(0.02, 0.004, 40);
  const Outcome on = runScene("squeezed ring", joint, squeezedRing(0.0362), 2, true);
  EXPECT_LT(on.deepest, 10 * kMicron);
  EXPECT_LT(on.speed, 1e-3);
  EXPECT_EQ(on.refused, 0);
  // At rest both plates are pressed alike, and the ring, which is its own mirror image, on both sides of its middle.
  const double lower = on.forceBetween(0, 1), upper = on.forceBetween(0, 2);
  EXPECT_GT(lower, 0.1);
  EXPECT_NEAR(upper / lower, 1, 1e-2);
  double force = 0, lever = 0;
  for (const ContactView& view : on.views)
    if (view.objectA == view.objectB) {
      force += view.force;
      lever += view.force * view.point_W.x();
    }
  ASSERT_GT(force, 0.1);
  EXPECT_LT(std::abs(lever / force), 0.05 * 0.02);
  const Outcome off = runScene("squeezed ring", joint, squeezedRing(0.0362), 1.2, false);
  EXPECT_GT(off.deepest, 1e-3);
}

Scenario underWeight() {
  Scenario scenario;
  scenario.id = scenario.name = "zigzag";
  scenario.elements = wishedElements();
  scenario.fixedParts = {"floor"};
  scenario.selfContactParts = {"zigzag"};
  return scenario;
}

TEST(SelfContact, threeLayersRestOnEachOther) {
  const Outcome on = runScene("three layers", zigzagJoint(0.004), underWeight(), 3, true);
  EXPECT_LT(on.deepest, 0.1e-3);
  EXPECT_LT(on.last, kMicron);
  EXPECT_LT(on.speed, 1e-5);
  const double weight = on.model->objects[0].mass * 9.81;
  EXPECT_NEAR(on.forceBetween(0, 1) / weight, 1, 1e-3);  // the floor carries all of it
  // Each layer bears what lies over it: two thirds and one third, less what the bends carry.
  EXPECT_GT(on.forceBetween(0, 0) / weight, 0.4);
  EXPECT_LT(on.forceBetween(0, 0) / weight, 1.1);
  const Outcome off = runScene("three layers", zigzagJoint(0.004), underWeight(), 1, false);
  EXPECT_GT(off.deepest, 1e-3);
}

TEST(SelfContact, aSlitThatIsNarrowerThanTheContactDistanceIsLeftAlone) {
  Hairpin hairpin;
  hairpin.gap = 0.0008;
  Scenario scenario = pressedHairpin(0);
  scenario.pressures.clear();
  scenario.supports.clear();
  ASSERT_GT(scenario.contactDistance, hairpin.gap);
  const auto model = compileModel(hairpinJoint(hairpin), scenario).value();
  ASSERT_TRUE(model->effectOn("selfContact"));
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 50; ++i) EXPECT_EQ(stepper.step({}, state).contacts, 0);
  EXPECT_LT((state.q - model->start.q).cwiseAbs().maxCoeff(), 1e-12);
  // It is no blind spot: pressed together it holds.
  const Outcome pressed = runScene("pressed slit", hairpinJoint(hairpin), pressedHairpin(1.0), 0.3, true);
  EXPECT_LT(pressed.deepest, 30 * kMicron);
  EXPECT_GT(pressed.forceBetween(0, 0), 0.5);
}

/// A hairpin that floats, its legs thrown at each other at 0.1 m/s each, in tissue without damping.
struct Thrown {
  std::shared_ptr<const Model> model;
  State state;
};
Thrown thrownHairpin() {
  Joint joint = hairpinJoint({});
  for (Material& material : joint.materials) material.massDamping = material.stiffnessDamping = 0;
  Scenario scenario = pressedHairpin(0);
  scenario.pressures.clear();
  scenario.supports.clear();
  scenario.dt = 0.002;
  Thrown thrown{compileModel(joint, scenario).value(), {}};
  thrown.state = thrown.model->start;
  const ObjectLayout& layout = thrown.model->objects[0].layout;
  const Hairpin h;
  const double middle = h.thickness + 0.5 * h.gap;
  for (int node = 0; node < layout.nodeCount; ++node)
    thrown.state.v[layout.vOffset + 3 * node + 1] = thrown.state.q[layout.qOffset + 3 * node + 1] > middle ? -0.1 : 0.1;
  return thrown;
}

TEST(SelfContact, keepsMomentumAndMakesNoEnergy) {
  auto [model, state] = thrownHairpin();
  Stepper stepper(model, {});
  SelfDepth depth(*model, 0);
  const Vec6 before = test::momentumOf(*model, state);
  const double scale = model->objects[0].mass * 0.1;
  double energy = test::energyOf(*model, state), gained = 0, deepest = 0, force = 0, drift = 0;
  const double first = energy;
  for (int i = 0; i < 400; ++i) {
    const StepReport& report = stepper.step({}, state);
    ASSERT_TRUE(report.taken);
    for (const ContactView& view : report.contactViews) force = std::max(force, view.force);
    const double now = test::energyOf(*model, state);
    gained = std::max(gained, now - energy);
    energy = now;
    deepest = std::max(deepest, depth.at(state));
    drift = std::max(drift, (test::momentumOf(*model, state) - before).head<3>().norm());
  }
  std::printf("thrown hairpin: %.1e of its momentum lost, energy %.3e J at first, most gained in a step %.1e J, deepest %.4f mm\n",
              drift / scale, first, gained, 1e3 * deepest);
  ASSERT_GT(force, 0.001) << "its legs meet";
  EXPECT_LT(drift / scale, 1e-10);      // round-off of the solve
  EXPECT_LT(gained, 1e-6 * first);
  EXPECT_LT(deepest, 50 * kMicron);
}

TEST(SelfContact, rowsOfOneObjectHoldBothOfItsPoints) {
  Hairpin coarse;
  coarse.cellsAlong = 6;
  coarse.cellsAcross = 2;
  const auto model = compileModel(hairpinJoint(coarse), pressedHairpin(1.0)).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 60; ++i) stepper.step({}, state);
  const SceneObject& object = model->objects[0];
  std::vector<Vec3> x(object.collision.vertices.size());
  surfacePositions(object.collision, object.layout, state.q, x);
  const std::span<const Vec3> spans[] = {x};
  ProximityFinder finder(model->collisionSurfaces, model->collisionPairs);
  std::vector<Proximity> found = finder.find(spans, {}, model->scenario.contactDistance, model->scenario.dt);
  ASSERT_GT(found.size(), 10u);
  // Two points beside each other, which share nodes, and one with itself, which no motion parts.
  const auto& corners = model->collisionSurfaces[0]->triangles[0];
  Proximity beside;
  beside.a = {1, {corners[0], corners[0], corners[0]}, {1, 0, 0}};
  beside.b = {3, corners, {0.2, 0.4, 0.4}};
  found.push_back(beside);
  const CouplingIslandModel& island = model->inside->islands[0];
  const ContactObject& body = *model->inside->objects[0];
  const VecX v = VecX::Random(object.layout.vSize);
  IslandRows rows;
  rows.clear();
  const auto point = [&](const FeaturePoint& p) {
    return pointAt(object.collision, false, {p.vertex.data(), static_cast<std::size_t>(p.count)}, {p.weight.data(), static_cast<std::size_t>(p.count)});
  };
  for (std::size_t c = 0; c < found.size(); ++c) {
    rows.begin(static_cast<int>(c));
    rows.append(body, point(found[c].a), found[c].normal_W, state.q, 0);
    rows.append(body, point(found[c].b), -found[c].normal_W, state.q, 0);
    ASSERT_TRUE(rows.finish());
    std::set<int> blocks;
    for (const RowTerm& term : rows.row(static_cast<int>(c))) EXPECT_TRUE(blocks.insert(term.block).second);
    VecX all = VecX::Zero(state.v.size());
    all.segment(object.layout.vOffset, object.layout.vSize) = v;
    const Vec3 apart = body.velocity(point(found[c].a), state.q, all) - body.velocity(point(found[c].b), state.q, all);
    EXPECT_NEAR(dot(rows.row(static_cast<int>(c)), v), found[c].normal_W.dot(apart), 1e-12);
  }
  rows.begin(static_cast<int>(found.size()));
  rows.append(body, point(beside.a), Vec3::UnitY(), state.q, 0);
  rows.append(body, point(beside.a), -Vec3::UnitY(), state.q, 0);
  EXPECT_FALSE(rows.finish());
  EXPECT_EQ(rows.count(), static_cast<int>(found.size()));

  // W of the factor against dense J A⁻¹ Jᵀ.
  test::IslandSystem system = test::systemOf(*model->inside, island, state);
  const int n = rows.count(), size = 3 * island.blockCount;
  MatX A(size, size), J = MatX::Zero(n, size);
  VecX unit(size), column(size);
  for (int i = 0; i < size; ++i) {
    unit = VecX::Unit(size, i);
    system.A.multiply(unit, column);
    A.col(i) = column;
  }
  std::vector<SparseRow> all;
  std::vector<int> ids;
  for (int r = 0; r < n; ++r) {
    all.push_back(rows.row(r));
    ids.push_back(r);
    for (const RowTerm& term : rows.row(r)) J.row(r).segment<3>(3 * term.block) += term.coefficient.transpose();
  }
  auto response = makeCholeskyResponse(island.symbolic, false);
  ASSERT_TRUE(response->factor(system.A));
  MatX W = MatX::Zero(n, n);
  response->prepare(all);
  response->addDelassus(ids, W);
  const MatX dense = J * A.ldlt().solve(J.transpose());
  EXPECT_LT((W - dense).cwiseAbs().maxCoeff() / dense.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ((W - W.transpose()).cwiseAbs().maxCoeff(), 0);
  const VecX eigen = Eigen::SelfAdjointEigenSolver<MatX>(W).eigenvalues();
  EXPECT_GT(eigen.minCoeff(), -1e-12 * eigen.maxCoeff());
}

TEST(SelfContact, aPartThatLiesInOneCellMakesNoContactWithItself) {
  // Five tetrahedra of one cell; its surface is finer than that, so its features are driven by the same nodes.
  Joint joint;
  joint.id = joint.name = "cell";
  addMaterials(joint);
  Part part = boxPart("cell", 1, PartKind::Soft, Vec3::Zero(), Vec3(0.02, 0.02, 0.001), 1);
  part.elements = Elements::Cells;
  joint.parts = {part};
  Scenario scenario;
  scenario.id = scenario.name = "cell";
  scenario.elements = Elements::Cells;
  scenario.gravity_W.setZero();
  scenario.selfContactParts = {"cell"};
  const auto model = compileModel(joint, scenario).value();
  ASSERT_EQ(model->collisionPairs.size(), 1u);
  EXPECT_EQ(std::set<int>(model->collisionPairs[0].cellOfVertex.begin(), model->collisionPairs[0].cellOfVertex.end()), std::set<int>{0});
  Stepper stepper(model, {});
  State state = model->start;
  const ObjectLayout& layout = model->objects[0].layout;
  for (int node = 0; node < layout.nodeCount; ++node)  // pressed flat, at 0.1 m/s
    state.v[layout.vOffset + 3 * node + 2] = state.q[layout.qOffset + 3 * node + 2] > 5e-4 ? -0.1 : 0.1;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(stepper.step({}, state).contacts, 0);
}

TEST(SelfContact, isTheSameForAnyThreadsAndAnyOrderOfParts) {
  Scenario scenario = underWeight();
  Joint joint = zigzagJoint(0.004);
  const auto hashAfter = [&](const Joint& of, int threads, VecX& q) {
    const auto model = compileModel(of, scenario).value();
    Stepper stepper(model, {.threads = threads});
    State state = model->start;
    for (int i = 0; i < 100; ++i) stepper.step({}, state);
    q = test::positionsOf(*model, findPart(of, "zigzag"), state);
    return toHex(stateHash(state));
  };
  VecX one, two, turned;
  EXPECT_EQ(hashAfter(joint, 1, one), hashAfter(joint, 2, two));
  // Another order of parts turns the pair with the floor round, which rounds otherwise: a step agrees to rounding, and what
  // rests in the end too, by the micron that resting sheets may slide.
  std::swap(joint.parts[0], joint.parts[1]);
  hashAfter(joint, 1, turned);
  EXPECT_LT((turned - one).cwiseAbs().maxCoeff(), 20e-6);
}

TEST(SelfContact, isOnWhereTheSceneAsks) {
  const Joint joint = zigzagJoint(0.004);
  const auto pairsWith = [&](Wish wish, std::vector<std::string> parts) {
    Scenario scenario = underWeight();
    scenario.effects.selfContact = wish;
    scenario.selfContactParts = std::move(parts);
    const auto model = compileModel(joint, scenario);
    if (!model.ok()) return -1;
    const auto self = std::count_if((*model)->collisionPairs.begin(), (*model)->collisionPairs.end(), [](const CollisionPair& pair) { return pair.self(); });
    EXPECT_EQ((*model)->effectOn("selfContact"), self > 0);
    return static_cast<int>(self);
  };
  EXPECT_EQ(pairsWith(Wish::Auto, {}), 0);
  EXPECT_EQ(pairsWith(Wish::Auto, {"zigzag"}), 1);
  EXPECT_EQ(pairsWith(Wish::On, {}), 1);
  EXPECT_EQ(pairsWith(Wish::On, {"zigzag"}), 1);
  EXPECT_EQ(pairsWith(Wish::On, {"floor"}), 0);  // rigid and fixed
  EXPECT_EQ(pairsWith(Wish::Off, {"zigzag"}), 0);
  EXPECT_EQ(pairsWith(Wish::Auto, {"tongue"}), -1);
}

TEST(SelfContact, layersOnEachOtherRub) {
  // A force pulls the upper leg of a pressed hairpin sideways.
  const auto slides = [](double friction) {
    Joint joint = hairpinJoint({});
    for (Material& material : joint.materials) material.friction = friction;
    Scenario scenario = pressedHairpin(1.0);
    scenario.loads.push_back({"hairpin", Vec3(0, 0, 0.05), Vec3::Zero(), Vec3(0.05, 0.014, 0)});
    const auto model = compileModel(joint, scenario).value();
    Stepper stepper(model, {});
    State state = model->start;
    double rubbed = 0;
    for (int i = 0; i < 40; ++i) {
      rubbed = 0;
      for (const ContactView& view : stepper.step({}, state).contactViews)
        if (view.force > 0) {
          EXPECT_LE(view.friction_W.norm(), friction * view.force * (1 + 1e-6) + 1e-9);
          rubbed += view.friction_W.norm();
        }
    }
    return rubbed;
  };
  EXPECT_EQ(slides(0), 0);
  EXPECT_GT(slides(0.3), 0.01);
}

}  // namespace
}  // namespace glenoid
