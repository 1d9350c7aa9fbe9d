// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/repair/Edges.h"
#include "simcore/repair/Thickness.h"
#include "simcore/repair/Topology.h"
#include "simcore/repair/Weld.h"

namespace glenoid {
namespace {

/// Two copies of a sheet, half the thickness to either side along the normals, and a rim of quads between.
TriMesh withTwoSides(const TriMesh& sheet, double thickness) {
  const std::vector<Vec3> normals = vertexNormals(sheet);
  const int n = static_cast<int>(sheet.vertices.size());
  // Where the sheet bends, its faces come nearer than the vertices: pushed out by the cosine, as a mitre joint is.
  std::vector<double> mitre(sheet.vertices.size(), 1);
  for (const auto& t : sheet.triangles) {
    const Vec3 normal = (sheet.vertices[t[1]] - sheet.vertices[t[0]]).cross(sheet.vertices[t[2]] - sheet.vertices[t[0]]).normalized();
    for (const int v : t) mitre[v] = std::min(mitre[v], std::max(0.5, normal.dot(normals[v])));
  }
  TriMesh out;
  for (const double side : {0.5, -0.5})
    for (int v = 0; v < n; ++v) out.vertices.push_back(sheet.vertices[v] + side * thickness / mitre[v] * normals[v]);
  for (const auto& t : sheet.triangles) {
    out.triangles.push_back(t);
    out.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  }
  forEachEdge(sidesOf(sheet.triangles), [&](std::span<const TriangleSide> edge) {
    if (edge.size() != 1) return;
    const int a = edge[0].forward ? edge[0].low : edge[0].high, b = edge[0].forward ? edge[0].high : edge[0].low;
    out.triangles.push_back({b, a, a + n});
    out.triangles.push_back({b, a + n, b + n});
  });
  return out;
}

/// Moves the walls of closed shells apart until they are thick enough, in small steps.
TriMesh withThickWalls(const TriMesh& mesh, double thickness, long& moved) {
  TriMesh out = mesh;
  moved = 0;
  std::vector<std::vector<int>> neighbours(mesh.vertices.size());
  for (const TriangleSide& side : sidesOf(mesh.triangles)) {
    neighbours[side.low].push_back(side.high);
    neighbours[side.high].push_back(side.low);
  }
  std::vector<char> touched(mesh.vertices.size(), 0);
  std::size_t cuts = selfCuts(mesh).size();
  for (int round = 0; round < 12; ++round) {
    const std::vector<Vec3> normals = vertexNormals(out);
    const std::vector<double> walls = wallBehindVertices(out, normals);
    std::vector<double> shift(walls.size(), -1);  // −1: unknown, takes its neighbours'
    double most = 0;
    for (std::size_t v = 0; v < walls.size(); ++v)
      if (walls[v] != HUGE_VAL) {
        shift[v] = std::max(0.0, (thickness - walls[v]) / 2);
        most = std::max(most, shift[v]);
      }
    if (most < 0.01 * thickness) break;
    for (int smoothing = 0; smoothing < 3; ++smoothing) {
      std::vector<double> next = shift;
      for (std::size_t v = 0; v < shift.size(); ++v) {
        double sum = 0;
        int known = 0;
        for (const int o : neighbours[v])
          if (shift[o] >= 0) sum += shift[o], ++known;
        if (known == 0) continue;
        // Never less than the wall itself asks for in the first place.
        next[v] = shift[v] < 0 ? sum / known : std::max(0.5 * (shift[v] + sum / known), 0.75 * shift[v]);
      }
      shift = next;
    }
    // A whole step may fold the surface into itself, as at a rim; a part of it need not.
    bool stepped = false;
    for (double part = 1; part > 0.1 && !stepped; part /= 2) {
      TriMesh tried = out;
      for (std::size_t v = 0; v < shift.size(); ++v) tried.vertices[v] += part * std::max(0.0, shift[v]) * normals[v];
      const std::size_t cutsNow = selfCuts(tried).size();
      if (cutsNow > cuts) continue;
      cuts = cutsNow;
      out = std::move(tried);
      stepped = true;
    }
    if (!stepped) break;
    for (std::size_t v = 0; v < shift.size(); ++v) touched[v] = touched[v] || shift[v] > 0;
  }
  moved = static_cast<long>(std::count(touched.begin(), touched.end(), 1));
  return out;
}

}  // namespace

TriMesh thickened(const TriMesh& mesh, double thickness, long& changed, long& left, double& reached) {
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  std::vector<char> sheets(mesh.triangles.size()), walls(mesh.triangles.size());
  for (std::size_t t = 0; t < sheets.size(); ++t) {
    const Shell& shell = shells.list[shells.ofTriangle[t]];
    sheets[t] = shell.sheet() && shell.openEdges > 0;
    walls[t] = !sheets[t];
  }
  changed = 0;
  TriMesh out;
  const auto append = [&](const TriMesh& piece) {
    const int base = static_cast<int>(out.vertices.size());
    out.vertices.insert(out.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const auto& t : piece.triangles) out.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  };
  if (std::count(walls.begin(), walls.end(), 1) > 0) {
    long moved = 0;
    append(withThickWalls(withTriangles(mesh, walls), thickness, moved));
    changed += moved;
  }
  if (std::count(sheets.begin(), sheets.end(), 1) > 0) {
    const TriMesh two = withTwoSides(withTriangles(mesh, sheets), thickness);
    changed += static_cast<long>(two.vertices.size());
    append(two);
  }
  const ThicknessReport report = measureThickness(out, 0.9 * thickness);
  left = std::lround(1000 * report.thinShare);
  reached = report.median;
  return out;
}

}  // namespace glenoid
