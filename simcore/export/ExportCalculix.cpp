// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "simcore/embed/Bind.h"
#include "simcore/export/Bonds.h"
#include "simcore/export/QuadraticTets.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid::exporting {
namespace {

/// Names of sets and materials: the program takes letters as capitals and reads to the next comma or blank.
class Names {
 public:
  std::string operator()(const std::string& id) {
    std::string name;
    for (const char c : id) {
      const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
      name += !plain ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    name.resize(std::min<std::size_t>(name.size(), 60));
    for (int more = 2; !m_taken.insert(name).second; ++more) name = name.substr(0, name.find('~')) + '~' + std::to_string(more);
    return name;
  }

 private:
  std::set<std::string> m_taken;
};

/// Twelve digits: of a number the program reads twenty characters and leaves out the rest, an exponent too.
std::string number(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 12).ptr};
}

std::string oneLine(std::string text) {
  std::replace_if(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

/// Nodes and elements are numbered through the whole file, from 1, part by part; points of reference of rigid ends are the last.
class CalculixDeck {
 public:
  CalculixDeck(const Joint& joint, ExportMesh mesh, int only, const Joint& authored) : m_joint(joint), m_mesh(mesh), m_only(only), m_authored(authored) {}

  Result<Written> write() {
    auto bonds = bondsOf(m_joint, m_mesh, false, m_authored, m_only);
    if (!bonds) return bonds.error();
    m_bonds = std::move(*bonds);
    writeHeading();
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      m_first.push_back(m_next);
      m_fine.emplace_back();
      if (m_joint.parts[p].kind == PartKind::Soft && (m_only < 0 || m_only == static_cast<int>(p))) writePart(static_cast<int>(p));
    }
    writeMaterials();
    writeRigidEnds();
    writeEquations();
    writeStep();
    losses();
    return std::move(out);
  }

 private:
  void writeHeading() {
    out << "** " << oneLine(m_joint.name) << "\n** SI units: m, N, kg, s, Pa. Axes: X forward, Y up, Z to the right.\n"
        << "** Run it with: ccx -i NAME (without the ending .inp). Sets are named by part, material and coupling.\n";
  }

  template <class List>
  void writeList(const List& numbers) {
    int inLine = 0;
    for (const long each : numbers) {
      out << (inLine ? ", " : "") << each;
      if (++inLine == 8) out << ",\n", inLine = 0;
    }
    if (inLine) out << "\n";
  }

  void writeNode(long node, const Vec3& x) { out << node << ", " << number(x.x()) << ", " << number(x.y()) << ", " << number(x.z()) << "\n"; }

  void writePart(int p) {
    const Part& part = m_joint.parts[p];
    QuadraticTets& fine = m_fine[p] = quadraticOf(*part.volume);
    const std::string name = m_setNames(part.id);
    m_parts.push_back(name);
    out << "** " << oneLine(part.name.empty() ? part.id : part.name) << "\n*NODE, NSET=" << name << "\n";
    for (const Vec3& x : fine.nodes) writeNode(m_next++, x);
    out.report.nodes += static_cast<long>(fine.nodes.size());
    out.report.tetrahedra += static_cast<long>(fine.tets.size());
    const PartTissue tissue = tissueOf(m_joint, part, m_mesh);
    for (const double fill : tissue.fill) m_partly += fill < 1 - 1e-9;
    std::map<int, std::vector<std::size_t>> byMaterial;
    for (std::size_t t = 0; t < fine.tets.size(); ++t) byMaterial[tissue.material[t]].push_back(t);
    std::vector<std::string> sets;
    for (const auto& [material, tets] : byMaterial) {
      if (!m_materialNames.count(material)) m_materialNames[material] = m_namesOfMaterials(m_joint.materials[material].id);
      sets.push_back(byMaterial.size() == 1 ? name : m_setNames(part.id + "-" + m_joint.materials[material].id));
      m_sections.push_back({sets.back(), material});
      out << "*ELEMENT, TYPE=C3D10, ELSET=" << sets.back() << "\n";
      for (const std::size_t t : tets) {
        out << ++m_element;
        for (const int node : fine.tets[t]) out << ", " << m_first[p] + node;
        out << "\n";
      }
    }
    if (sets.size() > 1) {
      out << "*ELSET, ELSET=" << name << "\n";
      for (const std::string& set : sets) out << set << "\n";
    }
  }

  void writeMaterials() {
    for (const auto& [material, name] : m_materialNames) {
      const Material& tissue = m_joint.materials[material];
      out << "*MATERIAL, NAME=" << name << "\n*ELASTIC\n" << number(tissue.youngsModulus) << ", " << number(tissue.poissonRatio) << "\n*DENSITY\n"
          << number(tissue.density) << "\n";
    }
    for (const auto& [set, material] : m_sections) out << "*SOLID SECTION, ELSET=" << set << ", MATERIAL=" << m_materialNames[material] << "\n";
    out << "*ELSET, ELSET=TISSUE\n";
    for (const std::string& part : m_parts) out << part << "\n";
  }

  /// Nodes of the volume are numbered otherwise here, where those of a part's middles follow its corners.
  std::pair<int, int> partAndNode(long bonded) const {
    int part = static_cast<int>(m_joint.parts.size()) - 1;
    while (m_bonds.first[part] > bonded || m_fine[part].nodes.empty()) --part;
    return {part, static_cast<int>(bonded - m_bonds.first[part])};
  }

  /// Edges whose corners are bonded alike, by part: the node in their middle is bonded as they are. On a part's own mesh they lie
  /// on its surface.
  std::vector<std::pair<int, int>> edgesOf(int part) const {
    std::set<std::pair<int, int>> edges;
    if (m_mesh == ExportMesh::Conforming) {
      for (const auto& t : boundaryOf(*m_joint.parts[part].volume).triangles)
        for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    } else {
      for (const auto& [edge, middle] : m_fine[part].middleOf) edges.insert(edge);
    }
    return {edges.begin(), edges.end()};
  }
  const Bonds::Bond* bondAt(int part, int node) const {
    const auto found = m_bonds.bonds.find(m_bonds.first[part] + node);
    return found == m_bonds.bonds.end() ? nullptr : &found->second;
  }

  /// Rigid ends: a bone moves all its nodes; of one part alone each coupling is an end of its own.
  void writeRigidEnds() {
    std::map<int, std::set<long>> nodesOf;  // by part, or by coupling
    const auto endOf = [&](const Bonds::Bond& bond) { return m_only < 0 ? bond.rigid : bond.coupling; };
    for (const auto& [node, bond] : m_bonds.bonds) {
      if (bond.rigid < 0) continue;
      const auto [part, own] = partAndNode(node);
      nodesOf[endOf(bond)].insert(m_first[part] + own);
    }
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      if (m_fine[p].nodes.empty()) continue;
      for (const auto& edge : edgesOf(static_cast<int>(p))) {
        const Bonds::Bond *a = bondAt(static_cast<int>(p), edge.first), *b = bondAt(static_cast<int>(p), edge.second);
        if (a && b && a->rigid >= 0 && b->rigid >= 0 && endOf(*a) == endOf(*b)) nodesOf[endOf(*a)].insert(m_first[p] + m_fine[p].middleOf.at(edge));
      }
    }
    for (const auto& [end, nodes] : nodesOf) {
      const int bone = m_only < 0 ? end : otherPart(m_joint.couplings[end]);
      const Part& part = m_joint.parts[bone];
      const Vec3 centre = boundsOf(*part.visual).center();
      const std::string name = m_setNames("ON-" + (m_only < 0 ? part.id : m_joint.couplings[end].id));
      out << "** What is bonded to " << oneLine(part.name.empty() ? part.id : part.name) << " moves with it: the first node below is its place, the second its turn (rad).\n"
          << "*NSET, NSET=" << name << "\n";
      writeList(nodes);
      const std::string place = m_setNames("PLACE-" + name.substr(3)), turn = m_setNames("TURN-" + name.substr(3));
      out << "*NODE, NSET=" << place << "\n";
      writeNode(m_next, centre);
      out << "*NODE, NSET=" << turn << "\n";
      writeNode(m_next + 1, centre);
      out << "*RIGID BODY, NSET=" << name << ", REF NODE=" << m_next << ", ROT NODE=" << m_next + 1 << "\n";
      m_next += 2;
      m_ends.push_back({place, turn});
    }
  }

  int otherPart(const Coupling& coupling) const {
    const int a = findPart(m_joint, coupling.partA);
    return a == m_only ? findPart(m_joint, coupling.partB) : a;
  }

  /// Where a bond puts its node, as a sum over nodes of the file.
  std::map<long, double> termsOf(const Bonds::Bond& bond) const {
    const int part = partAndNode(bond.nodes[0]).first;
    std::map<long, double> terms;
    std::map<int, double> corner;  // a point on a node names it four times
    for (int k = 0; k < 4; ++k) corner[static_cast<int>(bond.nodes[k] - m_bonds.first[part])] += bond.weights[k];
    for (const auto& [i, w] : corner) terms[m_first[part] + i] += w * (2 * w - 1);
    for (const auto& [i, w] : corner)
      for (const auto& [j, v] : corner)
        if (const auto middle = m_fine[part].middleOf.find({i, j}); i < j && middle != m_fine[part].middleOf.end())
          terms[m_first[part] + middle->second] += 4 * w * v;
    return terms;
  }

  /// The middle of an edge is bonded where it lies itself, so that forces spread over as many nodes as there are; between the
  /// bonds of its corners where that place hangs on something that is bonded.
  std::map<long, double> termsOfMiddle(const Bonds::Bond& a, const Bonds::Bond& b, const Vec3& place) const {
    const int other = partAndNode(a.nodes[0]).first;
    const VertexBinding in = bindToTets(*m_joint.parts[other].volume, std::vector{place})[0];
    Bonds::Bond own = a;
    bool bonded = false;
    for (int k = 0; k < 4; ++k) {
      own.nodes[k] = m_bonds.first[other] + in.node[k];
      own.weights[k] = in.weight[k];
      bonded = bonded || m_bonds.bonds.count(own.nodes[k]);
    }
    if (!bonded) return termsOf(own);
    std::map<long, double> terms;
    for (const Bonds::Bond* bond : {&a, &b})
      for (const auto& [parent, weight] : termsOf(*bond)) terms[parent] += 0.5 * weight;
    return terms;
  }

  void writeEquation(long node, const std::map<long, double>& terms) {
    long count = 1;
    for (const auto& [parent, weight] : terms) count += weight != 0;
    for (int axis = 1; axis <= 3; ++axis) {
      out << "*EQUATION\n" << count << "\n" << node << ", " << axis << ", -1.";
      int inLine = 1;
      for (const auto& [parent, weight] : terms) {
        if (weight == 0) continue;
        out << (inLine % 4 == 0 ? ",\n" : ", ") << parent << ", " << axis << ", " << number(weight);
        ++inLine;
      }
      out << "\n";
    }
  }

  void writeEquations() {
    for (const auto& [node, bond] : m_bonds.bonds) {
      if (bond.rigid >= 0) continue;
      const auto [part, own] = partAndNode(node);
      writeEquation(m_first[part] + own, termsOf(bond));
    }
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      if (m_fine[p].nodes.empty()) continue;
      for (const auto& edge : edgesOf(static_cast<int>(p))) {
        const Bonds::Bond *a = bondAt(static_cast<int>(p), edge.first), *b = bondAt(static_cast<int>(p), edge.second);
        if (!a || !b || a->rigid >= 0 || b->rigid >= 0 || a->coupling != b->coupling) continue;
        writeEquation(m_first[p] + m_fine[p].middleOf.at(edge), termsOfMiddle(*a, *b, m_fine[p].nodes[m_fine[p].middleOf.at(edge)]));
      }
    }
  }

  void writeStep() {
    out << "** An example of a step: rigid ends hold still, gravity pulls. To move an end, give its place or turn another value;\n"
           "** to load it, take its lines out of *BOUNDARY and add, say:  *CLOAD / PLACE-..., 2, -10.\n"
           "** Large deflections: *STEP, NLGEOM\n*STEP\n*STATIC\n";
    if (!m_ends.empty()) out << "*BOUNDARY\n";
    for (const auto& [place, turn] : m_ends) out << place << ", 1, 3, 0.\n" << turn << ", 1, 3, 0.\n";
    out << "*DLOAD\nTISSUE, GRAV, 9.81, 0., -1., 0.\n*NODE FILE\nU\n*EL FILE\nS\n";
    for (const auto& [place, turn] : m_ends) out << "*NODE PRINT, NSET=" << place << ", TOTALS=ONLY\nRF\n";
    out << "*END STEP\n";
  }

  void losses() {
    long named = 0, surfaces = 0, ends = 0;
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      if (m_only >= 0 && m_only != static_cast<int>(p)) continue;
      const Part& part = m_joint.parts[p];
      named += static_cast<long>(part.regions.size() + part.landmarks.size());
      surfaces += 2;
      ends += part.kind == PartKind::Rigid;
    }
    if (m_only < 0) {
      out.lose(LossKind::FixedBones, ends);
      out.lose(LossKind::Contact);
      out.lose(LossKind::Bursae, static_cast<long>(m_joint.bursae.size()));
      out.lose(LossKind::Couplings, m_bonds.rigidCouplings);
    }
    out.lose(LossKind::FillFractions, m_partly);
    out.lose(LossKind::CouplingStiffness, m_bonds.bonded);
    out.lose(LossKind::BondsLeftOut, m_bonds.leftOut);
    out.lose(LossKind::Surfaces, surfaces);
    out.lose(LossKind::Regions, named);
    out.lose(LossKind::Cages, std::count_if(m_joint.cages.begin(), m_joint.cages.end(), [&](const Cage& cage) {
               return m_only < 0 || cage.part == m_joint.parts[m_only].id;
             }));
  }

  const Joint& m_joint;
  ExportMesh m_mesh;
  int m_only;
  const Joint& m_authored;
  Bonds m_bonds;
  std::vector<QuadraticTets> m_fine;  ///< by part; empty where it has no volume here
  std::vector<long> m_first;          ///< by part, in the file
  long m_next = 1, m_element = 0, m_partly = 0;
  Names m_setNames, m_namesOfMaterials;
  std::vector<std::string> m_parts;
  std::map<int, std::string> m_materialNames;
  std::vector<std::pair<std::string, int>> m_sections;
  std::vector<std::pair<std::string, std::string>> m_ends;
  Written out;
};

}  // namespace

Result<Written> writeCalculix(const Joint& joint, ExportMesh mesh, int only, const Joint& authored) {
  return CalculixDeck(joint, mesh, only, authored).write();
}

}  // namespace glenoid::exporting
