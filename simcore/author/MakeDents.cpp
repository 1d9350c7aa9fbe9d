// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeDents.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <thread>

#include "simcore/author/CellsShown.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

constexpr double kSpacing = 0.016;       ///< m, of places, as far as their number allows; what DentPlaces says
constexpr std::size_t kFirstPlaces = 8;  ///< on a tissue; then twice as many, and so on while they tell more
constexpr double kForetold = 0.1;        ///< of a compliance: between places that differ from their neighbours by less than this more tell no more
constexpr double kSurprises = 0.1;       ///< share of the places that may differ by more
constexpr double kElements = 1500;   ///< cells of the whole part, about
constexpr double kStandsFor = 0.5;     ///< of a part's volume: fine cells that hold less do not stand for it
constexpr double kLeastShare = 0.02;     ///< of a half-space: near a rim that bends the surface behind may move more than the one that is pressed
constexpr double kThicknessShare = 0.4;  ///< a tip past the middle of a band would come out on its other side

Error inPart(Error error, const std::string& part) {
  error.place.part = part;
  return error;
}

/// `count` marked points, far from each other, the first in their weighted middle: each next one is the farthest from
/// those taken, so a longer list begins as a shorter one does.
std::vector<Vec3> spread(const std::vector<Vec3>& points, const std::vector<double>& weights, const std::vector<char>& marked, int count) {
  std::vector<double> distance(points.size(), 0);
  std::vector<Vec3> taken;
  Vec3 middle = Vec3::Zero();
  double all = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (marked[i]) middle += weights[i] * points[i], all += weights[i], distance[i] = 1e300;
  if (all > 0) middle /= all;
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (marked[i] && (!marked[next] || (points[i] - middle).norm() < (points[next] - middle).norm())) next = i;
  while (static_cast<int>(taken.size()) < count && distance[next] > 0) {
    taken.push_back(points[next]);
    for (std::size_t i = 0; i < points.size(); ++i) distance[i] = std::min(distance[i], (points[i] - points[next]).norm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return taken;
}

/// What of a part's surface shows one use of a material and is not bonded to another part: middles of visual triangles. Not
/// vertices: those of an edge are softer than the faces, which are what a tip meets.
struct OpenTissue {
  int part, use;
  std::vector<char> marked;      ///< of the part's triangles
  std::vector<Vec3> middles;
  std::vector<double> areas;     ///< m²
  double whole = 0;              ///< area of the marked ones, m²
  int wanted() const { return std::max(static_cast<int>(std::ceil(whole / (kSpacing * kSpacing))), static_cast<int>(kFirstPlaces)); }
};

OpenTissue openTissue(const Joint& joint, int index, int use) {
  const Part& part = joint.parts[static_cast<std::size_t>(index)];
  OpenTissue tissue{index, use, {}, {}, {}};
  for (const int own : useOfTriangles(part)) tissue.marked.push_back(own == use);
  for (const Coupling& coupling : joint.couplings) {
    if (coupling.partA != part.id || !hasHold(joint, coupling)) continue;
    const HeldSurface held = heldSurface(part, coupling);
    if (held.surface == SurfaceKind::Visual)
      for (const int t : held.triangles) tissue.marked[static_cast<std::size_t>(t)] = 0;
  }
  for (std::size_t t = 0; t < tissue.marked.size(); ++t) {
    const auto& c = part.visual->triangles[t];
    const Vec3 &x = part.visual->vertices[c[0]], &y = part.visual->vertices[c[1]], &z = part.visual->vertices[c[2]];
    tissue.middles.push_back((x + y + z) / 3);
    tissue.areas.push_back(0.5 * (y - x).cross(z - x).norm());
    if (tissue.marked[t]) tissue.whole += tissue.areas.back();
  }
  return tissue;
}

/// How many places each tissue gets: one for each square of kSpacing, at most `each`; where that is more than `all` of them together,
/// the same share of what is over kFirstPlaces.
std::vector<int> shareOut(const std::vector<OpenTissue>& tissues, int each, int all) {
  const int least = static_cast<int>(kFirstPlaces);
  int over = 0;
  for (const OpenTissue& tissue : tissues) over += std::min(tissue.wanted(), std::max(each, least)) - least;
  const int left = std::max(0, all - least * static_cast<int>(tissues.size()));
  std::vector<int> counts;
  for (const OpenTissue& tissue : tissues) {
    const int more = std::min(tissue.wanted(), std::max(each, least)) - least;
    counts.push_back(std::min(each, least + (over > left ? more * left / over : more)));
  }
  return counts;
}

/// Where the normal into the part from a place of the surface comes out of it again. Where the place is an edge the ray begins
/// a little beside it.
std::optional<Vec3> backOf(const TriangleTree& surface, const TipPatch& patch) {
  const Vec3 u = patch.normal_W.unitOrthogonal(), v = patch.normal_W.cross(u);
  for (const double below : {1e-4, 1e-5, 1e-6})  // m: of a film what is deeper lies outside again
    for (int n = 0; n < 9; ++n) {
      const Vec3 beside = n == 0 ? Vec3::Zero().eval() : Vec3(std::cos(0.785 * n) * u + std::sin(0.785 * n) * v);
      const Vec3 from = patch.middle_W - below * patch.normal_W + 0.1 * patch.radius * beside;
      if (!surface.inside(from)) continue;
      if (const auto hit = surface.cast(from, -patch.normal_W)) return hit->point;
    }
  return {};
}

}  // namespace

GradedCells fineCells(const Part& part, double radius) {
  GradedCells cells;
  cells.finest = radius / 2.1;
  cells.core = 1.6 * radius;
  cells.coarsest = std::max(cells.finest, std::cbrt(enclosedVolume(*part.visual) / kElements));
  return cells;
}

namespace {

/// A place to press, and what came of it.
struct Spot {
  int part, use;
  Vec3 at_W;
  Vec3 normal_W = Vec3::UnitY();
  Result<DentSample> sample = Error{};
  bool tooThin = false;  ///< for the fine cells: no dent
};

/// E/(1 − ν²) of a material of a part, Pa.
double modulusOf(const Joint& joint, const Part& part, int use) {
  const Material& material = joint.materials[findMaterial(joint, part.materials[static_cast<std::size_t>(use)].material)];
  return material.youngsModulus / (1 - material.poissonRatio * material.poissonRatio);
}

using Shares = std::array<double, DentSample::kRadii>;

std::array<double, DentSample::kRadii> radiiFrom(double radius) {
  std::array<double, DentSample::kRadii> radii;
  for (std::size_t k = 0; k < radii.size(); ++k) radii[k] = radius * (1 << k);
  return radii;
}

/// `shown`: of a half-space by the part's fine cells; what they do not show is added.
void press(const Joint& joint, double radius, const Shares& shown, Spot& spot) {
  const Part& part = joint.parts[static_cast<std::size_t>(spot.part)];
  std::array<TipPatch, DentSample::kRadii> patches;
  const Shares radii = radiiFrom(radius);
  for (std::size_t k = 0; k < patches.size(); ++k) patches[k] = tipPatchAt(*part.visual, spot.at_W, radii[k]);
  const TipPatch& least = patches.front();
  spot.normal_W = least.normal_W;
  const std::optional<Vec3> behind = backOf(TriangleTree(*part.visual), least);
  const TipPatch back = behind ? tipPatchAt(*part.visual, *behind, radius) : TipPatch{};
  const double thick = behind ? (*behind - least.middle_W).norm() : 0.0;
  spot.sample = DentSample{least.middle_W, modulusOf(joint, part, spot.use), {}, kThicknessShare * thick};
  auto mesh = embedGraded(part, least, fineCells(part, radius));
  if (!mesh) {
    spot.sample = inPart(mesh.error(), part.id);
    return;
  }
  double volume = 0;
  for (int t = 0; t < static_cast<int>(mesh->tets.size()); ++t) volume += tetVolume(*mesh, t);
  spot.tooThin = volume < kStandsFor * enclosedVolume(*part.visual);
  if (spot.tooThin) return;
  const auto fine = StaticPart::make(joint, spot.part, std::make_shared<const TetMesh>(std::move(*mesh)), TetFilling::Whole);
  if (!fine) {
    spot.sample = inPart(fine.error(), part.id);
    return;
  }
  const std::vector<double> found = fine->compliances(patches, back);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double halfSpace = diskCompliance(spot.sample->modulus, patches[k].radius);
    spot.sample->compliance[k] = std::max(found[k] + (1 - shown[k]) * halfSpace, kLeastShare * halfSpace);
  }
}

/// All of them on all processors; false where it was cancelled. Every place is a problem of its own, so any number of
/// threads gives the same answer.
bool pressAll(std::vector<Spot>& spots, std::size_t first, const std::function<void(Spot&)>& one, const std::function<bool(const Spot&)>& goOn) {
  std::atomic<std::size_t> next = first;
  std::atomic<bool> cancelled = false;
  std::vector<std::jthread> helpers;
  for (unsigned n = 1; n < std::thread::hardware_concurrency(); ++n)
    helpers.emplace_back([&] {
      for (std::size_t i = next++; i < spots.size() && !cancelled; i = next++) one(spots[i]);
    });
  for (std::size_t i = next++; i < spots.size() && !cancelled; i = next++) {
    one(spots[i]);
    if (!goOn(spots[i])) cancelled = true;
  }
  helpers.clear();
  return !cancelled;
}

/// One part's table: a bottom where none was found; where it is too thin for a dent it is hard. Empty where it is so everywhere.
DentTable tableOf(const std::vector<Spot>& spots, int part, double radius) {
  constexpr double kHard = 1e-9;  // m/N
  DentTable table;
  table.radii = radiiFrom(radius);
  std::vector<double> depths;
  for (const Spot& spot : spots)
    if (spot.part == part && !spot.tooThin && spot.sample->depthMost > 0) depths.push_back(spot.sample->depthMost);
  if (depths.empty()) return table;
  std::sort(depths.begin(), depths.end());
  for (const Spot& spot : spots) {
    if (spot.part != part) continue;
    DentSample& sample = table.samples.emplace_back(*spot.sample);
    if (spot.tooThin) {
      sample.compliance.fill(kHard);
      sample.depthMost = 0;
    } else if (sample.depthMost == 0) {
      sample.depthMost = depths[depths.size() / 2];
    }
  }
  return table;
}

/// Whether the places from `first` to `middle` had told what those after it said.
bool foretold(const std::vector<Spot>& spots, std::size_t first, std::size_t middle, double radius) {
  const DentTable known = tableOf(std::vector<Spot>(spots.begin() + static_cast<std::ptrdiff_t>(first), spots.begin() + static_cast<std::ptrdiff_t>(middle)), spots[first].part, radius);
  if (known.samples.empty()) return false;
  std::vector<DentField::Facing> facings;
  for (std::size_t i = first; i < middle; ++i) facings.push_back({spots[i].normal_W, spots[i].use});
  const DentField field(known, facings);
  std::size_t surprises = 0;
  for (std::size_t i = middle; i < spots.size(); ++i) {
    const TissueGive give = field.at(spots[i].at_W, {spots[i].normal_W, spots[i].use});
    bool right = !spots[i].tooThin;
    for (std::size_t k = 0; k < give.compliance.size(); ++k) right = right && std::abs(std::log(give.compliance[k] / spots[i].sample->compliance[k])) < kForetold;
    surprises += !right;
  }
  return static_cast<double>(surprises) <= kSurprises * static_cast<double>(spots.size() - middle);
}

}  // namespace

Result<std::vector<DentPlaces>> makeDents(Joint& joint, const DentWishes& wishes, const BuildProgress& progress) {
  std::vector<Shares> shown(joint.parts.size());
  std::vector<Spot> spots;
  std::atomic<int> done = 0;
  const auto one = [&](Spot& spot) {
    press(joint, wishes.radius, shown[static_cast<std::size_t>(spot.part)], spot);
    ++done;
  };
  std::vector<OpenTissue> tissues;
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    const Part& part = joint.parts[index];
    if (part.kind != PartKind::Soft || (!wishes.part.empty() && wishes.part != part.id)) continue;
    const double poisson = joint.materials[static_cast<std::size_t>(findMaterial(joint, part.materials.front().material))].poissonRatio;
    const auto shares = cellsShown(fineCells(part, wishes.radius), radiiFrom(wishes.radius), poisson);
    if (!shares) return inPart(shares.error(), part.id);
    shown[index] = *shares;
    for (int use = 0; use < static_cast<int>(part.materials.size()); ++use) tissues.push_back(openTissue(joint, static_cast<int>(index), use));
  }
  const std::vector<int> counts = shareOut(tissues, wishes.places, wishes.jointPlaces);
  std::vector<double> coarse(joint.parts.size(), 0);
  const double all = std::max(1, std::accumulate(counts.begin(), counts.end(), 0));
  for (std::size_t k = 0; k < tissues.size(); ++k) {
    const OpenTissue& tissue = tissues[k];
    const std::string& id = joint.parts[static_cast<std::size_t>(tissue.part)].id;
    const std::vector<Vec3> places = spread(tissue.middles, tissue.areas, tissue.marked, counts[k]);
    const std::size_t before = spots.size();
    bool known = false;
    for (std::size_t count = kFirstPlaces; spots.size() - before < places.size() && !known; count *= 2) {
      const std::size_t first = spots.size();
      for (std::size_t n = first - before; n < std::min(count, places.size()); ++n) spots.push_back({tissue.part, tissue.use, places[n]});
      if (!pressAll(spots, first, one, [&](const Spot&) { return !progress || progress(id, std::min(1.0, done / all)); }))
        return Error{Fault::Cancelled, {}, {}, "dents"};
      for (std::size_t n = first; n < spots.size(); ++n)
        if (!spots[n].sample) return spots[n].sample.error();
      known = first > before && foretold(spots, before, first, wishes.radius);
    }
    double& apart = coarse[static_cast<std::size_t>(tissue.part)];
    if (!known && counts[k] < tissue.wanted()) apart = std::max(apart, std::sqrt(tissue.whole / counts[k]));
  }
  std::vector<DentPlaces> pressed;
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    if (joint.parts[index].kind != PartKind::Soft || (!wishes.part.empty() && wishes.part != joint.parts[index].id)) continue;
    DentPlaces& places = pressed.emplace_back(DentPlaces{static_cast<int>(index)});
    places.coarse = coarse[index];
    for (const Spot& spot : spots)
      if (spot.part == places.part) ++places.count, places.tooThin += spot.tooThin;
    DentTable table = tableOf(spots, static_cast<int>(index), wishes.radius);
    table.basis = dentBasis(joint, joint.parts[index]);
    joint.parts[index].dents = table.samples.empty() ? nullptr : std::make_shared<const DentTable>(std::move(table));
  }
  return pressed;
}

}  // namespace glenoid
