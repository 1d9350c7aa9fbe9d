// SPDX-License-Identifier: GPL-3.0-or-later
// Stress and strain of tissue against closed forms: on any tetrahedra a uniform stress is exact (the patch test of Bazeley,
// Cheung, Irons and Zienkiewicz, 1965).
#include "simcore/reading/Tissue.h"

#include <gtest/gtest.h>

#include <random>

#include "simcore/mesh/TetTools.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.03, kYoung = 5e4, kPoisson = 0.4;  // m, Pa; those of "tissue"

/// A cube whose tetrahedra are all different, with the faces of the tetrahedra as its surface and a region for each side:
/// "x0" at low x, "x1" at high x, …
Joint patchJoint() {
  Joint joint;
  joint.id = joint.name = "patch";
  scenes::addMaterials(joint);
  auto mesh = std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), kSide * Vec3::Ones(), 3, 3, 3));
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Vec3& x : mesh->nodes)
    for (int axis = 0; axis < 3; ++axis)
      if (x[axis] > 1e-6 && x[axis] < kSide - 1e-6) x[axis] += 0.2 * kSide / 3 * uniform(random);  // sides stay flat
  Part cube;
  cube.id = cube.name = "cube";
  cube.number = 1;
  cube.kind = PartKind::Soft;
  cube.materials = {{"tissue", ""}};
  cube.volume = mesh;
  cube.cellSize = kSide / 3;
  cube.visual = cube.collision = std::make_shared<TriMesh>(boundaryOf(*mesh));
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      Vec3 low = -Vec3::Ones(), high = Vec3::Ones();
      low[axis] = side * kSide - 1e-6;
      high[axis] = side * kSide + 1e-6;
      cube.regions.push_back(scenes::regionIn(cube, std::string(1, "xyz"[axis]) + std::to_string(side), Box3(low, high)));
    }
  joint.parts = {cube};
  return joint;
}

Scenario patchScenario() {
  Scenario scenario;
  scenario.id = scenario.name = "patch";
  scenario.gravity_W.setZero();
  scenario.effects.contact = Wish::Off;
  scenario.dt = 0.1;
  return scenario;
}

/// A roller on each of three sides that meet: no rigid motion is left.
void addRollers(Scenario& scenario) {
  scenario.supports = {{"cube", "x0", {true, false, false}, 1e9}, {"cube", "y0", {false, true, false}, 1e9}, {"cube", "z0", {false, false, true}, 1e9}};
}

struct Rest {
  std::shared_ptr<const Model> model;
  State state;
};

Rest atRest(const Joint& joint, const Scenario& scenario, int steps = 150) {
  const auto model = compileModel(joint, scenario);
  EXPECT_TRUE(model.ok()) << toLogLine(model.error());
  Rest rest{*model, (*model)->start};
  Stepper stepper(rest.model, {});
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step({}, rest.state).taken);
  return rest;
}

/// Largest distance of an element's stress from `stress`, relative to the largest of those.
double stressError(const Rest& rest, const Mat3& stress) {
  double worst = 0;
  for (const ElementReading& element : readTissue(*rest.model, rest.state, 0)) worst = std::max(worst, (element.stress_W - stress).norm());
  return worst / stress.norm();
}

TEST(Tissue, aBarUnderDeadTractionHasForceOverAreaInEveryElement) {
  Joint joint = patchJoint();
  Scenario scenario = patchScenario();
  addRollers(scenario);
  // Consistent forces of a traction along x: a third of each triangle's at its corners.
  const double traction = 500;  // Pa: 1 % strain
  const Part& cube = joint.parts[0];
  for (const int t : trianglesOf(*findRegion(cube, "x1"))) {
    const auto& corner = cube.visual->triangles[t];
    const Vec3 a = cube.visual->vertices[corner[0]], b = cube.visual->vertices[corner[1]], c = cube.visual->vertices[corner[2]];
    for (const int v : corner)
      scenario.loads.push_back({"cube", traction / 6 * (b - a).cross(c - a), Vec3::Zero(), cube.visual->vertices[v]});
  }
  const Rest rest = atRest(joint, scenario);
  Mat3 stress = Mat3::Zero(), strain = Vec3(1, -kPoisson, -kPoisson).asDiagonal().toDenseMatrix() * traction / kYoung;
  stress(0, 0) = traction;
  // What the stress test of patches asks: round-off times the condition of stiff rollers on soft tissue.
  EXPECT_LT(stressError(rest, stress), 1e-8);
  for (const ElementReading& element : readTissue(*rest.model, rest.state, 0)) {
    EXPECT_LT((element.strain_W - strain).norm(), 1e-8 * strain.norm());
    EXPECT_NEAR(vonMises(element.stress_W), traction, 1e-8 * traction);
  }
}

TEST(Tissue, pressureOnAClosedSurfaceIsUniformAndMovesNothing) {
  Joint joint = patchJoint();
  Scenario scenario = patchScenario();
  const double pressure = 1000;
  for (const Region& region : joint.parts[0].regions) scenario.pressures.push_back({"cube", region.id, pressure});
  // Nothing else holds the cube: the closed surface's forces and moments are zero to the last digits, or it would be gone.
  const Rest rest = atRest(joint, scenario);
  // It shrinks by the factor s in each direction: 3K (s − 1) = −p s², since the pressure acts on what the area has become
  // and the law speaks of forces on the area at rest.
  const double threeK = kYoung / (1 - 2 * kPoisson);
  const double s = (-threeK + std::sqrt(threeK * threeK + 4 * pressure * threeK)) / (2 * pressure);
  EXPECT_LT(stressError(rest, -pressure * s * s * Mat3::Identity()), 1e-8);
  Vec3 centre = Vec3::Zero();
  const ObjectLayout& layout = rest.model->objects[0].layout;
  for (int axis = 0; axis < 3; ++axis) {  // sides stay flat and are s apart
    double low = 1, high = -1;
    for (int node = 0; node < layout.nodeCount; ++node) {
      low = std::min(low, rest.state.q[3 * node + axis]);
      high = std::max(high, rest.state.q[3 * node + axis]);
    }
    EXPECT_NEAR(high - low, s * kSide, 1e-9 * kSide);
    centre[axis] = 0.5 * (low + high);
  }
  EXPECT_LT((centre - 0.5 * kSide * Vec3::Ones()).norm(), 1e-3 * kSide);  // it shrinks about its centre of mass
  EXPECT_LT(rest.state.v.norm(), 1e-9);
}

TEST(Tissue, aPressedSideGivesThePressureTimesWhatItsAreaHasBecome) {
  Joint joint = patchJoint();
  Scenario scenario = patchScenario();
  addRollers(scenario);
  const double pressure = 1500;
  scenario.pressures = {{"cube", "x1", pressure}};
  const Rest rest = atRest(joint, scenario);
  // Axial stress on the area at rest: σ = −p (1 − ν ε)², ε = σ/E.
  double sigma = -pressure;
  for (int i = 0; i < 100; ++i) sigma = -pressure * std::pow(1 - kPoisson * sigma / kYoung, 2);
  Mat3 stress = Mat3::Zero();
  stress(0, 0) = sigma;
  EXPECT_LT(stressError(rest, stress), 1e-8);
  EXPECT_GT(std::abs(sigma) / pressure, 1.02);  // the follower is felt
}

TEST(Tissue, stressTurnsWithThePart) {
  // A stretch along the part's own x, then a turn of the whole: the tensors are those of the turned axes.
  const auto model = compileModel(patchJoint(), patchScenario()).value();
  State state = model->start;
  const Mat3 R = Eigen::AngleAxisd(1.3, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  Mat3 stretch = Mat3::Identity();
  stretch(0, 0) = 1.05;
  const Mat3 F = R * stretch;
  for (int node = 0; node < model->objects[0].layout.nodeCount; ++node)
    state.q.segment<3>(3 * node) = F * model->objects[0].volume->nodes[node];
  const Mat3 strain = R * (stretch - Mat3::Identity()) * R.transpose();
  const double mu = kYoung / 2 / (1 + kPoisson), lambda = kYoung * kPoisson / (1 + kPoisson) / (1 - 2 * kPoisson);
  const Mat3 stress = 2 * mu * strain + lambda * strain.trace() * Mat3::Identity();
  for (const ElementReading& element : readTissue(*model, state, 0)) {
    EXPECT_LT((element.strain_W - strain).norm(), 1e-12);
    EXPECT_LT((element.stress_W - stress).norm(), 1e-11 * stress.norm());
  }
}

TEST(Tissue, isReadByTheLawThatTheStepsHad) {
  // Twice as long and held at its sides: P = h' (2µ + λ) h + E (s − 1 − h h') with h = 0.2 + c ln(1 + (s − 1.2)/c), c = 0.45; and
  // (2µ + λ)(s − 1) by the linear law.
  Scenario scenario = patchScenario();
  scenario.profile = Profile::Paper;
  const auto model = compileModel(patchJoint(), scenario).value();
  State state = model->start;
  const Mat3 F = Vec3(2, 1, 1).asDiagonal();
  for (int node = 0; node < model->objects[0].layout.nodeCount; ++node)
    state.q.segment<3>(3 * node) = F * model->objects[0].volume->nodes[node];
  const double mu = kYoung / 2 / (1 + kPoisson), lambda = kYoung * kPoisson / (1 + kPoisson) / (1 - 2 * kPoisson);
  const double c = 0.45, h = 0.2 + c * std::log(1 + 0.8 / c), slope = c / (c + 0.8);
  const double linear = 2 * mu + lambda, stretch = slope * linear * h + kYoung * (1 - h * slope);
  EXPECT_LT(stretch, 0.95 * linear);
  for (const auto& [law, wanted] : {std::pair{std::optional<bool>(), linear}, {std::optional(false), linear}, {std::optional(true), stretch}})
    for (const ElementReading& element : readTissue(*model, state, 0, law)) EXPECT_NEAR(element.stress_W(0, 0), wanted, 1e-9 * linear);
  EXPECT_NE(*tissueVtu(*model, state, true), *tissueVtu(*model, state, false));
}

TEST(Tissue, theGridHoldsEveryNodeAndCell) {
  const auto model = compileModel(patchJoint(), patchScenario()).value();
  const auto vtu = tissueVtu(*model, model->start);
  ASSERT_TRUE(vtu.ok());
  const TetMesh& mesh = *model->objects[0].volume;
  EXPECT_NE(vtu->find("NumberOfPoints=\"" + std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.tets.size()) + "\""),
            std::string::npos);
  for (const char* name : {"displacement", "velocity", "strain", "stress", "vonMises", "part"})
    EXPECT_NE(vtu->find(std::string("Name=\"") + name + "\""), std::string::npos) << name;
  Joint bones;
  bones.id = bones.name = "bones";
  scenes::addMaterials(bones);
  bones.parts = {scenes::boxPart("bone", 1, PartKind::Rigid, Vec3::Zero(), Vec3::Ones())};
  Scenario scenario = patchScenario();
  const auto rigid = compileModel(bones, scenario).value();
  const auto none = tissueVtu(*rigid, rigid->start);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().fault, Fault::Unusable);
}

}  // namespace
}  // namespace glenoid
