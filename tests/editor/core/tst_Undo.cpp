// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is edited in whatever order: undo all gives the bytes of the start, redo all those of the end.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <random>

#include "editor/core/FrozenScene.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/JointEdits.h"
#include "editor/core/PartEdits.h"
#include "editor/core/SameScene.h"
#include "simcore/file/Json.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/ScenarioJson.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/check/Faults.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

/// What a scene is on disk.
struct Bytes {
  std::string joint, scenario, hash;
  bool operator==(const Bytes&) const = default;
};
Bytes bytesOf(const Document& document) {
  const TemporaryFolder folder;
  const auto saved = saveJoint(document.joint(), folder.path("s.joint"));
  EXPECT_TRUE(saved.ok()) << toLogLine(saved.error());
  const auto also = saveScenario(document.scenario(), folder.path("s.scenario.json"));
  EXPECT_TRUE(also.ok()) << toLogLine(also.error());
  return {folder.get("s.joint/joint.json"), folder.get("s.scenario.json"), jointHash(document.joint())};
}

/// One random wish after another; ids and values are drawn from what the joint holds now. Answers whether a step came.
class Editor {
 public:
  Editor(Document& document, unsigned seed) : m_document(document), m_random(seed) {}

  static constexpr int kKinds = 38;
  bool step(int kind) {
    const int before = m_document.undoStack().index();
    wish(kind);
    return m_document.undoStack().index() > before;
  }

 private:
  int draw(int below) { return below <= 0 ? 0 : std::uniform_int_distribution<int>(0, below - 1)(m_random); }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }
  std::string fresh(const char* what) { return std::string(what) + std::to_string(++m_count); }
  const Joint& joint() const { return m_document.joint(); }
  const Part& part() { return joint().parts[draw(static_cast<int>(joint().parts.size()))]; }
  const Part* soft() {
    std::vector<const Part*> list;
    for (const Part& each : joint().parts)
      if (each.kind == PartKind::Soft) list.push_back(&each);
    return list.empty() ? nullptr : list[draw(static_cast<int>(list.size()))];
  }

  std::vector<int> triangles() {  // all surfaces here have twelve or more
    const int first = draw(8);
    return {first, first + 1, first + 3};
  }
  std::pair<std::string, const Region*> anyRegion() {
    const Part& chosen = part();
    if (chosen.regions.empty()) return {chosen.id, nullptr};
    return {chosen.id, &chosen.regions[draw(static_cast<int>(chosen.regions.size()))]};
  }

  void wish(int kind) {
    switch (kind) {
      case 0: renamePart(m_document, part().id, QString::fromStdString(fresh("Name "))); break;
      case 1: setPartNumber(m_document, part().id, 1 + draw(200)); break;
      case 2:
        setPartColor(m_document, part().id, {static_cast<float>(number(0, 1)), 0.25f, 0.5f});
        m_document.endGesture();
        break;
      case 3: {
        const Material& material = joint().materials[draw(static_cast<int>(joint().materials.size()))];
        std::vector<MaterialUse> uses = part().materials;
        const std::string id = part().id;
        uses[0].material = material.id;
        setPartMaterials(m_document, id, {uses[0]});
        break;
      }
      case 4: {
        Part copy = part();
        copy.id = fresh("part");
        copy.number = 1000 + m_count;
        addPart(m_document, copy);
        break;
      }
      case 5:
        if (joint().parts.size() > 2) removePart(m_document, part().id);
        break;
      case 6: {
        const Part& chosen = part();
        const SurfaceKind surface = draw(2) ? SurfaceKind::Visual : SurfaceKind::Collision;
        TriMesh mesh = *(surface == SurfaceKind::Visual ? chosen.visual : chosen.collision);
        mesh.vertices[draw(static_cast<int>(mesh.vertices.size()))].x() += 1e-6;
        if (draw(3) == 0) mesh = scenes::boxSurface(Vec3(0, 0, 0), Vec3(0.02, 0.03, 0.04), 1);  // fewer: regions go
        setPartSurface(m_document, chosen.id, surface, std::make_shared<const TriMesh>(mesh));
        break;
      }
      case 7:
        if (const Part* chosen = soft()) {
          TetMesh mesh = *chosen->volume;
          for (Vec3& node : mesh.nodes) node *= 1 + 1e-6;
          if (draw(2))
            setPartVolume(m_document, chosen->id, std::make_shared<const TetMesh>(mesh), number(0.001, 0.02));
          else
            setPartElements(m_document, chosen->id, chosen->elements == Elements::Cells ? Elements::Tetrahedra : Elements::Cells);
        }
        break;
      case 8: {
        const Part& chosen = part();
        if (chosen.kind == PartKind::Soft) {
          setPartKind(m_document, chosen.id, PartKind::Rigid);
        } else {
          setPartKind(m_document, chosen.id, PartKind::Soft,
                      std::make_shared<const TetMesh>(scenes::boxVolume(Vec3(0, 0, 0), Vec3(0.02, 0.02, 0.02), 1, 1, 1)), 0.02);
        }
        break;
      }
      case 9: {
        Material material;
        material.id = fresh("material");
        material.name = fresh("Stuff ");
        addMaterial(m_document, material);
        break;
      }
      case 10: {
        Material material = joint().materials[draw(static_cast<int>(joint().materials.size()))];
        material.friction = number(0, 1);
        material.poissonRatio = number(0, 0.49);
        setMaterial(m_document, material);
        break;
      }
      case 11: removeMaterial(m_document, joint().materials[draw(static_cast<int>(joint().materials.size()))].id); break;
      case 12: addExclusion(m_document, {part().id, part().id, fresh("because ")}); break;
      case 13:
        if (!joint().exclusions.empty()) {
          const Exclusion exclusion = joint().exclusions[draw(static_cast<int>(joint().exclusions.size()))];
          removeExclusion(m_document, exclusion.partB, exclusion.partA);
        }
        break;
      case 14:
        if (const Part* chosen = soft()) setCage(m_document, boxCage(*chosen, number(1e-3, 5e-3)), QStringLiteral("cage"));
        break;
      case 15:
        if (!joint().cages.empty()) removeCage(m_document, joint().cages[draw(static_cast<int>(joint().cages.size()))].part);
        break;
      case 16:
        if (!joint().cages.empty()) {  // a drag: many moves, one step
          const Cage cage = joint().cages[draw(static_cast<int>(joint().cages.size()))];
          std::vector<Vec3> handles = cage.moved_W;
          const int handle = draw(static_cast<int>(handles.size()));
          for (int i = 0; i < 5; ++i) {
            handles[handle] += Vec3(1e-4, 0, -1e-4);
            moveHandles(m_document, cage.part, handles, QStringLiteral("drag"));
          }
          m_document.endGesture();
        }
        break;
      case 17:
        m_document.setYoungsModulus(joint().materials[draw(static_cast<int>(joint().materials.size()))].id, number(1e3, 1e6));
        m_document.endGesture();
        break;
      case 18:
        if (!joint().couplings.empty()) {
          m_document.setCouplingStiffness(joint().couplings[draw(static_cast<int>(joint().couplings.size()))].id, number(1e6, 1e9));
          m_document.endGesture();
        }
        break;
      case 19: m_document.setProfile(static_cast<Profile>(draw(3))); break;
      case 20: {  // what a job would bring: the whole joint at once
        Joint other = joint();
        other.name = fresh("Joint ");
        other.startProof = StartProof{startHash(other), draw(10), 0, 0, number(0.1, 1)};
        m_document.edit("job", changesBetween(joint(), other), [&](Scene& scene) { scene.joint = other; });
        break;
      }
      case 21: {
        const Joint before = joint();
        Joint other = before;
        if (other.couplings.size() < 4 && !other.couplings.empty()) {
          Coupling copy = other.couplings[0];
          copy.id = fresh("coupling");
          other.couplings.push_back(copy);
          m_document.edit("coupling", changesBetween(before, other), [&](Scene& scene) { scene.joint = other; });
        }
        break;
      }
      case 22: addRegion(m_document, part().id, QString::fromStdString(fresh("Patch ")), SurfaceKind::Collision, triangles()); break;
      case 23:
        if (const auto [owner, region] = anyRegion(); region) setRegion(m_document, owner, region->id, region->surface, triangles());
        break;
      case 24:
        if (const auto [owner, region] = anyRegion(); region)
          renameRegion(m_document, owner, region->id, QString::fromStdString(fresh("Spot ")));
        break;
      case 25:
        if (const auto [owner, region] = anyRegion(); region) removeRegion(m_document, owner, region->id);
        break;
      case 26: addCoupling(m_document, {part().id, part().id, {}, SurfaceKind::Visual, triangles(), number(1e6, 1e9), 1e-3, {}}); break;
      case 27:
        if (!joint().couplings.empty()) removeCoupling(m_document, joint().couplings[draw(static_cast<int>(joint().couplings.size()))].id);
        break;
      case 28:
        if (!joint().couplings.empty())
          setCouplingReason(m_document, joint().couplings[draw(static_cast<int>(joint().couplings.size()))].id,
                            QString::fromStdString(fresh("because ")));
        break;
      case 29:
        if (!joint().couplings.empty())
          setCouplingDamping(m_document, joint().couplings[draw(static_cast<int>(joint().couplings.size()))].id, number(1e-4, 1e-2));
        m_document.endGesture();
        break;
      case 30: ownMaterial(m_document, part().id); break;
      case 31: setStart(m_document, {}, StartProof{startHash(joint()), draw(9), 0, 0, 1}, QStringLiteral("start")); break;
      case 32: renameJoint(m_document, QString::fromStdString(fresh("Left joint "))); break;
      case 33: describeJoint(m_document, QString::fromStdString(fresh("what it is "))); break;
      case 34: setJointLicence(m_document, QString::fromStdString(fresh("CC-"))); break;
      case 35: setJointAuthor(m_document, QString::fromStdString(fresh("somebody "))); break;
      case 36: setJointSide(m_document, static_cast<JointSide>(draw(3))); break;
      case 37: mirrorJoint(m_document); break;
    }
  }

  Document& m_document;
  std::mt19937 m_random;
  int m_count = 0;
};

class Undo : public testing::TestWithParam<unsigned> {};

TEST_P(Undo, ofEverythingGivesTheSameBytesAndRedoToo) {
  Document document;
  Scenario scenario = scenes::figure4Scenario();
  scenario.joint = "s.joint";
  document.open({soundJoint(), scenario, nullptr}, "a");
  Editor editor(document, GetParam());
  std::mt19937 order(GetParam() + 1000);
  // Between the ends the joint's hash, which is over the text of joint.json and every mesh, stands for the files.
  const auto stateOf = [&document] {
    const auto good = checkJoint(document.joint(), {});
    EXPECT_TRUE(good.ok()) << toLogLine(good.error());
    return jointHash(document.joint()) + toText(scene_json::fromScenario(document.scenario()));
  };
  const Bytes first = bytesOf(document);
  std::vector<std::string> states{stateOf()};
  for (int i = 0; i < 70; ++i) {
    const int kind = std::uniform_int_distribution<int>(0, Editor::kKinds - 1)(order);
    const int before = document.undoStack().index();
    if (!editor.step(kind)) continue;
    ASSERT_EQ(document.undoStack().index(), before + 1) << "one wish is one step, kind " << kind;
    states.push_back(stateOf());
    if (HasFailure()) FAIL() << "kind " << kind << " made a joint that cannot be saved";
    if (std::uniform_int_distribution<int>(0, 9)(order) == 0) {  // back and forth on the way
      document.undoStack().undo();
      document.undoStack().redo();
    }
  }
  const Bytes last = bytesOf(document);
  ASSERT_GT(states.size(), 30u);
  ASSERT_EQ(document.undoStack().count(), static_cast<int>(states.size()) - 1);
  document.saved(QStringLiteral("saved on the way"));
  EXPECT_TRUE(document.undoStack().isClean());
  for (int i = document.undoStack().count() - 1; i >= 0; --i) {
    document.undoStack().undo();
    ASSERT_EQ(stateOf(), states[i]) << "after undoing step " << i << ": " << document.undoStack().redoText().toStdString();
  }
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_EQ(bytesOf(document), first);
  for (std::size_t i = 1; i < states.size(); ++i) {
    document.undoStack().redo();
    ASSERT_EQ(stateOf(), states[i]) << "after redoing step " << i;
  }
  EXPECT_FALSE(document.undoStack().canRedo());
  EXPECT_EQ(bytesOf(document), last);
  EXPECT_TRUE(document.undoStack().isClean()) << "the step that was saved is known across undo";
}

INSTANTIATE_TEST_SUITE_P(Seeds, Undo, testing::Range(1u, 13u));

TEST(UndoKinds, everyKindOfEditWasMadeByTheSeedsAbove) {
  std::vector<int> made(Editor::kKinds, 0);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Document document;
    document.open({soundJoint(), scenes::figure4Scenario(), nullptr}, "a");
    Editor editor(document, seed);
    std::mt19937 order(seed + 1000);
    for (int i = 0; i < 70; ++i) {
      const int kind = std::uniform_int_distribution<int>(0, Editor::kKinds - 1)(order);
      made[kind] += editor.step(kind);
    }
  }
  for (int kind = 0; kind < Editor::kKinds; ++kind) EXPECT_GT(made[kind], 0) << "kind " << kind << " is never made";
}

TEST(UndoCost, aSceneOfHalfAMillionTrianglesIsCopiedByItsIds) {
  Joint joint = soundJoint();
  // 6 · 289² · 2 triangles on one part, and a region with a run for every other triangle of a patch.
  Part& part = joint.parts[0];
  const Box3 box = boundsOf(*part.visual);
  part.visual = std::make_shared<const TriMesh>(scenes::boxSurface(box.min(), box.max(), 205));
  ASSERT_GT(part.visual->triangles.size(), 500000u);
  Region sieve{"sieve", "Sieve", "other", SurfaceKind::Visual, {}};
  for (int t = 0; t < 50000; t += 2) sieve.triangles.push_back({t, 1});
  part.regions.push_back(sieve);
  joint.cages = {boxCage(softPart(joint), 2e-3)};
  Document document;
  const auto mesh = part.visual;
  document.open({std::move(joint), scenes::figure4Scenario(), nullptr}, "a");
  const long sharedBefore = mesh.use_count();
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < 1000; ++i) {
    document.setYoungsModulus("tissue", 1000 + i);
    document.endGesture();
  }
  const qint64 edits = clock.restart();
  EXPECT_EQ(document.undoStack().count(), 1000);
  EXPECT_EQ(mesh.use_count(), sharedBefore) << "what a step did not touch is kept once for all of them";
  EXPECT_EQ(document.joint().parts[0].visual, mesh);
  while (document.undoStack().canUndo()) document.undoStack().undo();
  const qint64 undone = clock.elapsed();
  EXPECT_EQ(document.joint().parts[0].visual, mesh);
  RecordProperty("editsMs", static_cast<int>(edits));
  std::printf("1000 edits: %lld ms, 1000 undos: %lld ms\n", static_cast<long long>(edits), static_cast<long long>(undone));
  // A copy of the mesh alone would take 1000 × 9 MB; the regions' runs would, 1000 × 0.2 MB.
  EXPECT_LT(edits, 2000);
  EXPECT_LT(undone, 2000);
}

TEST(UndoCost, aStepKeepsOnlyWhatItChanged) {
  Document document;
  document.open({soundJoint(), scenes::figure4Scenario(), nullptr}, "a");
  const auto before = FrozenScene::of(document.scene(), nullptr);
  Scene scene = document.scene();
  scene.joint.parts[1].name = "other";
  const auto after = FrozenScene::of(scene, before.get());
  ASSERT_EQ(after->parts().size(), before->parts().size());
  for (std::size_t i = 0; i < after->parts().size(); ++i) EXPECT_EQ(after->parts()[i] == before->parts()[i], i != 1) << i;
  EXPECT_TRUE(sameJoint(after->thaw().joint, scene.joint));
  EXPECT_TRUE(sameJoint(before->thaw().joint, document.joint()));
}

}  // namespace
}  // namespace glenoid
