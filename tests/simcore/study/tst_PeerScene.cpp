// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/step/Model.h"
#include "simcore/study/PeerBlocks.h"
#include "simcore/study/PeerProgram.h"

namespace glenoid::peers {
namespace {

const std::string kFolder = GLENOID_SOURCE_DIR "/tests/scenes/peers";

TEST(PeerScene, hasTheCountsOfThePeers) {
  const Joint joint = makeJoint(Stiffness::Mixed);
  const std::array<int, 7> tets{87, 129, 158, 65, 86, 96, 122}, nodes{48, 63, 75, 46, 55, 53, 71};
  const std::array<int, 7> bound{24, 31, 30, 10, 15, 17, 23};  // 150 in all
  const auto model = compileModel(joint, makeScenario(0.005)).value();
  // Springs hold inside the ends; what they give a node is its share of them.
  std::array<std::map<int, double>, 7> share;
  std::array<double, 7> beside{};  // of a piece of an end with a notch one point may lie in the notch, beyond the face
  for (const SpringView& spring : model->springs)
    for (int k = 0; k < 4; ++k)
      if (const double part = spring.stiffness * spring.a.weight[k]; std::abs(spring.a.weight[k]) > 1e-9) {
        const double x = model->objects[spring.objectA].volume->nodes[spring.a.node[k]].x() -
                         boundsOf(*joint.parts[spring.objectA].visual).min().x();
        if (std::min(x, 0.08 - x) < 1e-9)
          share[spring.objectA][spring.a.node[k]] += part;
        else
          beside[spring.objectA] += std::abs(part) / 1e12;
      }
  for (int i = 0; i < kBlocks; ++i) {
    const Part& part = joint.parts[i];
    EXPECT_EQ(part.volume->tets.size(), static_cast<std::size_t>(tets[i])) << part.id;
    EXPECT_EQ(part.volume->nodes.size(), static_cast<std::size_t>(nodes[i])) << part.id;
    EXPECT_EQ(share[i].size(), static_cast<std::size_t>(bound[i])) << part.id << ": every node of both ends is bound";
    for (const auto& [node, stiffness] : share[i]) EXPECT_GT(stiffness, 1e7) << part.id << " " << node;
    EXPECT_LT(beside[i], 0.01 * 0.02 * boundsOf(*part.visual).sizes().y()) << "m², beside ends of some 20 mm of width";
    EXPECT_TRUE(healthOf(*part.volume).healthy()) << part.id;
    EXPECT_EQ(healthOf(*part.volume).components, 1) << part.id;
    EXPECT_TRUE(healthOf(*part.visual).healthy()) << part.id;
  }
  EXPECT_EQ(model->couplingIslandCount, 3) << "blocks with the moving bone, ball, ridge";
}

TEST(PeerScene, blocksHaveTheirStiffnessSizeAndPlace) {
  const Joint joint = makeJoint(Stiffness::Mixed);
  EXPECT_EQ(joint.materials[findMaterial(joint, joint.parts[3].materials[0].material)].youngsModulus, 100e6);
  double across = 0;
  for (int i = 0; i < kBlocks; ++i) {
    const Box3 box = boundsOf(*joint.parts[i].visual);
    EXPECT_NEAR(box.sizes().x(), 0.08, 1e-12);
    EXPECT_NEAR(box.sizes().y(), blockShapes()[i].height, 1e-12);
    if (i) EXPECT_NEAR(box.min().z(), across + 0.002, 1e-12);
    across = box.max().z();
  }
}

TEST(PeerScene, ballPressesByAQuarterAtUpTo75Millimetres) {
  double fastest = 0, step = 1e-4;
  for (double t = 0; t < kSeconds; t += step) {
    const Vec3 way = ballCentre(t + step) - ballCentre(t);
    EXPECT_LT(way.norm(), 0.5 * step) << "no jump at " << t;  // m/s; across at most 0.42
    const double s = t - std::floor(t);
    if (t > kSettleSeconds && s > 0.36 && s < 0.84) fastest = std::max(fastest, way.norm() / step);
  }
  EXPECT_NEAR(fastest, 0.0754, 1e-3);  // (10 + 2) mm · π / 0.5 s
  const double underside = ridgeTop(0) + 0.001;
  for (int i = 0; i < kBlocks; ++i) {
    const double lowest = ballCentre(kSettleSeconds + i + 0.6).y() - kBallRadius - underside;
    EXPECT_NEAR(lowest, 0.75 * blockShapes()[i].height + 0.003, 1e-9) << i;
  }
  EXPECT_NEAR(ridgeTop(kSeconds) - underside, 0.003, 1e-12);
}

TEST(PeerScene, liesInTheFolderAsItIsBuilt) {
  for (const Stiffness stiffness : kStiffnesses) {
    const std::string name = stiffnessName(stiffness);
    const auto joint = loadJoint(kFolder + "/" + name + ".joint");
    ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
    EXPECT_EQ(jointHash(*joint), jointHash(makeJoint(stiffness))) << "run generate_peer_scene and commit its answer";
    const auto scenario = loadScenario(kFolder + "/" + name + ".scenario.json");
    ASSERT_TRUE(scenario.ok()) << toLogLine(scenario.error());
    EXPECT_TRUE(compileModel(*joint, *scenario).ok());
    EXPECT_EQ(scenario->tools[kBall].kind, ToolKind::Ball);
    EXPECT_EQ(scenario->tools[kRidge].kind, ToolKind::Bar);
  }
  const auto recording = loadRecording(kFolder + "/press.recording");
  ASSERT_TRUE(recording.ok()) << toLogLine(recording.error());
  std::vector<Pose> hands;
  for (const double t : {0.0, 0.2, 1.6, 4.55, 8.0}) {
    handsAt(t, hands);
    for (int tool = 0; tool < 2; ++tool)  // 10 ms keys of a path that bends by at most 3 m/s² while it presses
      EXPECT_LT((handAt(recording->tracks[tool], t).p_WB - hands[tool].p_WB).norm(), 1e-4);
  }
}

TEST(PeerProgram, sceneIsHandedOverWhole) {
  std::ostringstream out;
  writeScene(Stiffness::Soft, 0.02, 8, out);
  const std::string text = out.str();
  EXPECT_EQ(text.rfind("dt 0.02", 0), 0u);
  EXPECT_NE(text.find("steps 400"), std::string::npos);
  std::size_t blocks = 0;
  for (std::size_t at = text.find("block "); at != std::string::npos; at = text.find("block ", at + 1)) ++blocks;
  EXPECT_EQ(blocks, 7u);
  EXPECT_EQ(text.substr(text.size() - 4), "end\n");
}

TEST(PeerProgram, programThatIsNotThereIsSaid) {
  const auto row = runProgram(kFolder + "/no-such-program", Stiffness::Soft, 0.02, 1, 1);
  ASSERT_FALSE(row.ok());
  EXPECT_EQ(row.error().fault, Fault::FileMissing);
  const auto silent = runProgram("/bin/true", Stiffness::Soft, 0.02, 1, 1);
  ASSERT_FALSE(silent.ok());
  EXPECT_EQ(silent.error().fault, Fault::Unusable);
}

TEST(PeerRow, comesBackFromItsJson) {
  Row row;
  row.simulator = "x";
  row.dt = 0.02;
  row.msP99 = 1.5;
  row.stable = true;
  row.ballDepth = 1e-4;
  row.contactsMax = 7;
  row.contactFallbacks = 3;
  EXPECT_EQ(toJson(toRow(toJson(row))), toJson(row));
}

}  // namespace
}  // namespace glenoid::peers
