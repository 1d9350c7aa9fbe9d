// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/body/RigidObject.h"
#include "simcore/coupling/Springs.h"
#include "simcore/embed/Bind.h"
#include "simcore/export/ExportParts.h"
#include "simcore/scene/Start.h"

namespace glenoid::exporting {
namespace {

constexpr const char* kPlugins[] = {
    "Sofa.Component.AnimationLoop", "Sofa.Component.Collision.Detection.Algorithm", "Sofa.Component.Collision.Detection.Intersection",
    "Sofa.Component.Collision.Geometry", "Sofa.Component.Collision.Response.Contact", "Sofa.Component.Constraint.Projective",
    "Sofa.Component.LinearSolver.Iterative", "Sofa.Component.Mapping.Linear", "Sofa.Component.Mapping.NonLinear", "Sofa.Component.Mass",
    "Sofa.Component.ODESolver.Backward", "Sofa.Component.SolidMechanics.FEM.Elastic", "Sofa.Component.SolidMechanics.Spring",
    "Sofa.Component.StateContainer", "Sofa.Component.Topology.Container.Constant", "Sofa.Component.Topology.Container.Dynamic",
    "Sofa.Component.Visual", "Sofa.GL.Component.Rendering3D"};

/// One part as SOFA gets it.
struct Body {
  const Part* part = nullptr;
  Vec3 centre = Vec3::Zero();   ///< rigid: of mass
  double mass = 0;
  std::vector<Vec3> start;      ///< soft: nodes
  std::vector<int> groups;      ///< parts of one group do not collide
  std::vector<std::pair<std::string, std::vector<Vec3>>> ends;  ///< of springs: node name, points as its mapping wants them
};

class SofaScene {
 public:
  SofaScene(const Joint& joint, ExportMesh mesh, const Joint& authored) : m_joint(joint), m_mesh(mesh), m_authored(authored) {}

  Result<Written> write() {
    if (const auto made = makeBodies(); !made) return made.error();
    if (const auto made = makeSprings(); !made) return made.error();
    out << "<?xml version=\"1.0\"?>\n<!-- " << xmlText(m_joint.name) << ": SI units; X anterior, Y superior, Z to the right of the body. -->\n"
        << "<Node name=\"root\" dt=\"0.005\" gravity=\"0 -9.81 0\">\n";
    for (const char* plugin : kPlugins) out << "  <RequiredPlugin name=\"" << plugin << "\"/>\n";
    out << "  <VisualStyle displayFlags=\"showVisualModels hideForceFields hideCollisionModels\"/>\n"
           "  <DefaultAnimationLoop/>\n  <CollisionPipeline/>\n  <BruteForceBroadPhase/>\n  <BVHNarrowPhase/>\n"
           "  <MinProximityIntersection alarmDistance=\"0.0015\" contactDistance=\"0.0005\"/>\n"
           "  <CollisionResponse response=\"PenalityContactForceField\"/>\n"
           "  <Node name=\"joint\">\n"
           "    <EulerImplicitSolver rayleighStiffness=\"" << meanDamping(&Material::stiffnessDamping) << "\" rayleighMass=\""
        << meanDamping(&Material::massDamping) << "\"/>\n"
           "    <CGLinearSolver iterations=\"200\" tolerance=\"1e-9\" threshold=\"1e-12\"/>\n";
    for (const Body& body : m_bodies) body.part->kind == PartKind::Soft ? writeSoft(body) : writeRigid(body);
    out << m_springs;
    out << "  </Node>\n</Node>\n";
    losses();
    return std::move(out);
  }

 private:
  Result<Done> makeBodies() {
    for (const Part& part : m_joint.parts) {
      Body body;
      body.part = &part;
      if (part.kind == PartKind::Soft) {
        auto start = startNodes(m_joint, part);
        if (!start) return start.error();
        body.start = std::move(*start);
      } else {
        const int material = findMaterial(m_joint, part.materials[0].material);
        const auto properties = massPropertiesOf(*part.visual, m_joint.materials[material].density);
        if (!properties) {
          Error error = properties.error();
          error.place.part = part.id;
          return error;
        }
        body.centre = properties->centre;
        body.mass = properties->mass;
      }
      m_bodies.push_back(std::move(body));
    }
    for (std::size_t e = 0; e < m_joint.exclusions.size(); ++e)
      for (Body& body : m_bodies)
        if (body.part->id == m_joint.exclusions[e].partA || body.part->id == m_joint.exclusions[e].partB)
          body.groups.push_back(static_cast<int>(e) + 1);
    return Done{};
  }

  Vec3 endOf(const Body& body, const VertexBinding& binding) const {
    return body.part->kind == PartKind::Rigid ? binding.r_B : boundPosition(binding, body.start);
  }

  Result<Done> makeSprings() {
    std::vector<CoupledPart> parts;
    for (const Body& body : m_bodies) parts.push_back({body.part, body.centre, numberedMesh(m_authored, body.part->id)});
    for (std::size_t c = 0; c < m_joint.couplings.size(); ++c) {
      const auto springs = deriveSprings(m_joint, static_cast<int>(c), parts);
      if (!springs) return springs.error();
      const std::string node = "springs-" + m_joint.couplings[c].id;
      std::vector<Vec3> endsA, endsB;
      Written list;
      for (std::size_t s = 0; s < springs->size(); ++s) {
        const CouplingSpring& spring = (*springs)[s];
        endsA.push_back(endOf(m_bodies[spring.objectA], spring.a));
        endsB.push_back(endOf(m_bodies[spring.objectB], spring.b));
        list << (s ? " " : "") << s << " " << s << " " << spring.stiffness << " " << spring.damping << " 0";
      }
      Body &a = m_bodies[springs->front().objectA], &b = m_bodies[springs->front().objectB];
      a.ends.push_back({node, endsA});
      b.ends.push_back({node, endsB});
      m_springs += "    <StiffSpringForceField template=\"Vec3d\" name=\"" + xmlText(m_joint.couplings[c].id) + "\" object1=\"@" +
                   xmlText(a.part->id + "/" + node) + "/ends\" object2=\"@" + xmlText(b.part->id + "/" + node) + "/ends\" spring=\"" +
                   list.bytes + "\"/>\n";
    }
    return Done{};
  }

  void points(std::string_view key, const std::vector<Vec3>& points, const Vec3& origin = Vec3::Zero()) {
    out << " " << key << "=\"";
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 x = points[i] - origin;
      out << (i ? " " : "") << x.x() << " " << x.y() << " " << x.z();
    }
    out << "\"";
  }
  template <std::size_t N>
  void indices(std::string_view key, const std::vector<std::array<int, N>>& cells) {
    out << " " << key << "=\"";
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::size_t k = 0; k < N; ++k) out << (i + k ? " " : "") << cells[i][k];
    out << "\"";
  }

  /// Visual surface, collision surface and ends of springs below a body, through its mapping.
  void writeCarried(const Body& body, const TriMesh& visual, const TriMesh& collision, std::string_view mapping) {
    const Part& part = *body.part;
    out << "      <Node name=\"visual\">\n        <OglModel name=\"surface\" color=\"" << static_cast<double>(part.color[0]) << " "
        << static_cast<double>(part.color[1]) << " " << static_cast<double>(part.color[2]) << " 1\"";
    points("position", visual.vertices, body.centre);
    indices("triangles", visual.triangles);
    out << "/>\n        " << mapping << "\n      </Node>\n";
    out << "      <Node name=\"collision\">\n        <MeshTopology name=\"topology\"";
    points("position", collision.vertices, body.centre);
    indices("triangles", collision.triangles);
    out << "/>\n        <MechanicalObject template=\"Vec3d\" name=\"surface\"/>\n        <TriangleCollisionModel group=\"";
    for (std::size_t g = 0; g < body.groups.size(); ++g) out << (g ? " " : "") << body.groups[g];
    out << "\"/>\n        " << mapping << "\n      </Node>\n";
    out.report.triangles += static_cast<long>(visual.triangles.size() + collision.triangles.size());
    for (const auto& [name, ends] : body.ends) {
      out << "      <Node name=\"" << xmlText(name) << "\">\n        <MechanicalObject template=\"Vec3d\" name=\"ends\"";
      points("position", ends);
      out << "/>\n        " << mapping << "\n      </Node>\n";
    }
  }

  void writeSoft(const Body& body) {
    const Part& part = *body.part;
    const TetMesh& mesh = *part.volume;
    const PartTissue tissue = tissueOf(m_joint, part, m_mesh);
    std::vector<double> masses(mesh.nodes.size(), 0);
    double poisson = 0, volume = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const Material& material = m_joint.materials[tissue.material[t]];
      const double v = tetVolume(mesh, static_cast<int>(t)) * tissue.fill[t];
      for (const int node : mesh.tets[t]) masses[node] += 0.25 * material.density * v;
      poisson += material.poissonRatio * v;
      volume += v;
    }
    out << "    <Node name=\"" << xmlText(part.id) << "\">\n      <TetrahedronSetTopologyContainer name=\"topology\"";
    points("position", mesh.nodes);
    indices("tetrahedra", mesh.tets);
    out << "/>\n      <MechanicalObject template=\"Vec3d\" name=\"nodes\"";
    points("position", body.start);
    points("rest_position", mesh.nodes);
    out << "/>\n      <TetrahedronFEMForceField template=\"Vec3d\" method=\"polar\" poissonRatio=\"" << poisson / volume << "\" youngModulus=\"";
    // A tetrahedron that is partly tissue is as much softer.
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      out << (t ? " " : "") << m_joint.materials[tissue.material[t]].youngsModulus * tissue.fill[t];
    out << "\"/>\n      <DiagonalMass template=\"Vec3d,Vec3d\" vertexMass=\"";
    for (std::size_t i = 0; i < masses.size(); ++i) out << (i ? " " : "") << masses[i];
    out << "\"/>\n";
    // The mapping looks at the nodes where they start, so the surfaces are written there too.
    const auto visual = startSurface(m_joint, part, SurfaceKind::Visual), collision = startSurface(m_joint, part, SurfaceKind::Collision);
    writeCarried(body, *visual, *collision, "<BarycentricMapping/>");
    out << "    </Node>\n";
    out.report.nodes += static_cast<long>(mesh.nodes.size());
    out.report.tetrahedra += static_cast<long>(mesh.tets.size());
  }

  void writeRigid(const Body& body) {
    out << "    <Node name=\"" << xmlText(body.part->id) << "\">\n      <MechanicalObject template=\"Rigid3d\" name=\"body\" position=\""
        << body.centre.x() << " " << body.centre.y() << " " << body.centre.z() << " 0 0 0 1\"/>\n      <UniformMass totalMass=\""
        << body.mass << "\"/>\n      <FixedProjectiveConstraint indices=\"0\"/>\n";
    writeCarried(body, *body.part->visual, *body.part->collision, "<RigidMapping globalToLocalCoords=\"false\"/>");
    out << "    </Node>\n";
    ++m_fixed;
  }

  double meanDamping(double Material::*member) const {
    double sum = 0, parts = 0;
    for (const Part* part : softParts(m_joint)) {
      sum += m_joint.materials[findMaterial(m_joint, part->materials[0].material)].*member;
      ++parts;
    }
    return parts > 0 ? sum / parts : 0;
  }

  void losses() {
    long named = 0;
    bool friction = false;
    for (const Part& part : m_joint.parts) named += static_cast<long>(part.regions.size() + part.landmarks.size());
    for (const Material& material : m_joint.materials) friction |= material.friction > 0;
    out.lose(LossKind::FixedBones, m_fixed);
    out.lose(LossKind::ContactPenalty);
    out.lose(LossKind::Friction, friction);
    out.lose(LossKind::Damping, m_joint.materials.size() > 1);
    out.lose(LossKind::Bursae, static_cast<long>(m_joint.bursae.size()));
    out.lose(LossKind::Regions, named);
    out.lose(LossKind::Cages, static_cast<long>(m_joint.cages.size()));
  }

  const Joint& m_joint;
  ExportMesh m_mesh;
  const Joint& m_authored;
  std::vector<Body> m_bodies;
  std::string m_springs;
  long m_fixed = 0;
  Written out;
};

}  // namespace

Result<Written> writeSofa(const Joint& joint, ExportMesh mesh, const Joint& authored) { return SofaScene(joint, mesh, authored).write(); }

}  // namespace glenoid::exporting
