// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeDents.h"

#include <atomic>
#include <cmath>
#include <optional>
#include <thread>

#include "simcore/scene/JointFile.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

constexpr double kElements = 4000;   ///< cells of the whole part, about
constexpr double kDepthMost = 2.5e-3;  ///< m: the search for contacts sees no deeper than 4 mm
constexpr double kForceAtBottom = 2;  ///< N: what gives so much more that the bottom stops it earlier resists evenly up to there
constexpr double kThicknessShare = 0.4;  ///< a tip past the middle of a band would come out on its other side

Error inPart(Error error, const std::string& part) {
  error.place.part = part;
  return error;
}

/// Vertices far from each other among those marked: each next one is the farthest from those taken.
void spread(const std::vector<Vec3>& points, const std::vector<char>& marked, int count, std::vector<int>& taken) {
  std::vector<double> distance(points.size(), 0);
  std::size_t next = 0;
  for (std::size_t i = points.size(); i-- > 0;)
    if (marked[i]) distance[i] = 1e300, next = i;
  for (int n = 0; n < count && distance[next] > 0; ++n) {
    taken.push_back(static_cast<int>(next));
    for (std::size_t i = 0; i < points.size(); ++i) distance[i] = std::min(distance[i], (points[i] - points[next]).norm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
}

/// Places to press: so many on each tissue that a part shows, for a tendon is no mean of its ends and the belly beside.
std::vector<int> placesOn(const Part& part, int count) {
  std::vector<int> use(part.visual->triangles.size(), 0);
  for (std::size_t u = 1; u < part.materials.size(); ++u)
    if (const Region* region = findRegion(part, part.materials[u].region); region && region->surface == SurfaceKind::Visual)
      for (const int triangle : trianglesOf(*region)) use[static_cast<std::size_t>(triangle)] = static_cast<int>(u);
  std::vector<int> taken;
  for (int u = 0; u < static_cast<int>(part.materials.size()); ++u) {
    std::vector<char> marked(part.visual->vertices.size(), 0);
    for (std::size_t t = 0; t < use.size(); ++t)
      if (use[t] == u)
        for (const int vertex : part.visual->triangles[t]) marked[static_cast<std::size_t>(vertex)] = 1;
    spread(part.visual->vertices, marked, count, taken);
  }
  std::sort(taken.begin(), taken.end());
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
  return taken;
}

/// Tissue under a place of the surface, along the normal into the part, m; 0 at a rim, which has none.
double thicknessAt(const TriangleTree& surface, const TipPatch& patch) {
  constexpr double kBelow = 1e-4;
  const Vec3 from = patch.middle_W - kBelow * patch.normal_W;
  const auto hit = surface.inside(from) ? surface.cast(from, -patch.normal_W) : std::nullopt;
  return hit ? kBelow + hit->distance : 0;
}

}  // namespace

GradedCells fineCells(const Part& part, double radius) {
  GradedCells cells;
  cells.finest = radius / 2.5;
  cells.core = 1.6 * radius;
  cells.coarsest = std::max(cells.finest, std::cbrt(enclosedVolume(*part.visual) / kElements));
  return cells;
}

Result<Done> makeDents(Joint& joint, const DentWishes& wishes, const BuildProgress& progress) {
  struct Spot {
    int part, vertex;
    Result<DentSample> sample = Error{};
  };
  std::vector<Spot> spots;
  std::vector<std::optional<StaticPart>> coarse(joint.parts.size());
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    const Part& part = joint.parts[index];
    if (part.kind != PartKind::Soft || (!wishes.part.empty() && wishes.part != part.id)) continue;
    auto own = StaticPart::make(joint, static_cast<int>(index), part.volume, TetFilling::Partial);
    if (!own) return inPart(own.error(), part.id);
    coarse[index].emplace(std::move(*own));
    for (const int vertex : placesOn(part, wishes.places)) spots.push_back({static_cast<int>(index), vertex});
  }
  const auto fill = [&](Spot& spot) {
    const Part& part = joint.parts[static_cast<std::size_t>(spot.part)];
    const TipPatch patch = tipPatchAt(*part.visual, part.visual->vertices[static_cast<std::size_t>(spot.vertex)], wishes.radius);
    auto mesh = embedGraded(part, patch, fineCells(part, wishes.radius));
    if (!mesh) {
      spot.sample = inPart(mesh.error(), part.id);
      return;
    }
    const auto fine = StaticPart::make(joint, spot.part, std::make_shared<const TetMesh>(std::move(*mesh)), TetFilling::Whole);
    if (!fine) {
      spot.sample = inPart(fine.error(), part.id);
      return;
    }
    const double more = std::max(0.0, fine->compliance(patch) - coarse[static_cast<std::size_t>(spot.part)]->compliance(patch));
    const double thick = thicknessAt(TriangleTree(*part.visual), patch);
    spot.sample = DentSample{patch.middle_W, more, std::min(kDepthMost, kThicknessShare * thick)};
  };
  // Every place is a problem of its own, so any number of threads gives the same answer.
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> cancelled = false;
  const auto work = [&] {
    for (std::size_t i = next++; i < spots.size() && !cancelled; i = next++) fill(spots[i]), ++done;
  };
  {
    std::vector<std::jthread> helpers;
    for (unsigned n = 1; n < std::thread::hardware_concurrency(); ++n) helpers.emplace_back(work);
    for (std::size_t i = next++; i < spots.size() && !cancelled; i = next++) {
      fill(spots[i]);
      ++done;
      const std::string& id = joint.parts[static_cast<std::size_t>(spots[i].part)].id;
      if (progress && !progress(id, static_cast<double>(done) / static_cast<double>(spots.size()))) cancelled = true;
    }
  }
  if (cancelled) return Error{Fault::Cancelled, {}, {}, "dents"};
  for (const Spot& spot : spots)
    if (!spot.sample) return spot.sample.error();
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    if (!coarse[index]) continue;
    DentTable table;
    table.radius = wishes.radius;
    std::vector<double> depths;
    for (const Spot& spot : spots) {
      if (spot.part != static_cast<int>(index)) continue;
      table.samples.push_back(*spot.sample);
      if (spot.sample->depthMost > 0) depths.push_back(spot.sample->depthMost);
    }
    std::sort(depths.begin(), depths.end());
    for (DentSample& sample : table.samples) {
      if (sample.depthMost == 0 && !depths.empty()) sample.depthMost = depths[depths.size() / 2];
      sample.compliance = std::min(sample.compliance, sample.depthMost / kForceAtBottom);
    }
    table.basis = dentBasis(joint, joint.parts[index]);
    joint.parts[index].dents = std::make_shared<const DentTable>(std::move(table));
  }
  return Done{};
}

}  // namespace glenoid
