// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simcore/file/ByteReader.h"
#include "simcore/file/Ply.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

TriMesh tetrahedron() {
  TriMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 1.0 / 3.0, 0}, {0, 0, -1e-300}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

std::string ascii(const std::string& vertices, const std::string& faces, int vertexCount, int faceCount) {
  return "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex " + std::to_string(vertexCount) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faceCount) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + faces;
}

const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Error faultOf(const std::string& bytes) {
  const auto mesh = parsePly(bytes, "m.ply");
  EXPECT_FALSE(mesh.ok());
  return mesh.ok() ? Error{} : mesh.error();
}

TEST(Ply, whatIsWrittenComesBackBitForBit) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writePly(folder.path("m.ply"), tetrahedron()).ok());
  const auto back = readPly(folder.path("m.ply"));
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  EXPECT_EQ(*back, tetrahedron());
}

/// The same square in either byte order, with columns and elements that are none of ours in between.
TEST(Ply, binaryOfBothOrdersWithForeignColumns) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string bytes =
        std::string("ply\r\nformat binary_") + (order == std::endian::big ? "big" : "little") +
        "_endian 1.0\r\nelement camera 1\r\nproperty list ushort double lens\r\nelement face 2\r\n"
        "property uchar red\r\nproperty list uint8 uint32 vertex_index\r\nelement vertex 4\r\n"
        "property float nx\r\nproperty double x\r\nproperty float y\r\nproperty short z\r\nend_header\r\n";
    appendBytes<std::uint16_t>(2, order, bytes);
    for (const double d : {1.5, 2.5}) appendBytes(d, order, bytes);
    for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      bytes += std::string("\xff\x03", 2);
      for (const std::uint32_t index : t) appendBytes(index, order, bytes);
    }
    for (const auto& [x, y] : {std::pair(0.0, 0.0f), {1.25, 0.0f}, {1.25, 0.5f}, {0.0, 0.5f}}) {
      appendBytes(9.0f, order, bytes);
      appendBytes(x, order, bytes);
      appendBytes(y, order, bytes);
      appendBytes<std::int16_t>(-7, order, bytes);
    }
    const auto mesh = parsePly(bytes, "m.ply");
    ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
    EXPECT_EQ(mesh->vertices, (std::vector<Vec3>{{0, 0, -7}, {1.25, 0, -7}, {1.25, 0.5, -7}, {0, 0.5, -7}}));
    EXPECT_EQ(mesh->triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
  }
}

TEST(Ply, polygonsBecomeFansAndAreCounted) {
  PlyNotes notes;
  const auto mesh = parsePly(ascii(kSquare, "4 0 1 2 3\n3 0 1 2\n", 4, 2), "m.ply", &notes);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(notes.polygonsSplit, 1);
}

TEST(Ply, decimalCommasAreNumbers) {
  const auto mesh = parsePly(ascii("0 0 0\n1,5 -0,25 1,5e-1\n1 1 0\n", "3 0 1 2\n", 3, 1), "m.ply");
  ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
  EXPECT_EQ(mesh->vertices[1], Vec3(1.5, -0.25, 0.15));
  for (const char* wrong : {"1,5,0", "1.5,0", ",", "a,5"})
    EXPECT_FALSE(parsePly(ascii("0 0 0\n" + std::string(wrong) + " 0 0\n1 1 0\n", "3 0 1 2\n", 3, 1), "m.ply").ok()) << wrong;
}

TEST(Ply, concavePolygonsKeepTheirArea) {
  const auto areaOf = [](const TriMesh& mesh, bool& folds) {
    double area = 0;
    folds = false;
    for (const auto& t : mesh.triangles) {
      const double z = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).z() / 2;
      folds = folds || z < 0;
      area += std::abs(z);
    }
    return area;
  };
  // A star of five points of radius 2 and 0.8, from each of its corners as the first: area 5 · 2 · 0.8 · sin 36°.
  std::string points;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 ? 0.8 : 2, angle = i * 0.6283185307179586;
    points += std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + " 0\n";
  }
  for (int first = 0; first < 10; ++first) {
    std::string face = "10";
    for (int i = 0; i < 10; ++i) face += " " + std::to_string((first + i) % 10);
    bool folds = true;
    PlyNotes notes;
    const auto star = parsePly(ascii(points, face + "\n3 0 1 2\n", 10, 2), "m.ply", &notes);
    ASSERT_TRUE(star.ok());
    EXPECT_EQ(star->triangles.size(), 9u);
    EXPECT_EQ(star->triangles.back(), (std::array<int, 3>{0, 1, 2})) << "faces keep their order";
    TriMesh whole = *star;
    whole.triangles.pop_back();
    EXPECT_NEAR(areaOf(whole, folds), 5 * 2 * 0.8 * std::sin(0.6283185307179586), 1e-4) << first;
    EXPECT_FALSE(folds) << first;
    EXPECT_EQ(notes.polygonsSplit, 1);
  }
}

TEST(Ply, faultsNameTheElement) {
  const Error nan = faultOf(ascii("0 0 0\n1 nan 0\n1 1 0\n", "3 0 1 2\n", 3, 1));
  EXPECT_EQ(nan.fault, Fault::NotFinite);
  EXPECT_EQ(nan.place.element, 1);
  EXPECT_EQ(nan.place.file, "m.ply");
  EXPECT_EQ(faultOf(ascii("0 0 0\n1 1e999 0\n1 1 0\n", "3 0 1 2\n", 3, 1)).fault, Fault::NotFinite);
  const Error index = faultOf(ascii(kSquare, "3 0 1 2\n3 0 4 2\n", 4, 2));
  EXPECT_EQ(index.fault, Fault::BadIndex);
  EXPECT_EQ(index.place.element, 1);
  EXPECT_EQ(index.arguments, (Arguments{"4", "4"}));
  EXPECT_EQ(faultOf(ascii(kSquare, "3 0 -1 2\n", 4, 1)).fault, Fault::BadIndex);
  EXPECT_EQ(faultOf(ascii(kSquare, "3 0 1.5 2\n", 4, 1)).fault, Fault::BadIndex);
  EXPECT_EQ(faultOf(ascii(kSquare, "2 0 1 0\n", 4, 1)).fault, Fault::BadMesh);
  EXPECT_EQ(faultOf(ascii("0 0 zero\n1 1 1\n1 1 0\n", "3 0 1 2\n", 3, 1)).fault, Fault::BadMesh);
  EXPECT_EQ(faultOf(ascii(kSquare, "", 4, 0)).fault, Fault::BadMesh);
}

TEST(Ply, countsThatTheFileCannotHoldAreTruncation) {
  EXPECT_EQ(faultOf(ascii(kSquare, "3 0 1 2\n", 2000000000, 1)).fault, Fault::FileTruncated);
  EXPECT_EQ(faultOf(ascii(kSquare, "3 0 1 2\n", 4, 2)).fault, Fault::FileTruncated);
  EXPECT_EQ(faultOf(ascii(kSquare, "200 0 1 2\n", 4, 1)).fault, Fault::FileTruncated);
}

TEST(Ply, headersThatMakeNoSense) {
  EXPECT_EQ(faultOf("solid stl\n").fault, Fault::UnknownFormat);
  EXPECT_EQ(faultOf("\x89PNG\r\n").fault, Fault::UnknownFormat);
  const std::string tail = "end_header\n";
  struct Case {
    const char* header;
    long line;
  };
  for (const Case& c : {Case{"ply\nformat utf8 1.0\n", 2},
                        {"ply\nformat ascii 2.0\n", 2},
                        {"ply\nformat ascii 1.0\nelement vertex -1\n", 3},
                        {"ply\nformat ascii 1.0\nproperty int x\n", 3},
                        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", 4},
                        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n", 4},
                        {"ply\nformat ascii 1.0\nnonsense\n", 3}}) {
    const Error error = faultOf(c.header + tail);
    EXPECT_EQ(error.fault, Fault::BadMesh) << c.header;
    EXPECT_EQ(error.place.element, c.line) << c.header;
  }
  EXPECT_EQ(faultOf("ply\nend_header\n").fault, Fault::BadMesh);
  EXPECT_EQ(faultOf("ply\nformat ascii 1.0\nend_header\n").fault, Fault::BadMesh);
}

TEST(Ply, nothingIsWrittenThatCouldNotBeRead) {
  const TemporaryFolder folder;
  TriMesh mesh = tetrahedron();
  mesh.triangles[2][1] = 4;
  const auto index = writePly(folder.path("m.ply"), mesh);
  ASSERT_FALSE(index.ok());
  EXPECT_EQ(index.error().fault, Fault::BadIndex);
  EXPECT_EQ(index.error().place.element, 2);
  mesh = tetrahedron();
  mesh.vertices[3].z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(writePly(folder.path("m.ply"), mesh).error().fault, Fault::NotFinite);
  EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace glenoid
