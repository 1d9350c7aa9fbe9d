// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/file/Json.h"
#include "simcore/file/Ply.h"
#include "simcore/file/Vtk.h"
#include "tests/simcore/file/TemporaryFolder.h"

// Whatever a disk or a mail program did to a file: an answer, never a crash, never memory beyond the file's
// size.
namespace glenoid {
namespace {

/// A ball-like strip with enough rows that a cut falls everywhere.
TriMesh strip() {
  TriMesh mesh;
  for (int i = 0; i < 40; ++i) mesh.vertices.push_back({0.01 * i, i % 2 ? 0.01 : 0.0, 0.001 * i * i});
  for (int i = 0; i + 2 < 40; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

TetMesh tower() {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 1; i < 20; ++i) {
    mesh.nodes.push_back({0.1, 0.1, static_cast<double>(i)});
    mesh.tets.push_back({0, 1, 2, 2 + i});
  }
  return mesh;
}

/// splitmix64 (Steele, Lea, Flood 2014): the same damage on every machine.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// Every cut must be found; flipped bytes may give another valid file, but always an answer.
template <class Parse>
void damage(const std::string& whole, Parse&& parse) {
  ASSERT_TRUE(parse(whole).ok());
  for (std::size_t cut = 1; cut <= 50; ++cut) {
    const std::size_t length = whole.size() * (cut - 1) / 50;
    const auto result = parse(whole.substr(0, length));
    ASSERT_FALSE(result.ok()) << "cut at " << length << " of " << whole.size();
    EXPECT_FALSE(result.error().place.file.empty());
  }
  std::uint64_t state = 2010;
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = whole;
    const int flips = 1 + static_cast<int>(next(state) % 4);
    for (int i = 0; i < flips; ++i) {
      const std::size_t at = next(state) % damaged.size();
      damaged[at] = static_cast<char>(next(state));
    }
    const auto result = parse(damaged);
    if (result.ok()) continue;
    ++refused;
    EXPECT_FALSE(result.error().place.file.empty());
    EXPECT_NE(result.error().fault, Fault::Internal);
  }
  EXPECT_GT(refused, 0);
}

TEST(Damaged, ply) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writePly(folder.path("m.ply"), strip()).ok());
  damage(folder.get("m.ply"), [](const std::string& bytes) { return parsePly(bytes, "m.ply"); });
}

TEST(Damaged, vtk) {
  const TemporaryFolder folder;
  for (const VtkEncoding encoding : {VtkEncoding::Ascii, VtkEncoding::Binary}) {
    ASSERT_TRUE(writeVtk(folder.path("m.vtk"), tower(), encoding).ok());
    damage(folder.get("m.vtk"), [](const std::string& bytes) { return parseVtk(bytes, "m.vtk"); });
  }
}

TEST(Damaged, json) {
  JsonValue json = JsonValue::object();
  for (int i = 0; i < 30; ++i) {
    JsonValue row = JsonValue::array();
    row.append(0.1 * i);
    row.append(std::string("a \"word\" \\ ") + std::to_string(i));
    json.set("key " + std::to_string(i), row);
  }
  damage(toText(json), [](const std::string& bytes) { return parseJson(bytes, "x.json"); });
}

}  // namespace
}  // namespace glenoid
