// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/resources/Measures.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simcore/scene/Joint.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::test {

namespace {

void printLine(const std::string& quantity, double measured, const char* unit, const Wanted& wanted,
               const std::string& verdict) {
  static const bool head = [] {
    std::printf("| quantity | measured | wanted | tolerance | unit | verdict | source |\n");
    std::printf("|---|---|---|---|---|---|---|\n");
    return true;
  }();
  (void)head;
  std::printf("| %s | %.1f | %.1f | %.1f | %s | %s | %s |\n", quantity.c_str(), measured, wanted.value,
              wanted.tolerance, unit, verdict.c_str(), wanted.source);
}

}  // namespace

void expectMeasure(const std::string& quantity, double measured, const char* unit, const Wanted& wanted) {
  const bool holds = std::abs(measured - wanted.value) <= wanted.tolerance;
  printLine(quantity, measured, unit, wanted, holds ? "holds" : "MISSES");
  EXPECT_NEAR(measured, wanted.value, wanted.tolerance) << quantity << ", " << wanted.source;
}

void reportMeasure(const std::string& quantity, double measured, const char* unit, const Wanted& wanted,
                   const char* reason) {
  printLine(quantity, measured, unit, wanted, std::string("not judged: ") + reason);
}

Wanted tenth(double value, const char* source) {
  return {value, 0.1 * std::abs(value), source};
}

TriMesh inMillimetres(const TriMesh& metres) {
  TriMesh mm = metres;
  for (Vec3& v : mm.vertices) v *= 1e3;
  return mm;
}

TriMesh surfaceOf(const Part& part, const std::string& id) {
  const Region* region = findRegion(part, id);
  TriMesh mesh;
  if (!region) {
    ADD_FAILURE() << part.id << " has no region " << id;
    return mesh;
  }
  for (const int t : trianglesOf(*region)) {
    const int first = int(mesh.vertices.size());
    for (const int v : part.visual->triangles[t]) mesh.vertices.push_back(1e3 * part.visual->vertices[v]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

double areaOf(const TriMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area +=
        0.5 *
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  return area;
}

Vec3 centroidOf(const TriMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double w = (b - a).cross(c - a).norm();
    sum += w * (a + b + c) / 3;
    area += w;
  }
  return sum / area;
}

Cut cutBy(const TriMesh& mesh, const Vec3& origin, const Vec3& normal, double reach) {
  const Vec3 n = normal.normalized();
  Cut cut;
  double length = 0;
  for (const auto& t : mesh.triangles) {
    Vec3 ends[2];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      const double da = (a - origin).dot(n), db = (b - origin).dot(n);
      if ((da < 0) != (db < 0) && count < 2) ends[count++] = a + da / (da - db) * (b - a);
    }
    if (count != 2) continue;
    const Vec3 middle = 0.5 * (ends[0] + ends[1]);
    if ((middle - origin).norm() > reach) continue;
    const Vec3 outward =
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    // Green's theorem in the plane: half the sum of the distance of each piece times its length.
    const Vec3 along = ends[1] - ends[0];
    Vec3 side = along.cross(n);
    if (side.dot(outward) < 0) side = -side;
    cut.area += 0.5 * (middle - origin).dot(side);
    cut.points.push_back(ends[0]);
    cut.points.push_back(ends[1]);
    cut.middle += along.norm() * middle;
    length += along.norm();
  }
  if (length > 0) cut.middle /= length;
  return cut;
}

double extentAlong(const std::vector<Vec3>& points, const Vec3& direction) {
  const Vec3 d = direction.normalized();
  double low = 1e9, high = -1e9;
  for (const Vec3& p : points) low = std::min(low, p.dot(d)), high = std::max(high, p.dot(d));
  return std::max(high - low, 0.0);
}

Extents principalExtents(const TriMesh& mesh) {
  const Vec3 middle = centroidOf(mesh);
  Mat3 spread = Mat3::Zero();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const Vec3 d = (a + b + c) / 3 - middle;
    spread += (b - a).cross(c - a).norm() * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  Extents extents;
  for (int i = 0; i < 3; ++i) {
    extents.axes.col(i) = solver.eigenvectors().col(2 - i);
    extents.size[i] = extentAlong(mesh.vertices, extents.axes.col(i));
  }
  return extents;
}

Band measureBand(const TriMesh& mesh, const Vec3& first, const Vec3& last, const Vec3& acrossHint) {
  constexpr int kCuts = 24;
  const Vec3 way = last - first, along = way.normalized();
  const Vec3 across = (acrossHint - acrossHint.dot(along) * along).normalized();
  Band band{0, 0, 0, 0, 0};
  std::vector<Vec3> edgeA, edgeB;
  double thickness = 0;
  for (int i = 0; i <= kCuts; ++i) {
    const Cut cut = cutBy(mesh, first + way * double(i) / kCuts, along);
    if (cut.points.empty()) continue;
    const auto lower = [&](const Vec3& p, const Vec3& q) { return p.dot(across) < q.dot(across); };
    edgeA.push_back(*std::min_element(cut.points.begin(), cut.points.end(), lower));
    edgeB.push_back(*std::max_element(cut.points.begin(), cut.points.end(), lower));
    const double width = (edgeB.back() - edgeA.back()).norm();
    if (edgeA.size() == 1) band.widthFirst = width;
    band.widthLast = width;
    // Half the outline is the width along a curved section.
    double outline = 0;
    for (std::size_t k = 0; k + 1 < cut.points.size(); k += 2)
      outline += (cut.points[k + 1] - cut.points[k]).norm();
    thickness += cut.area / (outline / 2);
  }
  for (std::size_t i = 1; i < edgeA.size(); ++i) {
    band.lengthA += (edgeA[i] - edgeA[i - 1]).norm();
    band.lengthB += (edgeB[i] - edgeB[i - 1]).norm();
  }
  band.thickness = edgeA.empty() ? 0 : thickness / double(edgeA.size());
  return band;
}

double thicknessOf(const TriMesh& mesh) {
  const TriangleTree tree(mesh);
  const Box3 box = boundsOf(mesh);
  const int n = 36;
  double deepest = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3 p = box.min() + box.sizes().cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5) / n);
        if (tree.inside(p)) deepest = std::max(deepest, tree.closest(p).distance);
      }
  return 2 * deepest;
}

}  // namespace glenoid::test
