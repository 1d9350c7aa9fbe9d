// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown on surfaces, against closed forms on bodies whose grids do not follow them: every face cuts through cells.
#include "simcore/reading/SurfaceField.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "simcore/reading/ContactSpread.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr double kYoung = 5e4, kPoisson = 0.4;  // Pa; those of "tissue"
const Elements kKinds[] = {Elements::Tetrahedra, Elements::Cells};
const char* nameOf(Elements kind) { return kind == Elements::Cells ? "cells" : "tetrahedra"; }

/// A bar along x from the origin, in a grid that sticks out of it by shares of a cell, with a region for each side: "x0" at low x …
Joint barJoint(const Vec3& size, double cell, Elements kind, int facets = 24) {
  Joint joint;
  joint.id = joint.name = "bar";
  scenes::addMaterials(joint);
  Part bar = scenes::boxPart("bar", 1, PartKind::Soft, Vec3::Zero(), size);
  bar.visual = bar.collision = std::make_shared<TriMesh>(scenes::boxSurface(Vec3::Zero(), size, facets));
  const Vec3 low = -cell * Vec3(0.37, 0.61, 0.43);
  const Eigen::Vector3i n = ((size - low) / cell).array().ceil().cast<int>();
  bar.volume = std::make_shared<TetMesh>(scenes::boxVolume(low, low + cell * n.cast<double>(), n.x(), n.y(), n.z()));
  bar.cellSize = cell;
  bar.elements = kind;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      Vec3 from = -Vec3::Ones(), to = Vec3::Ones();
      from[axis] = side * size[axis] - 1e-6;
      to[axis] = side * size[axis] + 1e-6;
      bar.regions.push_back(scenes::regionIn(bar, std::string(1, "xyz"[axis]) + std::to_string(side), Box3(from, to)));
    }
  joint.parts = {bar};
  return joint;
}

Scenario quiet() {
  Scenario scenario;
  scenario.id = scenario.name = "bar";
  scenario.gravity_W.setZero();
  scenario.effects.contact = Wish::Off;
  scenario.dt = 0.1;
  return scenario;
}

struct Rest {
  std::shared_ptr<const Model> model;
  State state;
  SurfaceField field;
  std::vector<float> of(Quantity quantity, bool stretchLaw = true) const { return field.read(quantity, state, {}, stretchLaw)[0]; }
};

Rest atRest(const Joint& joint, const Scenario& scenario, int steps = 150) {
  const auto model = compileModel(joint, scenario);
  EXPECT_TRUE(model.ok()) << toLogLine(model.error());
  EXPECT_EQ((*model)->objects[0].cells, joint.parts[0].elements == Elements::Cells);
  Rest rest{*model, (*model)->start, SurfaceField(*model)};
  Stepper stepper(rest.model, {});
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step({}, rest.state).taken);
  return rest;
}

/// Largest distance of a value from `wanted` over that, among the vertices of the part that lie in a box.
double worst(const Rest& rest, const std::vector<float>& values, double wanted, const Box3& box = {Vec3(-1, -1, -1), Vec3(1, 1, 1)}) {
  double most = 0;
  int seen = 0;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (box.contains(rest.model->joint.parts[0].visual->vertices[v])) most = std::max(most, std::abs(values[v] - wanted) / std::abs(wanted)), ++seen;
  EXPECT_GT(seen, 50);
  return most;
}

/// A traction along x on both ends, which keeps its direction and its force: a third of each triangle's at its corners. Nothing
/// else holds the bar: a support on a face inside cells would bear stress of its own.
void pullEnds(const Joint& joint, double traction, Scenario& scenario) {
  const Part& bar = joint.parts[0];
  for (const char* end : {"x0", "x1"})
    for (const int t : trianglesOf(*findRegion(bar, end))) {
      const auto& corner = bar.visual->triangles[t];
      const Vec3 a = bar.visual->vertices[corner[0]], b = bar.visual->vertices[corner[1]], c = bar.visual->vertices[corner[2]];
      for (const int v : corner) scenario.loads.push_back({"bar", traction / 6 * (b - a).cross(c - a), Vec3::Zero(), bar.visual->vertices[v]});
    }
}

/// All of the bar but what is near its ends, where points carry the load: free sides and their edges.
const Box3 kBetweenEnds(Vec3(0.01, -1, -1), Vec3(0.03, 1, 1));

TEST(SurfaceField, aBarUnderDeadLoadHasForceOverAreaOnItsFreeSurfaces) {
  for (const Elements kind : kKinds) {
    const Joint joint = barJoint({0.04, 0.012, 0.01}, 0.0043, kind);
    Scenario scenario = quiet();
    const double traction = 500;  // 1 % strain
    pullEnds(joint, traction, scenario);
    const Rest rest = atRest(joint, scenario);
    const double stress = worst(rest, rest.of(Quantity::Stress), traction, kBetweenEnds),
                 strain = worst(rest, rest.of(Quantity::Strain), traction / kYoung, kBetweenEnds),
                 pressure = worst(rest, rest.of(Quantity::Pressure), -traction / 3, kBetweenEnds);
    std::printf("bar of cut %s: von Mises off by %.1e of F/A, strain by %.1e, pressure by %.1e\n", nameOf(kind), stress, strain, pressure);
    // Ends in cells load their nodes as tetrahedra would: what that leaves of sideways stress dies out along the bar.
    for (const double off : {stress, strain}) EXPECT_LT(off, kind == Elements::Cells ? 0.02 : 0.005) << nameOf(kind);
    EXPECT_LT(pressure, kind == Elements::Cells ? 0.08 : 0.005) << nameOf(kind);
  }
}

TEST(SurfaceField, theStretchLawIsReadWhereTheStepHasIt) {
  for (const Elements kind : kKinds) {
    const Joint joint = barJoint({0.04, 0.012, 0.01}, 0.0043, kind);
    Scenario scenario = quiet();
    scenario.loadRise = 2;
    const double traction = 0.8 * kYoung;  // P = E (s − 1) at a stretch of 1.8
    pullEnds(joint, traction, scenario);
    const Rest rest = atRest(joint, scenario, 250);
    const double law = worst(rest, rest.of(Quantity::Stress), traction, kBetweenEnds),
                 linear = worst(rest, rest.of(Quantity::Stress, false), traction, kBetweenEnds);
    std::printf("bar of cut %s at a stretch of 1.8: off by %.1e of F/A, read with the linear law by %.2f\n", nameOf(kind), law, linear);
    EXPECT_LT(law, 0.02) << nameOf(kind);
    EXPECT_GT(linear, 4 * law) << nameOf(kind);
  }
}

TEST(SurfaceField, aBentCantileverHasMyOverIAtItsOuterFibre) {
  for (const Elements kind : kKinds) {
    const double length = 0.06, side = 0.006, load = 2e-4;
    const Joint joint = barJoint({length, side, side}, kind == Elements::Cells ? 0.0023 : 0.0011, kind);
    Scenario scenario = quiet();
    scenario.supports = {{"bar", "x0", {true, true, true}, 1e8}};
    scenario.loads = {{"bar", Vec3(0, -load, 0), Vec3::Zero(), Vec3(length - 1e-4, side / 2, side / 2)}};
    const Rest rest = atRest(joint, scenario, 60);
    const std::vector<float> stress = rest.of(Quantity::Stress), strain = rest.of(Quantity::Strain);
    const double inertia = std::pow(side, 4) / 12;
    double off = 0, offStrain = 0;
    int seen = 0;
    for (std::size_t v = 0; v < stress.size(); ++v) {
      const Vec3 at = joint.parts[0].visual->vertices[v];
      if (at.x() < 0.25 * length || at.x() > 0.7 * length || std::abs(std::abs(at.y() - side / 2) - side / 2) > 1e-6) continue;
      const double wanted = load * (length - at.x()) * side / 2 / inertia;
      off = std::max(off, std::abs(stress[v] / wanted - 1));
      if (at.y() > side / 2) offStrain = std::max(offStrain, std::abs(strain[v] * kYoung / wanted - 1));  // the pulled side
      ++seen;
    }
    std::printf("cantilever of cut %s: |σ| at outer fibres off by at most %.3f of M y/I, strain by %.3f (%d places)\n", nameOf(kind), off, offStrain, seen);
    EXPECT_GT(seen, 50);
    EXPECT_LT(off, kind == Elements::Cells ? 0.06 : 0.25) << nameOf(kind);
    EXPECT_LT(offStrain, kind == Elements::Cells ? 0.06 : 0.25) << nameOf(kind);
  }
}

TEST(SurfaceField, aTurnedAndSqueezedBlockIsReadExactly) {
  for (const Elements kind : kKinds) {
    const Joint joint = barJoint({0.02, 0.015, 0.012}, 0.0039, kind);
    Rest rest = atRest(joint, quiet(), 0);
    const double s = 0.9;
    const Mat3 R = Eigen::AngleAxisd(2.0, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    for (int node = 0; node < rest.model->objects[0].layout.nodeCount; ++node)
      rest.state.q.segment<3>(3 * node) = s * R * rest.model->objects[0].volume->nodes[node];
    EXPECT_LT(worst(rest, rest.of(Quantity::Pressure), kYoung / (1 - 2 * kPoisson) * (1 - s)), 1e-5) << nameOf(kind);
    EXPECT_LT(worst(rest, rest.of(Quantity::Strain), s - 1), 1e-5) << nameOf(kind);
    for (const float stress : rest.of(Quantity::Stress)) EXPECT_LT(stress, 1e-4 * kYoung) << nameOf(kind);
  }
}

TEST(SurfaceField, fluidAroundABlockIsItsPressureOnEverySide) {
  for (const Elements kind : kKinds) {
    const Joint joint = barJoint({0.02, 0.018, 0.016}, 0.0021, kind);
    Scenario scenario = quiet();
    const double pressure = 300;
    for (const Region& region : joint.parts[0].regions) scenario.pressures.push_back({"bar", region.id, pressure});
    const Rest rest = atRest(joint, scenario);
    // The law speaks of force on the area at rest, of which s² is left: 3K (s − 1) = −p s².
    const double threeK = kYoung / (1 - 2 * kPoisson), s = (-threeK + std::sqrt(threeK * threeK + 4 * pressure * threeK)) / (2 * pressure);
    double side = 0;
    for (int axis = 0; axis < 3; ++axis) {  // more than a cell from the block's edges, through which no load is exact
      Vec3 low = Vec3::Constant(0.0045), high = Vec3(0.0155, 0.0135, 0.0115);
      low[axis] = -1, high[axis] = 1;
      side = std::max(side, worst(rest, rest.of(Quantity::Pressure), pressure * s * s, Box3(low, high)));
    }
    const double all = worst(rest, rest.of(Quantity::Pressure), pressure * s * s);
    std::printf("block of cut %s in a fluid: pressure off by %.3f on its sides, by %.3f where its edges and corners cut cells\n", nameOf(kind), side, all);
    // The load goes to a cell's nodes as to those of its tetrahedra, so its outermost layer is not quite uniform, however fine.
    EXPECT_LT(side, kind == Elements::Cells ? 0.14 : 0.08) << nameOf(kind);
  }
}

TEST(SurfaceField, weightsOfManyPlacesAreThoseOfEach) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<TissueSample> samples;
  for (int i = 0; i < 900; ++i) {
    const Vec3 at(uniform(random), uniform(random), 0.2 * uniform(random));
    samples.push_back({at, 0.5 + uniform(random), at.x() < 0.4 ? Lame{1, 2} : Lame{3, 4}});
  }
  samples.push_back({Vec3(0.9, 0.9, 0.1), 1, Lame{7, 7}});  // alone of its kind
  std::vector<Vec3> places;
  for (int i = 0; i < 300; ++i) places.push_back(Vec3(1.6 * uniform(random) - 0.3, uniform(random), uniform(random) - 0.4));
  places.push_back(samples.back().at_E);
  for (const double reach : {0.05, 0.15, 0.4}) {
    const RecoveryTable table = recoveryTable(samples, places, reach);
    ASSERT_EQ(table.places(), places.size());
    for (std::size_t v = 0; v < places.size(); ++v) {
      const auto weights = recoveryWeights(samples, places[v], reach);
      ASSERT_EQ(table.first[v + 1] - table.first[v], static_cast<int>(weights.size())) << v << " " << reach;
      for (std::size_t k = 0; k < weights.size(); ++k) {
        EXPECT_EQ(table.index[table.first[v] + static_cast<int>(k)], weights[k].index);
        EXPECT_EQ(table.weight[table.first[v] + static_cast<int>(k)], static_cast<float>(weights[k].weight));
      }
    }
  }
}

TEST(SurfaceField, spreadContactForcesSumToTheForces) {
  const Joint joint = scenes::blockOnPlateJoint();
  Scenario scenario = scenes::blockOnPlateScenario();
  const auto model = compileModel(joint, scenario).value();
  const SurfaceField field(model);
  State state = model->start;
  Stepper stepper(model, {});
  const StepReport* report = nullptr;
  for (int i = 0; i < 300; ++i) report = &stepper.step({}, state);
  std::vector<double> wanted(model->objects.size(), 0);
  for (const ContactView& contact : report->contactViews) wanted[contact.objectA] += contact.force, wanted[contact.objectB] += contact.force;
  const int block = findPart(joint, "block"), plate = findPart(joint, "plate");
  const double weight = 9.81 * model->objects[block].mass;
  ASSERT_NEAR(wanted[block], weight, 0.02 * weight) << "it rests";
  const SurfaceValues values = field.read(Quantity::Contact, state, report->contactViews);
  for (const int part : {block, plate}) {
    EXPECT_NEAR(spreadSum(*model, state.q, values, part), wanted[part], 1e-5 * wanted[part]);  // values are of 32 bits
    const auto peak = peakOf(*model, values, part, state.q);
    ASSERT_TRUE(peak);
    EXPECT_GT(peak->value, 0);
  }
  // It lies on its lower side: nothing reaches its upper one, and the plate has it on top.
  const std::vector<Vec3>& vertices = joint.parts[block].visual->vertices;
  double low = 1, high = -1;
  for (const Vec3& x : vertices) low = std::min(low, x.y()), high = std::max(high, x.y());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v].y() > high - 1e-9) {
      EXPECT_EQ(values[block][v], 0) << v;
    }
  for (std::size_t i = 0; i < model->objects.size(); ++i)
    if (model->objects[i].tool) {
      EXPECT_TRUE(values[i].empty());
    }
}

TEST(SurfaceField, aContactOfNoVertexGoesToTheNearestAndNoneIsLost) {
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario()).value();
  const int block = findPart(model->joint, "block"), plate = findPart(model->joint, "plate");
  ContactView far{block, plate, Vec3(0.5, 0, 0), Vec3::UnitY(), 0, 3};
  ContactView lost{block, plate, Vec3(NAN, 0, 0), Vec3::UnitY(), 0, 3};
  const SurfaceValues values = SurfaceField(model).read(Quantity::Contact, model->start, std::vector{far, lost});
  EXPECT_NEAR(spreadSum(*model, model->start.q, values, block), 3, 1e-5);
  EXPECT_EQ(std::count_if(values[block].begin(), values[block].end(), [](float p) { return p > 0; }), 1);
}

TEST(SurfaceField, whatHasNoTissueHasNoValues) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure4Scenario()).value();
  const SurfaceField field(model);
  EXPECT_TRUE(field.hasTissue());
  for (const Quantity quantity : {Quantity::Stress, Quantity::Strain, Quantity::Pressure}) {
    const SurfaceValues values = field.read(quantity, model->start, {});
    ASSERT_EQ(values.size(), 3u);
    EXPECT_TRUE(values[0].empty());
    EXPECT_EQ(values[1].size(), model->objects[1].visual.vertices.size());
    EXPECT_TRUE(values[2].empty());
    EXPECT_FALSE(peakOf(*model, values, 0, model->start.q));
  }
  for (const Quantity quantity : kQuantities) EXPECT_EQ(quantityNamed(quantityName(quantity)), quantity);
  EXPECT_FALSE(quantityNamed("colour"));
}

}  // namespace
}  // namespace glenoid
