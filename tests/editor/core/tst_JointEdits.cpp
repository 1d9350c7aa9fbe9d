// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/JointEdits.h"

#include <gtest/gtest.h>

#include "editor/core/PlayLink.h"
#include "simcore/author/MirrorJoint.h"
#include "simcore/scene/JointFile.h"
#include "tests/editor/core/EventLoop.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Scene pushedBlock() {
  Scene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
  scene.joint.side = JointSide::Right;
  scene.joint.name = "Right block";
  Recording hands;
  hands.tracks = {{scene.scenario.tools.at(0).id, {{0, scene.scenario.tools[0].home}}}};
  scene.input = std::make_shared<const Recording>(hands);
  scene.scenario.input = "hands.recording";
  return scene;
}

TEST(JointEdits, whatIsSaidOfTheJointIsUndone) {
  Document document;
  document.open(pushedBlock(), "a");
  const std::string before = jointHash(document.joint());
  EXPECT_TRUE(renameJoint(document, "Knee"));
  EXPECT_TRUE(describeJoint(document, "Of nobody in particular"));
  EXPECT_TRUE(setJointLicence(document, "CC0-1.0"));
  EXPECT_TRUE(setJointAuthor(document, "A. Author"));
  EXPECT_TRUE(setJointSide(document, JointSide::Left));
  EXPECT_EQ(document.undoStack().count(), 5);
  EXPECT_FALSE(renameJoint(document, "Knee"));
  EXPECT_FALSE(renameJoint(document, ""));
  EXPECT_FALSE(describeJoint(document, "Of nobody in particular"));
  EXPECT_FALSE(setJointSide(document, JointSide::Left));
  EXPECT_EQ(document.undoStack().count(), 5) << "the same again is no step";
  const Joint& joint = document.joint();
  EXPECT_EQ(joint.name, "Knee");
  EXPECT_EQ(joint.description, "Of nobody in particular");
  EXPECT_EQ(joint.provenance.license, "CC0-1.0");
  EXPECT_EQ(joint.provenance.author, "A. Author");
  EXPECT_EQ(joint.side, JointSide::Left);
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_EQ(jointHash(document.joint()), before);
}

TEST(JointEdits, mirroringIsOneStepWithScenarioAndHands) {
  Document document;
  const Scene right = pushedBlock();
  document.open(right, "a");
  ASSERT_TRUE(mirrorJoint(document));
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.joint().side, JointSide::Left);
  EXPECT_EQ(document.joint().name, "Left block");
  EXPECT_EQ(jointHash(document.joint()), jointHash(mirroredJoint(right.joint)));
  const Pose home = document.scenario().tools[0].home;
  EXPECT_EQ(home.p_WB.z(), -right.scenario.tools[0].home.p_WB.z());
  ASSERT_TRUE(document.scene().input);
  EXPECT_EQ(document.scene().input->tracks[0].keys[0].hand.p_WB, home.p_WB);
  EXPECT_TRUE(document.scenario().input.empty()) << "the file holds the hands of the other side";
  document.undoStack().undo();
  EXPECT_EQ(jointHash(document.joint()), jointHash(right.joint));
  EXPECT_EQ(document.scenario().input, "hands.recording");
  EXPECT_EQ(document.scene().input, right.input);
  document.undoStack().redo();
  ASSERT_TRUE(mirrorJoint(document));
  EXPECT_EQ(jointHash(document.joint()), jointHash(right.joint)) << "twice is none";
  Document empty;
  EXPECT_FALSE(mirrorJoint(empty));
}

using JointEditsRun = EventLoopTest;

TEST_F(JointEditsRun, ofTheMirroredJointBeginsAnew) {
  Document document;
  Scene scene = pushedBlock();
  for (Part& part : scene.joint.parts)  // off the plane, so that what is carried over would lie elsewhere
    for (auto* mesh : {&part.visual, &part.collision}) {
      TriMesh moved = **mesh;
      for (Vec3& vertex : moved.vertices) vertex.z() += 0.05;
      *mesh = std::make_shared<const TriMesh>(moved);
    }
  for (Part& part : scene.joint.parts)
    if (part.volume) {
      TetMesh moved = *part.volume;
      for (Vec3& node : moved.nodes) node.z() += 0.05;
      part.volume = std::make_shared<const TetMesh>(moved);
    }
  scene.input.reset();
  PlayLink link(document);
  document.open(scene, "a");
  ASSERT_TRUE(until([&] { return link.snapshot().model != nullptr; }));
  link.stepOnce();
  const auto model = link.snapshot().model;
  ASSERT_TRUE(mirrorJoint(document));
  ASSERT_TRUE(until([&] { return link.snapshot().model != model; }));
  const Snapshot& snapshot = link.snapshot();
  ASSERT_EQ(snapshot.q.size(), snapshot.model->start.q.size());
  EXPECT_LT((snapshot.q - snapshot.model->start.q).norm(), 1e-12);
}

}  // namespace
}  // namespace glenoid
