// SPDX-License-Identifier: GPL-3.0-or-later
// What no step may change: momentum of a closed system, its energy upwards, and the heap.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "simcore/step/StepModel.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace {
std::atomic<long> allocations{0};
}

// Every way to the heap that plain and aligned `new` take; the deletes match.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t align) {
  ++allocations;
  const auto a = static_cast<std::size_t>(align);
  if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace glenoid {
namespace {

/// Figure 4's chain with every part free and a loose block flying into its middle; no gravity, no tools.
std::shared_ptr<const Model> closedSystem(double dt, State& state) {
  Joint joint = scenes::figure4Joint();
  joint.parts.push_back(scenes::boxPart("loose", 4, PartKind::Soft, Vec3(-0.01, 0.022, 0.002), Vec3(0.01, 0.04, 0.018)));
  Scenario scenario;
  scenario.dt = dt;
  scenario.gravity_W.setZero();
  const auto model = compileModel(joint, scenario).value();
  state = model->start;
  const ObjectLayout& loose = model->objects[3].layout;
  for (int node = 0; node < loose.nodeCount; ++node) state.v.segment<3>(loose.vOffset + 3 * node) = Vec3(0.05, -0.4, 0.02);
  return model;
}

Vec6 momentumOf(const Model& model, const State& state) {
  Vec6 sum = Vec6::Zero();
  for (const auto& object : model.inside->objects) sum += object->momentum(state);
  return sum;
}

double energyOf(const Model& model, const State& state) {
  double sum = 0;
  for (const auto& object : model.inside->objects) sum += object->kineticEnergy(state) + object->elasticEnergy(state);
  for (const SpringView& spring : model.springs) {
    const ContactObject &a = *model.inside->objects[spring.objectA], &b = *model.inside->objects[spring.objectB];
    const Vec3 stretch = a.position(pointAt(spring.a, a.layout().rigid), state.q) - b.position(pointAt(spring.b, b.layout().rigid), state.q);
    sum += 0.5 * spring.stiffness * stretch.squaredNorm();
  }
  return sum;
}

TEST(Invariants, linearMomentumIsKeptThroughCouplingsAndContacts) {
  for (const double dt : {1e-3, 5e-3}) {
    State state;
    const auto model = closedSystem(dt, state);
    Stepper stepper(model, {});
    const Vec3 before = momentumOf(*model, state).head<3>();
    int touched = 0;
    for (int i = 0; i < 300; ++i) touched += stepper.step({}, state).active > 0;
    EXPECT_GT(touched, 3);
    // Round-off of 300 solves whose condition is about 1e6.
    EXPECT_LT((momentumOf(*model, state).head<3>() - before).norm(), 1e-9 * before.norm()) << dt;
  }
}

TEST(Invariants, angularMomentumDriftsLessWithSmallerSteps) {
  // The chain of Figure 4 turns and bends freely. At frozen rotation K v has no torque about the turned rest shape, but
  // some, of the order of the strain, about the strained one: Δt² K v in a step, so the drift fades with Δt.
  // (Rayleigh damping adds Δt β K v, which does not; it is off here.)
  const auto drift = [](double dt) {
    Scenario scenario;
    scenario.dt = dt;
    scenario.effects.gravity = scenario.effects.contact = scenario.effects.damping = Wish::Off;
    const auto model = compileModel(scenes::figure4Joint(), scenario).value();
    State state = model->start;
    const Vec3 omega(3, 2, 10);  // rad/s
    for (const SceneObject& object : model->objects) {
      const ObjectLayout& layout = object.layout;
      if (layout.rigid) state.v.segment<3>(layout.vOffset + 3) = omega;
      for (int node = 0; node < (layout.rigid ? 1 : layout.nodeCount); ++node)
        state.v.segment<3>(layout.vOffset + 3 * node) = omega.cross(state.q.segment<3>(layout.qOffset + 3 * node));
    }
    Stepper stepper(model, {});
    const Vec3 before = momentumOf(*model, state).tail<3>();
    const int steps = static_cast<int>(std::lround(0.2 / dt));
    for (int i = 0; i < steps; ++i) stepper.step({}, state);
    return (momentumOf(*model, state).tail<3>() - before).norm() / before.norm();
  };
  const double coarse = drift(4e-3), middle = drift(2e-3), fine = drift(1e-3);
  EXPECT_LT(middle, 0.65 * coarse) << coarse << " at 4 ms, " << middle << " at 2 ms";
  EXPECT_LT(fine, 0.65 * middle) << middle << " at 2 ms, " << fine << " at 1 ms";
  RecordProperty("slope", std::to_string(std::log2(coarse / fine) / 2));
  EXPECT_LT(fine, 2e-2);
}

TEST(Invariants, energyOfAClosedSystemDoesNotGrow) {
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    State state;
    const auto model = closedSystem(dt, state);
    Stepper stepper(model, {});
    const double start = energyOf(*model, state);
    double last = start, worst = 0;
    for (int i = 0; i < 300; ++i) {
      stepper.step({}, state);
      const double now = energyOf(*model, state);
      worst = std::max(worst, now - last);
      last = now;
    }
    EXPECT_LT(worst, 1e-9 * start) << "in one step of " << dt;
    EXPECT_LT(last, start);
  }
}

TEST(Invariants, aWarmStepAllocatesNothing) {
  for (const int threads : {1, 2}) {
    const auto model = compileModel(scenes::figure4Joint(), scenes::figure5Scenario()).value();
    Stepper stepper(model, {Profile::Direct, threads});
    State state = model->start;
    Inputs hands;
    for (const Tool& tool : model->scenario.tools) hands.hands.push_back(tool.home);
    const auto press = [&](int i) {
      for (Pose& hand : hands.hands) hand.p_WB.y() = 0.0205 - 2e-3 * (1 - std::cos(0.05 * i));
      return stepper.step(hands, state).active;
    };
    int active = 0;
    for (int i = 0; i < 400; ++i) active = std::max(active, press(i));
    ASSERT_GT(active, 1);
    const long before = allocations;
    for (int i = 400; i < 650; ++i) press(i);
    EXPECT_EQ(allocations - before, 0) << threads << " threads";
  }
}

}  // namespace
}  // namespace glenoid
