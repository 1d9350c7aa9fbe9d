// SPDX-License-Identifier: GPL-3.0-or-later
// Exported decks as another program solves them: the part's own tetrahedra, its bonds and its materials, beside the simulation
// refined and beside closed forms. What is exported is not looked at; only what CalculiX makes of it counts.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "simcore/embed/Cells.h"
#include "simcore/export/ExportJoint.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/step/Measures.h"
#include "tests/truth/Calculix.h"

namespace glenoid::truth {
namespace {

/// Bone – tissue – bone along X; the tissue's ends are its regions "left" and "right".
Joint betweenBones(Part tissue, double length) {
  Joint joint;
  joint.id = joint.name = "pulled";
  scenes::addMaterials(joint);
  joint.materials[0].density = 1;  // next to no mass, so that it comes to rest at once
  joint.materials[1].youngsModulus = 1e6;
  joint.materials[1].poissonRatio = 0.45;
  joint.materials[1].massDamping = 20;
  joint.parts = {scenes::boxPart("from", 1, PartKind::Rigid, {-0.01, -0.01, -0.01}, {0, 0.01, 0.01}), std::move(tissue),
                 scenes::boxPart("to", 9, PartKind::Rigid, {length, -0.01, -0.01}, {length + 0.01, 0.01, 0.01})};
  const std::string id = joint.parts[1].id;
  joint.couplings.push_back({"c-from", id, "from", "left", 1e12, 0, {}});
  joint.couplings.push_back({"c-to", id, "to", "right", 1e12, 0, {}});
  return joint;
}

Part inCells(Part part, double cell) {
  part.volume = std::make_shared<const TetMesh>(embedInCells(*part.visual, *part.collision, cell).value());
  part.cellSize = cell;
  return part;
}

Part band(double length, double width, double thickness) {
  Part part = scenes::boxPart("band", 2, PartKind::Soft, {0, -thickness / 2, -width / 2}, {length, thickness / 2, width / 2});
  part.regions = {scenes::regionIn(part, "left", Box3(Vec3(-1e-6, -1, -1), Vec3(1e-6, 1, 1))),
                  scenes::regionIn(part, "right", Box3(Vec3(length - 1e-6, -1, -1), Vec3(length + 1e-6, 1, 1)))};
  return part;
}

/// Where the far bone comes to rest in the simulation under a force at its middle, m from where it was.
Vec3 bySimulation(const Joint& joint, const Vec3& force) {
  Scenario scenario;
  scenario.id = scenario.name = "pulled";
  scenario.dt = 0.1;  // a large step forgets motion at once
  scenario.elements = Elements::Cells;
  scenario.fixedParts = {"from"};
  scenario.effects.gravity = scenario.effects.contact = Wish::Off;
  Load load;
  load.part = "to";
  load.force_W = force;
  load.point_W = boundsOf(*joint.parts.back().visual).center();
  scenario.loads = {load};
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  const int at = model->objects.back().layout.qOffset;
  const Vec3 rest = state.q.segment<3>(at);
  for (int i = 0; i < 60; ++i) stepper.step({}, state);
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 1e-5) << "not at rest";
  return state.q.segment<3>(at) - rest;
}

/// The same by CalculiX, from a deck that must run as it is; then a second step holds the first bone alone and pulls the other.
std::optional<Vec3> byCalculix(const Joint& joint, const Vec3& force, double edge, ExportReport& report) {
  const TemporaryFolder folder;
  const auto exported = exportJoint(joint, ExportFormat::Inp, folder.path("body.inp"), {.mesh = ExportMesh::Conforming, .size = {edge, 0}});
  EXPECT_TRUE(exported.ok()) << toLogLine(exported.error());
  if (!exported) return std::nullopt;
  report = *exported;
  std::ofstream(folder.path("body.inp"), std::ios::app)
      << "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\nPLACE-FROM, 1, 3\nTURN-FROM, 1, 3\n*DLOAD, OP=NEW\n*CLOAD, OP=NEW\nPLACE-TO, 1, " << force.x()
      << "\nPLACE-TO, 2, " << force.y() << "\nPLACE-TO, 3, " << force.z() << "\n*NODE PRINT, NSET=PLACE-TO\nU\n*END STEP\n";
  if (!runCalculix(folder.path(), "body")) return std::nullopt;
  std::ifstream in(folder.path("body.dat"));
  std::optional<Vec3> moved;
  bool displacements = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("displacements") != std::string::npos) displacements = true;
    std::istringstream words(line);
    long node = 0;
    Vec3 u;
    if (displacements && words >> node >> u.x() >> u.y() >> u.z()) moved = u;
  }
  return moved;
}

/// Compared as vectors, by the length of what the simulation says.
void compare(const char* what, const Joint& joint, const Vec3& force, double edge, const Vec3& wanted) {
  ExportReport report;
  const auto found = byCalculix(joint, force, edge, report);
  ASSERT_TRUE(found) << what;
  std::printf("%s: %ld tetrahedra, CalculiX %.4f %.4f %.4f mm, wanted %.4f %.4f %.4f mm: %.1f %% apart\n", what, report.tetrahedra, 1e3 * found->x(),
              1e3 * found->y(), 1e3 * found->z(), 1e3 * wanted.x(), 1e3 * wanted.y(), 1e3 * wanted.z(), 100 * (*found - wanted).norm() / wanted.norm());
  EXPECT_LT((*found - wanted).norm(), 0.05 * wanted.norm()) << what;
}

TEST(ConformingExport, aLigamentBandBendsAsTheSimulationRefined) {
  NEEDS_CALCULIX()
  const Joint joint = betweenBones(inCells(band(0.04, 0.01, 0.002), 0.001), 0.04);
  const Vec3 force(0, -2e-4, 0);  // small: the deck is linear
  compare("band", joint, force, 0.002, bySimulation(joint, force));
}

// Bone – soft – soft – bone: bonds of soft parts on each other are equations between nodes of meshes that do not match.
TEST(ConformingExport, bondedTissuesLengthenAsOneBarInClosedForm) {
  NEEDS_CALCULIX()
  constexpr double kLength = 0.03, kWidth = 0.01, kThickness = 0.006, kForce = 0.2;
  Joint joint = betweenBones(inCells(band(kLength, kWidth, kThickness), 0.002), 2 * kLength);
  joint.materials[1].poissonRatio = 0;
  Part second = joint.parts[1];
  second.id = "second";
  second.number = 3;
  TriMesh moved = *second.visual;
  for (Vec3& x : moved.vertices) x.x() += kLength;
  second.visual = second.collision = std::make_shared<const TriMesh>(moved);
  second = inCells(second, 0.002);
  joint.parts.insert(joint.parts.begin() + 2, second);
  joint.couplings[1].partA = "second";
  joint.couplings.push_back({"c-middle", "band", "second", "right", 1e12, 0, {}});
  compare("two bars", joint, Vec3(kForce, 0, 0), 0.002, Vec3(kForce * 2 * kLength / (joint.materials[1].youngsModulus * kWidth * kThickness), 0, 0));
}

}  // namespace
}  // namespace glenoid::truth
