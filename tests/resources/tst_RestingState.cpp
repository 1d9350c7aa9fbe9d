// SPDX-License-Identifier: GPL-3.0-or-later
// Both scenes that ship rest on their anatomy: no spring holds the humerus in its place, cuff and biceps pull as loads, and
// what presses on what carries them. Judged by statics: forces that the run reports must balance.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>

#include "resources/generate/CuffTone.h"
#include "simcore/live/Run.h"
#include "simcore/reading/Readings.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/step/Stepper.h"

namespace glenoid {
namespace {

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

struct Scene {
  Joint joint;
  Scenario scenario;
};

Scene shipped(const std::string& name) {
  Scene scene;
  scene.scenario = loadScenario(kResources + "/scenarios/" + name + ".scenario.json").value();
  scene.joint = loadJoint(kResources + (name == "palpation" ? "/joints/shoulder-superficial.joint" : "/joints/shoulder.joint")).value();
  return scene;
}

/// A scene after some seconds with hands at home.
struct Settled {
  explicit Settled(const Scene& scene, double seconds = 2) : model(compileModel(scene.joint, scene.scenario).value()), state(model->start) {
    Stepper stepper(model, {});
    Inputs inputs;
    for (int i = 0; i < std::lround(seconds / scene.scenario.dt); ++i) {
      handsAt(scene.scenario, nullptr, (i + 1) * scene.scenario.dt, inputs.hands);
      report = stepper.step(inputs, state);
      EXPECT_TRUE(report.taken);
    }
    now = readScene(*model, state, report.contactViews);
    atStart = readScene(*model, model->start, {});
  }
  const PartReading& part(const SceneReading& reading, const std::string& id) const {
    return *std::find_if(reading.parts.begin(), reading.parts.end(), [&](const PartReading& p) { return p.id == id; });
  }
  /// Where the head's centre is, which rests at the origin.
  Vec3 head() const {
    const PartReading &is = part(now, "humerus"), &was = part(atStart, "humerus");
    return is.centre_W + is.q_WB * Vec3(-was.centre_W);
  }
  /// Force on the humerus of the contacts with parts that `from` names, and its torque about the head's centre.
  Wrench contacts(const std::set<std::string>& from) const {
    Wrench sum;
    sum.point_W = head();
    for (const ContactReading& c : now.contacts) {
      if (c.a != "humerus" && c.b != "humerus") continue;
      const bool onA = c.a == "humerus";
      if (!from.empty() && !from.contains(onA ? c.b : c.a)) continue;
      const Vec3 force = (onA ? 1 : -1) * (c.force * c.normal_W + c.friction_W);
      sum.force_W += force;
      sum.torque_W += (c.point_W - sum.point_W).cross(force);
    }
    return sum;
  }
  Vec3 reaction() const { return contacts({"scapula", "labrum"}).force_W; }
  /// What acts on the humerus but for the joint's reaction.
  Vec3 carried() const {
    Vec3 sum = contacts({}).force_W - reaction() + part(now, "humerus").mass * model->scenario.gravity_W;
    for (const ActionReading& load : now.loads)
      if (load.part == "humerus") sum += load.onPart.force_W;
    for (const ActionReading& hold : now.holds)
      if (hold.part == "humerus") sum += hold.onPart.force_W;
    for (const CouplingReading& coupling : now.couplings)
      if (coupling.a == "humerus") sum += coupling.onA.force_W;
      else if (coupling.b == "humerus") sum -= coupling.onA.force_W;
    return sum;
  }
  std::shared_ptr<const Model> model;
  State state;
  StepReport report;
  SceneReading now, atStart;
};

const Settled& settled(const std::string& name) {
  static std::map<std::string, Settled> known;
  return known.try_emplace(name, shipped(name)).first->second;
}

class RestingState : public testing::TestWithParam<const char*> {};

TEST_P(RestingState, loadsAreTheToneThatIsPlanned) {
  const Scene scene = shipped(GetParam());
  const std::vector<Load> planned = generate::cuffTone(scene.joint);
  ASSERT_EQ(scene.scenario.loads.size(), planned.size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_EQ(scene.scenario.loads[i].part, planned[i].part);
    EXPECT_LT((scene.scenario.loads[i].force_W - planned[i].force_W).norm(), 1e-9);
    EXPECT_LT((*scene.scenario.loads[i].point_W - *planned[i].point_W).norm(), 1e-9);
  }
  for (const Hold& hold : scene.scenario.holds) EXPECT_EQ(hold.stiffness, 0) << "nothing holds the arm's place";
}

TEST_P(RestingState, anatomyPressesOnAnatomy) {
  const Settled& rest = settled(GetParam());
  std::map<std::set<std::string>, double> pairs;
  double largest = 0;
  for (const ContactReading& c : rest.now.contacts) largest = std::max(largest, c.force);
  int pressing = 0;
  for (const ContactReading& c : rest.now.contacts)
    if (c.force >= std::max(1e-3, 1e-3 * largest)) ++pressing, pairs[{c.a, c.b}] += c.force;
  for (const auto& [pair, force] : pairs) std::printf("%s on %s %.2f N, ", pair.begin()->c_str(), pair.rbegin()->c_str(), force);
  std::printf("%d of %zu contacts press, fastest %.1e m/s\n", pressing, rest.now.contacts.size(), rest.state.v.cwiseAbs().maxCoeff());
  EXPECT_GE(pressing, 12);
  EXPECT_GE(pairs.size(), 5u);
  for (const auto& pair : {std::set<std::string>{"humerus", "scapula"}, {"humerus", "labrum"}, {"humerus", "biceps-tendon"}, {"humerus", "supraspinatus"}})
    EXPECT_TRUE(pairs.contains(pair)) << *pair.begin() << " " << *pair.rbegin();
  EXPECT_LT(rest.state.v.cwiseAbs().maxCoeff(), 1e-3);
}

TEST_P(RestingState, theJointsReactionBalancesTheLoadsInsideTheRim) {
  const Settled& rest = settled(GetParam());
  const Wrench reaction = rest.contacts({"scapula", "labrum"});
  const double size = reaction.force_W.norm();
  const Vec3 along = reaction.force_W / size;
  // Where its line meets the plane of the rim, along the rim's two diameters.
  const Part& scapula = rest.model->joint.parts[findPart(rest.model->joint, "scapula")];
  const auto mark = [&](const char* id) {
    return std::find_if(scapula.landmarks.begin(), scapula.landmarks.end(), [&](const Landmark& l) { return l.id == id; })->position_W;
  };
  const Vec3 up = mark("glenoid-superior") - mark("glenoid-inferior"), front = mark("glenoid-anterior") - mark("glenoid-posterior");
  const Vec3 middle = (mark("glenoid-superior") + mark("glenoid-inferior") + mark("glenoid-anterior") + mark("glenoid-posterior")) / 4;
  const Vec3 normal = front.cross(up).normalized();
  const Vec3 on = rest.head() + reaction.force_W.cross(reaction.torque_W) / (size * size);
  const Vec3 at = on + (middle - on).dot(normal) / along.dot(normal) * along - middle;
  const double high = at.dot(up) / (0.5 * up.squaredNorm()), ahead = at.dot(front) / (0.5 * front.squaredNorm());
  std::printf("reaction %.1f N, %.2f up and %.2f ahead of the rim's middle in its half-widths; the rest adds up to %.2f %% of it\n", size, high, ahead,
              100 * (reaction.force_W + rest.carried()).norm() / size);
  EXPECT_GT(size, 20);
  EXPECT_LT(size, 100);
  EXPECT_LT(high * high + ahead * ahead, 1);
  EXPECT_LT((reaction.force_W + rest.carried()).norm(), 0.01 * size);
  std::printf("head %.2f mm from its centre\n", 1e3 * rest.head().norm());
  EXPECT_LT(rest.head().norm(), 3e-3);
}

TEST_P(RestingState, theHeadGoesWhereALoadThatIsTakenAwayNoLongerPullsIt) {
  // The pull of one muscle is the sum of its loads on the bone and around it. Without it the head moves against that pull,
  // further without all of it than without half (what the subscapularis pulls goes straight into the socket: a hundredth of
  // a millimetre either way), the reaction is less, and all balances again.
  const Settled& all = settled(GetParam());
  for (const char* muscle : {"infraspinatus", "supraspinatus"}) {
    Vec3 pull = Vec3::Zero();
    double last = 0;
    for (const double share : {0.5, 0.0}) {
      Scene scene = shipped(GetParam());
      pull.setZero();
      for (std::size_t i = 0; i < scene.scenario.loads.size(); ++i) {
        // In front of the loads on a muscle stands that on its insertion.
        const bool insertion = i + 1 < scene.scenario.loads.size() && scene.scenario.loads[i].part == "humerus" && scene.scenario.loads[i + 1].part == muscle;
        if (!insertion && scene.scenario.loads[i].part != muscle) continue;
        pull += scene.scenario.loads[i].force_W;
        scene.scenario.loads[i].force_W *= share;
      }
      const Settled less(scene);
      const double moved = -(less.head() - all.head()).dot(pull.normalized());
      std::printf("%s %.0f %%: the head moves by %.3f mm against its pull, reaction %.1f N, balanced to %.2f %%\n", muscle, 100 * share, 1e3 * moved,
                  less.reaction().norm(), 100 * (less.reaction() + less.carried()).norm() / less.reaction().norm());
      EXPECT_GT(moved, last) << muscle;
      EXPECT_LT((less.reaction() + less.carried()).norm(), 0.01 * all.reaction().norm()) << muscle;
      EXPECT_GT((less.reaction() - all.reaction()).dot(pull), 0) << muscle;
      last = moved;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, RestingState, testing::Values("arthroscopy", "palpation"));

}  // namespace
}  // namespace glenoid
