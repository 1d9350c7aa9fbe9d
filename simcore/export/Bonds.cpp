// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/export/Bonds.h"

#include <algorithm>

#include "simcore/coupling/Springs.h"
#include "simcore/embed/Bind.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid::exporting {
namespace {

constexpr double kLeastShare = 0.02;  ///< of the largest: nodes that carry less of a coupling are not bonded

/// Nodes of a soft part that carry a coupling, by their share of its stiffness. Those of a part's own mesh lie on its surface.
std::vector<int> carriers(const std::vector<CouplingSpring>& springs, VertexBinding CouplingSpring::* end, const TetMesh& mesh, ExportMesh kind) {
  std::map<int, double> share;
  double most = 0;
  for (const CouplingSpring& spring : springs)
    for (int k = 0; k < 4; ++k) {
      double& sum = share[(spring.*end).node[k]];
      sum += spring.stiffness * std::max(0.0, (spring.*end).weight[k]);
      most = std::max(most, sum);
    }
  std::set<int> surface;
  if (kind == ExportMesh::Conforming)
    for (const auto& triangle : boundaryOf(mesh).triangles) surface.insert(triangle.begin(), triangle.end());
  std::vector<int> nodes, outer;
  for (const auto& [node, stiffness] : share) {
    if (stiffness <= kLeastShare * most) continue;
    nodes.push_back(node);
    if (surface.count(node)) outer.push_back(node);
  }
  return outer.empty() ? nodes : outer;
}

class Bonding {
 public:
  Bonding(const Joint& joint, ExportMesh mesh, const Joint& authored, int only) : m_joint(joint), m_mesh(mesh), m_authored(authored), m_only(only) {}

  Result<Bonds> make(bool bones) {
    long next = 1;
    std::vector<CoupledPart> parts;
    for (std::size_t p = 0; p < m_joint.parts.size(); ++p) {
      const Part& part = m_joint.parts[p];
      m_made.first.push_back(next);
      const bool written = m_only < 0 || m_only == static_cast<int>(p);
      if (written && part.kind == PartKind::Soft) next += static_cast<long>(part.volume->nodes.size());
      if (written && part.kind == PartKind::Rigid && bones) next += static_cast<long>(part.collision->vertices.size());
      parts.push_back({&part, Vec3::Zero(), numberedMesh(m_authored, part.id)});
    }
    for (std::size_t c = 0; c < m_joint.couplings.size(); ++c)
      if (const auto done = bondOne(static_cast<int>(c), parts); !done) return done.error();
    return std::move(m_made);
  }

 private:
  bool isRigid(int part) const { return m_joint.parts[part].kind == PartKind::Rigid || (m_only >= 0 && part != m_only); }

  Result<Done> bondOne(int coupling, const std::vector<CoupledPart>& parts) {
    const Coupling& meant = m_joint.couplings[coupling];
    if (m_only >= 0 && findPart(m_joint, meant.partA) != m_only && findPart(m_joint, meant.partB) != m_only) return Done{};
    const auto springs = deriveSprings(m_joint, coupling, parts);
    if (!springs) return springs.error();
    const int a = springs->front().objectA, b = springs->front().objectB;
    if (isRigid(a) && isRigid(b)) {
      ++m_made.rigidCouplings;
      return Done{};
    }
    ++m_made.bonded;
    const int soft = isRigid(a) ? b : a, other = isRigid(a) ? a : b;
    const TetMesh& volume = *m_joint.parts[soft].volume;
    const std::vector<int> held = carriers(*springs, isRigid(a) ? &CouplingSpring::b : &CouplingSpring::a, volume, m_mesh);
    std::vector<Vec3> places;
    for (const int node : held) places.push_back(volume.nodes[node]);
    std::vector<VertexBinding> in;
    if (!isRigid(other)) in = bindToTets(*m_joint.parts[other].volume, places);
    for (std::size_t i = 0; i < held.size(); ++i) {
      Bonds::Bond how;
      how.coupling = coupling;
      if (isRigid(other)) how.rigid = other;
      for (int k = 0; k < 4 && !isRigid(other); ++k) {
        how.nodes[k] = m_made.first[other] + in[i].node[k];
        how.weights[k] = in[i].weight[k];
      }
      bond(m_made.first[soft] + held[i], how);
    }
    return Done{};
  }

  /// Bonds a node unless something holds it already, or something hangs on it.
  void bond(long node, const Bonds::Bond& how) {
    const bool taken = m_made.bonds.count(node) || m_parents.count(node);
    const bool chained = how.rigid < 0 && std::any_of(how.nodes.begin(), how.nodes.end(), [&](long parent) {
      return m_made.bonds.count(parent) || parent == node;
    });
    if (taken || chained) {
      ++m_made.leftOut;
      return;
    }
    if (how.rigid < 0) m_parents.insert(how.nodes.begin(), how.nodes.end());
    m_made.bonds.emplace(node, how);
  }

  const Joint& m_joint;
  ExportMesh m_mesh;
  const Joint& m_authored;
  int m_only;
  std::set<long> m_parents;
  Bonds m_made;
};

}  // namespace

Result<Bonds> bondsOf(const Joint& joint, ExportMesh mesh, bool bones, const Joint& authored, int only) {
  return Bonding(joint, mesh, authored, only).make(bones);
}

}  // namespace glenoid::exporting
