// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/TruthBlocks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/mesh/GridBox.h"

namespace glenoid::truth {

TriMesh boxSurface(const Vec3& low, const Vec3& high, int n) {
  return gridBox(low, high, {n, n, n});
}

TetMesh boxVolume(const Vec3& low, const Vec3& high, int nx, int ny, int nz) {
  TetMesh mesh;
  const auto node = [&](int x, int y, int z) { return x + (nx + 1) * (y + (ny + 1) * z); };
  for (int z = 0; z <= nz; ++z)
    for (int y = 0; y <= ny; ++y)
      for (int x = 0; x <= nx; ++x)
        mesh.nodes.push_back(low +
                             (high - low).cwiseProduct(Vec3(double(x) / nx, double(y) / ny, double(z) / nz)));
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        std::array<int, 8> c;
        for (int k = 0; k < 8; ++k) c[k] = node(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
        const bool odd = (x + y + z) % 2;
        const int even4[5][4] = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};
        const int odd4[5][4] = {{1, 0, 5, 3}, {2, 3, 6, 0}, {4, 5, 0, 6}, {7, 6, 3, 5}, {0, 3, 6, 5}};
        for (const auto& tet : odd ? odd4 : even4) {
          std::array<int, 4> t{c[tet[0]], c[tet[1]], c[tet[2]], c[tet[3]]};
          mesh.tets.push_back(t);
          if (tetVolume(mesh, static_cast<int>(mesh.tets.size()) - 1) < 0)
            std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
        }
      }
  return mesh;
}

Part boxPart(const std::string& id, int number, PartKind kind, const Vec3& low, const Vec3& high, int cells) {
  Part part;
  part.id = id;
  part.number = number;
  part.name = id;
  part.kind = kind;
  part.visual = std::make_shared<TriMesh>(boxSurface(low, high, 4));
  part.collision = std::make_shared<TriMesh>(boxSurface(low, high, 2));
  if (kind == PartKind::Soft) {
    part.volume = std::make_shared<TetMesh>(boxVolume(low, high, cells, cells, cells));
    part.cellSize = (high - low).maxCoeff() / cells;
  }
  part.materials = {{kind == PartKind::Soft ? "tissue" : "bone", ""}};
  return part;
}

Region regionIn(const Part& part, const std::string& id, const Box3& box) {
  std::vector<int> triangles;
  for (std::size_t t = 0; t < part.visual->triangles.size(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (const int v : part.visual->triangles[t]) centroid += part.visual->vertices[v] / 3;
    if (box.contains(centroid)) triangles.push_back(static_cast<int>(t));
  }
  return {id, id, "footprint", SurfaceKind::Visual, runsOf(triangles)};
}

void addMaterials(Joint& joint) {
  Material bone;
  bone.id = bone.name = "bone";
  bone.density = 2000;
  Material tissue;
  tissue.id = tissue.name = "tissue";
  tissue.density = 1000;
  tissue.youngsModulus = 5e4;
  tissue.poissonRatio = 0.4;
  tissue.stiffnessDamping = 1e-3;
  joint.materials = {bone, tissue};
}

TetMesh gradedVolume(const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<double>& z) {
  const int nx = static_cast<int>(x.size()) - 1, ny = static_cast<int>(y.size()) - 1,
            nz = static_cast<int>(z.size()) - 1;
  TetMesh mesh = boxVolume(Vec3::Zero(), Vec3(nx, ny, nz), nx, ny, nz);
  for (Vec3& node : mesh.nodes)
    node = Vec3(x[std::lround(node.x())], y[std::lround(node.y())], z[std::lround(node.z())]);
  return mesh;
}

TriMesh gradedSurface(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& z) {
  const TetMesh volume = gradedVolume(x, y, z);
  // Faces of one tetrahedron only; their nodes in the order that looks outwards.
  std::map<std::array<int, 3>, std::array<int, 3>> faces;
  for (const auto& t : volume.tets)
    for (const auto& face : {std::array{t[0], t[2], t[1]}, std::array{t[0], t[1], t[3]},
                             std::array{t[1], t[2], t[3]}, std::array{t[0], t[3], t[2]}}) {
      std::array<int, 3> key = face;
      std::sort(key.begin(), key.end());
      if (!faces.erase(key)) faces[key] = face;
    }
  TriMesh mesh;
  std::map<int, int> vertexOf;
  for (const auto& [key, face] : faces) {
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const auto [it, isNew] = vertexOf.try_emplace(face[k], static_cast<int>(mesh.vertices.size()));
      if (isNew) mesh.vertices.push_back(volume.nodes[face[k]]);
      triangle[k] = it->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

Part plainBox(const std::string& id, int number, const Vec3& low, const Vec3& high) {
  Part part = boxPart(id, number, PartKind::Rigid, low, high);
  part.visual = part.collision = std::make_shared<TriMesh>(boxSurface(low, high, 1));
  return part;
}

Box3 levelAt(int axis, double at) {
  Vec3 low(-1, -1, -1), high(1, 1, 1);
  low[axis] = at - 1e-6;
  high[axis] = at + 1e-6;
  return {low, high};
}

TruthScene namedScene(const char* id) {
  TruthScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = id;
  addMaterials(scene.joint);
  return scene;
}

}  // namespace glenoid::truth
