// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeDents.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>

#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/TriangleUse.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

constexpr std::size_t kFirstPlaces = 8;  ///< on a tissue, before it is known whether more tell more
constexpr double kElements = 4000;   ///< cells of the whole part, about
constexpr double kDepthMost = 2.5e-3;  ///< m: the search for contacts sees no deeper than 4 mm
constexpr double kForceAtBottom = 2;  ///< N: what gives so much more that the bottom stops it earlier resists evenly up to there
constexpr double kStandsFor = 0.5;     ///< of a part's volume: fine cells that hold less do not stand for it
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

/// Places on one tissue: middles of the visual triangles that show one use of a material. Not vertices: those of an edge
/// are softer than the faces, which are what a tip meets.
std::vector<Vec3> placesOn(const Part& part, int use, int count) {
  std::vector<char> marked;
  for (const int own : useOfTriangles(part)) marked.push_back(own == use);
  std::vector<Vec3> middles;
  std::vector<double> areas;
  for (const auto& c : part.visual->triangles) {
    const Vec3 &x = part.visual->vertices[c[0]], &y = part.visual->vertices[c[1]], &z = part.visual->vertices[c[2]];
    middles.push_back((x + y + z) / 3);
    areas.push_back(0.5 * (y - x).cross(z - x).norm());
  }
  return spread(middles, areas, marked, count);
}

/// Tissue under a place of the surface, along the normal into the part, m; 0 where none is found. Where the place is an
/// edge the ray begins a little beside it.
double thicknessAt(const TriangleTree& surface, const TipPatch& patch) {
  const Vec3 u = patch.normal_W.unitOrthogonal(), v = patch.normal_W.cross(u);
  for (const double below : {1e-4, 1e-5, 1e-6})  // m: of a film what is deeper lies outside again
    for (int n = 0; n < 9; ++n) {
      const Vec3 beside = n == 0 ? Vec3::Zero().eval() : Vec3(std::cos(0.785 * n) * u + std::sin(0.785 * n) * v);
      const Vec3 from = patch.middle_W - below * patch.normal_W + 0.1 * patch.radius * beside;
      if (!surface.inside(from)) continue;
      if (const auto hit = surface.cast(from, -patch.normal_W)) return below + hit->distance;
    }
  return 0;
}

}  // namespace

GradedCells fineCells(const Part& part, double radius) {
  GradedCells cells;
  cells.finest = radius / 2.5;
  cells.core = 1.6 * radius;
  cells.coarsest = std::max(cells.finest, std::cbrt(enclosedVolume(*part.visual) / kElements));
  return cells;
}

namespace {

/// A place to press, and what came of it.
struct Spot {
  int part;
  Vec3 at_W;
  Result<DentSample> sample = Error{};
  bool tooThin = false;  ///< for the fine cells: no dent
  /// Whether it is as soft as a dent can show.
  bool atBottom() const { return sample && sample->compliance * kForceAtBottom >= sample->depthMost; }
};

void press(const Joint& joint, const StaticPart& coarse, double radius, Spot& spot) {
  const Part& part = joint.parts[static_cast<std::size_t>(spot.part)];
  const TipPatch patch = tipPatchAt(*part.visual, spot.at_W, radius);
  const double thick = thicknessAt(TriangleTree(*part.visual), patch);
  spot.sample = DentSample{patch.middle_W, 0, std::min(kDepthMost, kThicknessShare * thick)};
  auto mesh = embedGraded(part, patch, fineCells(part, radius));
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
  spot.sample->compliance = std::max(0.0, fine->compliance(patch) - coarse.compliance(patch));
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

/// One part's table: a bottom where none was found, and no place softer than its bottom lets it be felt.
DentTable tableOf(const std::vector<Spot>& spots, int part, double radius) {
  DentTable table;
  table.radius = radius;
  std::vector<double> depths;
  for (const Spot& spot : spots) {
    if (spot.part != part) continue;
    table.samples.push_back(*spot.sample);
    if (spot.sample->depthMost > 0) depths.push_back(spot.sample->depthMost);
  }
  std::sort(depths.begin(), depths.end());
  for (DentSample& sample : table.samples) {
    if (sample.depthMost == 0 && !depths.empty()) sample.depthMost = depths[depths.size() / 2];
    sample.compliance = std::min(sample.compliance, sample.depthMost / kForceAtBottom);
  }
  return table;
}

}  // namespace

Result<std::vector<DentPlaces>> makeDents(Joint& joint, const DentWishes& wishes, const BuildProgress& progress) {
  std::vector<std::optional<StaticPart>> coarse(joint.parts.size());
  std::vector<Spot> spots;
  std::atomic<int> done = 0;
  const auto one = [&](Spot& spot) {
    press(joint, *coarse[static_cast<std::size_t>(spot.part)], wishes.radius, spot);
    ++done;
  };
  double all = 1;
  for (const Part& part : joint.parts)
    if (part.kind == PartKind::Soft && (wishes.part.empty() || wishes.part == part.id))
      all += static_cast<double>(part.materials.size()) * wishes.places;
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    const Part& part = joint.parts[index];
    if (part.kind != PartKind::Soft || (!wishes.part.empty() && wishes.part != part.id)) continue;
    auto own = StaticPart::make(joint, static_cast<int>(index), part.volume, TetFilling::Partial);
    if (!own) return inPart(own.error(), part.id);
    coarse[index].emplace(std::move(*own));
    for (int use = 0; use < static_cast<int>(part.materials.size()); ++use) {
      const std::vector<Vec3> places = placesOn(part, use, wishes.places);
      const std::size_t before = spots.size();
      const auto pressTo = [&](std::size_t count) {
        const std::size_t first = spots.size();
        for (std::size_t n = first - before; n < std::min(count, places.size()); ++n) spots.push_back({static_cast<int>(index), places[n]});
        return pressAll(spots, first, one, [&](const Spot&) { return !progress || progress(part.id, std::min(1.0, done / all)); });
      };
      if (!pressTo(kFirstPlaces)) return Error{Fault::Cancelled, {}, {}, "dents"};
      const auto soft = std::count_if(spots.begin() + static_cast<std::ptrdiff_t>(before), spots.end(), [](const Spot& s) { return s.atBottom(); });
      if (2 * static_cast<std::size_t>(soft) > spots.size() - before) continue;  // everywhere the bottom: more places tell nothing
      if (!pressTo(places.size())) return Error{Fault::Cancelled, {}, {}, "dents"};
    }
  }
  for (const Spot& spot : spots)
    if (!spot.sample) return spot.sample.error();
  std::vector<DentPlaces> pressed;
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    if (!coarse[index]) continue;
    DentPlaces& places = pressed.emplace_back(DentPlaces{static_cast<int>(index)});
    for (const Spot& spot : spots)
      if (spot.part == places.part) ++places.count, places.tooThin += spot.tooThin;
    DentTable table = tableOf(spots, static_cast<int>(index), wishes.radius);
    table.basis = dentBasis(joint, joint.parts[index]);
    joint.parts[index].dents = std::make_shared<const DentTable>(std::move(table));
  }
  return pressed;
}

}  // namespace glenoid
