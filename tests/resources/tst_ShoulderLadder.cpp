// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for small scenes holds for the shoulder that ships: contact conditions of a whole run, order of
// the parts, and the linear solvers on its own matrix.
#include <gtest/gtest.h>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/ConjugateGradients.h"
#include "simcore/linear/ReferenceCholesky.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/simcore/step/ContactJudge.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

using test::ContactJudge;

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

const Joint& shoulder() {
  static const Joint joint = loadJoint(kResources + "/joints/shoulder.joint").value();
  return joint;
}

/// Without friction, whose law the judge does not know (and whose compliance it would see: see tst_Friction), and without
/// dents, in which contacts give way on purpose (see tst_Dents).
const Scenario& arthroscopy() {
  static const Scenario scenario = [] {
    Scenario smooth = loadScenario(kResources + "/scenarios/arthroscopy.scenario.json").value();
    smooth.effects.friction = Wish::Off;
    smooth.effects.dent = Wish::Off;
    return smooth;
  }();
  return scenario;
}

const Recording& input() {
  static const Recording recording = loadRecording(kResources + "/recordings/arthroscopy.recording").value();
  return recording;
}

std::shared_ptr<const Model> arthroscopyModel() {
  static const auto model = compileModel(shoulder(), arthroscopy()).value();
  return model;
}

/// The shipped run step by step.
struct Session {
  explicit Session(std::shared_ptr<const Model> compiled, Profile profile = Profile::Direct)
      : model(std::move(compiled)), stepper(model, {profile}), state(model->start) {}
  const StepReport& step() {
    handsAt(model->scenario, &input(), (state.step + 1) * model->scenario.dt, hands.hands);
    return stepper.step(hands, state);
  }
  std::shared_ptr<const Model> model;
  Stepper stepper;
  State state;
  Inputs hands;
};

TEST(ShoulderLadder, everyContactOfAWholeRunIsComplementary) {
  // Speeds of 0.1 m/s keep 1e-17; the solve of the stiffest rows and a compliance of 1e-12 leave some 1e-13
  // m/s.
  Session run(arthroscopyModel());
  ContactJudge judge(*run.model);
  double worst = 0;
  int most = 0, active = 0, judged = 0, cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const State before = run.state;
    const StepReport& report = run.step();
    ASSERT_TRUE(report.taken);
    if (report.parts > 1) {  // as the first, in which all loads come at once: the judge sees whole steps alone
      ++cut;
      continue;
    }
    const ContactJudge::Verdict verdict = judge.judge(before, run.state);
    // A step that searched again along the motion that it takes holds contacts that the judge does not look for.
    ASSERT_LE(verdict.rows, report.contacts + report.droppedRows) << i;
    ASSERT_LE(verdict.active, report.active) << i;
    judged += verdict.rows == report.contacts + report.droppedRows;
    ASSERT_EQ(verdict.pull, 0);
    worst = std::max({worst, verdict.approach, verdict.both});
    most = std::max(most, verdict.rows);
    active += verdict.active;
  }
  std::printf("worst complementarity %.1e m/s, at most %d contacts, %d active over all steps\n", worst, most,
              active);
  EXPECT_LT(worst, 1e-11);
  EXPECT_GT(most, 40);  // rows are local minima of distance, not all that is near
  EXPECT_GT(active, 500);
  EXPECT_LE(cut, 1);
  EXPECT_GT(judged, 1900);
}

/// A run under a hundred newtons up and into the socket while both hands work: how deep parts lie in each other, m.
struct Depths {
  double thrown = 0;     ///< in the first 50 ms, in which all loads come at once and throw the head into its socket
  double later = 0;      ///< afterwards
  int steps = 0, deep = 0;  ///< of the later ones, those beyond 0.02 mm
};
Depths depthsUnderLoad(double dt, double seconds) {
  Scenario pressed = arthroscopy();
  pressed.dt = dt;
  pressed.loads.push_back({"humerus", Vec3(0, 40, -100), Vec3::Zero()});
  Session run(compileModel(shoulder(), pressed).value());
  Depths depths;
  std::string where;
  int most = 0;
  for (int i = 0; i * dt < seconds; ++i) {
    const StepReport& report = run.step();
    EXPECT_TRUE(report.taken);
    most = std::max(most, report.active);
    PenetrationProbe probe(*run.model, SurfaceKind::Collision);
    probe.look(run.state.q);
    if (i * dt < 0.05) {
      depths.thrown = std::max(depths.thrown, probe.deepest());
      continue;
    }
    ++depths.steps;
    depths.deep += probe.deepest() > 2e-5;
    if (probe.deepest() > depths.later) where = probe.where();
    depths.later = std::max(depths.later, probe.deepest());
  }
  EXPECT_GE(most, 8) << "it presses";
  std::printf("steps of %.2f ms: %.4f mm while it is thrown, %.4f mm (%s) after that, more than 0.02 mm in %d of %d\n", 1e3 * dt, 1e3 * depths.thrown,
              1e3 * depths.later, where.c_str(), depths.deep, depths.steps);
  return depths;
}

TEST(ShoulderLadder, pressedIntoItsSocketHardlyAnythingGoesInside) {
  // The labrum's edge lies along and across facets of the head and rolls over them, the cuff is squeezed against the
  // coracoacromial arch. 0.02 mm is what half a step of rolling leaves; where what touches changes from edge to edge it is
  // more, for one step. What a blow leaves is an error of the step: with a quarter of it less than half remains.
  const Depths whole = depthsUnderLoad(0.005, 10), quarter = depthsUnderLoad(0.00125, 0.05);
  EXPECT_LT(whole.later, 6e-5);
  EXPECT_LE(whole.deep, whole.steps / 100);
  EXPECT_LT(quarter.thrown, whole.thrown / 2);
}

TEST(ShoulderLadder, referenceIsComplementaryToo) {
  Session direct(arthroscopyModel());
  for (int i = 0; i < 560; ++i) direct.step();
  Session reference(arthroscopyModel(), Profile::Reference);
  reference.state = direct.state;
  ContactJudge judge(*direct.model);
  for (int i = 0; i < 3; ++i) {
    const State before = reference.state;
    reference.step();
    const ContactJudge::Verdict verdict = judge.judge(before, reference.state);
    EXPECT_GT(verdict.active, 1);
    EXPECT_LT(std::max(verdict.approach, verdict.both), 1e-11);
  }
}

/// Largest difference of any velocity of a part or tool, by id.
double difference(const Model& a, const State& x, const Model& b, const State& y) {
  double worst = 0;
  for (const SceneObject& one : a.objects)
    for (const SceneObject& other : b.objects)
      if (one.id == other.id && one.layout.vSize > 0)
        worst = std::max(worst, (x.v.segment(one.layout.vOffset, one.layout.vSize) -
                                 y.v.segment(other.layout.vOffset, one.layout.vSize))
                                    .cwiseAbs()
                                    .maxCoeff());
  return worst;
}

TEST(ShoulderLadder, orderOfPartsInTheFileDoesNotMatter) {
  Joint reversed = shoulder();
  std::reverse(reversed.parts.begin(), reversed.parts.end());
  std::reverse(reversed.couplings.begin(), reversed.couplings.end());
  Session first(arthroscopyModel()), second(compileModel(reversed, arthroscopy()).value());
  double worst = 0;
  int active = 0, apart = 0;
  for (int i = 0; i < 600; ++i) {  // to 3 s: both tools press
    active += first.step().active;
    second.step();
    const double off = difference(*first.model, first.state, *second.model, second.state);
    // Round-off of speeds of 0.1 m/s through solves of condition 1e6.
    apart += off > 1e-11;
    worst = std::max(worst, off);
  }
  std::printf("parts in reverse: %.1e m/s apart at most, more than round-off in %d steps\n", worst, apart);
  EXPECT_GT(active, 100);
  // A contact that presses by less than the tolerance of the solver may press in one order and not in the other: 4 steps of
  // 600 are apart by more than round-off here, the others agree again.
  EXPECT_LE(apart, 6);
  EXPECT_LT(worst, 1e-9);
}

TEST(ShoulderLadder, threeSolversGiveOneAnswer) {
  Session run(arthroscopyModel());
  for (int i = 0; i < 100; ++i) run.step();
  const StepModel& inside = *run.model->inside;
  for (const CouplingIslandModel& island : inside.islands) {
    const auto [A, b] = test::systemOf(inside, island, run.state);
    BlockCholesky cholesky(island.symbolic);
    ReferenceCholesky cholmod(island.symbolic);
    ASSERT_TRUE(cholesky.factor(A) && cholmod.factor(A));
    VecX x = b, y = b, z;
    cholesky.solve(x);
    cholmod.solve(y);
    CgWork work;
    const CgReport report = solveConjugateGradients(A, b, z, {1e-13, 20000}, work, true);
    ASSERT_TRUE(report.finite);
    // As in tst_Equivalence; a tool that nothing pulls has y near zero, so the scale is that of a millimetre
    // a second.
    EXPECT_LT((x - y).norm(), 1e-12 * (1e-3 + y.norm())) << island.blockCount << " blocks";
    EXPECT_LT((z - y).norm(), 1e-10 * (1e-3 + y.norm()))
        << island.blockCount << " blocks, " << report.iterations << " iterations";
  }
}

}  // namespace
}  // namespace glenoid
