// SPDX-License-Identifier: GPL-3.0-or-later
// Hard contacts: hands that jump, tissue between bones, contacts that say the same thing over and over.
#include <gtest/gtest.h>

#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

/// From 0.2 s to 0.7 s the hand is somewhere else, in one step each way.
std::function<Inputs(const Model&, double)> jumpTo(const Vec3& there) {
  return [there](const Model& model, double t) {
    const Touch touch{0, -1, -1, model.scenario.tools[0].home.p_WB, there, -Vec3::UnitY(), 0};
    return t < 0.2 ? Inputs{} : playHands(model, touch, HandPlay::Jump, 0.5, t - 0.2);
  };
}

TEST(HardContacts, theHandJumpsFiveCentimetresDeepIntoTissue) {
  HardCase hard = fingerOverBlock("hand 5 cm deep in tissue");
  hard.joint.parts[1] = box("block", 2, PartKind::Soft, "tissue", Vec3(-0.04, 0.0005, -0.04), Vec3(0.04, 0.0805, 0.04), 3, 4);
  hard.scenario.tools[0].home.p_WB = Vec3(0.002, 0.09, 0.001);
  hard.loadEnds = 0.7;
  hard.ending = "the hand jumps back";
  hard.hands = jumpTo(Vec3(0.002, 0.0305, 0.001));
  expectUnshaken(hard);
}

TEST(HardContacts, theHandJumpsFiveCentimetresDeepIntoBone) {
  for (const ToolKind kind : {ToolKind::Finger, ToolKind::Probe}) {
    HardCase hard;
    hard.name = kind == ToolKind::Finger ? "finger 5 cm deep in bone" : "probe 5 cm deep in bone";
    scenes::addMaterials(hard.joint);
    hard.joint.parts = {box("bone", 1, PartKind::Rigid, "bone", Vec3(-0.05, -0.1, -0.05), Vec3(0.05, 0, 0.05))};
    hard.scenario.fixedParts = {"bone"};
    hard.scenario.tools = {finger(Vec3(0.002, 0.01, 0.001))};
    hard.scenario.tools[0].kind = kind;
    if (kind == ToolKind::Probe) hard.scenario.tools[0].radius = 0.0015, hard.scenario.tools[0].length = 0.16;
    hard.loadEnds = 0.7;
    hard.ending = "the hand jumps back";
    hard.hands = jumpTo(Vec3(0.002, -0.05, 0.001));
    expectUnshaken(hard);
  }
}

TEST(HardContacts, tissueSqueezedBetweenTwoBonesToATenth) {
  HardCase hard;
  hard.name = "squeezed to a tenth";
  scenes::addMaterials(hard.joint);
  hard.joint.materials[1].stiffnessDamping = 5e-3;
  hard.joint.materials[1].massDamping = 5;
  // Without friction nothing holds the tissue sideways: it comes to rest and then creeps off at 0.1 mm/s.
  for (Material& material : hard.joint.materials) material.friction = 0.2;
  hard.joint.parts = {box("plate", 1, PartKind::Rigid, "bone", Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)),
                      box("tissue", 2, PartKind::Soft, "tissue", Vec3(-0.01, 0.0002, -0.01), Vec3(0.01, 0.0202, 0.01), 3, 3),
                      box("press", 3, PartKind::Rigid, "bone", Vec3(-0.04, 0.0204, -0.04), Vec3(0.04, 0.0304, 0.04))};
  hard.scenario.fixedParts = {"plate"};
  // The press keeps its direction and rises when the hand does.
  hard.scenario.holds = {{"press", 20, 500, 1e-2}};
  Tool tool = finger(Vec3(0, 0.032, 0));
  tool.stiffness = 5e4;
  tool.forceMax = 2000;
  hard.scenario.tools = {tool};
  hard.loadEnds = 1.2;
  hard.ending = "the hand that pushed the upper bone has gone back up";
  hard.hands = [](const Model& model, double t) {
    // The press's underside must come down to 2 mm, its top to 12 mm.
    const double low = 0.0115;
    const double y = t < 0.4 ? 0.032 - (0.032 - low) * t / 0.4 : (t < 0.8 ? low : std::min(0.032, low + (0.032 - low) * (t - 0.8) / 0.4));
    return Inputs{{handAt(model.scenario.tools[0], Vec3(0, y, 0))}};
  };
  expectUnshaken(hard, [](const HardResult& result, double) {
    EXPECT_LT(shapeError(*result.model, result.end, 1), 2e-3) << "it swells back; what is left is the press's weight";
  });
}

TEST(HardContacts, twoHundredRedundantAndDuplicateContacts) {
  for (const PartKind kind : {PartKind::Rigid, PartKind::Soft}) {
    HardCase hard;
    hard.name = std::string("200 redundant contacts, ") + (kind == PartKind::Soft ? "soft" : "rigid");
    scenes::addMaterials(hard.joint);
    hard.joint.materials[1].stiffnessDamping = 5e-3;
    hard.joint.materials[1].massDamping = 5;
    const Vec3 low(-0.02, 0.0002, -0.02), high(0.02, 0.0202, 0.02);
    hard.joint.parts = {box("plate", 1, PartKind::Rigid, "bone", Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)),
                        box("block", 2, kind, kind == PartKind::Soft ? "tissue" : "bone", low, high)};
    // The collision surface lies there twice, vertex upon vertex.
    TriMesh twice = scenes::boxSurface(low, high, 9);
    const int count = static_cast<int>(twice.vertices.size());
    const TriMesh once = twice;
    twice.vertices.insert(twice.vertices.end(), once.vertices.begin(), once.vertices.end());
    for (const auto& t : once.triangles) twice.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    hard.joint.parts[1].collision = std::make_shared<TriMesh>(twice);
    hard.scenario.fixedParts = {"plate"};
    hard.scenario.tools = {finger(Vec3(0.003, 0.03, 0.002))};
    hard.loadEnds = 0.6;
    hard.ending = "the finger that pressed on it has gone";
    hard.hands = [](const Model& model, double t) {
      const double y = t < 0.2 ? 0.03 - 0.015 * t / 0.2 : (t < 0.4 ? 0.015 : std::min(0.03, 0.015 + 0.015 * (t - 0.4) / 0.2));
      return Inputs{{handAt(model.scenario.tools[0], Vec3(0.003, y, 0.002))}};
    };
    expectUnshaken(hard, [](const HardResult& result, double) { EXPECT_GE(result.contactsMax, 200); });
  }
}

TEST(HardContacts, degenerateTrianglesInACollisionMesh) {
  HardCase hard = fingerOverBlock("degenerate triangles");
  for (Part& part : hard.joint.parts) {
    TriMesh mesh = scenes::boxSurface(boundsOf(*part.collision).min(), boundsOf(*part.collision).max(), 3);
    const auto first = mesh.triangles[0];
    const Vec3 a = mesh.vertices[first[0]], b = mesh.vertices[first[1]];
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(0.5 * (a + b));
    mesh.vertices.push_back(a);
    mesh.vertices.push_back(b);
    mesh.triangles.push_back({first[0], first[1], middle});          // on a line
    mesh.triangles.push_back({first[0], first[0], first[1]});        // a line
    mesh.triangles.push_back({first[2], first[2], first[2]});        // a point
    mesh.triangles.push_back({middle + 1, first[0], middle + 2});    // a line between doubled vertices
    for (int copy = 0; copy < 2; ++copy) mesh.triangles.push_back(first);  // again and again: an odd number, or the check,
                                                                     // which counts crossings, would see a hole
    for (std::size_t t = 10; t < 14; ++t) {                          // and a few in the middle of faces
      const auto tri = mesh.triangles[t];
      mesh.triangles.push_back({tri[0], tri[1], tri[1]});
    }
    part.collision = std::make_shared<TriMesh>(mesh);
  }
  // A finger beside the middle squeezes a block that nothing else holds sideways off its plate.
  for (Material& material : hard.joint.materials) material.friction = 0.5;
  hard.loadEnds = 0.8;
  hard.ending = "the finger has pressed and is gone";
  hard.hands = [](const Model& model, double t) {
    const double y = t < 0.3 ? 0.06 - 0.03 * t / 0.3 : (t < 0.5 ? 0.03 : std::min(0.06, 0.03 + 0.03 * (t - 0.5) / 0.3));
    return Inputs{{handAt(model.scenario.tools[0], Vec3(0.002, y, 0.001))}};
  };
  expectUnshaken(hard);
}

}  // namespace
}  // namespace glenoid::hard
