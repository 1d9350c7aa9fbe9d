// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ScenarioFile.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "simcore/scene/SceneScale.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

namespace glenoid {
namespace {

Scenario sample() {
  Scenario scenario;
  scenario.id = "arthroscopy";
  scenario.name = "Arthroscopy";
  scenario.description = "Two tools\nthrough portals";
  scenario.joint = "../joints/s.joint";
  scenario.dt = 0.004;
  scenario.gravity_W = {0.1, -9.8, 1.0 / 3.0};
  scenario.profile = Profile::Reference;
  scenario.contactDistance = 0.002;
  scenario.recoverySpeedMax = 0.2;
  scenario.holds = {{"humerus", 0, 40, 0.02, {true, false, true}, {false, true, true}}};
  scenario.loadRise = 0.25;
  scenario.elements = Elements::Cells;
  scenario.loads = {{"humerus", Vec3(1, -20, 3), Vec3(0.1, 0, -0.2)}, {"humerus", Vec3(0, 1, 0), Vec3::Zero(), Vec3(0.1, 0, 1.0 / 3.0)}};
  scenario.pressures = {{"cuff", "insertion", 1234.5}};
  scenario.supports = {{"cuff", "insertion", {false, true, false}, 3e7, 0.03}};
  Tool probe;
  probe.id = "probe";
  probe.name = "Probe";
  probe.home = {{0.1, 0.2, 0.3}, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
  probe.perforates = {"cuff"};
  Tool finger = probe;
  finger.id = "finger";
  finger.kind = ToolKind::Finger;
  finger.length = 0.05;
  finger.radius = 0.008;
  finger.mass = 0.1;
  finger.stiffness = 900;
  finger.angularStiffness = 3;
  finger.dampingRatio = 0.5;
  finger.forceMax = 20;
  finger.friction = 0.35;
  Tool ball = finger, bar = finger;
  ball.id = "ball";
  ball.kind = ToolKind::Ball;
  bar.id = "bar";
  bar.kind = ToolKind::Bar;
  bar.link = "finger";
  bar.linkStiffness = 1500;
  scenario.tools = {probe, finger, ball, bar};
  scenario.effects.friction = Wish::Off;
  scenario.effects.haptics = Wish::On;
  scenario.cameras = {{"front", "Front", {0.4, 0, 0}, {0, 0.1, 0}, {0, 0, 1}, 0.5}};
  scenario.input = "builtin:arthroscopy";
  scenario.seed = 4000000000u;
  return scenario;
}

void expectSame(const Scenario& a, const Scenario& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.joint, b.joint);
  EXPECT_EQ(a.dt, b.dt);
  EXPECT_EQ(a.gravity_W, b.gravity_W);
  EXPECT_EQ(a.profile, b.profile);
  EXPECT_EQ(a.contactDistance, b.contactDistance);
  EXPECT_EQ(a.recoverySpeedMax, b.recoverySpeedMax);
  EXPECT_EQ(a.fixedParts, b.fixedParts);
  EXPECT_EQ(a.holds, b.holds);
  EXPECT_EQ(a.loads, b.loads);
  EXPECT_EQ(a.loadRise, b.loadRise);
  EXPECT_EQ(a.elements, b.elements);
  EXPECT_EQ(a.pressures, b.pressures);
  EXPECT_EQ(a.supports, b.supports);
  EXPECT_EQ(a.motions, b.motions);
  EXPECT_EQ(a.effects, b.effects);
  EXPECT_EQ(a.input, b.input);
  EXPECT_EQ(a.seed, b.seed);
  ASSERT_EQ(a.tools.size(), b.tools.size());
  for (std::size_t i = 0; i < a.tools.size(); ++i) {
    const Tool &p = a.tools[i], &q = b.tools[i];
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.link, q.link);
    EXPECT_EQ(p.linkStiffness, q.linkStiffness);
    EXPECT_EQ(
        (std::array{p.length, p.radius, p.mass, p.stiffness, p.angularStiffness, p.dampingRatio, p.forceMax,
                    p.friction}),
        (std::array{q.length, q.radius, q.mass, q.stiffness, q.angularStiffness, q.dampingRatio,
                    q.forceMax, q.friction}));
    EXPECT_EQ(p.home.p_WB, q.home.p_WB);
    EXPECT_EQ(p.home.q_WB.coeffs(), q.home.q_WB.coeffs());
    EXPECT_EQ(p.perforates, q.perforates);
  }
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].id, b.cameras[i].id);
    EXPECT_EQ(a.cameras[i].name, b.cameras[i].name);
    EXPECT_EQ(a.cameras[i].eye_W, b.cameras[i].eye_W);
    EXPECT_EQ(a.cameras[i].target_W, b.cameras[i].target_W);
    EXPECT_EQ(a.cameras[i].up_W, b.cameras[i].up_W);
    EXPECT_EQ(a.cameras[i].fieldOfView, b.cameras[i].fieldOfView);
  }
}

const std::string kMinimal = R"({"schemaVersion": 1, "id": "a", "name": "A", "joint": "x.joint")";

Error faultOf(const std::string& path) {
  const auto loaded = loadScenario(path);
  EXPECT_FALSE(loaded.ok()) << path;
  return loaded.ok() ? Error{} : loaded.error();
}

TEST(ScenarioFile, lengthsThatAreLeftOpenStayOpenAndTheFirstFormMeantTheShouldersOwn) {
  const TemporaryFolder folder;
  const std::string path = folder.put("a.scenario.json", kMinimal + "}");
  const Scenario older = loadScenario(path).value();
  EXPECT_EQ(older.contactDistance, 0.0015);
  EXPECT_EQ(older.recoverySpeedMax, 0.1);
  folder.put("a.scenario.json", R"({"schemaVersion": 2, "id": "a", "name": "A", "joint": "x.joint"})");
  const Scenario open = loadScenario(path).value();
  EXPECT_EQ(open.contactDistance, 0);
  EXPECT_EQ(open.recoverySpeedMax, 0);
  saveScenario(open, path).value();
  EXPECT_EQ(folder.get("a.scenario.json").find("contactDistance"), std::string::npos);
  EXPECT_EQ(loadScenario(path).value().contactDistance, 0);
  Joint joint;
  EXPECT_EQ(scaled(joint, open).contactDistance, 0.0015) << "nothing has a size";
  EXPECT_NEAR(scaled(joint, open).recoverySpeedMax, 0.1, 1e-15);
  EXPECT_EQ(scaled(joint, older).contactDistance, 0.0015);
}

TEST(ScenarioFile, whatIsSavedComesBack) {
  const TemporaryFolder folder;
  Scenario scenario = sample();
  scenario.fixedParts = {"humerus"};
  scenario.motions = {{"humerus",
                       {0.1, 0, 0.2},
                       {{0.5, {0, 0.1, 0}, Quat::Identity()}, {1.5, {0, 0.2, 0}, Quat(Eigen::AngleAxisd(0.4, Vec3(3, 1, 2).normalized()))}}}};
  ASSERT_TRUE(saveScenario(scenario, folder.path("a.scenario.json")).ok());
  const auto back = loadScenario(folder.path("a.scenario.json"));
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  expectSame(*back, scenario);
}

TEST(ScenarioFile, whatIsNotSaidKeepsItsDefault) {
  const TemporaryFolder folder;
  const auto loaded = loadScenario(folder.put("a.scenario.json", kMinimal + "}"));
  ASSERT_TRUE(loaded.ok()) << toLogLine(loaded.error());
  Scenario expected;
  expected.id = "a";
  expected.name = "A";
  expected.joint = "x.joint";
  expectSame(*loaded, expected);
}

TEST(ScenarioFile, theFirstSaveOverAnOlderSchemaKeepsIt) {
  const TemporaryFolder folder;
  const std::string older = kMinimal + R"(, "holds": [{"part": "p"}], "loads": [{"part": "p", "force": [0, -1, 0]}]})";
  const std::string path = folder.put("a.scenario.json", older);
  auto loaded = loadScenario(path);
  ASSERT_TRUE(loaded.ok()) << toLogLine(loaded.error());
  EXPECT_EQ(loaded->holds, (std::vector<Hold>{Hold{"p"}}));
  EXPECT_EQ(loaded->loads, (std::vector<Load>{Load{"p", Vec3(0, -1, 0)}}));  // at the origin, as ever
  ASSERT_TRUE(saveScenario(*loaded, path).ok());
  EXPECT_NE(folder.get("a.scenario.json").find("\"schemaVersion\": 2"), std::string::npos);
  EXPECT_EQ(folder.get("a.scenario.v1.json"), older);
  expectSame(*loadScenario(path), *loaded);
  loaded->dt = 0.001;
  ASSERT_TRUE(saveScenario(*loaded, path).ok());
  EXPECT_EQ(folder.get("a.scenario.v1.json"), older) << "only the first save does";
}

TEST(ScenarioFile, actionsThatMakeNoSenseAreRefusedWithTheirPlace) {
  const TemporaryFolder folder;
  struct Slip {
    const char* members;
    Fault fault;
    const char* pointer;
  };
  for (const Slip& slip : {Slip{R"("holds": [{"part": "p", "stiffness": 0, "angularStiffness": 0}])", Fault::Unusable, "/holds/0"},
                           Slip{R"("holds": [{"part": "p", "axes": []}])", Fault::SchemaMismatch, "/holds/0/axes"},
                           Slip{R"("holds": [{"part": "p", "axes": ["w"]}])", Fault::SchemaMismatch, "/holds/0/axes/0"},
                           Slip{R"("supports": [{"part": "p", "region": "r", "stiffnessPerArea": 0}])", Fault::OutOfRange, "/supports/0/stiffnessPerArea"},
                           Slip{R"("pressures": [{"part": "p", "pressure": 1}])", Fault::SchemaMismatch, "/pressures/0"},
                           Slip{R"("motions": [{"part": "p", "keys": []}])", Fault::SchemaMismatch, "/motions/0/keys"},
                           Slip{R"("motions": [{"part": "p", "keys": [{"time": 1}, {"time": 1}]}])", Fault::Unusable, "/motions/0/keys/1"},
                           Slip{R"("motions": [{"part": "p", "keys": [{"time": 1, "rotation": [0, 0, 0, 2]}]}])", Fault::OutOfRange,
                                "/motions/0/keys/0/rotation"},
                           Slip{R"("motions": [{"part": "p", "keys": [{"time": 1}]}, {"part": "p", "keys": [{"time": 1}]}])", Fault::DuplicateId,
                                "/motions/1/part"}}) {
    const Error error = faultOf(folder.put("a.scenario.json", kMinimal + ", " + slip.members + "}"));
    EXPECT_EQ(error.fault, slip.fault) << slip.members << toLogLine(error);
    EXPECT_EQ(error.place.pointer, slip.pointer) << slip.members;
  }
}

TEST(ScenarioFile, aScenarioStandsOnAnother) {
  const TemporaryFolder folder;
  folder.put("base/base.scenario.json", kMinimal + R"(, "dt": 0.01, "input": "in.recording", "seed": 3,
    "effects": {"contact": "off", "friction": "on"}, "fixedParts": ["p", "q"]})");
  folder.put("middle.scenario.json", R"({"schemaVersion": 1, "extends": "base/base.scenario.json", "id": "m",
    "effects": {"friction": "off"}, "fixedParts": ["r"]})");
  const auto loaded = loadScenario(folder.put(
      "top/top.scenario.json", R"({"schemaVersion": 1, "extends": "../middle.scenario.json", "dt": 0.002})"));
  ASSERT_TRUE(loaded.ok()) << toLogLine(loaded.error());
  EXPECT_EQ(loaded->id, "m");
  EXPECT_EQ(loaded->name, "A");
  EXPECT_EQ(loaded->dt, 0.002);
  EXPECT_EQ(loaded->seed, 3u);
  EXPECT_EQ(loaded->effects.contact, Wish::Off);
  EXPECT_EQ(loaded->effects.friction, Wish::Off);
  EXPECT_EQ(loaded->fixedParts, std::vector<std::string>{"r"});
  EXPECT_EQ(loaded->joint, "../base/x.joint");  // still the joint beside base.scenario.json
  EXPECT_EQ(loaded->input, "../base/in.recording");
}

TEST(ScenarioFile, cyclesAndDanglingReferencesAreNamed) {
  const TemporaryFolder folder;
  const auto extending = [&](const std::string& name, const std::string& other) {
    return folder.put(name, std::string(R"({"schemaVersion": 1, "extends": ")").append(other).append("\"}"));
  };
  const Error self = faultOf(extending("self.scenario.json", "./self.scenario.json"));
  EXPECT_EQ(self.fault, Fault::CyclicReference);
  EXPECT_EQ(self.place.pointer, "/extends");
  const std::string a = extending("a.scenario.json", "b.scenario.json");
  const std::string b = extending("b.scenario.json", "sub/../a.scenario.json");
  std::filesystem::create_directory(folder.path("sub"));
  const Error cycle = faultOf(a);
  EXPECT_EQ(cycle.fault, Fault::CyclicReference);
  EXPECT_EQ(cycle.place.file, b);
  EXPECT_EQ(cycle.arguments, Arguments{"sub/../a.scenario.json"});
  const Error dangling = faultOf(extending("d.scenario.json", "gone.scenario.json"));
  EXPECT_EQ(dangling.fault, Fault::FileMissing);
  EXPECT_EQ(dangling.place.file, folder.path("gone.scenario.json"));
  for (const char* bad : {"builtin:arthroscopy", "/etc/passwd", ""})
    EXPECT_EQ(faultOf(extending("e.scenario.json", bad)).fault, Fault::BadReference) << bad;
  for (int i = 0; i < 40; ++i) extending(std::to_string(i), std::to_string(i + 1));
  EXPECT_EQ(faultOf(folder.path("0")).fault, Fault::TooDeep);
  EXPECT_EQ(faultOf(folder.put("f", R"({"schemaVersion": 1, "extends": 3})")).fault, Fault::SchemaMismatch);
}

TEST(ScenarioFile, aToolIsCarriedByOneThatAHandHolds) {
  Scenario scenario = sample();
  scenario.tools[3].link = "hand";
  EXPECT_EQ(checkScenario(scenario, "a.json").error().fault, Fault::UnknownId);
  scenario.tools[3].link = "finger";
  EXPECT_TRUE(checkScenario(scenario, "a.json").ok());
  scenario.tools[1].link = "probe";
  const auto chained = checkScenario(scenario, "a.json");
  ASSERT_FALSE(chained.ok());
  EXPECT_EQ(chained.error().fault, Fault::BadReference);
  EXPECT_EQ(chained.error().place.pointer, "/tools/3/link");
}

TEST(ScenarioFile, aFaultIsNamedInTheFileThatHoldsIt) {
  const TemporaryFolder folder;
  const std::string base = folder.put("base.scenario.json", kMinimal + R"(, "dt": 0.5})");
  const std::string top =
      folder.put("top.scenario.json", R"({"schemaVersion": 1, "extends": "base.scenario.json"})");
  EXPECT_EQ(faultOf(top).place.file, base);
  folder.put("base.scenario.json", kMinimal + "}");
  folder.put("top.scenario.json", R"({"schemaVersion": 1, "extends": "base.scenario.json", "dt": -1})");
  EXPECT_EQ(faultOf(top).place.file, top);
  EXPECT_EQ(faultOf(top).place.pointer, "/dt");
  folder.put("base.scenario.json", R"({"schemaVersion": 9})");
  EXPECT_EQ(faultOf(top).fault, Fault::NewerSchema);
  EXPECT_EQ(faultOf(top).place.file, base);
}

TEST(ScenarioFile, slipsAreNamedWithTheirPlace) {
  struct Slip {
    const char* members;
    Fault fault;
    const char* pointer;
  };
  const std::string tool = R"({"id": "p", "kind": "probe", "home": {"position": [0, 0, 0]}})";
  const std::string two = std::string(R"(, "tools": [)").append(tool).append(", ").append(tool).append("]");
  for (
      const Slip& slip :
      {Slip{R"(, "dt": 0)", Fault::OutOfRange, "/dt"}, Slip{R"(, "dt": 0.2)", Fault::OutOfRange, "/dt"},
       Slip{R"(, "dt": Infinity)", Fault::NotFinite, "/dt"},
       Slip{R"(, "gravity": [0, 1])", Fault::SchemaMismatch, "/gravity"},
       Slip{R"(, "profile": "fast")", Fault::SchemaMismatch, "/profile"},
       Slip{R"(, "effects": {"magic": "on"})", Fault::SchemaMismatch, "/effects"},
       Slip{R"(, "seed": -1)", Fault::OutOfRange, "/seed"},
       Slip{R"(, "seed": 4294967296)", Fault::OutOfRange, "/seed"},
       Slip{two.c_str(), Fault::DuplicateId, "/tools/1/id"},
       Slip{R"(, "holds": [{"part": "a"}, {"part": "a"}])", Fault::DuplicateId, "/holds/1/part"},
       Slip{
           R"(, "tools": [{"id": "p", "kind": "probe", "home": {"position": [0, 0, 0], "rotation": [0, 0, 0, 0]}}])",
           Fault::OutOfRange, "/tools/0/home/rotation"},
       Slip{R"(, "tools": [{"id": "p", "kind": "probe", "mass": 0, "home": {"position": [0, 0, 0]}}])",
            Fault::OutOfRange, "/tools/0/mass"},
       Slip{R"(, "cameras": [{"id": "c", "eye": [0, 1, 0], "target": [0, 0, 0], "up": [0, 1, 0]}])",
            Fault::Unusable, "/cameras/0"}}) {
    const TemporaryFolder folder;
    const std::string path = folder.put("a.scenario.json", kMinimal + slip.members + "}");
    const Error error = faultOf(path);
    EXPECT_EQ(error.fault, slip.fault) << slip.members << toLogLine(error);
    EXPECT_EQ(error.place.pointer, slip.pointer) << slip.members;
    EXPECT_EQ(error.place.file, path);
  }
}

TEST(ScenarioFile, roundedQuaternionsAreMadeUnit) {
  const TemporaryFolder folder;
  const auto loaded = loadScenario(folder.put("a", kMinimal + R"(, "tools": [{"id": "p", "kind": "probe",
    "home": {"position": [0, 0, 0], "rotation": [0.7071068, 0, 0, 0.7071068]}}]})"));
  ASSERT_TRUE(loaded.ok());
  EXPECT_NEAR(loaded->tools[0].home.q_WB.norm(), 1, 1e-15);
}

TEST(ScenarioFile, referencesIntoTheJoint) {
  const Joint joint = sampleJoint();
  const Place place{"a.scenario.json", "", "", {}};
  EXPECT_TRUE(checkScenario(sample(), joint, place).ok());
  struct Slip {
    std::function<void(Scenario&)> change;
    Fault fault;
    const char* pointer;
    Arguments arguments;
  };
  const std::vector<Slip> slips = {
      {[](Scenario& s) {
         s.fixedParts = {"cuff", "ulna"};
       },
       Fault::UnknownId,
       "/fixedParts/1",
       {"ulna", "part"}},
      {[](Scenario& s) { s.holds[0].part = "ulna"; }, Fault::UnknownId, "/holds/0/part", {"ulna", "part"}},
      {[](Scenario& s) { s.loads[0].part = "ulna"; }, Fault::UnknownId, "/loads/0/part", {"ulna", "part"}},
      {[](Scenario& s) { s.loads[0].part = "cuff"; }, Fault::BadReference, "/loads/0/part", {"cuff"}},
      {[](Scenario& s) { s.holds[0].part = "cuff"; }, Fault::BadReference, "/holds/0/part", {"cuff"}},
      {[](Scenario& s) { s.fixedParts = {"humerus"}; }, Fault::BadReference, "/holds/0/part", {"humerus"}},
      {[](Scenario& s) { s.pressures[0].region = "belly"; }, Fault::UnknownId, "/pressures/0/region", {"belly", "region"}},
      {[](Scenario& s) { s.supports[0].part = "ulna"; }, Fault::UnknownId, "/supports/0/part", {"ulna", "part"}},
      {[](Scenario& s) { s.fixedParts = {"cuff"}; }, Fault::BadReference, "/pressures/0/part", {"cuff"}},
      {[](Scenario& s) { s.motions = {{"cuff", Vec3::Zero(), {{0, Vec3::Zero(), Quat::Identity()}}}}; },
       Fault::Unusable,
       "/motions/0/part",
       {"a motion of a part that is not among fixedParts"}},
      {[](Scenario& s) { s.tools[1].perforates = {"skin"}; },
       Fault::UnknownId,
       "/tools/1/perforates/0",
       {"skin", "part"}}};
  for (const Slip& slip : slips) {
    Scenario scenario = sample();
    slip.change(scenario);
    const auto checked = checkScenario(scenario, joint, place);
    ASSERT_FALSE(checked.ok()) << slip.pointer;
    EXPECT_EQ(checked.error().fault, slip.fault) << slip.pointer;
    EXPECT_EQ(checked.error().place.file, "a.scenario.json");
    EXPECT_EQ(checked.error().place.pointer, slip.pointer);
    EXPECT_EQ(checked.error().arguments, slip.arguments);
  }
}

TEST(ScenarioFile, savingRefusesWhatCouldNotBeLoaded) {
  const TemporaryFolder folder;
  const std::string path = folder.put("a.scenario.json", "old");
  Scenario scenario = sample();
  scenario.gravity_W.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(saveScenario(scenario, path).error().fault, Fault::NotFinite);
  scenario = sample();
  scenario.tools[1].id = "probe";
  EXPECT_EQ(saveScenario(scenario, path).error().fault, Fault::DuplicateId);
  EXPECT_EQ(folder.get("a.scenario.json"), "old");
}

}  // namespace
}  // namespace glenoid
