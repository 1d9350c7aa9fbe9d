// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Isosurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace glenoid {

namespace {

/// Grid samples of the field, x fastest.
struct Grid {
  Box3 box;
  double h;
  int nx, ny, nz;
  std::vector<float> values;

  Grid(const ScalarField& field, const Box3& b, double step) : box(b), h(step) {
    nx = int(std::ceil(b.sizes().x() / h)) + 1;
    ny = int(std::ceil(b.sizes().y() / h)) + 1;
    nz = int(std::ceil(b.sizes().z() / h)) + 1;
    values.resize(std::size_t(nx) * ny * nz);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const float v = float(field(at(long(i))));
      values[i] = v == 0 ? 1e-6f : v;  // a node on the surface would make flat triangles
    }
  }
  long index(int x, int y, int z) const { return x + long(nx) * (y + long(ny) * z); }
  Vec3 at(long i) const {
    return box.min() + h * Vec3(double(i % nx), double(i / nx % ny), double(i / (long(nx) * ny)));
  }
};

class Marcher {
 public:
  explicit Marcher(const Grid& grid) : m_grid(grid) {}

  void tetrahedron(const std::array<long, 4>& n) {
    std::array<long, 4> in{}, out{};
    int inside = 0, outside = 0;
    for (const long i : n) (m_grid.values[i] < 0 ? in[inside++] : out[outside++]) = i;
    if (inside == 1) triangle(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]), in[0]);
    if (inside == 3) triangle(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]), in[0]);
    if (inside == 2) {
      const int a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                d = cut(in[1], out[0]);
      triangle(a, b, c, in[0]);
      triangle(a, c, d, in[1]);
    }
  }
  TriMesh take() { return std::move(m_mesh); }

 private:
  int cut(long a, long b) {
    if (a > b) std::swap(a, b);
    const auto [found, isNew] =
        m_edges.try_emplace(std::uint64_t(a) << 32 | std::uint64_t(b), int(m_mesh.vertices.size()));
    if (isNew) {
      const double va = m_grid.values[a], vb = m_grid.values[b];
      const double t = std::clamp(va / (va - vb), 0.02, 0.98);
      m_mesh.vertices.push_back((1 - t) * m_grid.at(a) + t * m_grid.at(b));
    }
    return found->second;
  }
  void triangle(int a, int b, int c, long insideNode) {
    const Vec3 &pa = m_mesh.vertices[a], &pb = m_mesh.vertices[b], &pc = m_mesh.vertices[c];
    const bool outward = (pb - pa).cross(pc - pa).dot(pa - m_grid.at(insideNode)) > 0;
    m_mesh.triangles.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
  }

  const Grid& m_grid;
  TriMesh m_mesh;
  std::unordered_map<std::uint64_t, int> m_edges;  // looked up only, never walked
};

}  // namespace

TriMesh isosurface(const ScalarField& field, const Box3& box, double h) {
  const Grid grid(field, box, h);
  Marcher marcher(grid);
  // The six orders in which a path can walk from corner 000 to 111.
  constexpr int kAxes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int z = 0; z + 1 < grid.nz; ++z)
    for (int y = 0; y + 1 < grid.ny; ++y)
      for (int x = 0; x + 1 < grid.nx; ++x) {
        int negative = 0;
        for (int c = 0; c < 8; ++c)
          negative += grid.values[grid.index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))] < 0;
        if (negative == 0 || negative == 8) continue;
        for (const auto& order : kAxes) {
          std::array<int, 3> corner{x, y, z};
          std::array<long, 4> nodes{grid.index(x, y, z), 0, 0, 0};
          for (int k = 0; k < 3; ++k) {
            ++corner[order[k]];
            nodes[k + 1] = grid.index(corner[0], corner[1], corner[2]);
          }
          marcher.tetrahedron(nodes);
        }
      }
  return marcher.take();
}

std::vector<Vec3> neighbourMeans(const TriMesh& mesh) {
  std::vector<Vec3> mean(mesh.vertices.size(), Vec3::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      mean[t[k]] += mesh.vertices[t[(k + 1) % 3]];
      ++count[t[k]];
    }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mean[i] = count[i] > 0 ? Vec3(mean[i] / count[i]) : mesh.vertices[i];
  return mean;
}

TriMesh largestComponent(const TriMesh& mesh) {
  std::vector<int> root(mesh.vertices.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : mesh.triangles)
    for (int k = 1; k < 3; ++k) root[find(t[k])] = find(t[0]);
  std::map<int, int> size;
  for (const auto& t : mesh.triangles) ++size[find(t[0])];
  int best = -1;
  for (const auto& [id, n] : size)
    if (best < 0 || n > size[best]) best = id;
  TriMesh kept;
  std::vector<int> renamed(mesh.vertices.size(), -1);
  for (auto t : mesh.triangles) {
    if (find(t[0]) != best) continue;
    for (int& v : t) {
      if (renamed[v] < 0) {
        renamed[v] = int(kept.vertices.size());
        kept.vertices.push_back(mesh.vertices[v]);
      }
      v = renamed[v];
    }
    kept.triangles.push_back(t);
  }
  return kept;
}

}  // namespace glenoid
