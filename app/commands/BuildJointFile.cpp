// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/BuildJointFile.h"

#include <cstdio>
#include <filesystem>

#include "app/commands/Console.h"
#include "editor/core/ProblemSentences.h"
#include "simcore/author/BuildJoint.h"
#include "simcore/author/RigidAdvice.h"
#include "simcore/check/StartWarnings.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecipeFile.h"

namespace glenoid {
namespace {

/// What files of other programs lost and what was mended.
void printSources(const std::vector<SourceReport>& sources) {
  for (const SourceReport& source : sources) {
    std::printf("import: %s from %s (%s, %g m per unit), %ld triangles of %ld", source.part.c_str(), source.file.c_str(), source.format.c_str(),
                source.metresPerUnit, source.trianglesAfter, source.trianglesBefore);
    for (const NoteCount& note : source.notes) std::printf("; %s %ld", importNoteName(note.note), note.count);
    for (const RepairChange& change : source.changes) std::printf("; %s changed %ld, left %ld", toWord(change.step).c_str(), change.changed, change.left);
    std::putchar('\n');
  }
}

/// What was tried for two rigid parts that no cage can separate.
void printAdvice(const Part& a, const Part& b) {
  const RigidAdvice advice = adviseRigid(a, b);
  if (advice.surfacesOverlap) {
    std::printf("start:   both are rigid and their visual surfaces overlap too: move one of them, or exclude the pair\n");
    return;
  }
  if (advice.triangles > 0) std::printf("start:   tried: with %d collisionTriangles each they do not cut\n", advice.triangles);
  if (advice.clearance > 0) std::printf("start:   tried: with these and \"clearance\": %g in the recipe they do not cut\n", advice.clearance);
  if (advice.triangles == 0 && advice.clearance == 0)
    std::printf("start:   both are rigid, and neither more triangles nor a clearance keeps them apart: move one of them, or exclude the pair\n");
}

void printStart(const SeparationOutcome& start, const Joint& joint) {
  const StartProof& proof = start.check.proof;
  std::printf("start: %d overlaps up to %.2f mm deep before; %d sweeps moved %zu cages, surfaces by up to %.2f mm\n", start.overlapsBefore,
              start.depthBefore * 1e3, start.sweeps, start.movedParts.size(), start.maxShift * 1e3);
  std::printf("start: %d pairs of parts compared exactly: %d intersecting triangle pairs, %d of the visual surfaces; least volume ratio %.3f\n",
              proof.pairs, proof.cuts, proof.visualCuts, proof.minVolumeRatio);
  for (std::size_t i = 0; i < start.movedParts.size(); ++i)
    std::printf("start: cage of %s, by up to %.2f mm\n", start.movedParts[i].c_str(), start.shifts[i] * 1e3);
  for (const Overlap& overlap : start.check.overlaps) {
    const Part &a = joint.parts[overlap.partA], &b = joint.parts[overlap.partB];
    std::printf("start: %s and %s still cut each other in %zu places, %.2f mm deep\n", a.id.c_str(), b.id.c_str(), overlap.cuts.size(),
                overlap.depth * 1e3);
    if (a.kind == PartKind::Rigid && b.kind == PartKind::Rigid) printAdvice(a, b);
  }
  const auto warnings = startWarnings(joint);
  if (!warnings) return;  // the cages were just used: nothing can fail here that did not fail before
  for (const Problem& problem : *warnings) std::printf("start: warning: %s\n", sentenceOf(problem, joint).toUtf8().constData());
}

/// Collision surfaces that push the wrong way; whether there are any.
bool printCuts(const BuildReport& report) {
  bool any = false;
  for (const PartFigures& part : report.parts) {
    if (part.collisionCuts == 0) continue;
    any = true;
    std::printf("%s: its collision surface cuts itself (%d pairs of triangles). More collisionTriangles may help, or a thicker surface (\"thicken\")\n",
                part.part.c_str(), part.collisionCuts);
  }
  return any;
}

}  // namespace

Result<Done> buildJointFile(const std::string& recipeFile, const std::string& meshFolder, const std::string& out) {
  const std::string meshes = meshFolder.empty() ? (std::filesystem::path(recipeFile).parent_path() / "meshes").string() : meshFolder;
  std::vector<SourceReport> sources;
  const Result<JointRecipe> recipe = loadRecipe(recipeFile, meshes, &sources);
  if (!recipe) return recipe.error();
  printSources(sources);
  BuildReport report;
  Result<Joint> joint = Error{};
  {
    ProgressLine progress("Building " + recipe->name);
    joint = buildJoint(*recipe, [&](const std::string&, double done) {
      progress.show(done);
      return true;
    }, &report);
  }
  if (!joint) return joint.error();
  if (const auto saved = saveJoint(*joint, out); !saved) return saved.error();
  for (const Part& part : joint->parts) {
    std::printf("%3d  %-24s %6zu visual, %5zu collision", part.number, part.id.c_str(), part.visual->triangles.size(),
                part.collision->triangles.size());
    if (part.volume) std::printf(", %5zu tetrahedra in cells of %.2f mm", part.volume->tets.size(), part.cellSize * 1e3);
    std::putchar('\n');
  }
  for (const Coupling& coupling : joint->couplings)
    if (coupling.byNodes())
      std::printf("     %-24s %5zu nodes of %s hold to %s, %.4g N/m each\n", coupling.id.c_str(), coupling.nodesA.size(), coupling.partA.c_str(),
                  coupling.partB.c_str(), coupling.stiffnessPerNode);
  if (report.start) printStart(*report.start, *joint);
  const bool cuts = printCuts(report);
  std::printf("%s: hash %s\n", out.c_str(), jointHash(*joint).c_str());
  if (report.start && !report.start->check.holds())
    return Error{Fault::CheckFailed, {out, "", "", {}}, {"parts still cut each other at the start, listed above"}, "joint build"};
  if (cuts) return Error{Fault::CheckFailed, {out, "", "", {}}, {"a collision surface cuts itself, listed above"}, "joint build"};
  return Done{};
}

}  // namespace glenoid
