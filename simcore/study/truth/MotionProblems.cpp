// SPDX-License-Identifier: GPL-3.0-or-later
// Whole steps without contact.
#include <cmath>
#include <complex>

#include "simcore/study/truth/TruthMotions.h"
#include "simcore/study/truth/TruthRun.h"

namespace glenoid::truth {

namespace {

/// Two masses on a spring, pulled apart by d at the start: what is the most that their distance is off that
/// of `wanted` after n steps, of d.
Result<TruthValue> springPair(const TruthSetup& setup, double dt, bool continuous) {
  constexpr double kStiffness = 4, kApart = 1e-3, kSeconds = 0.5;
  TruthScene scene = twoBoxesOnASpring(kStiffness);
  scene.scenario.dt = dt;
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  const int first = run.layoutOf(0).qOffset, second = run.layoutOf(1).qOffset;
  const double m1 = run.model().objects[0].mass, m2 = run.model().objects[1].mass,
               omega = std::sqrt(kStiffness * (m1 + m2) / (m1 * m2));
  const double rest = run.state.q[second] - run.state.q[first];
  run.state.q[second] += kApart;
  const std::complex<double> z = 1.0 / std::complex<double>(1, -omega * dt);
  std::complex<double> swing = 1;
  double worst = 0;
  for (long n = 1; n <= std::lround(kSeconds / dt); ++n) {
    if (!run.step()) return notAtRest();
    swing *= z;
    const double wanted = continuous ? std::cos(omega * static_cast<double>(n) * dt) : swing.real();
    worst = std::max(worst, std::abs((run.state.q[second] - run.state.q[first] - rest) / kApart - wanted));
  }
  return TruthValue{worst, worst};
}

/// A rigid box alone in space that tumbles about no principal axis: the most that its energy or its angular
/// momentum is off, as a share.
Result<TruthValue> freeRotation(const TruthSetup& setup, double dt) {
  TruthScene scene = twoFallingBoxes();
  scene.scenario.effects.gravity = Wish::Off;
  scene.scenario.dt = dt;
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  const ObjectLayout& layout = run.layoutOf(0);
  const auto omega = [&]() -> Vec3 { return run.state.v.segment<3>(layout.vOffset + 3); };
  run.state.v.segment<3>(layout.vOffset + 3) = Vec3(8, 3, -5);
  // Moments of inertia of a box of 30 × 20 × 50 mm and 2000 kg/m³, about its own axes.
  const Vec3 side(0.03, 0.02, 0.05), squares = side.cwiseAbs2();
  const Vec3 inertia = 2000 * side.prod() / 12 *
                       Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  const auto momentum = [&]() -> Vec3 {
    const Quat turn = poseAt(run.state.q, layout.qOffset).q_WB *
                      poseAt(run.model().start.q, layout.qOffset).q_WB.conjugate();
    return turn * Vec3(inertia.cwiseProduct(turn.conjugate() * omega()));
  };
  const Vec3 before = momentum();
  const double energy = 0.5 * omega().dot(before);
  double worst = 0;
  for (long n = 0; n < std::lround(2 / dt); ++n) {
    if (!run.step()) return notAtRest();
    const Vec3 now = momentum();
    worst = std::max(
        {worst, (now - before).norm() / before.norm(), std::abs(0.5 * omega().dot(now) / energy - 1)});
  }
  return TruthValue{worst, worst};
}

constexpr double kBarYoung = 5e5, kBarDensity = 1000, kBarDown = 0.1;

/// How much a hanging bar grows between what holds it and its lower end, by its own weight, m.
Result<TruthValue> hangingBarGrowth(const TruthSetup& setup, double cell) {
  TruthScene scene =
      hangingBar(static_cast<int>(std::lround(0.02 / cell)), setup.stiffness * kBarYoung, kBarDensity);
  scene.scenario.dt = 0.1;
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  if (!run.settle(1e-9, 60)) return notAtRest();
  const TetMesh& mesh = *run.model().objects[1].volume;
  const auto sag = [&](int node) {
    return mesh.nodes[static_cast<std::size_t>(node)].y() -
           run.state.q[run.layoutOf(1).qOffset + 3 * node + 1];
  };
  double top = 0, held = 0, bottom = 0;
  int bottoms = 0;
  for (int i = 0; i < run.layoutOf(1).nodeCount; ++i)
    if (mesh.nodes[static_cast<std::size_t>(i)].y() < -kBarDown + 1e-9) bottom += sag(i), ++bottoms;
  // The bond's own mean over its area: nodes of the end share the area unevenly, and sag unevenly for it.
  for (const SpringView& spring : run.model().springs) {
    double mean = 0;
    for (std::size_t k = 0; k < 4; ++k) mean += spring.a.weight[k] * sag(spring.a.node[k]);
    top += spring.stiffness * mean;
    held += spring.stiffness;
  }
  const double grown = bottom / bottoms - top / held,
               known = kBarDensity * 9.81 * kBarDown * kBarDown / (2 * kBarYoung);
  return TruthValue{grown, std::abs(grown / known - 1)};
}

constexpr double kBarLoad = 2;  // F L²/(E I)

int bricksThrough(double cell) {
  return static_cast<int>(std::lround(kBarLength / 20 / cell));
}

Result<TruthValue> elastica(const TruthSetup& setup, double cell) {
  const auto made = TruthRun::make(clampedBar(bricksThrough(cell), kBarLoad, setup.stiffness), setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  if (!run.settle(1e-7, 400)) return notAtRest();
  const double drop = -run.placeOf(1, Vec3(kBarLength, 0, 0)).y() / kBarLength;
  return TruthValue{drop, std::abs(drop / elasticaDrop(kBarLoad) - 1)};
}

}  // namespace

std::vector<TruthProblem> motionProblems() {
  constexpr const char* kNoVelocity = "a scenario cannot say how fast a part begins";
  std::vector<TruthProblem> all;
  all.push_back({"free-rotation",
                 "A rigid box that tumbles freely",
                 "energy and angular momentum, what is off",
                 "",
                 0,
                 "conservation",
                 "step",
                 "s",
                 {0.02, 0.005, 0.001},
                 3,
                 false,
                 {1e-11, 1e-11},
                 {},
                 freeRotation,
                 {},
                 kNoVelocity});
  all.push_back({"spring-pair",
                 "Two masses on a spring",
                 "distance, the most that it is off",
                 "",
                 0,
                 "x = d cos ωt",
                 "step",
                 "s",
                 {0.002, 0.001, 0.0005, 0.00025},
                 4,
                 false,
                 {0.03, 0.03, 0.9},
                 {},
                 [](const TruthSetup& setup, double dt) { return springPair(setup, dt, true); },
                 {},
                 "a scenario cannot begin with a spring pulled apart"});
  all.push_back({"spring-pair-step",
                 "The same beside what backward Euler must do",
                 "distance, the most that it is off",
                 "",
                 0,
                 "x = d Re (1 − iωΔt)⁻ⁿ",
                 "step",
                 "s",
                 {0.02, 0.005, 0.001},
                 3,
                 false,
                 {1e-9, 1e-9},
                 {},
                 [](const TruthSetup& setup, double dt) { return springPair(setup, dt, false); },
                 {},
                 "a scenario cannot begin with a spring pulled apart"});
  all.push_back({"hanging-bar",
                 "A bar that hangs by its own weight",
                 "how much longer it gets",
                 "m",
                 kBarDensity * 9.81 * kBarDown * kBarDown / (2 * kBarYoung),
                 "ρ g L² / 2E",
                 "cell",
                 "m",
                 {0.02, 0.01, 0.005},
                 2,
                 true,
                 {1e-3, 1e-3, 1.5},
                 {1e-3, 1e-3},
                 hangingBarGrowth,
                 [](const TruthSetup& setup, double cell) {
                   TruthScene scene = hangingBar(static_cast<int>(std::lround(0.02 / cell)),
                                                 setup.stiffness * kBarYoung, kBarDensity);
                   scene.scenario.dt = 0.1;
                   return scene;
                 }});
  all.push_back({"elastica",
                 "A slender bar that bends far",
                 "drop of its end, of its length",
                 "",
                 elasticaDrop(kBarLoad),
                 "elastica: Bisshopp and Drucker 1945, F L²/EI = 2",
                 "cell",
                 "m",
                 {0.005, 0.0025, 0.00125},
                 2,
                 true,
                 {0.08, 0.25, 1.2},
                 {0.01, 0.01},
                 elastica,
                 [](const TruthSetup& setup, double cell) {
                   return clampedBar(bricksThrough(cell), kBarLoad, setup.stiffness);
                 }});
  return all;
}

}  // namespace glenoid::truth
