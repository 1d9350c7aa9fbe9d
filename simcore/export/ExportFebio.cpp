// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "simcore/body/RigidObject.h"
#include "simcore/export/Bonds.h"

namespace glenoid::exporting {
namespace {

/// Numbers of nodes and elements run through the whole file, from 1, part by part.
class FebioModel {
 public:
  FebioModel(const Joint& joint, ExportMesh mesh, const Joint& authored) : m_joint(joint), m_mesh(mesh), m_authored(authored) {}

  Result<Written> write() {
    auto bonds = bondsOf(m_joint, m_mesh, true, m_authored);
    if (!bonds) return bonds.error();
    m_bonds = std::move(*bonds);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " << xmlText(m_joint.name) << ": SI units. -->\n"
        << "<febio_spec version=\"4.0\">\n<Module type=\"solid\"/>\n"
           "<Control>\n  <analysis>STATIC</analysis>\n  <time_steps>10</time_steps>\n  <step_size>0.1</step_size>\n"
           "  <solver type=\"solid\"/>\n</Control>\n<Globals>\n  <Constants><T>0</T><P>0</P><R>8.31446</R><Fc>96485.3</Fc></Constants>\n</Globals>\n";
    if (const auto written = writeMaterials(); !written) return written.error();
    writeMesh();
    writeDomains();
    writeBoundary();
    writeRigid();
    out << "<Loads>\n  <body_load name=\"gravity\" type=\"body force\"><force lc=\"1\">0,9.81,0</force></body_load>\n</Loads>\n"
           "<LoadData>\n  <load_controller id=\"1\" name=\"ramp\" type=\"loadcurve\"><interpolate>LINEAR</interpolate>"
           "<points><pt>0,0</pt><pt>1,1</pt></points></load_controller>\n</LoadData>\n"
           "<Output>\n  <plotfile type=\"febio\"><var type=\"displacement\"/><var type=\"stress\"/></plotfile>\n</Output>\n</febio_spec>\n";
    losses();
    return std::move(out);
  }

 private:
  Result<Done> writeMaterials() {
    out << "<Material>\n";
    int id = 0;
    for (const Part& part : m_joint.parts) {
      const Material& material = m_joint.materials[findMaterial(m_joint, part.materials[0].material)];
      out << "  <material id=\"" << ++id << "\" name=\"" << xmlText(part.id) << "\" type=\""
          << (part.kind == PartKind::Soft ? "neo-Hookean" : "rigid body") << "\">\n    <density>" << material.density << "</density>\n";
      if (part.kind == PartKind::Soft) {
        out << "    <E>" << material.youngsModulus << "</E>\n    <v>" << material.poissonRatio << "</v>\n";
        m_severalMaterials += part.materials.size() > 1;
        for (const double fill : tissueOf(m_joint, part, m_mesh).fill) m_partly += fill < 1 - 1e-9;
      } else {
        const auto properties = massPropertiesOf(*part.visual, material.density);
        if (!properties) {
          Error error = properties.error();
          error.place.part = part.id;
          return error;
        }
        const Vec3& c = properties->centre;
        out << "    <center_of_mass>" << c.x() << "," << c.y() << "," << c.z() << "</center_of_mass>\n";
      }
      out << "  </material>\n";
    }
    out << "</Material>\n";
    return Done{};
  }

  void writeMesh() {
    out << "<Mesh>\n";
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      const Part& part = m_joint.parts[p];
      const auto& nodes = part.kind == PartKind::Soft ? part.volume->nodes : part.collision->vertices;
      out << "  <Nodes name=\"" << xmlText(part.id) << "\">\n";
      for (std::size_t i = 0; i < nodes.size(); ++i)
        out << "    <node id=\"" << m_bonds.first[p] + static_cast<long>(i) << "\">" << nodes[i].x() << "," << nodes[i].y() << "," << nodes[i].z()
            << "</node>\n";
      out << "  </Nodes>\n";
      out.report.nodes += static_cast<long>(nodes.size());
    }
    long element = 0;
    const auto cells = [&](const Part& part, long first, const char* type, const auto& list) {
      out << "  <Elements type=\"" << type << "\" name=\"" << xmlText(part.id) << "\">\n";
      for (const auto& cell : list) {
        out << "    <elem id=\"" << ++element << "\">";
        for (std::size_t k = 0; k < cell.size(); ++k) out << (k ? "," : "") << first + cell[k];
        out << "</elem>\n";
      }
      out << "  </Elements>\n";
    };
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      const Part& part = m_joint.parts[p];
      if (part.kind == PartKind::Soft) {
        cells(part, m_bonds.first[p], "tet4", part.volume->tets);
        out.report.tetrahedra += static_cast<long>(part.volume->tets.size());
      } else {
        cells(part, m_bonds.first[p], "tri3", part.collision->triangles);
        out.report.triangles += static_cast<long>(part.collision->triangles.size());
      }
    }
    std::map<std::string, std::vector<long>> sets;
    for (const auto& [node, how] : m_bonds.bonds)
      if (how.rigid >= 0) sets[m_joint.parts[how.rigid].id].push_back(node);
    for (const auto& [rigid, nodes] : sets) {
      out << "  <NodeSet name=\"" << xmlText("on-" + rigid) << "\">";
      for (std::size_t i = 0; i < nodes.size(); ++i) out << (i ? "," : "") << nodes[i];
      out << "</NodeSet>\n";
      m_sets.push_back(rigid);
    }
    out << "</Mesh>\n";
  }

  void writeDomains() {
    out << "<MeshDomains>\n";
    for (const Part& part : m_joint.parts) {
      const std::string name = xmlText(part.id);
      out << (part.kind == PartKind::Soft ? "  <SolidDomain name=\"" : "  <ShellDomain name=\"") << name << "\" mat=\"" << name << "\"/>\n";
    }
    out << "</MeshDomains>\n";
  }

  void writeBoundary() {
    if (m_bonds.bonds.empty()) return;
    out << "<Boundary>\n";
    for (const std::string& rigid : m_sets)
      out << "  <bc name=\"" << xmlText("on-" + rigid) << "\" node_set=\"" << xmlText("on-" + rigid) << "\" type=\"rigid\"><rb>"
          << xmlText(rigid) << "</rb></bc>\n";
    for (const auto& [node, how] : m_bonds.bonds) {
      if (how.rigid >= 0) continue;
      for (const char dof : {'x', 'y', 'z'}) {
        const std::string_view axis(&dof, 1);
        out << "  <bc type=\"linear constraint\"><node>" << node << "</node><dof>" << axis << "</dof><offset>0</offset>";
        std::map<long, double> children;  // a point on a node names it four times
        for (int k = 0; k < 4; ++k) children[how.nodes[k]] += how.weights[k];
        for (const auto& [child, weight] : children)
          if (weight != 0)
            out << "<child_dof><node>" << child << "</node><dof>" << axis << "</dof><value>" << weight << "</value></child_dof>";
        out << "</bc>\n";
      }
    }
    out << "</Boundary>\n";
  }

  void writeRigid() {
    if (std::none_of(m_joint.parts.begin(), m_joint.parts.end(), [](const Part& p) { return p.kind == PartKind::Rigid; })) return;
    out << "<Rigid>\n";
    for (const Part& part : m_joint.parts) {
      if (part.kind != PartKind::Rigid) continue;
      out << "  <rigid_bc name=\"" << xmlText("fixed-" + part.id) << "\" type=\"rigid_fixed\"><rb>" << xmlText(part.id)
          << "</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof><Rz_dof>1</Rz_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>\n";
      ++m_fixed;
    }
    out << "</Rigid>\n";
  }

  void losses() {
    long named = 0;
    for (const Part& part : m_joint.parts) named += static_cast<long>(part.regions.size() + part.landmarks.size());
    out.lose(LossKind::FixedBones, m_fixed);
    out.lose(LossKind::MaterialLaw);
    out.lose(LossKind::FillFractions, m_partly);
    out.lose(LossKind::MaterialRegions, m_severalMaterials);
    out.lose(LossKind::CouplingStiffness, m_bonds.bonded);
    out.lose(LossKind::BondsLeftOut, m_bonds.leftOut);
    out.lose(LossKind::Couplings, m_bonds.rigidCouplings);
    out.lose(LossKind::Contact);
    out.lose(LossKind::Surfaces, static_cast<long>(m_joint.parts.size() + softParts(m_joint).size()));
    out.lose(LossKind::Bursae, static_cast<long>(m_joint.bursae.size()));
    out.lose(LossKind::Regions, named);
    out.lose(LossKind::Cages, static_cast<long>(m_joint.cages.size()));
  }

  const Joint& m_joint;
  ExportMesh m_mesh;
  const Joint& m_authored;
  Bonds m_bonds;
  std::vector<std::string> m_sets;
  long m_fixed = 0, m_partly = 0, m_severalMaterials = 0;
  Written out;
};

}  // namespace

Result<Written> writeFebio(const Joint& joint, ExportMesh mesh, const Joint& authored) { return FebioModel(joint, mesh, authored).write(); }

}  // namespace glenoid::exporting
