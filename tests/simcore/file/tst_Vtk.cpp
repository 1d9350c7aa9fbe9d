// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "simcore/file/ByteReader.h"
#include "simcore/file/Vtk.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

TetMesh twoTets() {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {0.1, 0, 0}, {0, 1.0 / 3.0, 0}, {0, 0, 0.1}, {0.2, 0.3, 0.4}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  return mesh;
}

Error faultOf(const std::string& bytes) {
  const auto mesh = parseVtk(bytes, "m.vtk");
  EXPECT_FALSE(mesh.ok());
  return mesh.ok() ? Error{} : mesh.error();
}

const std::string kHead = "# vtk DataFile Version 2.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const std::string kPoints = "POINTS 4 float\n0 0 0 1 0 0\n0 1 0 0 0 1\n";
const std::string kCells = "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";

TEST(Vtk, whatIsWrittenComesBackBitForBit) {
  const TemporaryFolder folder;
  for (const VtkEncoding encoding : {VtkEncoding::Ascii, VtkEncoding::Binary}) {
    ASSERT_TRUE(writeVtk(folder.path("m.vtk"), twoTets(), encoding).ok());
    const auto back = readVtk(folder.path("m.vtk"));
    ASSERT_TRUE(back.ok()) << toLogLine(back.error());
    EXPECT_EQ(*back, twoTets());
  }
}

TEST(Vtk, orderAndForeignDataDoNotMatter) {
  const auto mesh = parseVtk(kHead + "CELL_TYPES 1\n10\nCELLS 1 5\n4 0 1 2 3\n" + kPoints +
                                 "POINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE default\n0 0 0 0\n",
                             "m.vtk");
  ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
  EXPECT_EQ(mesh->nodes[3], Vec3(0, 0, 1));
}

TEST(Vtk, version5HasOffsetsAndConnectivity) {
  const std::string head =
      "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n";
  std::string bytes = head;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) appendBytes(x, std::endian::big, bytes);
  bytes += "\nMETADATA\nINFORMATION 0\n\nCELLS 2 4\nOFFSETS vtktypeint64\n";
  for (const std::int64_t i : {0, 4}) appendBytes(i, std::endian::big, bytes);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t i : {0, 1, 2, 3}) appendBytes(i, std::endian::big, bytes);
  bytes += "\nCELL_TYPES 1\n";
  appendBytes<std::int32_t>(10, std::endian::big, bytes);
  const auto mesh = parseVtk(bytes, "m.vtk");
  ASSERT_TRUE(mesh.ok()) << toLogLine(mesh.error());
  EXPECT_EQ(mesh->tets, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh->nodes[1], Vec3(1, 0, 0));
}

TEST(Vtk, elementsWithoutVolumeAreNamed) {
  TetMesh flat = twoTets();
  flat.nodes[4] = (flat.nodes[1] + flat.nodes[2] + flat.nodes[3]) / 3;  // in the plane, up to round-off
  const auto checked = checkTetMesh(flat, "m.vtk");
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().fault, Fault::BadElement);
  EXPECT_EQ(checked.error().place.element, 1);
  EXPECT_EQ(checked.error().place.file, "m.vtk");
  ASSERT_EQ(checked.error().arguments.size(), 1u);
  TetMesh inverted = twoTets();
  std::swap(inverted.tets[0][1], inverted.tets[0][2]);
  EXPECT_EQ(checkTetMesh(inverted, "m").error().place.element, 0);
  EXPECT_EQ(checkTetMesh(inverted, "m").error().fault, Fault::BadElement);
  TetMesh repeated = twoTets();
  repeated.tets[1] = {1, 1, 2, 3};
  EXPECT_EQ(checkTetMesh(repeated, "m").error().fault, Fault::BadElement);
  TetMesh point = twoTets();
  for (Vec3& x : point.nodes) x.setZero();
  EXPECT_EQ(checkTetMesh(point, "m").error().fault, Fault::BadElement);
  const TemporaryFolder folder;
  EXPECT_EQ(writeVtk(folder.path("m.vtk"), flat).error().fault, Fault::BadElement);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(Vtk, aSmallElementIsNoFlatOne) {
  TetMesh small = twoTets();
  for (Vec3& x : small.nodes) x *= 1e-9;
  EXPECT_TRUE(checkTetMesh(small, "m").ok());
}

TEST(Vtk, otherFaultsNameTheElement) {
  const Error index = faultOf(kHead + kPoints + "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n");
  EXPECT_EQ(index.fault, Fault::BadIndex);
  EXPECT_EQ(index.arguments, (Arguments{"4", "4"}));
  EXPECT_EQ(index.place.element, 0);
  EXPECT_EQ(faultOf(kHead + kPoints + "CELLS 1 5\n4 0 1 2 -3\nCELL_TYPES 1\n10\n").fault, Fault::BadIndex);
  EXPECT_EQ(faultOf(kHead + kPoints + "CELLS 1 5\n4 0 1 2 99999999999\nCELL_TYPES 1\n10\n").fault,
            Fault::BadIndex);
  const Error nan = faultOf(kHead + "POINTS 4 float\n0 0 0 1 0 0\n0 NaN 0 0 0 1\n" + kCells);
  EXPECT_EQ(nan.fault, Fault::NotFinite);
  EXPECT_EQ(nan.place.element, 2);
  const Error hexahedron = faultOf(kHead + kPoints + "CELLS 1 9\n8 0 1 2 3 0 1 2 3\nCELL_TYPES 1\n12\n");
  EXPECT_EQ(hexahedron.fault, Fault::BadMesh);
  EXPECT_EQ(hexahedron.place.element, 0);
  EXPECT_EQ(faultOf(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n").fault, Fault::BadMesh);
  EXPECT_EQ(faultOf(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n").fault, Fault::BadMesh);
  EXPECT_EQ(faultOf(kHead + kPoints + "CELLS 1 5\n4 0 one 2 3\nCELL_TYPES 1\n10\n").fault, Fault::BadMesh);
  EXPECT_EQ(faultOf(kHead + kPoints + "LINES 1\n" + kCells).fault, Fault::BadMesh);
}

TEST(Vtk, otherFormatsAndTruncation) {
  EXPECT_EQ(faultOf("<?xml version=\"1.0\"?>\n").fault, Fault::UnknownFormat);
  EXPECT_EQ(faultOf("# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n").fault,
            Fault::UnknownFormat);
  EXPECT_EQ(faultOf("# vtk DataFile Version 9.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n").fault,
            Fault::UnknownFormat);
  EXPECT_EQ(faultOf(kHead).fault, Fault::FileTruncated);
  EXPECT_EQ(faultOf(kHead + "POINTS 2000000000 float\n0 0 0\n").fault, Fault::FileTruncated);
  EXPECT_EQ(faultOf(kHead + kPoints).fault, Fault::FileTruncated);
}

}  // namespace
}  // namespace glenoid
