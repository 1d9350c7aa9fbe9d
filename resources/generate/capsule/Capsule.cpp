// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/capsule/Capsule.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "resources/generate/capsule/Underneath.h"
#include "simcore/scene/Joint.h"

namespace glenoid::generate {
namespace {

constexpr int kAround = 72, kAlong = 14;             ///< cells of the capsule's visual sheets
constexpr int kCoarseAround = 18, kCoarseAlong = 4;  ///< of its collision sheets

constexpr double kUnderTendon = 0.6;                 ///< mm from a tendon to the wall's inner side, where there is room
constexpr double kOffHead = 0.1;                     ///< mm, least, from there to the head

double eased(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// From one turn to another the shorter way round.
double towards(double from, double to) {
  return from + (to - from) - std::round(to - from);
}

Band slender(const Bones& bones, const Vec3& onScapula, const Vec3& onHumerus, double halfWidth,
             double thickness, double room = 1) {
  Band band;
  band.room = room;
  std::tie(band.middleFrom, band.middleTo) = Sleeve::turnsNear(bones, onScapula, onHumerus);
  band.middleTo = towards(band.middleFrom, band.middleTo);
  band.halfFrom = band.halfTo = halfWidth;
  band.thickness = band.border = thickness;
  return band;
}

/// From the anterior band, between the places of the reference body, to the posterior one at eight o'clock.
Band hammock(const Bones& bones) {
  auto [frontFrom, frontTo] = Sleeve::turnsNear(bones, {2.3, -6, -27}, {13.3, -12.8, -6});
  frontTo = towards(frontFrom, frontTo);
  const double backFrom = 0.36, backTo = 0.40;
  Band band;
  band.middleFrom = 0.5 * (frontFrom + backFrom);
  band.middleTo = 0.5 * (frontTo + backTo);
  band.halfFrom = 0.5 * (frontFrom - backFrom);
  band.halfTo = 0.5 * (frontTo - backTo);
  band.thickness = 1.1;
  band.border = 2.0;
  band.across = 28;
  band.along = 22;
  band.coarseAcross = 6;
  band.coarseAlong = 5;
  return band;
}

/// Closed body between two sheets of rows of `across` points, which are rings where `closed`. The inner
/// sheet's triangles come first.
TriMesh slab(const std::vector<Vec3>& inner, const std::vector<Vec3>& outer, int across, bool closed) {
  TriMesh mesh;
  mesh.vertices = inner;
  mesh.vertices.insert(mesh.vertices.end(), outer.begin(), outer.end());
  const int sheet = int(inner.size()), rows = sheet / across, cells = closed ? across : across - 1;
  const auto at = [&](int i, int j) { return j * across + i % across; };
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i < cells; ++i) quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i < cells; ++i)
      quad(sheet + at(i, j), sheet + at(i + 1, j), sheet + at(i + 1, j + 1), sheet + at(i, j + 1));
  const int last = rows - 1;
  for (int i = 0; i < cells; ++i) {
    quad(at(i, 0), at(i + 1, 0), sheet + at(i + 1, 0), sheet + at(i, 0));
    quad(at(i + 1, last), at(i, last), sheet + at(i, last), sheet + at(i + 1, last));
  }
  for (int j = 0; j + 1 < rows && !closed; ++j) {
    quad(at(0, j + 1), at(0, j), sheet + at(0, j), sheet + at(0, j + 1));
    quad(at(cells, j), at(cells, j + 1), sheet + at(cells, j + 1), sheet + at(cells, j));
  }
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

double Band::middleAt(double way) const {
  return middleFrom + (middleTo - middleFrom) * eased(way);
}

double Band::halfAt(double way) const {
  return halfFrom + (halfTo - halfFrom) * way;
}

double Band::thicknessAt(double aside) const {
  return thickness + (border - thickness) * eased((std::abs(aside) - 0.45) / 0.25);
}

CapsuleShapes::CapsuleShapes(const Bones& bones, const std::vector<TriMesh>& inside, Field over)
    : m_bones(bones),
      m_tendon(fieldOf(inside.back())),
      m_over(std::move(over)),
      m_superior(slender(bones, {-1, 15.5, -27}, {21, 9.8, 0}, 0.040, 1.6)),
      m_middle(slender(bones, {0.5, 8.5, -30}, {23.3, 1, -4.6}, 0.036, 1.8, 1.25)),
      m_inferior(hammock(bones)),
      m_sleeve(bones, inside, kCapsuleThickness, [this](const SleevePlace& place) {
        double most = 0;
        for (const Band* band : {&m_superior, &m_middle, &m_inferior}) {
          double off = place.turn - band->middleAt(place.way);
          off = (off - std::round(off)) / (band->room * band->halfAt(place.way));
          most = std::max(most, eased((1.3 - std::abs(off)) / 0.3) * band->thicknessAt(off) / 2);
        }
        return most;
      }) {}

TriMesh CapsuleShapes::wall(int around, int along) const {
  const auto sheet = [&](double offset) {
    Sheet made{{}, {}, around, true};
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i < around; ++i) {
        const SleevePlace place{double(i) / around, double(j) / along};
        const double thin = 0.55 + 0.45 * eased(std::min(place.way, 1 - place.way) / 0.1);
        made.out.push_back(m_sleeve.outward(place));
        made.points.push_back(m_sleeve.at(place) + thin * offset * made.out.back());
      }
    return made;
  };
  Sheet inner = sheet(-kCapsuleThickness / 2);
  moveUnder(inner, m_over, m_bones.humerusShape, kUnderTendon, kOffHead);
  return slab(inner.points, sheet(kCapsuleThickness / 2).points, around, true);
}

/// A coarse sheet on the inner side, drawn off what it may touch, and another so much farther out.
TriMesh CapsuleShapes::coarse(const std::vector<SleevePlace>& places, double inwards, double thickness,
                              int across, bool closed, double clearance) const {
  std::vector<Vec3> inner, outer;
  for (const SleevePlace& place : places)
    inner.push_back(m_sleeve.at(place) - inwards * m_sleeve.outward(place));
  TriMesh sheet = slab(inner, inner, across, closed);
  const int rows = int(inner.size()) / across;
  sheet.triangles.resize(2 * (closed ? across : across - 1) * (rows - 1));
  keepClear(sheet, unionOf(m_bones.humerusCoarse, m_tendon), clearance);
  sheet.vertices.resize(inner.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    outer.push_back(sheet.vertices[i] + thickness * m_sleeve.outward(places[i]));
  return slab(sheet.vertices, outer, across, closed);
}

Surfaces CapsuleShapes::capsule() const {
  std::vector<SleevePlace> places;
  for (int j = 0; j <= kCoarseAlong; ++j)
    for (int i = 0; i < kCoarseAround; ++i)
      places.push_back({double(i) / kCoarseAround, double(j) / kCoarseAlong});
  return {wall(kAround, kAlong), coarse(places, 0.5, 1.6, kCoarseAround, true, 0.9)};
}

TriMesh CapsuleShapes::bandMesh(const Band& band) const {
  std::vector<Vec3> inner, outer;
  for (int j = 0; j <= band.along; ++j)
    for (int i = 0; i <= band.across; ++i) {
      const double way = double(j) / band.along, aside = 2.0 * i / band.across - 1;
      const SleevePlace place{band.middleAt(way) + aside * band.halfAt(way), way};
      const double fromEnd = eased(std::min(way, 1 - way) / 0.12),
                   rounded = std::sqrt(1 - std::pow(aside, 4) * 0.94);
      // Half in the wall, half before it; at both ends all of it.
      const double base = -fromEnd * kCapsuleThickness / 2,
                   half = 0.5 * band.thicknessAt(aside) * (0.6 + 0.4 * fromEnd) * rounded;
      const Vec3 at = m_sleeve.at(place), out = m_sleeve.outward(place);
      inner.push_back(at + (base - half) * out);
      outer.push_back(at + (base + half) * out);
    }
  return slab(inner, outer, band.across + 1, false);
}

Surfaces CapsuleShapes::surfacesOf(const Band& band) const {
  std::vector<SleevePlace> places;
  for (int j = 0; j <= band.coarseAlong; ++j)
    for (int i = 0; i <= band.coarseAcross; ++i) {
      const double way = 0.03 + 0.94 * j / band.coarseAlong;
      places.push_back(
          {band.middleAt(way) + (2.0 * i / band.coarseAcross - 1) * 0.95 * band.halfAt(way), way});
    }
  return {bandMesh(band),
          coarse(places, kCapsuleThickness / 2 + 0.3, 1.4, band.coarseAcross + 1, false, 0.7)};
}

std::vector<Region> CapsuleShapes::capsuleRegions(const TriMesh& visual,
                                                  const std::vector<TendonOver>& tendons) const {
  const int sheet = kAround * (kAlong + 1);
  const auto where = [&](const std::string& id, const std::string& name, const char* kind,
                         const std::function<bool(bool outer, double turn, double way, const Vec3&)>& rule) {
    std::vector<int> triangles;
    for (std::size_t t = 0; t < visual.triangles.size(); ++t) {
      bool outer = true;
      double way = 0;
      Vec3 direction = Vec3::Zero(), middle = Vec3::Zero();
      for (const int v : visual.triangles[t]) {
        outer &= v >= sheet;
        way += double(v % sheet / kAround) / kAlong / 3;
        const double angle = 2 * std::numbers::pi * (v % kAround) / kAround;
        direction += Vec3(std::cos(angle), std::sin(angle), 0);
        middle += visual.vertices[v] / 3;
      }
      double turn = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi);
      if (rule(outer, turn < 0 ? turn + 1 : turn, way, middle)) triangles.push_back(int(t));
    }
    Region region;
    region.id = id, region.name = name, region.kind = kind;
    region.triangles = runsOf(triangles);
    return region;
  };
  std::vector<Region> regions{
      where("glenoid-end", "Collum scapulae (end on the neck of the scapula)", "footprint",
            [](bool, double, double way, const Vec3&) { return way < 0.08; }),
      where("humeral-end", "Collum anatomicum (end on the anatomical neck)", "footprint",
            [](bool, double, double way, const Vec3&) { return way > 0.92; }),
      where("axillary-pouch", "Recessus axillaris (axillary pouch)", "landmark",
            [](bool, double turn, double way, const Vec3&) {
              return std::abs(turn - 0.5) < 0.12 && way > 0.15 && way < 0.85;
            }),
      where("rotator-interval", "Intervallum rotatorum (rotator interval)", "landmark",
            [](bool, double turn, double way, const Vec3&) {
              return turn > 0.84 && turn < 0.97 && way > 0.3 && way < 0.85;
            })};
  for (const TendonOver& over : tendons)
    regions.push_back(
        where(over.id, over.name, "footprint", [&](bool outer, double, double way, const Vec3& p) {
          return outer && way > 0.2 && way < 0.92 && over.tendon(p) < 1.5;
        }));
  return regions;
}

std::vector<Region> CapsuleShapes::ligamentRegions(const TriMesh& visual, const std::string& which) const {
  const Band& band = which == "superior" ? m_superior : which == "middle" ? m_middle : m_inferior;
  const int across = band.across + 1, sheet = across * (band.along + 1);
  std::vector<int> first, last, wall;
  for (std::size_t t = 0; t < visual.triangles.size(); ++t) {
    bool outer = true;
    double way = 0;
    for (const int v : visual.triangles[t])
      outer &= v >= sheet, way += double(v % sheet / across) / band.along / 3;
    if (way < 0.12) first.push_back(int(t));
    if (way > 0.88) last.push_back(int(t));
    if (outer && way > 0.12 && way < 0.88) wall.push_back(int(t));
  }
  const auto region = [](const char* id, const char* name, const std::vector<int>& triangles) {
    Region r;
    r.id = id, r.name = name, r.kind = "footprint";
    r.triangles = runsOf(triangles);
    return r;
  };
  return {region("glenoid-end", "Labrum glenoidale (end at the labrum)", first),
          region("humeral-end", "Collum anatomicum (end on the anatomical neck)", last),
          region("capsule-side", "Facies capsularis (side on the capsule)", wall)};
}

}  // namespace glenoid::generate
