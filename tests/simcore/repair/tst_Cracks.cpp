// SPDX-License-Identifier: GPL-3.0-or-later
// A closed tube that is slit along its length: whatever the length of the slit, it stays a body, and the slit is zipped.
#include "simcore/repair/Cracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Diagnose.h"
#include "simcore/repair/RepairStep.h"

namespace glenoid {
namespace {

constexpr int kAround = 24;

/// A tube of radius 12 and length 300 with pointed ends, `rings` rings; between two of them slit along one line, whose lips are
/// `width` apart; `uneven`: the vertices of one lip lie between those of the other.
TriMesh slitTube(int rings, int first, int last, double width, bool uneven = false) {
  TriMesh mesh;
  const auto place = [&](double ring, double turn) {
    const double a = 2 * std::numbers::pi * turn / kAround;
    return Vec3(12 * std::cos(a), 12 * std::sin(a), 300 * (ring / (rings - 1) - 0.5));
  };
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < kAround; ++k) mesh.vertices.push_back(place(r, k));
  const int low = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(Vec3(0, 0, -160));
  mesh.vertices.push_back(Vec3(0, 0, 160));
  // The other lip: copies of the vertices at k = 0, moved by the width.
  std::vector<int> lip(static_cast<std::size_t>(rings), -1);
  for (int r = first + 1; r < last; ++r) {
    lip[r] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(place(r + (uneven ? 0.4 : 0), 0) - Vec3(0, width, 0));
  }
  const auto at = [&](int r, int k) { return k == kAround ? (lip[r] >= 0 ? lip[r] : r * kAround) : r * kAround + k; };
  for (int r = 0; r + 1 < rings; ++r)
    for (int k = 0; k < kAround; ++k) {
      mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)});
      mesh.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r + 1, k)});
    }
  for (int k = 0; k < kAround; ++k) {
    mesh.triangles.push_back({low, (k + 1) % kAround, k});
    mesh.triangles.push_back({low + 1, (rings - 1) * kAround + k, (rings - 1) * kAround + (k + 1) % kAround});
  }
  return mesh;
}

const Finding* find(const SurfaceDiagnosis& diagnosis, FindingKind kind) {
  for (const Finding& finding : diagnosis.findings)
    if (finding.kind == kind) return &finding;
  return nullptr;
}

TEST(Cracks, aSlitBodyIsNoSheetAndIsZipped) {
  const TriMesh whole = slitTube(60, 0, 0, 0);
  ASSERT_TRUE(healthOf(whole).healthy());
  const double volume = enclosedVolume(whole);
  for (const int last : {8, 30, 58})
    for (const double width : {1e-4, 0.05, 0.3})
      for (const bool uneven : {false, true}) {
        const TriMesh slit = slitTube(60, 2, last, width, uneven);
        const SurfaceDiagnosis found = diagnose(slit);
        EXPECT_FALSE(find(found, FindingKind::Sheets)) << last << " " << width << " " << uneven;
        const Finding* holes = find(found, FindingKind::Holes);
        ASSERT_TRUE(holes) << last << " " << width << " " << uneven;
        EXPECT_EQ(holes->count, 1);
        EXPECT_TRUE(holes->harmless) << "nothing is missing";
        const auto mended = repair(slit, automaticRepairs(found));
        ASSERT_TRUE(mended.ok());
        EXPECT_TRUE(healthOf(mended->mesh).healthy()) << last << " " << width << " " << uneven;
        EXPECT_NEAR(enclosedVolume(mended->mesh) / volume, 1, 2e-3) << last << " " << width << " " << uneven;
        if (!uneven) {
          EXPECT_EQ(mended->mesh.triangles.size(), whole.triangles.size()) << "zipped, no slivers: " << last << " " << width;
        }
      }
}

TEST(Cracks, aWideSlitIsAHoleAndAStripIsASheet) {
  // Lips as far apart as a third of the edges: a lid is needed, and over most of the bone it is an invention.
  const TriMesh wide = slitTube(60, 2, 58, 3);
  const Finding* holes = find(diagnose(wide), FindingKind::Sheets);
  EXPECT_TRUE(holes) << "as before: its rim is long for its area";
  // A strip whose sides are nearer than its edges are long has no body to be cracked.
  TriMesh strip;
  for (int i = 0; i <= 20; ++i)
    for (const double y : {0.0, 0.4}) strip.vertices.push_back(Vec3(4 * i, y, 0));
  for (int i = 0; i < 20; ++i) {
    strip.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    strip.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  EXPECT_TRUE(find(diagnose(strip), FindingKind::Sheets));
  long changed = 0;
  EXPECT_EQ(zipped(strip, changed), strip);
  EXPECT_EQ(changed, 0);
  EXPECT_EQ(zipped(slitTube(60, 0, 0, 0), changed), slitTube(60, 0, 0, 0)) << "what is whole stays";
}

TEST(Cracks, theLidOfEarsIsThatOfAPlanePolygon) {
  // A square of nine vertices a side: any lid has its area, 36 − 2 triangles.
  TriMesh mesh;
  std::vector<int> loop;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 9; ++i) {
      const double s = i / 9.0;
      const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
      loop.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back((1 - s) * corners[side] + s * corners[(side + 1) % 4]);
    }
  const RimLid lid = lidOfEars(mesh, loop);
  EXPECT_EQ(lid.triangles.size(), 34u);
  EXPECT_NEAR(lid.area, 1, 1e-9);
  EXPECT_FALSE(isCrack(mesh, loop, 1000));
}

}  // namespace
}  // namespace glenoid
