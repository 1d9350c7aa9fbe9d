// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/resources/ReferenceMesh.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid::test {

std::optional<std::string> referenceFolder() {
  const char* named = std::getenv("GLENOID_ANATOMY");
  const std::string folder = named ? named : GLENOID_SOURCE_DIR "/../shared/data/anatomy";
  if (std::filesystem::is_directory(folder)) return folder;
  return std::nullopt;
}

TriMesh referenceMesh(const std::string& folder, const std::string& file) {
  constexpr double kScale = 1.0975;
  const Vec3 head(71.8497, 1324.9819, 162.6776);  // in the turned frame
  std::ifstream in(folder + "/" + file, std::ios::binary);
  TriMesh mesh;
  char header[80];
  std::uint32_t count = 0;
  if (!in.read(header, 80) || !in.read(reinterpret_cast<char*>(&count), 4)) return mesh;
  std::map<std::array<float, 3>, int> known;
  for (std::uint32_t t = 0; t < count; ++t) {
    float numbers[12];
    char more[2];
    if (!in.read(reinterpret_cast<char*>(numbers), sizeof numbers) || !in.read(more, 2)) break;
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const std::array<float, 3> p{numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]};
      const auto [found, isNew] = known.try_emplace(p, int(mesh.vertices.size()));
      if (isNew) mesh.vertices.push_back(kScale * (Vec3(-p[1], p[2], -p[0]) - head));
      corners[k] = found->second;
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
      mesh.triangles.push_back(corners);
  }
  return mesh;
}

TriMesh aligned(const TriMesh& moved, const TriMesh& still, int rounds) {
  const TriangleTree tree(still);
  TriMesh mesh = moved;
  for (int round = 0; round < rounds; ++round) {
    struct Pair {
      double distance;
      Vec3 from, to;
    };
    std::vector<Pair> pairs;
    for (const Vec3& p : mesh.vertices) {
      const auto hit = tree.closest(p);
      pairs.push_back({hit.distance, p, hit.point});
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    pairs.resize(pairs.size() * 4 / 5);
    Eigen::Matrix3Xd from(3, pairs.size()), to(3, pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) from.col(i) = pairs[i].from, to.col(i) = pairs[i].to;
    const Eigen::Matrix4d step = Eigen::umeyama(from, to, false);
    for (Vec3& p : mesh.vertices) p = (step * p.homogeneous()).head<3>();
  }
  return mesh;
}

}  // namespace glenoid::test
