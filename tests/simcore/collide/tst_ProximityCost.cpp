// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>

#include "simcore/collide/Penetration.h"
#include "tests/simcore/collide/Scene.h"

namespace {
long allocations = 0;
}
// Counts every allocation of this program. Not inlined: the compiler would think that new is paired with free.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t align) {
  ++allocations;
  const std::size_t step = static_cast<std::size_t>(align);
  if (void* p = std::aligned_alloc(step, (size + step - 1) / step * step)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace glenoid {
namespace {

using namespace shapes;

/// Ellipsoid about the y axis with 2 · around · rings triangles.
TriMesh ellipsoid(const Vec3& half, int around, int rings) {
  TriMesh mesh;
  mesh.vertices.push_back({0, half.y(), 0});
  for (int r = 1; r <= rings; ++r) {
    const double polar = std::numbers::pi * r / (rings + 1);
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * (i + 0.5 * (r % 2)) / around;
      mesh.vertices.push_back({half.x() * std::sin(polar) * std::sin(turn), half.y() * std::cos(polar),
                               half.z() * std::sin(polar) * std::cos(turn)});
    }
  }
  const int last = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back({0, -half.y(), 0});
  const auto at = [&](int r, int i) { return 1 + (r - 1) * around + i % around; };
  for (int i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
    mesh.triangles.push_back({last, at(rings, i + 1), at(rings, i)});
    for (int r = 1; r < rings; ++r) {
      mesh.triangles.push_back({at(r, i), at(r + 1, i), at(r + 1, i + 1)});
      mesh.triangles.push_back({at(r, i), at(r + 1, i + 1), at(r, i + 1)});
    }
  }
  return mesh;
}

/// As crowded as a shoulder of Table 1's sizes: a head, a socket, nine soft parts wrapped closely around the
/// head and touching their neighbours, two tools; 1500 triangles, 25 pairs.
CollisionScene crowdedJoint() {
  CollisionScene scene;
  scene.meshes.push_back(ellipsoid({0.024, 0.025, 0.024}, 12, 11));  // 264
  scene.meshes.push_back(
      moved(ellipsoid({0.018, 0.008, 0.02}, 12, 9), poseOf({0, 0.0333, 0}, {0, 1, 0}, 0.1)));  // 216
  const std::array<std::array<int, 2>, 9> sizes{
      {{10, 7}, {8, 8}, {8, 6}, {7, 5}, {8, 7}, {6, 5}, {6, 4}, {7, 2}, {7, 2}}};
  for (int i = 0; i < 9; ++i) {
    const double angle = 2 * std::numbers::pi * i / 9;
    const TriMesh part = ellipsoid({0.0092, 0.03, 0.003}, sizes[i][0], sizes[i][1]);
    const Vec3 place(0.0268 * std::sin(angle), 0, 0.0268 * std::cos(angle));
    scene.meshes.push_back(moved(part, poseOf(place, {0, 1, 0}, angle)));
    scene.pairs.push_back({0, 2 + i, {}, {}});
    if (i > 0) scene.pairs.push_back({1 + i, 2 + i, {}, {}});
  }
  for (int i = 0; i < 2; ++i) {
    const double side = i ? 1 : -1;
    scene.meshes.push_back(
        moved(ellipsoid({0.0025, 0.06, 0.0025}, 8, 6), poseOf({side * 0.034, 0.05, 0.022}, {1, 0, 0}, 0.3)));
    const int tool = static_cast<int>(scene.meshes.size()) - 1;
    for (const int other : {0, i ? 3 : 9, i ? 4 : 10}) scene.pairs.push_back({tool, other, {}, {}});
  }
  scene.pairs.push_back({1, 5, {}, {}});
  scene.pairs.push_back({1, 6, {}, {}});
  return scene;
}

/// Moves every surface a little, differently in each step.
void stir(CollisionScene& scene, const CollisionScene& rest, int step) {
  for (std::size_t s = 0; s < scene.meshes.size(); ++s) {
    const double phase = 0.07 * step + 1.3 * static_cast<double>(s);
    const Pose pose = poseOf(Vec3(std::sin(phase), std::cos(1.7 * phase), std::sin(2.3 * phase)) * 4e-4,
                             {1, 2, 3}, 0.02 * std::sin(phase));
    for (std::size_t v = 0; v < scene.meshes[s].vertices.size(); ++v) {
      scene.meshes[s].vertices[v] = pose * rest.meshes[s].vertices[v];
    }
  }
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// CPU time of this thread.
double threadMicroseconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

template <class F>
double microseconds(F&& work) {
  const double start = threadMicroseconds();
  work();
  return threadMicroseconds() - start;
}

TEST(ProximityCost, aCrowdedJointIsFoundWithoutAllocating) {
  const CollisionScene rest = crowdedJoint();
  CollisionScene scene = rest;
  for (const TriMesh& mesh : scene.meshes) {
    ASSERT_GT(enclosedVolume(mesh), 0);
    scene.velocities.emplace_back(mesh.vertices.size(), Vec3(0.02, -0.03, 0.01));
  }
  ProximityFinder finder(scene.surfaces(), scene.pairs);
  PenetrationCheck check(scene.surfaces(), scene.pairs);
  const auto positions = scene.positionSpans(), velocities = scene.velocitySpans();
  std::size_t most = 0, sum = 0;
  double deepest = 0;
  const auto run = [&] {
    const auto& found = finder.find(positions, velocities, 0.0015, 0.005);
    most = std::max(most, found.size());
    sum += found.size();
  };
  constexpr int steps = 300;
  for (int i = 0; i < steps; ++i) {  // warm-up: the same steps
    stir(scene, rest, i);
    run();
    deepest = std::max(deepest, check.deepest(positions).depth);
  }
  sum = 0;
  const long before = allocations;
  ASSERT_GT(before, 0);  // the counter counts
  for (int i = 0; i < steps; ++i) {
    stir(scene, rest, i);
    run();
  }
  EXPECT_EQ(allocations, before);
  std::vector<double> find, penetration;
  find.reserve(steps);
  penetration.reserve(steps);
  for (int i = 0; i < steps; ++i) {
    stir(scene, rest, i);
    find.push_back(microseconds([&] { run(); }));
    penetration.push_back(microseconds([&] { check.deepest(positions); }));
  }
  std::printf(
      "proximity: median %.0f us, penetration check: median %.0f us; contacts mean %.1f, most %zu; triangle "
      "pairs %ld, vertex-face %ld, edge-edge %ld, depth queries %ld; deepest %.2f mm\n",
      median(find), median(penetration), static_cast<double>(sum) / (2 * steps), most,
      finder.counts().trianglePairs, finder.counts().vertexFace, finder.counts().edgeEdge,
      finder.counts().depthQueries, 1e3 * deepest);
  // The scene must be worth measuring. Times are printed, not judged: the machine is shared.
  EXPECT_GT(sum / (2 * steps), 25u);  // local minima of distance; what is merely near gives no row
  EXPECT_GT(deepest, 1e-4);
}

TEST(ProximityCost, equalPositionsGiveEqualBitsWhateverCameBefore) {
  const CollisionScene rest = crowdedJoint();
  CollisionScene scene = rest;
  ProximityFinder used(scene.surfaces(), scene.pairs);
  for (int i = 0; i < 40; ++i) {
    stir(scene, rest, 3 * i);
    const auto found = used.find(scene.positionSpans(), {}, 0.0015, 0.005);
    ProximityFinder fresh(scene.surfaces(), scene.pairs);
    const auto& again = fresh.find(scene.positionSpans(), {}, 0.0015, 0.005);
    ASSERT_EQ(found.size(), again.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].key, again[k].key);
      EXPECT_EQ(found[k].gap, again[k].gap);
      EXPECT_EQ(found[k].normal_W, again[k].normal_W);
      EXPECT_EQ(found[k].a.weight, again[k].a.weight);
      EXPECT_EQ(found[k].b.weight, again[k].b.weight);
    }
  }
}

}  // namespace
}  // namespace glenoid
