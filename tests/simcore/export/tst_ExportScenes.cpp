// SPDX-License-Identifier: GPL-3.0-or-later
// SOFA and FEBio files: well-formed, references lead somewhere, numbers are those of the joint.
#include <QFile>
#include <QXmlStreamReader>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "simcore/coupling/Springs.h"
#include "simcore/scene/JointFile.h"
#include "tests/simcore/export/Exported.h"

namespace glenoid {
namespace {

/// An XML document as a tree.
struct Element {
  QString name, text;
  std::map<QString, QString> attributes;
  std::vector<std::unique_ptr<Element>> children;

  std::vector<const Element*> all(const QString& wanted) const {
    std::vector<const Element*> found;
    for (const auto& child : children) {
      if (child->name == wanted) found.push_back(child.get());
      for (const Element* deeper : child->all(wanted)) found.push_back(deeper);
    }
    return found;
  }
  const Element* child(const QString& wanted) const {
    for (const auto& each : children)
      if (each->name == wanted) return each.get();
    return nullptr;
  }
  const Element* named(const QString& wanted) const {
    for (const auto& each : children)
      if (each->attributes.count("name") && each->attributes.at("name") == wanted) return each.get();
    return nullptr;
  }
  QString at(const QString& key) const { return attributes.count(key) ? attributes.at(key) : QString(); }
};

std::unique_ptr<Element> parse(const std::string& text) {
  QXmlStreamReader xml(QByteArray::fromStdString(text));
  auto root = std::make_unique<Element>();
  std::vector<Element*> stack{root.get()};
  while (!xml.atEnd()) {
    switch (xml.readNext()) {
      case QXmlStreamReader::StartElement: {
        auto element = std::make_unique<Element>();
        element->name = xml.name().toString();
        for (const auto& a : xml.attributes()) element->attributes[a.name().toString()] = a.value().toString();
        Element* raw = element.get();
        stack.back()->children.push_back(std::move(element));
        stack.push_back(raw);
        break;
      }
      case QXmlStreamReader::EndElement: stack.pop_back(); break;
      case QXmlStreamReader::Characters: stack.back()->text += xml.text(); break;
      default: break;
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString() << " at line " << xml.lineNumber();
  return root;
}

std::vector<double> numbers(const QString& text, QChar separator = u' ') {
  std::string plain = text.toStdString();
  if (separator != u' ')
    for (char& c : plain)
      if (c == separator.toLatin1()) c = ' ';
  std::istringstream in(plain);
  std::vector<double> list;
  for (double x; in >> x;) list.push_back(x);
  return list;
}

std::vector<double> flat(const std::vector<Vec3>& points) {
  std::vector<double> list;
  for (const Vec3& x : points) list.insert(list.end(), {x.x(), x.y(), x.z()});
  return list;
}

TEST(ExportSofa, partsBecomeNodesWithTheirNumbers) {
  const Joint joint = richJoint();
  const Exported file(joint, ExportFormat::Scn);
  const auto document = parse(file.text);
  const Element* root = document->child("Node");
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root->at("name"), "root");
  EXPECT_EQ(numbers(root->at("gravity")), (std::vector<double>{0, -9.81, 0}));
  const Element* all = root->named("joint");
  ASSERT_NE(all, nullptr);
  EXPECT_NE(all->child("EulerImplicitSolver"), nullptr);
  EXPECT_NE(all->child("CGLinearSolver"), nullptr);
  for (const Part& part : joint.parts) {
    const Element* node = all->named(QString::fromStdString(part.id));
    ASSERT_NE(node, nullptr) << part.id;
    const Element* state = node->child("MechanicalObject");
    ASSERT_NE(state, nullptr);
    if (part.kind == PartKind::Soft) {
      EXPECT_EQ(state->at("template"), "Vec3d");
      EXPECT_EQ(numbers(state->at("rest_position")), flat(part.volume->nodes));
      const auto start = numbers(state->at("position")), rest = numbers(state->at("rest_position"));
      ASSERT_EQ(start.size(), rest.size());
      for (std::size_t i = 1; i < start.size(); i += 3) EXPECT_NEAR(start[i] - rest[i], 1e-3, 1e-9) << "lifted by its cage";
      EXPECT_EQ(numbers(node->child("TetrahedronSetTopologyContainer")->at("tetrahedra")).size(), 4 * part.volume->tets.size());
      const auto young = numbers(node->child("TetrahedronFEMForceField")->at("youngModulus"));
      ASSERT_EQ(young.size(), part.volume->tets.size());
      for (const double e : young) EXPECT_NEAR(e, 1e5 / 3, 1) << "the box fills its cells";
      double mass = 0;
      for (const double m : numbers(node->child("DiagonalMass")->at("vertexMass"))) mass += m;
      EXPECT_NEAR(mass, 1000 * enclosedVolume(*part.visual), 1e-9) << part.id;
    } else {
      EXPECT_EQ(state->at("template"), "Rigid3d");
      const auto pose = numbers(state->at("position"));
      ASSERT_EQ(pose.size(), 7u);
      EXPECT_NEAR(pose[0], boundsOf(*part.visual).center().x(), 1e-12);
      EXPECT_EQ(pose[6], 1);
      EXPECT_NEAR(node->child("UniformMass")->at("totalMass").toDouble(), 2000 * enclosedVolume(*part.visual), 1e-9);
    }
    const Element* visual = node->named("visual");
    ASSERT_NE(visual, nullptr);
    EXPECT_EQ(numbers(visual->child("OglModel")->at("triangles")).size(), 3 * part.visual->triangles.size());
    EXPECT_EQ(numbers(visual->child("OglModel")->at("position")).size(), 3 * part.visual->vertices.size());
    EXPECT_NE(visual->child(part.kind == PartKind::Soft ? "BarycentricMapping" : "RigidMapping"), nullptr);
    const Element* collision = node->named("collision");
    ASSERT_NE(collision, nullptr);
    EXPECT_EQ(numbers(collision->child("MeshTopology")->at("triangles")).size(), 3 * part.collision->triangles.size());
  }
  EXPECT_EQ(file.lost(LossKind::FixedBones), 2);
  EXPECT_EQ(file.lost(LossKind::Bursae), 1);
  EXPECT_EQ(file.lost(LossKind::Regions), 4);
}

TEST(ExportSofa, couplingsBecomeSpringsBetweenMappedPoints) {
  const Joint joint = richJoint();
  const auto document = parse(Exported(joint, ExportFormat::Scn).text);
  const Element* all = document->child("Node")->named("joint");
  const auto fields = all->all("StiffSpringForceField");
  ASSERT_EQ(fields.size(), joint.couplings.size());
  for (std::size_t c = 0; c < fields.size(); ++c) {
    std::size_t ends[2] = {0, 0};
    std::vector<double> places[2];
    for (const int side : {0, 1}) {
      QString path = fields[c]->at(side ? "object2" : "object1");
      ASSERT_TRUE(path.startsWith('@')) << path.toStdString();
      const Element* at = all;
      for (const QString& step : path.mid(1).split('/')) {
        at = at->named(step);
        ASSERT_NE(at, nullptr) << path.toStdString();
      }
      EXPECT_EQ(at->name, "MechanicalObject");
      places[side] = numbers(at->at("position"));
      ends[side] = places[side].size() / 3;
    }
    EXPECT_EQ(ends[0], ends[1]);
    const auto springs = numbers(fields[c]->at("spring"));
    ASSERT_EQ(springs.size(), 5 * ends[0]);
    double stiffness = 0;
    for (std::size_t s = 0; s < ends[0]; ++s) {
      EXPECT_EQ(springs[5 * s], s);
      EXPECT_EQ(springs[5 * s + 1], s);
      EXPECT_NEAR(springs[5 * s + 3] / springs[5 * s + 2], 1e-3, 1e-12);
      EXPECT_EQ(springs[5 * s + 4], 0) << "no length at rest";
      stiffness += springs[5 * s + 2];
    }
    const Part& a = joint.parts[findPart(joint, joint.couplings[c].partA)];
    EXPECT_NEAR(stiffness, 1e8 * areaOf(a, *findRegion(a, joint.couplings[c].regionA)), 1e-6 * stiffness);
  }
}

TEST(ExportSofa, pairsWithoutContactShareAGroupAndOthersDoNot) {
  Joint joint = richJoint();
  joint.exclusions.pop_back();  // right and middle, say, may touch
  const auto document = parse(Exported(joint, ExportFormat::Scn).text);
  const Element* all = document->child("Node")->named("joint");
  std::map<std::string, std::set<double>> groups;
  for (const Part& part : joint.parts) {
    const auto list = numbers(all->named(QString::fromStdString(part.id))->named("collision")->child("TriangleCollisionModel")->at("group"));
    groups[part.id] = {list.begin(), list.end()};
  }
  for (const Part& a : joint.parts)
    for (const Part& b : joint.parts) {
      if (a.id >= b.id) continue;
      const bool excluded = std::any_of(joint.exclusions.begin(), joint.exclusions.end(), [&](const Exclusion& e) {
        return (e.partA == a.id && e.partB == b.id) || (e.partA == b.id && e.partB == a.id);
      });
      const bool shared = std::any_of(groups[a.id].begin(), groups[a.id].end(), [&](double g) { return groups[b.id].count(g); });
      EXPECT_EQ(shared, excluded) << a.id << " " << b.id;
    }
}

TEST(ExportFebio, meshMaterialsAndDomainsBelongTogether) {
  const Joint joint = richJoint();
  const Exported file(joint, ExportFormat::Feb);
  const auto document = parse(file.text);
  const Element* spec = document->child("febio_spec");
  ASSERT_NE(spec, nullptr);
  EXPECT_EQ(spec->at("version"), "4.0");
  EXPECT_EQ(spec->child("Module")->at("type"), "solid");
  std::map<long, Vec3> nodes;
  std::map<QString, std::set<long>> nodesOf;
  for (const Element* set : spec->all("Nodes"))
    for (const auto& node : set->children) {
      const auto x = numbers(node->text, u',');
      ASSERT_EQ(x.size(), 3u);
      EXPECT_TRUE(nodes.emplace(node->at("id").toLong(), Vec3(x[0], x[1], x[2])).second) << "node ids are unique";
      nodesOf[set->at("name")].insert(node->at("id").toLong());
    }
  std::set<QString> materials, elementSets;
  for (const Element* material : spec->all("material")) {
    materials.insert(material->at("name"));
    const Part& part = joint.parts[findPart(joint, material->at("name").toStdString())];
    EXPECT_EQ(material->at("type"), part.kind == PartKind::Soft ? "neo-Hookean" : "rigid body");
    if (part.kind == PartKind::Soft) {
      EXPECT_EQ(material->child("E")->text.toDouble(), 1e5 / 3);
      EXPECT_EQ(material->child("v")->text.toDouble(), 0.4);
      EXPECT_EQ(material->child("density")->text.toDouble(), 1000);
    } else {
      EXPECT_NEAR(numbers(material->child("center_of_mass")->text, u',')[0], boundsOf(*part.visual).center().x(), 1e-12);
    }
  }
  std::set<long> elements;
  for (const Element* set : spec->all("Elements")) {
    const Part& part = joint.parts[findPart(joint, set->at("name").toStdString())];
    elementSets.insert(set->at("name"));
    const bool soft = part.kind == PartKind::Soft;
    EXPECT_EQ(set->at("type"), soft ? "tet4" : "tri3");
    EXPECT_EQ(set->children.size(), soft ? part.volume->tets.size() : part.collision->triangles.size());
    for (const auto& element : set->children) {
      EXPECT_TRUE(elements.insert(element->at("id").toLong()).second);
      const auto corners = numbers(element->text, u',');
      ASSERT_EQ(corners.size(), soft ? 4u : 3u);
      for (const double corner : corners) EXPECT_TRUE(nodesOf[set->at("name")].count(static_cast<long>(corner)));
      if (!soft) continue;
      const Vec3 x0 = nodes[static_cast<long>(corners[0])];
      const auto edge = [&](int k) -> Vec3 { return nodes[static_cast<long>(corners[k])] - x0; };
      EXPECT_GT(edge(1).dot(edge(2).cross(edge(3))), 0) << "FEBio wants them turned as ours";
    }
  }
  for (const char* kind : {"SolidDomain", "ShellDomain"})
    for (const Element* domain : spec->all(kind)) {
      EXPECT_TRUE(materials.count(domain->at("mat")));
      EXPECT_TRUE(elementSets.count(domain->at("name")));
    }
  EXPECT_EQ(spec->all("SolidDomain").size(), 1u);
  EXPECT_EQ(spec->all("ShellDomain").size(), 2u);
  EXPECT_EQ(file.lost(LossKind::CouplingStiffness), 2);
  EXPECT_EQ(file.lost(LossKind::FixedBones), 2);
}

TEST(ExportFebio, couplingsToBoneHoldTheSoftPartsNodesAtTheirFace) {
  const Joint joint = richJoint();
  const auto document = parse(Exported(joint, ExportFormat::Feb).text);
  const Element* spec = document->child("febio_spec");
  std::map<QString, std::vector<double>> sets;
  for (const Element* set : spec->all("NodeSet")) sets[set->at("name")] = numbers(set->text, u',');
  const auto bonds = spec->all("bc");
  ASSERT_EQ(bonds.size(), 2u);
  for (const Element* bond : bonds) {
    EXPECT_EQ(bond->at("type"), "rigid");
    const std::string bone = bond->child("rb")->text.toStdString();
    ASSERT_GE(findPart(joint, bone), 0);
    const auto& set = sets[bond->at("node_set")];
    EXPECT_GE(set.size(), 4u);
    const double face = bone == "left" ? -0.02 : 0.02;
    for (const double id : set)
      for (const Element* nodes : spec->all("Nodes"))
        for (const auto& node : nodes->children)
          if (node->at("id").toLong() == static_cast<long>(id)) {
            EXPECT_EQ(nodes->at("name"), "middle");
            EXPECT_NEAR(numbers(node->text, u',')[0], face, 1e-12);
          }
  }
}

TEST(ExportFebio, softToSoftIsAWeightedSumOfNodesThatNothingElseHolds) {
  Joint joint = richJoint();
  joint.parts[2].kind = PartKind::Soft;  // the right bone becomes tissue of its own cells
  const Box3 box = boundsOf(*joint.parts[2].visual);
  joint.parts[2].volume = std::make_shared<const TetMesh>(scenes::boxVolume(box.min(), box.max(), 1, 1, 1));
  joint.parts[2].materials = {{"tissue", ""}};
  ASSERT_TRUE(checkJoint(joint, {}).ok());
  const Exported file(joint, ExportFormat::Feb);
  const auto document = parse(file.text);
  std::set<long> dependent, parents;
  int constraints = 0;
  for (const Element* bond : document->all("bc")) {
    if (bond->at("type") != "linear constraint") continue;
    ++constraints;
    dependent.insert(bond->child("node")->text.toLong());
    double sum = 0;
    for (const Element* term : bond->all("child_dof")) {
      parents.insert(term->child("node")->text.toLong());
      EXPECT_EQ(term->child("dof")->text, bond->child("dof")->text);
      sum += term->child("value")->text.toDouble();
    }
    EXPECT_NEAR(sum, 1, 1e-12) << "moved as a whole it stays where it is";
  }
  EXPECT_GT(constraints, 0);
  EXPECT_EQ(constraints % 3, 0);
  for (const long node : dependent) EXPECT_FALSE(parents.count(node)) << "no chains";
}

TEST(ExportScenes, theShippedShoulderIsWrittenWhole) {
  const auto joint = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder.joint");
  ASSERT_TRUE(joint.ok());
  for (const ExportFormat format : {ExportFormat::Scn, ExportFormat::Feb}) {
    const Exported file(*joint, format);
    const auto document = parse(file.text);
    long tets = 0;
    for (const Part& part : joint->parts)
      if (part.volume) tets += static_cast<long>(part.volume->tets.size());
    EXPECT_EQ(file.report.tetrahedra, tets);
    if (format == ExportFormat::Scn) {
      EXPECT_EQ(document->all("StiffSpringForceField").size(), joint->couplings.size());
    } else {
      EXPECT_EQ(document->all("Nodes").size(), joint->parts.size());
      EXPECT_EQ(file.lost(LossKind::CouplingStiffness) + file.lost(LossKind::Couplings), static_cast<long>(joint->couplings.size()));
    }
  }
}

}  // namespace
}  // namespace glenoid
