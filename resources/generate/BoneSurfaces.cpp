// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <numbers>

#include "resources/generate/Bones.h"
#include "resources/generate/Flesh.h"
#include "resources/generate/Relax.h"
#include "resources/generate/Parts.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {

namespace {

/// Where the shape ends on the way out from an inner point.
Vec3 outward(const Field& shape, const Vec3& from, const Vec3& direction, double lift) {
  return settle(shape, from, direction.normalized(), 0, 0) + lift * direction.normalized();
}

/// Joins two rings that need not have the same number of points, both counter-clockwise seen from above and
/// starting near the same azimuth; `upper` comes first. Greedy by the shorter diagonal.
void joinUneven(TriMesh& mesh, int upper, int upperCount, int lower, int lowerCount) {
  int i = 0, j = 0;
  while (i < upperCount || j < lowerCount) {
    const int a = upper + i % upperCount, b = upper + (i + 1) % upperCount;
    const int c = lower + j % lowerCount, d = lower + (j + 1) % lowerCount;
    const double onUpper = (mesh.vertices[b] - mesh.vertices[c]).norm(),
                 onLower = (mesh.vertices[d] - mesh.vertices[a]).norm();
    if (j == lowerCount || (i < upperCount && onUpper <= onLower)) {
      mesh.triangles.push_back({a, b, c});
      ++i;
    } else {
      mesh.triangles.push_back({a, d, c});
      ++j;
    }
  }
}

/// The humerus in 116 triangles: most of them where the cuff, the labrum and the biceps tendon lie. Columns
/// run down the lesser tubercle's lip, the floor and the greater tubercle's lip of the groove and are spread
/// evenly over the rest of the head. Vertices of the head stand out by 0.9 mm, half of what its chords sink.
TriMesh coarseHumerus(const Field& shape) {
  TriMesh mesh;
  const auto ring = [&](const Vec3& centre, double elevation, const std::vector<double>& azimuths,
                        double lift) {
    const int first = int(mesh.vertices.size());
    const double e = elevation * std::numbers::pi / 180;
    for (const double degrees : azimuths) {
      const double a = degrees * std::numbers::pi / 180;
      mesh.vertices.push_back(
          outward(shape, centre, {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)}, lift));
    }
    return first;
  };
  const Vec3 centre(1.5, 0, 1.5);
  const std::vector<double> columns{19, 38, 54, 92, 128, 164, 200, 236, 272, 308, 343};
  const int n = int(columns.size());
  std::vector<int> rings;
  for (const double elevation : {60.0, 30.0, 2.0, -27.0}) {
    rings.push_back(ring(centre, elevation, columns, 0));
    // The groove's floor and lips stay where they are, the sphere stands out.
    for (int k = 3; k < n; ++k) {
      Vec3& p = mesh.vertices[rings.back() + k];
      if (std::abs(p.norm() - humerus::kHeadRadius) < 0.6) p *= (humerus::kHeadRadius + 0.9) / p.norm();
    }
  }
  const int pole = int(mesh.vertices.size());
  mesh.vertices.push_back(Vec3(-1, humerus::kHeadRadius + 0.7, -1));
  for (int k = 0; k < n; ++k) mesh.triangles.push_back({pole, rings[0] + (k + 1) % n, rings[0] + k});
  for (int r = 0; r + 1 < int(rings.size()); ++r) {
    for (int k = 0; k < n; ++k) {
      const int l = (k + 1) % n;
      const int a = rings[r] + k, b = rings[r] + l, c = rings[r + 1] + k, d = rings[r + 1] + l;
      // The diagonal that leaves the surface more convex, so that the head bulges and the groove stays open.
      const Vec3 m1 = 0.5 * (mesh.vertices[a] + mesh.vertices[d]),
                 m2 = 0.5 * (mesh.vertices[b] + mesh.vertices[c]);
      const bool first = (m1 - centre).norm() > (m2 - centre).norm();
      if (first) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      }
    }
  }
  const int neck = ring(humerus::canalAt(-46), 0, {30, 80, 132, 183, 235, 286, 338}, 0.6);
  joinUneven(mesh, rings.back(), n, neck, 7);
  const int low = ring(humerus::canalAt(-235), 0, {0, 90, 180, 270}, 0.8);
  joinUneven(mesh, neck, 7, low, 4);
  const Vec3 el = humerus::lateralEpicondyle(), em = humerus::medialEpicondyle(),
             down = -humerus::canalAxis();
  const Vec3 across = (el - em).normalized(), forward = across.cross(down).normalized();
  const int end = int(mesh.vertices.size());
  for (const Vec3& p : {Vec3(0.5 * (el + em) + 13 * forward + 8 * down), Vec3(el + 3 * down),
                        Vec3(0.5 * (el + em) - 9 * forward + 6 * down), Vec3(em + 3 * down)})
    mesh.vertices.push_back(p);
  joinUneven(mesh, low, 4, end, 4);
  mesh.triangles.push_back({end, end + 1, end + 2});
  mesh.triangles.push_back({end, end + 2, end + 3});
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Draws space out about a point by up to `kDraw`, within about `radius`; the farther, the less.
struct Lens {
  static constexpr double kDraw = 2.4;
  Vec3 centre;
  double radius;
  double drawn(double r) const { return r * (1 + (kDraw - 1) * std::exp(-r * r / (radius * radius))); }
  Vec3 apply(const Vec3& p) const {
    const Vec3 d = p - centre;
    const double r = d.norm();
    return r < 1e-9 ? p : Vec3(centre + drawn(r) / r * d);
  }
  Vec3 undo(const Vec3& p) const {
    const Vec3 d = p - centre;
    const double r = d.norm();
    double low = 0, high = r;
    for (int i = 0; i < 50; ++i) (drawn((low + high) / 2) < r ? low : high) = (low + high) / 2;
    return r < 1e-9 ? p : Vec3(centre + low / r * d);
  }
};

/// Moves vertices along the normals of their triangles until these lie as much within the shape as outside
/// it.
void fit(TriMesh& mesh, const Field& shape) {
  constexpr int kSamples = 4;
  for (int round = 0; round < 25; ++round) {
    std::vector<Vec3> push(mesh.vertices.size(), Vec3::Zero());
    std::vector<double> weight(mesh.vertices.size(), 0.0);
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      const Vec3 cross = (b - a).cross(c - a), normal = cross.normalized();
      for (int i = 0; i <= kSamples; ++i)
        for (int j = 0; i + j <= kSamples; ++j) {
          const Vec3 w(double(i) / kSamples, double(j) / kSamples, double(kSamples - i - j) / kSamples);
          const double off = std::clamp(shape(w[0] * a + w[1] * b + w[2] * c), -3.0, 3.0);
          for (int k = 0; k < 3; ++k) {
            push[t[k]] -= cross.norm() * w[k] * off * normal;
            weight[t[k]] += cross.norm() * w[k];
          }
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (weight[i] > 0) mesh.vertices[i] += 0.4 * push[i] / weight[i];
  }
}

/// The scapula in 110 triangles, most of them in the socket and the roof: simplified in a space that is drawn
/// out there.
TriMesh coarseScapula(const TriMesh& visual, const Field& shape) {
  const Lens socket{scapula::glenoid().origin, 24}, roof{scapula::acromion().origin, 33};
  TriMesh drawn = visual;
  for (Vec3& p : drawn.vertices) p = roof.apply(socket.apply(p));
  TriMesh coarse = simplified(drawn, 110);
  for (Vec3& p : coarse.vertices) p = socket.undo(roof.undo(p));
  fit(coarse, shape);
  return coarse;
}

}  // namespace

Field fieldOf(const TriMesh& closed) {
  const auto tree = std::make_shared<const TriangleTree>(closed);
  return [tree](const Vec3& p) { return tree->signedDistance(p); };
}

Bones makeBones() {
  Bones bones;
  bones.humerusShape = humerus::field();
  bones.scapulaShape = scapula::field();
  const auto fine = [](const Field& shape, const Box3& box, double h) {
    TriMesh mesh = largestComponent(isosurface(shape, box, h));
    relax(mesh, shape, 3);
    return mesh;
  };
  const TriMesh humerusFine = fine(bones.humerusShape, Box3(Vec3(-45, -310, -40), Vec3(45, 40, 105)), 1.6);
  const TriMesh scapulaFine = fine(bones.scapulaShape, Box3(Vec3(-100, -155, -130), Vec3(45, 60, 25)), 1.3);
  bones.humerus = {simplified(humerusFine, 5188), coarseHumerus(bones.humerusShape)};
  bones.scapula.visual = simplified(scapulaFine, 10224);
  bones.scapula.collision = coarseScapula(bones.scapula.visual, bones.scapulaShape);
  bones.humerusCoarse = fieldOf(bones.humerus.collision);
  // Coarse triangles fill the socket: it keeps off the head, at least as far as the labrum's edge needs.
  keepClear(bones.scapula.collision, bones.humerusCoarse, 1.8);
  bones.scapulaCoarse = fieldOf(bones.scapula.collision);
  return bones;
}

}  // namespace glenoid::generate
