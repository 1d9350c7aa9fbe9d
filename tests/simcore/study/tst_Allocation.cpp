// SPDX-License-Identifier: GPL-3.0-or-later
// A warm step takes nothing from the heap: the shipped scene, and the same joint in finer cells up to nearly 10 000
// velocities. Counts at malloc itself, below `new` and below Eigen, which does not use it.
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

#include "simcore/study/RefineJoint.h"
#include "tests/simcore/study/ShippedScene.h"

namespace {
std::atomic<long> allocations{0};
}

extern "C" {
// The C library's own entries behind the names that are replaced here.
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) { return ++allocations, __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return ++allocations, __libc_calloc(count, size); }
void* realloc(void* p, std::size_t size) { return ++allocations, __libc_realloc(p, size); }
void* memalign(std::size_t align, std::size_t size) { return ++allocations, __libc_memalign(align, size); }
void* aligned_alloc(std::size_t align, std::size_t size) { return ++allocations, __libc_memalign(align, size); }
int posix_memalign(void** out, std::size_t align, std::size_t size) {
  ++allocations;
  return (*out = __libc_memalign(align, size)) ? 0 : ENOMEM;
}
}

namespace glenoid::test {
namespace {

TEST(Allocation, theCounterSeesEveryWayToTheHeap) {
  const long before = allocations;
  int* volatile one = new int(1);  // volatile: the pair may not be left out
  delete one;
  EXPECT_GT(allocations, before);
  const long afterNew = allocations;
  EXPECT_EQ(VecX::Zero(100).eval().size(), 100);
  EXPECT_GT(allocations, afterNew);
}

/// Steps the hands along the input; twice the same stretch, since only the second time every scratch has its size.
void expectNoAllocation(const StudyScene& scene, std::shared_ptr<const Model> model, const State& start, double time, int steps) {
  for (const int threads : {1, 2}) {
    Stepper stepper(model, {Profile::Direct, threads});
    State state = start;
    Inputs inputs;
    long counted = 0;
    int active = 0;
    for (const bool warm : {false, true}) {
      state = start;
      for (int s = 0; s < steps; ++s) {
        handsAt(scene.scenario, &scene.input, time + (s + 1) * scene.scenario.dt, inputs.hands);
        const long before = allocations;
        active = std::max(active, stepper.step(inputs, state).active);
        if (warm) counted += allocations - before;
      }
    }
    EXPECT_GT(active, 0) << "nothing touches: the test would see no contact code";
    EXPECT_EQ(counted, 0) << threads << " threads";
  }
}

TEST(Allocation, aWarmStepOfTheShippedSceneAllocatesNothing) {
  const StudyScene scene = shippedScene();
  const auto model = compileModel(scene.joint, scene.scenario).value();
  constexpr double kTime = 6.4;  // s, while the cuff is pressed
  expectNoAllocation(scene, model, stateAt(scene, model, kTime), kTime, 100);
}

TEST(Allocation, aWarmStepOfCellsAllocatesNothing) {
  StudyScene scene = shippedScene();
  scene.scenario.elements = Elements::Cells;
  scene.scenario.loads.clear();  // what pulls the muscles of this scene was chosen for tetrahedra
  const auto model = compileModel(scene.joint, scene.scenario).value();
  constexpr double kTime = 6.4;
  expectNoAllocation(scene, model, stateAt(scene, model, kTime), kTime, 100);
}

TEST(Allocation, aWarmStepOfSomeThousandVelocitiesAllocatesNothing) {
  const StudyScene scene = shippedScene();
  const auto coarse = compileModel(scene.joint, scene.scenario).value();
  constexpr double kTime = 6.4;
  const State state = stateAt(scene, coarse, kTime);
  const auto fine = compileModel(refineJoint(scene.joint, 10).value(), scene.scenario).value();
  EXPECT_GT(fine->start.v.size(), 6000);
  EXPECT_LT(fine->start.v.size(), 10000);
  expectNoAllocation(scene, fine, carryToRefined(*coarse, state, *fine), kTime, 20);
}

}  // namespace
}  // namespace glenoid::test
