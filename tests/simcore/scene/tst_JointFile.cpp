// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/JointFile.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/file/Ply.h"
#include "simcore/scene/DraftFile.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

namespace glenoid {
namespace {

/// The sample saved, its joint.json changed as text, loaded again.
struct Saved {
  TemporaryFolder folder;
  std::string joint = folder.path("s.joint");
  std::string json = joint + "/joint.json";

  Saved() { EXPECT_TRUE(saveJoint(sampleJoint(), joint).ok()); }

  void replace(const std::string& what, const std::string& by) {
    std::string text = folder.get("s.joint/joint.json");
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    folder.put("s.joint/joint.json", text.replace(at, what.size(), by));
  }
  Error fault() const {
    const auto loaded = loadJoint(joint);
    EXPECT_FALSE(loaded.ok());
    return loaded.ok() ? Error{} : loaded.error();
  }
  std::string blob(const std::string& ending) const {
    for (const auto& entry : std::filesystem::directory_iterator(joint + "/meshes"))
      if (entry.path().extension() == ending) return entry.path().string();
    return {};
  }
};

TEST(JointFile, whatIsSavedComesBack) {
  const Saved saved;
  const auto back = loadJoint(saved.joint);
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  expectSame(*back, sampleJoint());
  EXPECT_EQ(jointHash(*back), jointHash(sampleJoint()));
  EXPECT_EQ(back->parts[0].visual, back->parts[0].collision);  // one file, one mesh in memory
  EXPECT_TRUE(std::signbit(back->parts[0].landmarks[0].position_W.z()));
}

TEST(JointFile, savingAgainGivesTheSameBytes) {
  const Saved saved;
  const std::string before = saved.folder.get("s.joint/joint.json");
  ASSERT_TRUE(saveJoint(*loadJoint(saved.joint), saved.joint).ok());
  EXPECT_EQ(saved.folder.get("s.joint/joint.json"), before);
  EXPECT_EQ(saved.folder.fileCount(), 5u);  // joint.json, three surfaces, one volume
}

TEST(JointFile, partsAreSortedByNumber) {
  Joint joint = sampleJoint();
  std::swap(joint.parts[0], joint.parts[1]);
  EXPECT_EQ(jointHash(joint), jointHash(sampleJoint()));
  const TemporaryFolder folder;
  ASSERT_TRUE(saveJoint(joint, folder.path("s.joint")).ok());
  const auto back = loadJoint(folder.path("s.joint"));
  ASSERT_TRUE(back.ok());
  expectSame(*back, sampleJoint());
}

TEST(JointFile, theHashSeesEveryValueAndEveryMesh) {
  const std::string hash = jointHash(sampleJoint());
  EXPECT_EQ(hash.size(), 32u);
  const std::vector<std::function<void(Joint&)>> changes = {
      [](Joint& j) { j.materials[1].friction = std::nextafter(0.1, 1); },
      [](Joint& j) { j.parts[0].color[2] = 0.5f; },
      [](Joint& j) { j.parts[1].regions[0].triangles[0].count = 2; },
      [](Joint& j) { j.couplings[0].damping = 0; },
      [](Joint& j) { j.exclusions.clear(); },
      [](Joint& j) { j.side = JointSide::Right; },
      [](Joint& j) { j.description.clear(); },
      [](Joint& j) { j.axes_W = Mat3::Identity(); },
      [](Joint& j) { j.bursae[0].roof[0].region = "head"; },
      [](Joint& j) { j.cages[0].moved_W[0].x() = std::nextafter(j.cages[0].moved_W[0].x(), 1); },
      [](Joint& j) { j.startProof->cuts = 1; },
      [](Joint& j) { j.couplings[0].reason.clear(); },
      [](Joint& j) { j.materials[1].appearance = Appearance::Ligament; },
      [](Joint& j) { j.provenance.license = "MIT"; },
      [](Joint& j) { j.parts[1].volume.reset(); },
      [](Joint& j) {
        TriMesh mesh = *j.parts[1].collision;
        mesh.vertices[2].x() = std::nextafter(mesh.vertices[2].x(), 1);
        j.parts[1].collision = std::make_shared<const TriMesh>(mesh);
      }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Joint joint = sampleJoint();
    changes[i](joint);
    EXPECT_NE(jointHash(joint), hash) << i;
  }
}

TEST(JointFile, onlyBlobsOfTheOlderSaveAreRemoved) {
  Saved saved;
  saved.folder.put("s.joint/notes.txt", "mine");
  saved.folder.put("s.joint/meshes/other.ply", "mine too");
  const std::string volume = saved.blob(".vtk");
  Joint joint = sampleJoint();
  joint.parts.pop_back();
  joint.couplings.clear();
  joint.exclusions.clear();
  joint.bursae.clear();
  joint.cages.clear();
  ASSERT_TRUE(saveJoint(joint, saved.joint).ok());
  EXPECT_FALSE(std::filesystem::exists(volume));
  EXPECT_EQ(saved.folder.get("s.joint/notes.txt"), "mine");
  EXPECT_EQ(saved.folder.get("s.joint/meshes/other.ply"), "mine too");
  EXPECT_EQ(saved.folder.fileCount(), 4u);
  EXPECT_TRUE(loadJoint(saved.joint).ok());
}

TEST(JointFile, aDamagedBlobOfTheRightNameIsWrittenAnew) {
  const Saved saved;
  ASSERT_TRUE(writeWholeFile(saved.blob(".ply"), "ply\nbroken").ok());
  ASSERT_FALSE(loadJoint(saved.joint).ok());
  ASSERT_TRUE(saveJoint(sampleJoint(), saved.joint).ok());
  EXPECT_TRUE(loadJoint(saved.joint).ok());
}

TEST(JointFile, aSaveThatFailsLeavesTheOldJoint) {
  Saved saved;
  Joint joint = sampleJoint();
  joint.materials[0].density = std::numeric_limits<double>::quiet_NaN();
  const auto refused = saveJoint(joint, saved.joint);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().fault, Fault::NotFinite);
  EXPECT_EQ(refused.error().place.pointer, "/materials/0/density");
  // A folder where joint.json should come: meshes are written, the last step fails.
  const TemporaryFolder other;
  std::filesystem::create_directories(other.path("s.joint/joint.json"));
  EXPECT_EQ(saveJoint(sampleJoint(), other.path("s.joint")).error().fault, Fault::FileUnwritable);
  EXPECT_EQ(saveJoint(sampleJoint(), other.path("no/such.joint")).error().fault, Fault::FileMissing);
  expectSame(*loadJoint(saved.joint), sampleJoint());
}

TEST(JointFile, aJointOfTheFirstSchemaIsReadAndKeptBesideItsSuccessor) {
  Saved saved;
  saved.replace("\"schemaVersion\": 2", "\"schemaVersion\": 1");
  const std::string old = saved.folder.get("s.joint/joint.json");
  const auto loaded = loadJoint(saved.joint);
  ASSERT_TRUE(loaded.ok()) << toLogLine(loaded.error());
  EXPECT_EQ(jointHash(*loaded), jointHash(sampleJoint())) << "the form of the file is no content";
  EXPECT_FALSE(std::filesystem::exists(saved.joint + "/joint.v1.json")) << "reading changes nothing";

  Joint joint = *loaded;  // another mesh, so that the old one is no longer named by joint.json
  TriMesh mesh = *joint.parts[1].visual;
  mesh.vertices[0].x() += 1e-3;
  joint.parts[1].visual = std::make_shared<const TriMesh>(mesh);
  ASSERT_TRUE(saveJoint(joint, saved.joint).ok());
  EXPECT_EQ(saved.folder.get("s.joint/joint.v1.json"), old);
  EXPECT_NE(saved.folder.get("s.joint/joint.json").find("\"schemaVersion\": 2"), std::string::npos);
  EXPECT_EQ(jointHash(*loadJoint(saved.joint)), jointHash(joint));

  // Later saves leave the copy and its meshes alone; it can still be opened.
  joint.name = "again";
  ASSERT_TRUE(saveJoint(joint, saved.joint).ok());
  EXPECT_EQ(saved.folder.get("s.joint/joint.v1.json"), old);
  saved.folder.put("s.joint/joint.json", old);
  const auto back = loadJoint(saved.joint);
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  expectSame(*back, sampleJoint());
}

TEST(DraftFile, keepsWhatCannotBeSavedAndWritesEachMeshOnce) {
  const TemporaryFolder folder;
  Joint joint = sampleJoint();
  joint.parts[0].materials.clear();
  joint.parts[1].volume.reset();
  joint.couplings[0].regionA = "nowhere";
  Scenario scenario;
  scenario.id = "s";
  scenario.fixedParts = {"humerus", "ghost"};
  EXPECT_FALSE(checkJoint(joint, {}).ok());
  for (const char* name : {"1", "2"}) {
    std::filesystem::create_directory(folder.path(name));
    const auto saved = saveDraft({joint, scenario}, folder.path(name), folder.path("blobs"));
    ASSERT_TRUE(saved.ok()) << toLogLine(saved.error());
    const auto back = loadDraft(folder.path(name));
    ASSERT_TRUE(back.ok()) << toLogLine(back.error());
    expectSame(back->joint, joint);
    EXPECT_EQ(back->scenario.fixedParts, scenario.fixedParts);
  }
  for (const auto& blob : std::filesystem::directory_iterator(folder.path("blobs")))
    EXPECT_EQ(std::filesystem::hard_link_count(blob.path()), 3u) << blob.path();
  EXPECT_EQ(loadDraft(folder.path("3")).error().fault, Fault::FileMissing);
  EXPECT_EQ(saveDraft({joint, scenario}, folder.path("3"), folder.path("blobs")).error().fault, Fault::FileMissing);
}

TEST(JointFile, foldersAndFilesThatAreNotThere) {
  Saved saved;
  const Error missing = [&] {
    const auto loaded = loadJoint(saved.folder.path("none.joint"));
    return loaded.error();
  }();
  EXPECT_EQ(missing.fault, Fault::FileMissing);
  EXPECT_EQ(missing.place.file, saved.folder.path("none.joint"));
  EXPECT_TRUE(loadJoint(saved.json).ok()) << "joint.json stands for its folder";
  const std::string blob = saved.blob(".vtk");
  std::filesystem::remove(blob);
  EXPECT_EQ(saved.fault().fault, Fault::FileMissing);
  EXPECT_EQ(saved.fault().place.file, blob);
  EXPECT_EQ(saved.fault().place.part, "cuff");
  saved.folder.put("s.joint/joint.json", "");
  EXPECT_EQ(saved.fault().fault, Fault::FileEmpty);
  EXPECT_EQ(saved.fault().place.file, saved.json);
  saved.folder.put("s.joint/joint.json", std::string(100000, '['));
  EXPECT_EQ(saved.fault().fault, Fault::TooDeep);
  std::filesystem::remove(saved.json);
  EXPECT_EQ(saved.fault().fault, Fault::FileMissing);
  EXPECT_EQ(saved.fault().place.file, saved.json);
}

/// One text replaced by another, and the one answer that fits.
struct Slip {
  const char *what, *by;
  Fault fault;
  const char *pointer, *part;
  Arguments arguments;
};

TEST(JointFile, everySlipIsNamedWithItsPlace) {
  const std::vector<Slip> slips = {
      {"\"schemaVersion\": 2", "\"schemaVersion\": 3", Fault::NewerSchema, "/schemaVersion", "", {"3", "2"}},
      {"\"massDamping\": 0.7", "\"massDamping\": NaN", Fault::NotFinite, "/materials/1/massDamping", "", {}},
      {"\"massDamping\": 0.7",
       "\"massDamping\": -1",
       Fault::OutOfRange,
       "/materials/1/massDamping",
       "",
       {"-1", "0", ""}},
      {"\"poissonRatio\": 0.45",
       "\"poissonRatio\": 0.5",
       Fault::OutOfRange,
       "/materials/1/poissonRatio",
       "",
       {"0.5", "0", "0.4999"}},
      {"\"number\": 5", "\"number\": 3", Fault::DuplicateId, "/parts/1/number", "cuff", {"3"}},
      {"\"number\": 5", "\"number\": 0", Fault::OutOfRange, "/parts/1/number", "", {"0", "1", "1000000"}},
      {"\"id\": \"cuff\"", "\"id\": \"humerus\"", Fault::DuplicateId, "/parts/1/id", "", {"humerus"}},
      {"\"id\": \"tendon\"", "\"id\": \"bone\"", Fault::DuplicateId, "/materials/1/id", "", {"bone"}},
      {"\"id\": \"empty\"",
       "\"id\": \"insertion\"",
       Fault::DuplicateId,
       "/parts/1/regions/1/id",
       "cuff",
       {"insertion"}},
      {"{\"material\": \"bone\"}",
       "{\"material\": \"cork\"}",
       Fault::UnknownId,
       "/parts/0/materials/0/material",
       "humerus",
       {"cork", "material"}},
      {"\"region\": \"insertion\"",
       "\"region\": \"elsewhere\"",
       Fault::UnknownId,
       "/parts/1/materials/1/region",
       "cuff",
       {"elsewhere", "region"}},
      {"\"regionA\": \"insertion\"",
       "\"regionA\": \"head\"",
       Fault::UnknownId,
       "/couplings/0/regionA",
       "cuff-humerus",
       {"head", "region"}},
      {"\"partB\": \"humerus\"",
       "\"partB\": \"ulna\"",
       Fault::UnknownId,
       "/couplings/0/partB",
       "cuff-humerus",
       {"ulna", "part"}},
      {"\"partB\": \"humerus\"",
       "\"partB\": \"cuff\"",
       Fault::BadReference,
       "/couplings/0/partB",
       "cuff-humerus",
       {"cuff"}},
      {"\"part\": \"humerus\"", "\"part\": \"ulna\"", Fault::UnknownId, "/bursae/0/roof/0/part", "sac", {"ulna", "part"}},
      {"\"region\": \"empty\"", "\"region\": \"full\"", Fault::UnknownId, "/bursae/0/floor/0/region", "sac", {"full", "region"}},
      {"\"part\": \"humerus\"",
       "\"region\": \"head\", \"part\": \"humerus\"",
       Fault::BadReference,
       "/bursae/0/roof/0/region",
       "sac",
       {"head"}},
      {"\"partA\": \"humerus\"",
       "\"partA\": \"ulna\"",
       Fault::UnknownId,
       "/exclusions/0/partA",
       "",
       {"ulna", "part"}},
      {"[[0, 1], [2, 2]]",
       "[[0, 3], [2, 2]]",
       Fault::OutOfRange,
       "/parts/0/regions/0/triangles/1",
       "humerus",
       {"2", "3", ""}},
      {"[[0, 1], [2, 2]]",
       "[[0, 1], [2, 0]]",
       Fault::OutOfRange,
       "/parts/0/regions/0/triangles/1",
       "humerus",
       {"0", "1", ""}},
      {"[[0, 1], [2, 2]]",
       "[[0, 1], [2, 3]]",
       Fault::BadIndex,
       "/parts/0/regions/0/triangles/1",
       "humerus",
       {"4", "4"}},
      {"[[0, 1], [2, 2]]",
       "[[0, 1], [2147483647, 2147483647]]",
       Fault::BadIndex,
       "/parts/0/regions/0/triangles/1",
       "humerus",
       {"4294967293", "4"}},
      {"\"kind\": \"soft\"",
       "\"kind\": \"rigid\"",
       Fault::BadMesh,
       "/parts/1/volume",
       "cuff",
       {"a rigid part has no volume mesh"}},
      {"\"kind\": \"rigid\"",
       "\"kind\": \"soft\"",
       Fault::BadMesh,
       "/parts/0/volume",
       "humerus",
       {"a soft part needs a volume mesh"}},
      {"\"visual\": \"meshes/",
       "\"visual\": \"meshes/../../",
       Fault::BadReference,
       "/parts/0/visual",
       "humerus",
       {}},
      {"\"visual\": \"meshes/",
       "\"visual\": \"/meshes/",
       Fault::BadReference,
       "/parts/0/visual",
       "humerus",
       {}},
      {".vtk\"", ".ply\"", Fault::BadReference, "/parts/1/volume", "cuff", {}},
      {"\"density\": 1000", "\"weight\": 1000", Fault::SchemaMismatch, "/materials/1", "", {}},
      {"\"stiffnessPerArea\": 2e+07",
       "\"stiffnessPerArea\": \"stiff\"",
       Fault::SchemaMismatch,
       "/couplings/0/stiffnessPerArea",
       "",
       {"must be of type number"}},
      {"\"name\": \"Cuff\"", "\"id\": \"Cuff\"", Fault::DuplicateId, "/parts/1/id", "", {"id"}},
  };
  for (const Slip& slip : slips) {
    Saved saved;
    saved.replace(slip.what, slip.by);
    const Error error = saved.fault();
    EXPECT_EQ(error.fault, slip.fault) << slip.by << " " << toLogLine(error);
    EXPECT_EQ(error.place.file, saved.json) << slip.by;
    EXPECT_EQ(error.place.pointer, slip.pointer) << slip.by;
    EXPECT_EQ(error.place.part, slip.part) << slip.by;
    if (!slip.arguments.empty()) {
      EXPECT_EQ(error.arguments, slip.arguments) << slip.by;
    }
  }
}

TEST(JointFile, aMeshThatIsNotWhatItsNameSays) {
  const Saved saved;
  const Joint joint = sampleJoint();
  const std::string collision =
      saved.joint + "/meshes/" + toHex(contentHash(*joint.parts[1].collision)) + ".ply";
  ASSERT_TRUE(writePly(collision, *joint.parts[1].visual).ok());
  const Error error = saved.fault();
  EXPECT_EQ(error.fault, Fault::HashMismatch);
  EXPECT_EQ(error.place.file, collision);
  EXPECT_EQ(error.place.part, "cuff");
  EXPECT_EQ(error.arguments, (Arguments{toHex(contentHash(*joint.parts[1].visual)),
                                        toHex(contentHash(*joint.parts[1].collision))}));
}

TEST(JointFile, aTetrahedronWithoutVolumeIsNamed) {
  const Saved saved;
  const std::string flat =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
      "0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  const std::string blob = saved.blob(".vtk");
  ASSERT_TRUE(writeWholeFile(blob, flat).ok());
  const Error error = saved.fault();
  EXPECT_EQ(error.fault, Fault::BadElement);
  EXPECT_EQ(error.place.file, blob);
  EXPECT_EQ(error.place.part, "cuff");
  EXPECT_EQ(error.place.element, 0);
}

TEST(JointFile, aJointInMemoryIsJudgedAlike) {
  EXPECT_TRUE(checkJoint(sampleJoint(), "j").ok());
  Joint joint = sampleJoint();
  joint.parts[1].visual.reset();
  const auto noMesh = checkJoint(joint, "j");
  ASSERT_FALSE(noMesh.ok());
  EXPECT_EQ(noMesh.error().fault, Fault::BadMesh);
  EXPECT_EQ(noMesh.error().place.part, "cuff");
  EXPECT_EQ(noMesh.error().place.pointer, "/parts/1/visual");
  joint = sampleJoint();
  joint.parts[0].materials.clear();
  EXPECT_EQ(checkJoint(joint, "j").error().fault, Fault::Unusable);
  joint = sampleJoint();
  joint.couplings[0].stiffnessPerArea = 0;
  EXPECT_EQ(checkJoint(joint, "j").error().fault, Fault::OutOfRange);
}

}  // namespace
}  // namespace glenoid
