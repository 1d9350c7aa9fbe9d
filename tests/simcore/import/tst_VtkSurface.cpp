// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/vtk/VtkSurface.h"

#include <gtest/gtest.h>

#include "simcore/mesh/PolygonSplit.h"
#include "simcore/mesh/MeshHealth.h"
#include "tests/simcore/import/SampleFiles.h"

namespace glenoid {
namespace {

void expectBox(const Result<ImportedFile>& file, const std::string& what) {
  ASSERT_TRUE(file.ok()) << what << ": " << toLogLine(file.error());
  const MeshHealth health = healthOf(file->surfaces[0].mesh);
  EXPECT_TRUE(health.healthy()) << what;
  EXPECT_EQ(health.triangles, 12) << what;
  EXPECT_DOUBLE_EQ(health.volume, 6) << what;
}

TEST(VtkSurface, legacyTextAndBinaryOfBothGenerations) {
  for (const bool binary : {false, true})
    for (const bool offsets : {false, true})
      expectBox(parseVtkSurface(samples::vtk(binary, offsets), "box.vtk"), std::to_string(binary) + std::to_string(offsets));
}

TEST(VtkSurface, fieldsOfTheWholeMayStandAnywhere) {
  // As VTK 9.1 writes them: right behind the kind of the data set, strings with a length before each, metadata behind an array.
  const std::string text = "FIELD FieldData 4\nfour%20floats 2 2 float\n1.5 2 3 4 \nbits 1 9 bit\n1 0 1 1 0 1 0 1 1 \nSPACE 1 2 string\nSPACE=RAS\na name of words\n"
                           "METADATA\nCOMPONENT_NAMES\nspace\n\nlong 1 1 vtktypeint64\n1099511627776 \n";
  std::string binary = "FIELD FieldData 4\nfour%20floats 2 2 float\n" + std::string(16, '\x0a') + "\nbits 1 9 bit\n" + std::string(2, '\x20') +
                       "\nSPACE 1 2 string\n" + std::string(1, static_cast<char>(0xc9)) + "SPACE=RAS" + std::string("\x80\x64", 2) + std::string(100, 'x') +
                       "\nMETADATA\nCOMPONENT_NAMES\nspace\n\nlong 1 1 vtktypeint64\n" + std::string(8, '\0') + "\n";
  for (const bool isBinary : {false, true})
    for (const bool offsets : {false, true})
      for (const char* before : {"POINTS", "POLYGONS", "CELL_DATA"}) {
        std::string file = samples::vtk(isBinary, offsets);
        file.insert(file.find(before), isBinary ? binary : text);
        expectBox(parseVtkSurface(file, "box.vtk"), std::string(before) + std::to_string(isBinary) + std::to_string(offsets));
      }
  std::string cut = samples::vtk(false, false);
  cut.insert(cut.find("POINTS"), "FIELD FieldData 3\nfew 1 2 float\n1 2\n");
  EXPECT_FALSE(parseVtkSurface(cut, "box.vtk").ok()) << "fewer arrays than it says";
  std::string huge = samples::vtk(true, false);
  huge.insert(huge.find("POINTS"), "FIELD FieldData 1\nall 4000000000 4000000000 double\n");
  EXPECT_EQ(parseVtkSurface(huge, "box.vtk").error().fault, Fault::BadMesh);
  huge = samples::vtk(true, false);
  huge.insert(huge.find("POINTS"), "FIELD FieldData 1\nall 2000000000 2000000000 double\n");
  EXPECT_EQ(parseVtkSurface(huge, "box.vtk").error().fault, Fault::FileTruncated);
}

TEST(VtkSurface, everyPackingOfVtp) {
  using samples::VtpForm;
  for (const VtpForm form : {VtpForm::Ascii, VtpForm::Binary, VtpForm::BinaryZlib, VtpForm::AppendedRaw, VtpForm::AppendedRawZlib,
                             VtpForm::AppendedBase64, VtpForm::AppendedBase64Zlib})
    for (const bool wide : {false, true})
      for (const bool big : {false, true})
        expectBox(parseVtp(samples::vtp(form, wide, big), "box.vtp"),
                  "form " + std::to_string(static_cast<int>(form)) + (wide ? " wide" : "") + (big ? " big" : ""));
}

/// An unstructured grid as text: legacy of both generations, or VTU.
enum class Grid { Counted, Offsets, Xml };
std::string gridText(Grid form, const std::string& points, int count, const std::vector<std::vector<int>>& cells, const std::vector<int>& types) {
  std::string counted, corners, ends = form == Grid::Offsets ? "0 " : "", kinds;
  std::size_t numbers = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    counted += std::to_string(cells[c].size()) + " ";
    for (const int i : cells[c]) counted += std::to_string(i) + " ", corners += std::to_string(i) + " ", ++numbers;
    ends += std::to_string(numbers) + " ";
    kinds += std::to_string(types[c]) + " ";
  }
  const std::string n = std::to_string(cells.size()), p = std::to_string(count);
  if (form == Grid::Xml)
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"" + p +
           "\" NumberOfCells=\"" + n + "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">" + points +
           "</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + corners +
           "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + ends +
           "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + kinds + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
  const std::string head = "\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + p + " double\n" + points + "\n", tail = "\nCELL_TYPES " + n + "\n" + kinds + "\n";
  if (form == Grid::Counted) return "# vtk DataFile Version 3.0" + head + "CELLS " + n + " " + std::to_string(numbers + cells.size()) + "\n" + counted + tail;
  return "# vtk DataFile Version 5.1" + head + "CELLS " + std::to_string(cells.size() + 1) + " " + std::to_string(numbers) + "\nOFFSETS vtktypeint64\n" + ends +
         "\nCONNECTIVITY vtktypeint64\n" + corners + tail;
}

TEST(VtkSurface, theOutsideOfGridsIsTaken) {
  // The unit cube with its middle (8) and a point above it (9).
  const std::string points = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 0.5 0.5 0.5 2";
  struct Case {
    const char* what;
    std::vector<std::vector<int>> cells;
    std::vector<int> types;
    double volume;
    std::size_t triangles;
  };
  for (const Case& one : {Case{"tetrahedron", {{0, 1, 3, 4}}, {10}, 1.0 / 6, 4}, Case{"hexahedron", {{0, 1, 2, 3, 4, 5, 6, 7}}, {12}, 1, 12},
                          Case{"voxel", {{0, 1, 3, 2, 4, 5, 7, 6}}, {11}, 1, 12}, Case{"wedge", {{0, 1, 3, 4, 5, 7}}, {13}, 0.5, 8}, Case{"wedge the other way round", {{0, 3, 1, 4, 7, 5}}, {13}, 0.5, 8},
                          Case{"mirrored hexahedron", {{4, 5, 6, 7, 0, 1, 2, 3}}, {12}, 1, 12},
                          Case{"pyramid", {{0, 1, 2, 3, 8}}, {14}, 1.0 / 6, 6},
                          Case{"a pyramid on a cube, and the marks of a boundary", {{4, 5, 6, 7, 9}, {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 5, 4}, {4, 5, 9}, {4, 5, 6, 7}, {2, 3}, {0}},
                               {14, 12, 9, 5, 9, 3, 1}, 4.0 / 3, 14},
                          Case{"six pyramids in a cube", {{0, 1, 2, 3, 8}, {4, 7, 6, 5, 8}, {0, 4, 5, 1, 8}, {1, 5, 6, 2, 8}, {2, 6, 7, 3, 8}, {3, 7, 4, 0, 8}}, {14, 14, 14, 14, 14, 14}, 1, 12},
                          Case{"faces alone", {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 7, 4}}, {9, 9, 9, 9, 9, 8}, 1, 12},
                          Case{"a curved tetrahedron by its corners", {{0, 1, 3, 4, 8, 8, 8, 8, 8, 8}}, {24}, 1.0 / 6, 4}})
    for (const Grid form : {Grid::Counted, Grid::Offsets, Grid::Xml}) {
      const std::string text = gridText(form, points, 10, one.cells, one.types);
      const auto file = form == Grid::Xml ? parseVtp(text, "grid.vtu") : parseVtkSurface(text, "grid.vtk");
      ASSERT_TRUE(file.ok()) << one.what << ": " << toLogLine(file.error());
      EXPECT_EQ(file->format, form == Grid::Xml ? "VTU" : "VTK");
      const MeshHealth health = healthOf(file->surfaces[0].mesh);
      EXPECT_EQ(file->surfaces[0].mesh.triangles.size(), one.triangles) << one.what;
      EXPECT_EQ(health.openEdges + health.misorientedEdges + health.nonManifoldEdges, 0) << one.what;
      EXPECT_NEAR(health.volume, one.volume, 1e-12) << one.what << ", wound outwards";
    }
  const auto fault = [&](const std::vector<std::vector<int>>& cells, const std::vector<int>& types) {
    const auto file = parseVtkSurface(gridText(Grid::Counted, points, 10, cells, types), "grid.vtk");
    return file ? Fault::Internal : file.error().fault;
  };
  EXPECT_EQ(fault({{0, 1, 3}}, {10}), Fault::BadMesh) << "too few corners";
  EXPECT_EQ(fault({{0, 1, 3, 10}}, {10}), Fault::BadIndex);
  EXPECT_EQ(fault({{0, 1, 3, 4}}, {42}), Fault::BadMesh) << "a type nobody knows here";
  EXPECT_EQ(fault({{0, 1}}, {3}), Fault::BadMesh) << "no triangles";
  EXPECT_FALSE(parseVtkSurface("# vtk DataFile Version 3.0\ng\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\n", "g.vtk").ok());
}

TEST(VtkSurface, stripsKeepTheirWinding) {
  const std::string text = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 0 1 0 1 0 0 1 1 0 0.5 2 0\n"
                           "TRIANGLE_STRIPS 1 6\n5 0 2 1 3 4\nLINES 1 3\n2 0 1\nVERTICES 1 2\n1 0\n";
  const auto file = parseVtkSurface(text, "strip.vtk");
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  const TriMesh& mesh = file->surfaces[0].mesh;
  ASSERT_EQ(mesh.triangles.size(), 3u);
  double turn = 0;
  for (const auto& t : mesh.triangles) {
    const double z = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).z();
    EXPECT_GT(std::abs(z), 0);
    EXPECT_GE(z * turn, 0);
    turn = z;
  }
  EXPECT_EQ(file->notes, (std::vector<NoteCount>{{ImportNote::StripsSplit, 1}, {ImportNote::LinesDropped, 1}, {ImportNote::PointsDropped, 1}}));
}

TEST(VtkSurface, otherDataSetsAndLiesAreNamed) {
  struct Slip {
    const char *what, *by;
    Fault fault;
  };
  for (const Slip& slip : {Slip{"POLYDATA", "UNSTRUCTURED_GRID", Fault::BadMesh}, Slip{"# vtk", "# wtk", Fault::UnknownFormat},
                           Slip{"POINTS 8", "POINTS 99999999", Fault::FileTruncated}, Slip{"POLYGONS 6 30", "POLYGONS 6 31", Fault::BadMesh},
                           Slip{"4 0 2 3 1", "4 0 2 3 8", Fault::BadIndex}, Slip{"POINTS 8 float\n0", "POINTS 8 float\nnan", Fault::NotFinite},
                           Slip{"ASCII", "MORSE", Fault::BadMesh}}) {
    std::string text = samples::vtk(false, false);
    text.replace(text.find(slip.what), std::string(slip.what).size(), slip.by);
    const auto file = parseVtkSurface(text, "x.vtk");
    ASSERT_FALSE(file.ok()) << slip.by;
    EXPECT_EQ(file.error().fault, slip.fault) << slip.by << ": " << toLogLine(file.error());
    EXPECT_EQ(file.error().place.file, "x.vtk");
  }
  for (const Slip& slip : {Slip{"\"PolyData\"", "\"ImageData\"", Fault::BadMesh}, Slip{"NumberOfPoints=\"8\"", "NumberOfPoints=\"2000000000\"", Fault::BadMesh},
                           Slip{"NumberOfPolys=\"6\"", "NumberOfPolys=\"5\"", Fault::BadMesh}, Slip{"<VTKFile", "<VTXFile", Fault::UnknownFormat}}) {
    std::string text = samples::vtp(samples::VtpForm::Ascii, false, false);
    text.replace(text.find(slip.what), std::string(slip.what).size(), slip.by);
    const auto file = parseVtp(text, "x.vtp");
    ASSERT_FALSE(file.ok()) << slip.by;
    EXPECT_EQ(file.error().fault, slip.fault) << slip.by << ": " << toLogLine(file.error());
  }
}

TEST(PolygonSplit, aConcavePolygonKeepsItsArea) {
  // An arrow: a fan from its first corner would reach outside.
  const std::vector<Vec3> points{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  std::vector<std::array<int, 3>> triangles;
  splitPolygon(points, std::vector<int>{1, 2, 3, 0}, triangles);
  ASSERT_EQ(triangles.size(), 2u);
  double area = 0;
  for (const auto& t : triangles) {
    const double z = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z() / 2;
    EXPECT_GT(z, 0);
    area += z;
  }
  EXPECT_DOUBLE_EQ(area, 1.5);
}

}  // namespace
}  // namespace glenoid
