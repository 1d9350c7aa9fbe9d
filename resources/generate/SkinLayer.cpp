// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "resources/generate/Superficial.h"

namespace glenoid::generate {
namespace {

constexpr double kThickness = 10;   ///< mm, fat and skin
constexpr double kGap = 1.5;        ///< mm above what lies below
constexpr double kSide = 78;        ///< degrees to the front and to the back, where it reaches farthest
constexpr int kCoarser = 4;          ///< fine cells along a coarse one
static_assert(kSkinAcross % kCoarser == 0 && kSkinAlong % kCoarser == 0);

/// A fan of half planes that turns from the neck (cut upright along the body) over the joint down the arm (cut level):
/// where it stands, and which way is out in its middle.
struct Cut {
  Vec3 centre, out;
};

Cut stopsAt(double v) {
  struct Stop {
    double v, y, z, angle;
  };
  // Angle of `out` from upright, degrees.
  constexpr Stop stops[] = {{0, 0, -62, -6}, {0.25, -4, -28, 8}, {0.45, -10, -2, 42}, {0.62, -24, 8, 80}, {0.8, -62, 18, 92}, {1, -118, 30, 94}};
  int i = 0;
  while (i + 2 < int(std::size(stops)) && stops[i + 1].v < v) ++i;
  const double t = (v - stops[i].v) / (stops[i + 1].v - stops[i].v), s = t * t * (3 - 2 * t);
  const auto mix = [](double a, double b, double w) { return a + (b - a) * w; };
  const double angle = mix(stops[i].angle, stops[i + 1].angle, s) * std::numbers::pi / 180;
  const double x = v < 0.5 ? -8 : -8 + 6 * (v - 0.5) / 0.5;
  return {{x, mix(stops[i].y, stops[i + 1].y, t), mix(stops[i].z, stops[i + 1].z, t)}, {0, std::cos(angle), std::sin(angle)}};
}

/// Evened out over a stretch of the way.
Cut evenCutAt(double v) {
  constexpr int kSamples = 8;  // to either side
  constexpr double kStretch = 0.12;
  Cut sum{Vec3::Zero(), Vec3::Zero()};
  double weights = 0;
  for (int k = -kSamples; k <= kSamples; ++k) {
    const double t = double(k) / (kSamples + 1), weight = (1 - t * t) * (1 - t * t);
    const double reach = std::min({kStretch, v, 1 - v});  // both ends stay where they are
    const Cut cut = stopsAt(std::clamp(v + reach * t, 0.0, 1.0));
    sum.centre += weight * cut.centre;
    sum.out += weight * cut.out;
    weights += weight;
  }
  return {sum.centre / weights, sum.out.normalized()};
}

/// Towards the borders in front and behind, which turn without a kink, the even one.
Cut cutAt(double u, double v) {
  const double aside = (2 * u - 1) * (2 * u - 1), weight = aside * aside;
  const Cut cut = stopsAt(v), even = evenCutAt(v);
  return {(1 - weight) * cut.centre + weight * even.centre, ((1 - weight) * cut.out + weight * even.out).normalized()};
}

/// Half the angle that the layer covers: less towards the neck and the arm's end, which rounds its four corners.
double sideAt(double v) {
  const double neck = std::max(0.0, 1 - v / 0.28), arm = std::max(0.0, 1 - (1 - v) / 0.2);
  return kSide * (1 - 0.34 * neck * neck * neck - 0.12 * arm * arm * arm) * std::numbers::pi / 180;
}

Vec3 ray(const Cut& cut, double u, double v) {
  const double a = sideAt(v) * (1 - 2 * u);  // front first
  return std::cos(a) * cut.out + std::sin(a) * Vec3::UnitX();
}

/// How far out the ground reaches along each ray of a grid, smoothed from above: never below what it was.
std::vector<double> heights(const Field& ground, int across, int along) {
  const auto at = [&](int i, int j) { return j * (across + 1) + i; };
  std::vector<double> height((across + 1) * (along + 1), 30);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= across; ++i) {
      const Cut cut = cutAt(double(i) / across, double(j) / along);
      const Vec3 d = ray(cut, double(i) / across, double(j) / along);
      double r = 130;
      while (r > 20) {
        const double away = ground(cut.centre + r * d);
        if (away < 0.3) break;
        r -= std::max(0.3, 0.8 * away);
      }
      height[at(i, j)] = std::max(r, 26.0);
    }
  const std::vector<double> least = height;
  for (int round = 0; round < 160; ++round) {
    std::vector<double> next = height;
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        double sum = 0;
        int n = 0;
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const int k = i + di, l = j + dj;
          if (k < 0 || l < 0 || k > across || l > along) continue;
          sum += height[at(k, l)];
          ++n;
        }
        next[at(i, j)] = std::max(least[at(i, j)], 0.4 * height[at(i, j)] + 0.6 * sum / n);
      }
    height = std::move(next);
  }
  return height;
}

/// Of a finer grid every kCoarser-th, the highest of its neighbourhood: chords of the coarse sheet cut less deep.
std::vector<double> coarser(const std::vector<double>& height) {
  std::vector<double> result;
  for (int j = 0; j <= kSkinAlong; j += kCoarser)
    for (int i = 0; i <= kSkinAcross; i += kCoarser) {
      double highest = 0;
      for (int l = std::max(j - 1, 0); l <= std::min(j + 1, kSkinAlong); ++l)
        for (int k = std::max(i - 1, 0); k <= std::min(i + 1, kSkinAcross); ++k)
          highest = std::max(highest, height[l * (kSkinAcross + 1) + k]);
      result.push_back(highest);
    }
  return result;
}

/// Two sheets over the grid and a rim that joins them.
TriMesh shell(const std::vector<double>& height, int across, int along) {
  TriMesh mesh;
  for (const double lift : {kGap, kGap + kThickness})
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        const Cut cut = cutAt(double(i) / across, double(j) / along);
        mesh.vertices.push_back(cut.centre + (height[j * (across + 1) + i] + lift) * ray(cut, double(i) / across, double(j) / along));
      }
  const int sheet = (across + 1) * (along + 1);
  const auto at = [&](int i, int j) { return j * (across + 1) + i; };
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      quad(a, b, c, d);
      quad(sheet + a, sheet + d, sheet + c, sheet + b);
    }
  for (int i = 0; i < across; ++i) {
    quad(at(i, 0), sheet + at(i, 0), sheet + at(i + 1, 0), at(i + 1, 0));
    quad(at(i + 1, along), sheet + at(i + 1, along), sheet + at(i, along), at(i, along));
  }
  for (int j = 0; j < along; ++j) {
    quad(at(0, j + 1), sheet + at(0, j + 1), sheet + at(0, j), at(0, j));
    quad(at(across, j), sheet + at(across, j), sheet + at(across, j + 1), at(across, j + 1));
  }
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

Surfaces skinLayer(const Ground& ground) {
  Surfaces s;
  const std::vector<double> height = heights(unionOf(ground.visual, ground.coarse), kSkinAcross, kSkinAlong);
  s.visual = shell(height, kSkinAcross, kSkinAlong);
  s.collision = shell(coarser(height), kSkinAcross / kCoarser, kSkinAlong / kCoarser);
  keepClear(s.collision, ground.coarse, 0.8);
  return s;
}

}  // namespace glenoid::generate
