// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MirrorJoint.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "simcore/author/MakeDents.h"
#include "simcore/author/Overlaps.h"
#include "simcore/author/SeparateStart.h"
#include "simcore/embed/CellGrouping.h"
#include "simcore/live/Run.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/JointFile.h"
#include "tests/simcore/author/OverlappingParts.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

namespace glenoid {
namespace {

Vec3 mirrored(const Vec3& v) { return {v.x(), v.y(), -v.z()}; }

/// With cages, a proof, landmarks and regions on both surfaces.
const Joint& freed() {
  static const Joint made = [] {
    JointRecipe recipe = test::overlappingParts();
    recipe.id = "left-thing";
    recipe.name = "Left thing";
    recipe.description = "A left thing; what is left of it.";
    recipe.side = JointSide::Left;
    recipe.parts[0].name = "LEFT ball";
    recipe.parts[0].landmarks = {{"left-tip", "Tip of the left ball", Vec3(0.001, 0.002, 0.024)}};
    recipe.parts[1].regions = {{"end", "End", "other", SurfaceKind::Visual, {{3, 40}, {100, 7}}}};
    recipe.start.emplace();
    recipe.start->clearance = 5e-4;
    auto joint = buildJoint(recipe);
    EXPECT_TRUE(joint.ok()) << toLogLine(joint.error());
    return *joint;
  }();
  return made;
}

std::string bytesOf(const std::filesystem::path& folder) {
  std::string all;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    all += std::filesystem::relative(file, folder).string() + '\n' + text.str();
  }
  return all;
}

TEST(MirrorJoint, twiceGivesTheSameFilesByteForByte) {
  const TemporaryFolder folder;
  for (const Joint& joint : {freed(), sampleJoint()}) {
    const std::string here = folder.path(joint.id + "-here.joint"), there = folder.path(joint.id + "-there.joint"),
                      back = folder.path(joint.id + "-back.joint");
    ASSERT_TRUE(saveJoint(joint, here).ok());
    const auto loaded = loadJoint(here);
    ASSERT_TRUE(loaded.ok()) << toLogLine(loaded.error());
    ASSERT_TRUE(saveJoint(mirroredJoint(*loaded), there).ok());
    const auto other = loadJoint(there);
    ASSERT_TRUE(other.ok()) << toLogLine(other.error());
    ASSERT_TRUE(saveJoint(mirroredJoint(*other), back).ok());
    EXPECT_NE(jointHash(*other), jointHash(joint));
    EXPECT_EQ(bytesOf(here), bytesOf(back));
  }
}

TEST(MirrorJoint, everythingThatHasAPlaceIsMirrored) {
  const Joint& joint = freed();
  const Joint other = mirroredJoint(joint);
  EXPECT_EQ(other.side, JointSide::Right);
  ASSERT_EQ(other.parts.size(), joint.parts.size());
  for (std::size_t p = 0; p < joint.parts.size(); ++p) {
    const Part &a = joint.parts[p], &b = other.parts[p];
    EXPECT_EQ(a.regions, b.regions);
    for (const auto& [from, to] : {std::pair(a.visual, b.visual), std::pair(a.collision, b.collision)}) {
      for (std::size_t v = 0; v < from->vertices.size(); ++v) EXPECT_EQ(to->vertices[v], mirrored(from->vertices[v]));
      EXPECT_TRUE(healthOf(*to).healthy());
      EXPECT_NEAR(enclosedVolume(*to), enclosedVolume(*from), 1e-12 * enclosedVolume(*from)) << "wound outwards";
    }
    for (const Region& region : a.regions) EXPECT_NEAR(areaOf(a, region), areaOf(b, *findRegion(b, region.id)), 1e-15);
    for (std::size_t i = 0; i < a.landmarks.size(); ++i) EXPECT_EQ(b.landmarks[i].position_W, mirrored(a.landmarks[i].position_W));
    if (!a.volume) continue;
    for (int t = 0; t < static_cast<int>(a.volume->tets.size()); ++t)
      EXPECT_NEAR(tetVolume(*b.volume, t), tetVolume(*a.volume, t), 1e-12 * tetVolume(*a.volume, t));
    // The cells that elements are made of are found again.
    const auto cells = groupIntoCells(*a.volume), others = groupIntoCells(*b.volume);
    ASSERT_EQ(cells.ok(), others.ok());
    if (cells.ok()) {
      EXPECT_EQ(cells->cells.size(), others->cells.size());
    }
  }
  ASSERT_FALSE(joint.cages.empty());
  for (std::size_t c = 0; c < joint.cages.size(); ++c) {
    EXPECT_GT(enclosedVolume({other.cages[c].rest_W, other.cages[c].triangles}), 0);
    for (std::size_t i = 0; i < joint.cages[c].moved_W.size(); ++i) {
      EXPECT_EQ(other.cages[c].moved_W[i], mirrored(joint.cages[c].moved_W[i]));
      EXPECT_EQ(other.cages[c].rest_W[i], mirrored(joint.cages[c].rest_W[i]));
    }
  }
}

TEST(MirrorJoint, whatWasProvedAndComputedHoldsOfTheMirrorImage) {
  Joint joint = freed();
  const Joint other = mirroredJoint(joint);
  ASSERT_TRUE(joint.startProof && other.startProof);
  EXPECT_EQ(other.startProof->of, startHash(other));
  const auto counted = checkStart(other);
  ASSERT_TRUE(counted.ok());
  EXPECT_EQ(counted->proof.cuts, joint.startProof->cuts);
  EXPECT_NEAR(counted->proof.minVolumeRatio, joint.startProof->minVolumeRatio, 1e-9);
  // A proof that was stale stays so.
  joint.startProof->of = std::string(32, 'a');
  EXPECT_EQ(mirroredJoint(joint).startProof->of, std::string(32, 'a'));

  // Dents: what stands for another set of meshes does not come to hold.
  joint.parts[1].dents = std::make_shared<const DentTable>(DentTable{{1e-3, 2e-3, 4e-3}, {{Vec3(0.01, 0.02, 0.03), 1e4, {1e-4, 5e-5, 2e-5}, 1e-3}}, dentBasis(joint, joint.parts[1])});
  joint.parts[2].dents = std::make_shared<const DentTable>(DentTable{{1e-3, 2e-3, 4e-3}, {{Vec3(0.01, 0.02, 0.03), 1e4, {1e-4, 5e-5, 2e-5}, 1e-3}}, "stale"});
  const Joint dented = mirroredJoint(joint);
  EXPECT_EQ(dented.parts[1].dents->basis, dentBasis(dented, dented.parts[1]));
  EXPECT_EQ(dented.parts[1].dents->samples[0].at_W, Vec3(0.01, 0.02, -0.03));
  EXPECT_EQ(dented.parts[2].dents->basis, "stale");
}

TEST(MirrorJoint, namesSayTheOtherSideAndIdsStay) {
  const Joint other = mirroredJoint(freed());
  EXPECT_EQ(other.name, "Right thing");
  EXPECT_EQ(other.parts[0].name, "RIGHT ball");
  EXPECT_EQ(other.parts[0].landmarks[0].name, "Tip of the right ball");
  EXPECT_EQ(other.id, "left-thing");
  EXPECT_EQ(other.description, freed().description);
  const SideWords words = sideWordsOf(freed());
  EXPECT_EQ(words.names, (std::vector<std::string>{"Left thing", "LEFT ball", "Tip of the left ball"}));
  EXPECT_EQ(words.ids, (std::vector<std::string>{"left-thing", "left-tip"}));
  EXPECT_EQ(words.sentences, std::vector<std::string>{freed().description});

  for (const auto& [word, opposite] : std::vector<std::pair<std::string, std::string>>{
           {"Ligamentum dextrum", "Ligamentum sinistrum"}, {"hombro derecho", "hombro izquierdo"}, {"left-right", "right-left"},
           {"leftover, bright, rightmost", "leftover, bright, rightmost"}, {"lEft", "lEft"}, {"", ""}, {"Knöchel left", "Knöchel right"}}) {
    EXPECT_EQ(otherSideIn(word), opposite);
    EXPECT_EQ(otherSideIn(opposite), word);
  }
  Joint unsaid;
  EXPECT_EQ(mirroredJoint(unsaid).side, JointSide::Unsaid);
}

/// A scenario in which everything that has a direction has one.
Scenario busyScenario() {
  Scenario scenario;
  scenario.name = "Left thing, pushed";
  scenario.fixedParts = {"ball"};
  scenario.gravity_W = Vec3(1, -9, 2);
  scenario.loads = {{"band", Vec3(0.01, 0.02, -0.03), Vec3::Zero(), {}}};
  scenario.motions = {{"ball", Vec3(0.001, 0, 0.002), {{0, Vec3::Zero(), Quat::Identity()},
                                                       {0.2, Vec3(1e-3, -2e-3, 3e-3), Quat(Eigen::AngleAxisd(0.2, Vec3(1, 2, 3).normalized()))}}}};
  Tool probe;
  probe.id = "probe";
  probe.name = "Probe of the left hand";
  probe.home.p_WB = Vec3(0.01, 0.005, 0.15);  // its facets are no mirror image of themselves: it touches nothing
  probe.home.q_WB = Quat(Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()));
  scenario.tools = {probe};
  scenario.cameras = {{"front", "From the left", Vec3(0.3, 0.1, 0.2), Vec3(0, 0, 0.01), Vec3(0, 1, 0.1), 0.5}};
  return scenario;
}

TEST(MirrorJoint, theMirroredRunIsTheMirrorImageOfTheRun) {
  Joint joint = freed();
  joint.couplings.clear();
  const Scenario scenario = busyScenario();
  Recording hands;
  hands.tracks = {{"probe", {{0, scenario.tools[0].home}, {0.1, scenario.tools[0].home}}}};
  hands.tracks[0].keys[1].hand.p_WB += Vec3(-0.004, 0.001, -0.006);
  hands.tracks[0].keys[1].hand.q_WB = Quat(Eigen::AngleAxisd(0.9, Vec3(1, -2, 0.7).normalized()));
  const auto stateOf = [](const Joint& j, const Scenario& s, const Recording& input) {
    const auto model = compileModel(j, s);
    EXPECT_TRUE(model.ok()) << toLogLine(model.error());
    RunOptions options;
    options.steps = 20;
    options.input = &input;
    auto run = runScenario(*model, options);
    EXPECT_TRUE(run.ok());
    EXPECT_GT(run->report.contacts.max, 0);
    return std::pair(*model, run->state);
  };
  const auto [model, state] = stateOf(joint, scenario, hands);
  const auto [otherModel, otherState] = stateOf(mirroredJoint(joint), mirroredScenario(scenario), mirroredRecording(hands));
  for (std::size_t i = 0; i < model->objects.size(); ++i) {
    const ObjectLayout &a = model->objects[i].layout, &b = otherModel->objects[i].layout;
    if (a.rigid) {
      EXPECT_LT((mirrored(state.q.segment<3>(a.qOffset)) - otherState.q.segment<3>(b.qOffset)).norm(), 1e-7) << model->objects[i].id;
      continue;
    }
    for (int n = 0; n < a.nodeCount; ++n)
      EXPECT_LT((mirrored(state.q.segment<3>(a.qOffset + 3 * n)) - otherState.q.segment<3>(b.qOffset + 3 * n)).norm(), 1e-7)
          << model->objects[i].id << " node " << n;
  }
}

TEST(MirrorJoint, scenarioAndRecordingTwiceAreTheSame) {
  const Scenario scenario = busyScenario(), other = mirroredScenario(scenario), back = mirroredScenario(other);
  EXPECT_EQ(other.gravity_W, Vec3(1, -9, -2));
  EXPECT_EQ(other.name, "Right thing, pushed");
  EXPECT_EQ(other.cameras[0].eye_W, Vec3(0.3, 0.1, -0.2));
  EXPECT_EQ(other.cameras[0].name, "From the right");
  EXPECT_EQ(back.name, scenario.name);
  EXPECT_EQ(back.gravity_W, scenario.gravity_W);
  EXPECT_EQ(back.loads, scenario.loads);
  EXPECT_EQ(back.motions, scenario.motions);
  EXPECT_EQ(back.tools[0].home.p_WB, scenario.tools[0].home.p_WB);
  EXPECT_EQ(back.tools[0].home.q_WB.coeffs(), scenario.tools[0].home.q_WB.coeffs());
  EXPECT_EQ(back.cameras[0].eye_W, scenario.cameras[0].eye_W);
  EXPECT_EQ(back.cameras[0].up_W, scenario.cameras[0].up_W);

  // Every point of a tool that is its own mirror image goes where the plane sends its partner.
  const Pose pose = scenario.tools[0].home, image = mirroredTool(pose);
  for (const Vec3& x : {Vec3(0.01, 0.02, 0.1), Vec3(0.003, 0, 0), Vec3(0, -0.01, 0.05)})
    EXPECT_LT((mirrored(pose * x) - image * Vec3(x.x(), -x.y(), x.z())).norm(), 1e-15);
  Recording recording;
  recording.jointHash = recording.stateHash = "of the other";
  EXPECT_TRUE(mirroredRecording(recording).stateHash.empty());
}

}  // namespace
}  // namespace glenoid
