// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the shipped shoulder, exported as decks of their own tetrahedra and solved by CalculiX: how they sag under a small
// weight between bones that hold still, beside the simulation in finer cells. The shapes, bonds and materials are the anatomy's.
// Either side clamps somewhat more than the bonded region, whole cells here and whole nodes there, so both sag more as they are
// refined: the muscle most by 1.70, 1.82 and 1.91 µm in cells of 3, 2 and 1.5 mm, 1.82, 1.83 and 2.00 µm with edges of 6, 4 and
// 2.5 mm (in proportion to the size both go to some 2.2). Cells half as long as edges clamp about alike.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "simcore/embed/Bind.h"
#include "simcore/embed/Cells.h"
#include "simcore/export/ExportJoint.h"
#include "simcore/scene/JointFile.h"
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"
#include "tests/truth/Calculix.h"

namespace glenoid::truth {
namespace {

/// The part between the bones that it is bonded to, all as they lie at rest, in cells of this size.
Joint alone(const std::string& id, double cell) {
  Joint joint = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder.joint").value();
  std::erase_if(joint.couplings, [&](const Coupling& c) { return c.partA != id && c.partB != id; });
  std::set<std::string> kept{id};
  for (const Coupling& coupling : joint.couplings)
    for (const std::string& other : {coupling.partA, coupling.partB})
      if (findPart(joint, other) >= 0 && joint.parts[findPart(joint, other)].kind == PartKind::Rigid) kept.insert(other);
  std::erase_if(joint.couplings, [&](const Coupling& c) { return !kept.count(c.partA) || !kept.count(c.partB); });
  std::erase_if(joint.parts, [&](const Part& part) { return !kept.count(part.id); });
  joint.exclusions.clear();
  joint.bursae.clear();
  joint.cages.clear();
  joint.startProof.reset();
  for (Coupling& coupling : joint.couplings) coupling.stiffnessPerArea = 1e12, coupling.damping = 0;  // the deck's bonds do not give
  for (Material& material : joint.materials) material.massDamping = 20, material.stiffnessDamping = 0;
  for (Part& part : joint.parts) {
    part.dents.reset();
    if (part.kind != PartKind::Soft) continue;
    part.volume = std::make_shared<const TetMesh>(embedInCells(*part.visual, *part.collision, cell).value());
    part.cellSize = cell;
  }
  return joint;
}

/// How the visual vertices of the only soft part move under a weight, m.
std::vector<Vec3> bySimulation(const Joint& joint, const std::string& id, const Vec3& gravity) {
  Scenario scenario;
  scenario.id = scenario.name = "sags";
  scenario.dt = 0.1;  // a large step forgets motion at once
  scenario.elements = Elements::Cells;
  scenario.gravity_W = gravity;
  scenario.effects.contact = Wish::Off;
  for (const Part& part : joint.parts)
    if (part.kind == PartKind::Rigid) scenario.fixedParts.push_back(part.id);
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  for (int i = 0; i < 12; ++i) stepper.step({}, state);
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 1e-6) << "not at rest";
  for (const SceneObject& object : model->objects) {
    if (object.id != id) continue;
    std::vector<Vec3> rest(object.visual.vertices.size()), moved(rest.size());
    surfacePositions(object.visual, object.layout, model->start.q, rest);
    surfacePositions(object.visual, object.layout, state.q, moved);
    for (std::size_t v = 0; v < rest.size(); ++v) moved[v] -= rest[v];
    return moved;
  }
  return {};
}

/// Of the nodes of a deck under the same weight, in the deck's order, m.
std::vector<Vec3> byCalculix(const Joint& joint, const std::string& set, const Vec3& gravity, const TetSize& size) {
  const TemporaryFolder folder;
  const auto exported = exportJoint(joint, ExportFormat::Inp, folder.path("body.inp"), {.mesh = ExportMesh::Conforming, .size = size});
  EXPECT_TRUE(exported.ok()) << toLogLine(exported.error());
  if (!exported) return {};
  const Vec3 down = gravity.normalized();
  std::ofstream(folder.path("body.inp"), std::ios::app)
      << "*STEP\n*STATIC\n*DLOAD, OP=NEW\nTISSUE, GRAV, " << gravity.norm() << ", " << down.x() << ", " << down.y() << ", " << down.z()
      << "\n*NODE PRINT, NSET=" << set << "\nU\n*END STEP\n";
  if (!runCalculix(folder.path(), "body")) return {};
  std::ifstream in(folder.path("body.dat"));
  std::vector<Vec3> moved;
  bool displacements = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("displacements") != std::string::npos) displacements = true, moved.clear();
    std::istringstream words(line);
    long node = 0;
    Vec3 u;
    if (displacements && words >> node >> u.x() >> u.y() >> u.z()) moved.push_back(u);
  }
  return moved;
}

/// Root of the mean square over the surface of the difference, as a share of the simulation's, and the ratio of the largest ways.
void compare(const std::string& id, const std::string& set, double cell, double edge, double weight) {
  const Joint joint = alone(id, cell);
  const Vec3 gravity(0, -weight, 0);
  const std::vector<Vec3> ours = bySimulation(joint, id, gravity);
  const TriMesh& surface = *joint.parts[findPart(joint, id)].visual;
  const TetSize size = chosenSize(surface, {edge, 0});
  const TetMesh mesh = conformingMesh(surface, size).value();
  const std::vector<Vec3> nodes = byCalculix(joint, set, gravity, size);
  ASSERT_GE(nodes.size(), mesh.nodes.size());  // first the corners, then the middles of edges
  ASSERT_EQ(ours.size(), surface.vertices.size());
  const std::vector<VertexBinding> at = bindToTets(mesh, surface.vertices);
  double difference = 0, whole = 0, mostOurs = 0, mostTheirs = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const Vec3 theirs = boundPosition(at[v], std::span(nodes).first(mesh.nodes.size()));
    difference += (theirs - ours[v]).squaredNorm();
    whole += ours[v].squaredNorm();
    mostOurs = std::max(mostOurs, ours[v].norm());
    mostTheirs = std::max(mostTheirs, theirs.norm());
  }
  std::printf("%s, cells of %.2f mm, %zu tetrahedra with edges of %.2f mm: most %.4f µm, CalculiX %.4f µm; all over %.1f %% apart\n", id.c_str(),
              1e3 * cell, mesh.tets.size(), 1e3 * size.edge, 1e6 * mostOurs, 1e6 * mostTheirs, 100 * std::sqrt(difference / whole));
  EXPECT_LT(mostOurs, 1e-4) << "too much for a linear deck";
  EXPECT_NEAR(mostTheirs, mostOurs, 0.05 * mostOurs);
  EXPECT_LT(std::sqrt(difference / whole), 0.05);
}

TEST(ExportedAnatomy, theCoracoacromialLigamentSagsAsInCalculix) {
  NEEDS_CALCULIX()
  compare("coracoacromial-ligament", "CORACOACROMIAL-LIGAMENT", 0.5e-3, 1.1e-3, 0.01);
}

TEST(ExportedAnatomy, aCuffMuscleSagsAsInCalculix) {
  NEEDS_CALCULIX()
  compare("supraspinatus", "SUPRASPINATUS", 2e-3, 4e-3, 0.01);
}

}  // namespace
}  // namespace glenoid::truth
