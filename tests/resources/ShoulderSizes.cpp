// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/resources/ShoulderSizes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "simcore/scene/JointFile.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::test {

const Joint& shippedShoulder() {
  static const Joint joint = [] {
    Result<Joint> loaded = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder.joint");
    if (!loaded) {
      std::fprintf(stderr, "%s\n", toLogLine(loaded.error()).c_str());
      std::abort();
    }
    return std::move(*loaded);
  }();
  return joint;
}

const Part& partOf(const Joint& joint, const std::string& id) {
  return joint.parts.at(findPart(joint, id));
}

Vec3 landmark(const Part& part, const std::string& id) {
  for (const Landmark& l : part.landmarks)
    if (l.id == id) return 1e3 * l.position_W;
  ADD_FAILURE() << part.id << " has no landmark " << id;
  return Vec3::Zero();
}

std::vector<Vec3> verticesOf(const Part& part, const std::string& id) {
  const Region* region = findRegion(part, id);
  std::vector<Vec3> points;
  if (!region) {
    ADD_FAILURE() << part.id << " has no region " << id;
    return points;
  }
  std::set<int> used;
  for (const int t : trianglesOf(*region))
    used.insert(part.visual->triangles[t].begin(), part.visual->triangles[t].end());
  for (const int v : used) points.push_back(1e3 * part.visual->vertices[v]);
  return points;
}

Sphere fitSphere(const std::vector<Vec3>& points) {
  MatX a(points.size(), 4);
  VecX b(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    a.row(i) << 2 * points[i].transpose(), 1;
    b[i] = points[i].squaredNorm();
  }
  const VecX x = a.colPivHouseholderQr().solve(b);
  Sphere s{x.head<3>(), std::sqrt(x[3] + x.head<3>().squaredNorm()), 0};
  for (const Vec3& p : points) s.rms += std::pow((p - s.centre).norm() - s.radius, 2);
  s.rms = std::sqrt(s.rms / double(points.size()));
  return s;
}

Vec3 shaftMiddle(const TriMesh& humerus, double y) {
  // Weighted by the length of the outline's pieces.
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (const auto& t : humerus.triangles) {
    std::vector<Vec3> cut;
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = 1e3 * humerus.vertices[t[k]], b = 1e3 * humerus.vertices[t[(k + 1) % 3]];
      if ((a.y() < y) != (b.y() < y)) cut.push_back(a + (y - a.y()) / (b.y() - a.y()) * (b - a));
    }
    if (cut.size() != 2) continue;
    const double l = (cut[0] - cut[1]).norm();
    sum += l * 0.5 * (cut[0] + cut[1]);
    length += l;
  }
  return sum / length;
}

Vec3 shaftAxis(const TriMesh& humerus, double yLow, double yHigh) {
  return (shaftMiddle(humerus, yHigh) - shaftMiddle(humerus, yLow)).normalized();
}

GrooveCut grooveAt(const TriMesh& humerus, double y) {
  TriMesh mm = humerus;
  for (Vec3& v : mm.vertices) v *= 1e3;
  const TriangleTree tree(mm);
  // Seen from inside the bone, in front of which the groove runs: outline by rays over the front and the
  // side.
  const Vec3 centre(4, y, 5);
  std::vector<Vec3> outline;
  for (double degrees = -30; degrees <= 100; degrees += 0.5) {
    const double a = degrees * std::numbers::pi / 180;
    if (const auto hit = tree.cast(centre, Vec3(std::cos(a), 0, std::sin(a)))) outline.push_back(hit->point);
  }
  // The two lips are the ends of the longest bridge over the outline: the chord under which the outline dips
  // most.
  GrooveCut best{0, 0};
  std::size_t lipA = 0, lipB = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (std::size_t j = i + 2; j < outline.size() && (outline[j] - outline[i]).norm() < 22; ++j) {
      const Vec3 chord = outline[j] - outline[i];
      const Vec3 out = chord.cross(Vec3::UnitY()).normalized() *
                       (chord.cross(Vec3::UnitY()).dot(outline[i] - centre) > 0 ? 1 : -1);
      double depth = 0, above = 0;
      for (std::size_t k = i + 1; k < j; ++k) {
        depth = std::max(depth, (outline[i] - outline[k]).dot(out));
        above = std::max(above, (outline[k] - outline[i]).dot(out));
      }
      if (above < 0.05 && depth > best.depth) best.depth = depth, lipA = i, lipB = j;
    }
  const Vec3 chord = (outline[lipB] - outline[lipA]).normalized();
  const Vec3 out = chord.cross(Vec3::UnitY()).normalized() *
                   (chord.cross(Vec3::UnitY()).dot(outline[lipA] - centre) > 0 ? 1 : -1);
  double first = 1e9, last = -1e9;
  for (std::size_t k = lipA; k <= lipB; ++k)
    if ((outline[lipA] - outline[k]).dot(out) > best.depth / 2) {
      first = std::min(first, chord.dot(outline[k]));
      last = std::max(last, chord.dot(outline[k]));
    }
  best.width = last - first;
  return best;
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace glenoid::test
