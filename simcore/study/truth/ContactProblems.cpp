// SPDX-License-Identifier: GPL-3.0-or-later
// Whole steps with contact and friction.
#include <cmath>
#include <numbers>

#include "simcore/study/truth/TruthContacts.h"
#include "simcore/study/truth/TruthMotions.h"
#include "simcore/study/truth/TruthRun.h"

namespace glenoid::truth {

namespace {

constexpr double kBall = 0.02, kTouch = 4e-3, kReach = 16 * kTouch, kYoung = 5e4;

/// A ball under its own weight on a block that reaches 16 radii of contact: `cell` in radii of contact,
/// growing faster outwards where it is larger.
TruthScene hertzScene(const TruthSetup& setup, double cell) {
  const double depth = kTouch * kTouch / kBall,
               force = 4.0 / 3 * kYoung / (1 - 0.3 * 0.3) * std::sqrt(kBall) * std::pow(depth, 1.5);
  TruthScene scene = ballOnBlock(kBall, force / 9.81, setup.stiffness * kYoung, cell * kTouch,
                                 std::pow(2, std::sqrt(cell)), kReach);
  scene.scenario.dt = 0.05;
  return scene;
}

Result<TruthValue> hertz(const TruthSetup& setup, double cell) {
  const TruthScene scene = hertzScene(setup, cell);
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  const int ball = run.layoutOf(0).qOffset;
  const double start = run.state.q[ball + 1], hertzDepth = kTouch * kTouch / kBall;
  const double thickness = -boundsOf(*scene.joint.parts[1].visual).min().y(),
               known = hertzDepth * layerDepth(kTouch / thickness);
  double speed = 1;
  for (int i = 0; i < 60 && (i < 4 || speed * scene.scenario.dt > 1e-3 * hertzDepth); ++i) {
    if (!run.step()) return notAtRest();
    speed = std::abs(run.state.v[run.layoutOf(0).vOffset + 1]);
  }
  const double depth = start - run.state.q[ball + 1];
  return TruthValue{depth / hertzDepth, std::abs(depth / known - 1)};
}

/// Root mean square over both blocks' nodes of how far they are from where one stress puts them, of the most
/// that anything moves.
Result<TruthValue> patch(const TruthSetup& setup, int below, int above) {
  const TruthScene scene = contactPatch(below, above, setup.stiffness);
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  if (!run.settle(1e-3 * kPatchPressure / kPatchYoung * 0.04 / scene.scenario.dt, 300)) return notAtRest();
  double off = 0, most = 0;
  int count = 0;
  for (int object = 0; object < 2; ++object) {
    const TetMesh& mesh = *run.model().objects[static_cast<std::size_t>(object)].volume;
    for (int i = 0; i < run.layoutOf(object).nodeCount; ++i) {
      const double y = mesh.nodes[static_cast<std::size_t>(i)].y(), apart = object == 1 ? kPatchGap : 0;
      const double wanted = -kPatchPressure / kPatchYoung * (y - apart + 0.02) - apart;
      off += std::pow(run.state.q[run.layoutOf(object).qOffset + 3 * i + 1] - y - wanted, 2);
      most = std::max(most, std::abs(wanted));
      ++count;
    }
  }
  const double error = std::sqrt(off / count) / most;
  return TruthValue{error, error};
}

Slide slideOf(double dt) {
  Slide slide{.turn = 0.3, .scatter = 0.3, .friction = 0.1};
  slide.dt = dt;
  return slide;
}

Result<TruthValue> slope(const TruthSetup& setup, double dt) {
  const Slide slide = slideOf(dt);
  const auto made = TruthRun::make({slideJoint(slide), slideScenario(slide)}, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  constexpr double kSeconds = 0.4;
  if (!run.run(kSeconds)) return notAtRest();
  const double speed = run.state.v[run.layoutOf(1).vOffset];
  return TruthValue{speed, std::abs(speed / slideSpeed(slide, kSeconds) - 1)};
}

constexpr double kCreep = 0.5;  // s: two swings of creeping after it has stuck

Result<TruthValue> creeping(const TruthSetup& setup, double dt) {
  const StickSlip wish;
  const auto made = TruthRun::make(stickSlip(wish, dt), setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  const int block = run.layoutOf(1).qOffset;
  const double start = run.state.q[block];
  double worst = 0;
  for (long n = 1; n <= std::lround(kCreep / dt); ++n) {
    if (!run.step()) return notAtRest();
    worst = std::max(worst,
                     std::abs(run.state.q[block] - start - stickSlipWay(wish, static_cast<double>(n) * dt)));
  }
  const double way = run.state.q[block] - start;
  return TruthValue{way, worst / stickSlipWay(wish, kCreep)};
}

constexpr double kCapstanFriction = 0.3;
int facetsOf(double angle) {
  return static_cast<int>(std::lround(std::numbers::pi / angle));
}

Result<TruthValue> roundTheDrum(const TruthSetup& setup, double angle) {
  const TruthScene scene = capstan(facetsOf(angle), kCapstanFriction);
  const auto made = TruthRun::make(scene, setup);
  if (!made) return made.error();
  TruthRun& run = **made;
  if (!run.run(kCapstanRise)) return notAtRest();
  // What the held end's springs give: their mean is that of its section, a rectangle of two by one bricks.
  const SceneObject& band = run.model().objects[1];
  double sum = 0, weights = 0;
  for (int i = 0; i < band.layout.nodeCount; ++i) {
    const Vec3& x = band.volume->nodes[static_cast<std::size_t>(i)];
    if (x.x() > 0 || x.y() > -0.02 + 1e-9) continue;
    const double share = std::abs(x.z()) < 1e-6 ? 2 : 1;
    sum += share * (run.state.q[band.layout.qOffset + 3 * i + 1] - x.y());
    weights += share;
  }
  const double ratio = kCapstanPull / (kCapstanSpring * sum / weights);
  return TruthValue{ratio, std::abs(ratio / std::exp(kCapstanFriction * std::numbers::pi) - 1)};
}

}  // namespace

std::vector<TruthProblem> contactProblems() {
  std::vector<TruthProblem> all;
  all.push_back({"hertz",
                 "A ball on a block",
                 "depth, of a half-space's",
                 "",
                 layerDepth(1.0 / 16),
                 "Hertz 1882, with what a bonded layer of 16 radii of contact gives less (Dimitriadis 2002)",
                 "cell",
                 "radii of contact",
                 {1, 0.7, 0.5, 0.35},
                 2,
                 true,
                 {0.1, 0.25, 0.6},
                 {0.03, 0.1},
                 hertz,
                 hertzScene});
  all.push_back({"contact-patch",
                 "Contact patch: two blocks of like meshes",
                 "displacement, root mean square of what is off",
                 "",
                 0,
                 "exact: one stress; Taylor and Papadopoulos 1991",
                 "cell",
                 "m",
                 {0.02, 0.04 / 3, 0.01},
                 3,
                 true,
                 {1e-3, 1e-3},
                 {0.12, 0.12},
                 [](const TruthSetup& setup, double cell) {
                   return patch(setup, static_cast<int>(std::lround(0.08 / cell)),
                                static_cast<int>(std::lround(0.04 / cell)));
                 },
                 [](const TruthSetup& setup, double cell) {
                   return contactPatch(static_cast<int>(std::lround(0.08 / cell)),
                                       static_cast<int>(std::lround(0.04 / cell)), setup.stiffness);
                 }});
  const auto unlike = [](double cell) {
    return std::pair(static_cast<int>(std::lround(0.08 / cell)),
                     3 * static_cast<int>(std::lround(0.02 / cell)));
  };
  all.push_back({"contact-patch-unlike",
                 "Contact patch: two blocks of unlike meshes, 2 to 3",
                 "displacement, root mean square of what is off",
                 "",
                 0,
                 "exact: one stress; Taylor and Papadopoulos 1991",
                 "cell",
                 "m",
                 {0.02, 0.01},
                 2,
                 true,
                 {0.01, 0.01},
                 {0.15, 0.15},
                 [unlike](const TruthSetup& setup, double cell) {
                   return patch(setup, unlike(cell).first, unlike(cell).second);
                 },
                 [unlike](const TruthSetup& setup, double cell) {
                   return contactPatch(unlike(cell).first, unlike(cell).second, setup.stiffness);
                 }});
  all.push_back({"slope",
                 "A block that slides down a slope of scattered triangles",
                 "speed after 0.4 s",
                 "m/s",
                 slideSpeed(slideOf(0.001), 0.4),
                 "(g sin α − µ g cos α) t",
                 "step",
                 "s",
                 {0.02, 0.01, 0.005, 0.0025},
                 3,
                 false,
                 {1e-6, 1e-6},
                 {},
                 slope,
                 [](const TruthSetup&, double dt) {
                   return TruthScene{slideJoint(slideOf(dt)), slideScenario(slideOf(dt))};
                 }});
  all.push_back({"stick-slip",
                 "A block that a spring draws along: it sticks, then creeps",
                 "way after 0.5 s",
                 "m",
                 stickSlipWay({}, kCreep),
                 "v (t − t₀ − sin ω(t − t₀)/ω)",
                 "step",
                 "s",
                 {0.004, 0.002, 0.001, 0.0005},
                 3,
                 false,
                 {0.01, 0.02, 0.8},
                 {},
                 creeping,
                 [](const TruthSetup&, double dt) { return stickSlip({}, dt); }});
  all.push_back({"capstan",
                 "A band round half a drum",
                 "pull over what holds it",
                 "",
                 std::exp(kCapstanFriction * std::numbers::pi),
                 "Euler 1769 and Eytelwein 1808: e^(µ φ), µ 0.3, φ π",
                 "angle",
                 "rad",
                 {std::numbers::pi / 12, std::numbers::pi / 24},
                 1,
                 false,
                 {0.03, 0.05},
                 {},
                 roundTheDrum,
                 [](const TruthSetup&, double angle) { return capstan(facetsOf(angle), kCapstanFriction); }});
  return all;
}

std::span<const TruthProblem> truthProblems() {
  static const std::vector<TruthProblem> all = [] {
    std::vector<TruthProblem> list = elasticProblems();
    for (auto* more : {&motionProblems, &contactProblems})
      for (TruthProblem& problem : more()) list.push_back(std::move(problem));
    return list;
  }();
  return all;
}

const TruthProblem* findTruthProblem(std::string_view id) {
  for (const TruthProblem& problem : truthProblems())
    if (problem.id == id) return &problem;
  return nullptr;
}

}  // namespace glenoid::truth
