// SPDX-License-Identifier: GPL-3.0-or-later
// MSH and VTU read back by small parsers written from the formats' documents, not from the writer.
#include <QXmlStreamReader>
#include <map>
#include <sstream>

#include "simcore/embed/Fill.h"
#include "tests/simcore/export/Exported.h"

namespace glenoid {
namespace {

struct MshVolume {
  std::string name;
  std::vector<Vec3> nodes;
  std::vector<std::array<long, 4>> tets;
};

/// MSH 4.1 ASCII with volumes of linear tetrahedra, by physical group.
std::map<int, MshVolume> parseMsh(const std::string& text) {
  std::map<int, MshVolume> volumes;
  std::map<int, int> physicalOf;
  std::map<long, std::pair<int, int>> nodeAt;  // tag → entity, index
  std::istringstream in(text);
  std::string line;
  const auto expect = [&](const char* end) {
    EXPECT_TRUE(std::getline(in >> std::ws, line));
    EXPECT_EQ(line, end);
  };
  while (std::getline(in >> std::ws, line)) {
    if (line == "$MeshFormat") {
      double version = 0;
      int binary = -1, size = 0;
      in >> version >> binary >> size;
      EXPECT_EQ(version, 4.1);
      EXPECT_EQ(binary, 0);
      EXPECT_EQ(size, 8);
      expect("$EndMeshFormat");
    } else if (line == "$PhysicalNames") {
      int count = 0, dim = 0, tag = 0;
      in >> count;
      while (count--) {
        in >> dim >> tag >> std::ws;
        std::getline(in, line);
        EXPECT_EQ(dim, 3);
        EXPECT_EQ(line.front(), '"');
        volumes[tag].name = line.substr(1, line.size() - 2);
      }
      expect("$EndPhysicalNames");
    } else if (line == "$Entities") {
      int points, curves, surfaces, solids;
      in >> points >> curves >> surfaces >> solids;
      EXPECT_EQ(points + curves + surfaces, 0);
      while (solids--) {
        int tag, groups, group, bounding;
        double box[6];
        in >> tag;
        for (double& x : box) in >> x;
        in >> groups >> group >> bounding;
        EXPECT_EQ(groups, 1);
        EXPECT_EQ(bounding, 0);
        for (int k = 0; k < 3; ++k) EXPECT_LT(box[k], box[k + 3]);
        physicalOf[tag] = group;
      }
      expect("$EndEntities");
    } else if (line == "$Nodes") {
      long blocks, count, low, high, seen = 0;
      in >> blocks >> count >> low >> high;
      while (blocks--) {
        int dim, entity, parametric;
        long size;
        in >> dim >> entity >> parametric >> size;
        EXPECT_EQ(dim, 3);
        EXPECT_EQ(parametric, 0);
        std::vector<long> tags(size);
        for (long& tag : tags) {
          in >> tag;
          EXPECT_TRUE(tag >= low && tag <= high);
        }
        for (const long tag : tags) {
          Vec3 x;
          in >> x.x() >> x.y() >> x.z();
          nodeAt[tag] = {entity, static_cast<int>(volumes[physicalOf[entity]].nodes.size())};
          volumes[physicalOf[entity]].nodes.push_back(x);
          ++seen;
        }
      }
      EXPECT_EQ(seen, count);
      EXPECT_EQ(static_cast<long>(nodeAt.size()), count) << "tags are unique";
      expect("$EndNodes");
    } else if (line == "$Elements") {
      long blocks, count, low, high, seen = 0;
      in >> blocks >> count >> low >> high;
      while (blocks--) {
        int dim, entity, type;
        long size;
        in >> dim >> entity >> type >> size;
        EXPECT_EQ(type, 4) << "4-node tetrahedron";
        while (size--) {
          long tag;
          std::array<long, 4> tet;
          in >> tag >> tet[0] >> tet[1] >> tet[2] >> tet[3];
          EXPECT_TRUE(tag >= low && tag <= high);
          for (long& node : tet) {
            EXPECT_EQ(nodeAt[node].first, entity);
            node = nodeAt[node].second;
          }
          volumes[physicalOf[entity]].tets.push_back(tet);
          ++seen;
        }
      }
      EXPECT_EQ(seen, count);
      expect("$EndElements");
    } else {
      ADD_FAILURE() << "unexpected line: " << line;
      break;
    }
  }
  return volumes;
}

Joint twoSofts() {
  Joint joint = richJoint();
  Part other = softPart(joint);
  other.id = "other";
  other.number = 9;
  const auto away = [](auto& points) { for (Vec3& x : points) x.z() += 1.0 / 3.0; };
  changeMesh(other.visual, [&](TriMesh& m) { away(m.vertices); });
  changeMesh(other.collision, [&](TriMesh& m) { away(m.vertices); });
  changeMesh(other.volume, [&](TetMesh& m) { away(m.nodes); });
  joint.parts.push_back(other);
  return joint;
}

TEST(ExportMsh, volumesComeBackBitForBit) {
  const Joint joint = twoSofts();
  const Exported file(joint, ExportFormat::Msh);
  const auto volumes = parseMsh(file.text);
  ASSERT_EQ(volumes.size(), 2u);
  long nodes = 0, tets = 0;
  for (const Part& part : joint.parts) {
    if (part.kind != PartKind::Soft) continue;
    ASSERT_TRUE(volumes.count(part.number)) << part.id;
    const MshVolume& back = volumes.at(part.number);
    EXPECT_EQ(back.name, part.id);
    EXPECT_EQ(back.nodes, part.volume->nodes);
    ASSERT_EQ(back.tets.size(), part.volume->tets.size());
    for (std::size_t t = 0; t < back.tets.size(); ++t)
      for (int k = 0; k < 4; ++k) EXPECT_EQ(back.tets[t][k], part.volume->tets[t][k]);
    nodes += static_cast<long>(back.nodes.size());
    tets += static_cast<long>(back.tets.size());
  }
  EXPECT_EQ(file.report.nodes, nodes);
  EXPECT_EQ(file.report.tetrahedra, tets);
  EXPECT_EQ(file.lost(LossKind::RigidParts), 2);
  EXPECT_EQ(file.lost(LossKind::Couplings), 2);
  EXPECT_EQ(file.lost(LossKind::Bursae), 1);
  EXPECT_EQ(file.lost(LossKind::Cages), 1);
  EXPECT_EQ(file.lost(LossKind::Exclusions), 3);
  EXPECT_EQ(file.lost(LossKind::Surfaces), 8);
}

TEST(ExportMsh, onePartAlone) {
  const Exported file(twoSofts(), ExportFormat::Msh, "other");
  const auto volumes = parseMsh(file.text);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_EQ(volumes.begin()->second.name, "other");
  EXPECT_EQ(file.lost(LossKind::Couplings), 0) << "none of them is its own";
}

/// Numbers of each DataArray by name, and the counts of the piece.
struct Vtu {
  long points = -1, cells = -1;
  std::map<QString, std::vector<double>> arrays;
  std::map<QString, QString> sections, types;
};
Vtu parseVtu(const std::string& text) {
  Vtu vtu;
  QXmlStreamReader xml(QByteArray::fromStdString(text));
  QString section;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto attributes = xml.attributes();
    if (xml.name() == u"VTKFile") {
      EXPECT_EQ(attributes.value(QStringLiteral("type")).toString(), "UnstructuredGrid");
    } else if (xml.name() == u"Piece") {
      vtu.points = attributes.value(QStringLiteral("NumberOfPoints")).toLong();
      vtu.cells = attributes.value(QStringLiteral("NumberOfCells")).toLong();
    } else if (xml.name() == u"DataArray") {
      EXPECT_EQ(attributes.value(QStringLiteral("format")).toString(), "ascii");
      const QString name = attributes.value(QStringLiteral("Name")).toString();
      vtu.sections[name] = section;
      vtu.types[name] = attributes.value(QStringLiteral("type")).toString();
      std::istringstream numbers(xml.readElementText().toStdString());
      for (double x; numbers >> x;) vtu.arrays[name].push_back(x);
    } else {
      section = xml.name().toString();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return vtu;
}

TEST(ExportVtu, volumesAndTissueComeBack) {
  const Joint joint = twoSofts();
  const Exported file(joint, ExportFormat::Vtu);
  Vtu vtu = parseVtu(file.text);
  EXPECT_EQ(vtu.points, file.report.nodes);
  EXPECT_EQ(vtu.cells, file.report.tetrahedra);
  EXPECT_EQ(vtu.arrays["Points"].size(), 3u * vtu.points);
  EXPECT_EQ(vtu.arrays["startDisplacement"].size(), 3u * vtu.points);
  EXPECT_EQ(vtu.arrays["connectivity"].size(), 4u * vtu.cells);
  EXPECT_EQ(vtu.arrays["types"], std::vector<double>(vtu.cells, 10));
  EXPECT_EQ(vtu.sections["fill"], "CellData");
  EXPECT_EQ(vtu.sections["Points"], "Points");
  EXPECT_EQ(vtu.sections["connectivity"], "Cells");
  EXPECT_EQ(vtu.types["connectivity"], "Int64");
  long node = 0, cell = 0;
  for (const Part& part : joint.parts) {
    if (part.kind != PartKind::Soft) continue;
    const std::vector<double> fill = fillFractions(*part.volume, *part.visual);
    for (std::size_t t = 0; t < part.volume->tets.size(); ++t, ++cell) {
      EXPECT_EQ(vtu.arrays["offsets"][cell], 4.0 * (cell + 1));
      for (int k = 0; k < 4; ++k) EXPECT_EQ(vtu.arrays["connectivity"][4 * cell + k], node + part.volume->tets[t][k]);
      EXPECT_EQ(vtu.arrays["part"][cell], part.number);
      EXPECT_EQ(vtu.arrays["fill"][cell], fill[t]);
      EXPECT_EQ(vtu.arrays["youngsModulus"][cell], 1e5 / 3) << "every digit";
      EXPECT_EQ(vtu.arrays["poissonRatio"][cell], 0.4);
      EXPECT_EQ(vtu.arrays["density"][cell], 1000);
    }
    const bool caged = findCage(joint, part.id) != nullptr;
    for (const Vec3& x : part.volume->nodes) {
      for (int k = 0; k < 3; ++k) EXPECT_EQ(vtu.arrays["Points"][3 * node + k], x[k]);
      EXPECT_NEAR(vtu.arrays["startDisplacement"][3 * node + 1], caged ? 1e-3 : 0, 1e-9) << "the cage lifts it by a millimetre";
      ++node;
    }
  }
}

TEST(ExportVtu, thirdsAndHugeNumbersNeedNoLocale) {
  const Exported file(richJoint(), ExportFormat::Vtu);
  EXPECT_EQ(file.text.find(','), std::string::npos);
  EXPECT_NE(file.text.find("33333.333333333336"), std::string::npos);
}

TEST(ExportJoint, whatCannotBeExportedIsRefusedAndNothingIsWritten) {
  const TemporaryFolder folder;
  Joint joint = richJoint();
  EXPECT_EQ(exportJoint(joint, ExportFormat::Msh, folder.path("x"), {.part = "elbow"}).error().fault, Fault::UnknownId);
  EXPECT_EQ(exportJoint(joint, ExportFormat::Vtu, folder.path("x"), {.part = joint.parts[0].id}).error().fault, Fault::Unusable);
  EXPECT_EQ(exportJoint(joint, ExportFormat::Glb, folder.path("no/x")).error().fault, Fault::FileMissing);
  changeMesh(joint.parts[0].visual, [](TriMesh& m) { m.triangles[0][0] = 1 << 20; });
  for (const ExportFormat format : kExportFormats)
    EXPECT_EQ(exportJoint(joint, format, folder.path("x")).error().fault, Fault::BadIndex) << exportWord(format);
  EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace glenoid
