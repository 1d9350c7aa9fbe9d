// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/StaticPart.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <mutex>
#include <optional>

#include "simcore/coupling/Springs.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/Fill.h"
#include "simcore/fem/CorotTet.h"
#include "simcore/scene/TriangleUse.h"

namespace glenoid {

struct StaticPart::Inside {
  using Matrix = Eigen::SparseMatrix<double>;
  std::shared_ptr<const TetMesh> mesh;
  Matrix K;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Eigen::IncompleteCholesky<double>> solver;
  /// In its place where the incomplete factor breaks down, as it may on flat tetrahedra: slower, never without an answer.
  std::optional<Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper>> plain;
  /// A solver keeps its limits and its count of iterations where every solve writes them: one solve at a time.
  std::mutex solving;
};

StaticPart::StaticPart(std::unique_ptr<Inside> inside) : m_inside(std::move(inside)) {}
StaticPart::~StaticPart() = default;
StaticPart::StaticPart(StaticPart&&) noexcept = default;

namespace {

struct Hold {
  VertexBinding at;
  double stiffness;
};

/// This part's ends of its couplings' springs, on other tetrahedra.
Result<std::vector<Hold>> holdsOf(const Joint& whole, int index, const std::shared_ptr<const TetMesh>& mesh) {
  Joint joint = whole;  // meshes are shared
  joint.parts[index].volume = mesh;
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, Vec3::Zero()});
  const std::string& id = joint.parts[index].id;
  std::vector<Hold> holds;
  for (std::size_t c = 0; c < joint.couplings.size(); ++c) {
    const Coupling& coupling = joint.couplings[c];
    if (coupling.partA != id && coupling.partB != id) continue;
    const auto springs = deriveSprings(joint, static_cast<int>(c), parts);
    if (!springs) return springs.error();
    for (const CouplingSpring& spring : *springs) holds.push_back({spring.objectA == index ? spring.a : spring.b, spring.stiffness});
  }
  return holds;
}

Result<std::vector<CorotTet>> elementsOf(const Joint& joint, const Part& part, const TetMesh& mesh, TetFilling filling) {
  const std::vector<double> fill =
      filling == TetFilling::Partial ? fillFractions(mesh, *part.visual) : std::vector<double>(mesh.tets.size(), 1.0);
  const std::vector<int> label = labelTets(mesh, *part.visual, useOfTriangles(part));
  std::vector<CorotTet> elements;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Material& material = joint.materials[findMaterial(joint, part.materials[std::max(label[t], 0)].material)];
    Mat34 nodes;
    for (int i = 0; i < 4; ++i) nodes.col(i) = mesh.nodes[mesh.tets[t][i]];
    auto element = makeCorotTet(nodes, lameFrom(material.youngsModulus, material.poissonRatio), fill[t]);
    if (!element) return element.error();
    elements.push_back(*element);
  }
  return elements;
}

}  // namespace

Result<StaticPart> StaticPart::make(const Joint& joint, int index, std::shared_ptr<const TetMesh> mesh, TetFilling filling) {
  const Part& part = joint.parts[index];
  const auto holds = holdsOf(joint, index, mesh);
  if (!holds) return holds.error();
  const auto elements = elementsOf(joint, part, *mesh, filling);
  if (!elements) return elements.error();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * mesh->tets.size());
  const auto add = [&](int a, int b, const Mat3& block) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * a + r, 3 * b + c, block(r, c));
  };
  for (std::size_t t = 0; t < mesh->tets.size(); ++t) {
    const CorotTet& element = (*elements)[t];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        add(mesh->tets[t][i], mesh->tets[t][j], stiffnessBlock(element, element.gradients_E.col(i), element.gradients_E.col(j)));
  }
  for (const Hold& hold : *holds)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (const double k = hold.stiffness * hold.at.weight[i] * hold.at.weight[j]; k != 0)
          add(hold.at.node[i], hold.at.node[j], k * Mat3::Identity());
  if (holds->empty()) return Error{Fault::Unusable, {"", "", part.id, {}}, {"couplings"}, "nothing holds the part"};
  auto inside = std::make_unique<Inside>();
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(mesh->nodes.size());
  inside->K.resize(size, size);
  inside->K.setFromTriplets(entries.begin(), entries.end());
  inside->mesh = std::move(mesh);
  inside->solver.setTolerance(1e-4);
  inside->solver.setMaxIterations(20000);
  inside->solver.compute(inside->K);
  if (inside->solver.info() != Eigen::Success) {
    inside->plain.emplace();
    inside->plain->setTolerance(1e-4);
    inside->plain->setMaxIterations(20000);
    inside->plain->compute(inside->K);
  }
  return StaticPart(std::move(inside));
}

namespace {

template <class Solver>
double answer(const Solver& solver, const TetMesh& mesh, std::span<const Vec3> points, std::span<const double> weights,
              const Vec3& normal) {
  const std::vector<VertexBinding> bindings = bindToTets(mesh, points);
  VecX load = VecX::Zero(3 * static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t s = 0; s < bindings.size(); ++s)
    for (int i = 0; i < 4; ++i) load.segment<3>(3 * bindings[s].node[i]) += weights[s] * bindings[s].weight[i] * normal;
  const VecX moved = solver.solve(load);
  return load.dot(moved);
}

}  // namespace

double StaticPart::compliance(const TipPatch& patch) const {
  const std::lock_guard lock(m_inside->solving);
  return m_inside->plain ? answer(*m_inside->plain, *m_inside->mesh, patch.points_W, patch.weights, patch.normal_W)
                         : answer(m_inside->solver, *m_inside->mesh, patch.points_W, patch.weights, patch.normal_W);
}

double StaticPart::compliance(const Vec3& point_W, const Vec3& normal_W) const {
  const double whole = 1;
  const std::lock_guard lock(m_inside->solving);
  return m_inside->plain ? answer(*m_inside->plain, *m_inside->mesh, {&point_W, 1}, {&whole, 1}, normal_W)
                         : answer(m_inside->solver, *m_inside->mesh, {&point_W, 1}, {&whole, 1}, normal_W);
}

}  // namespace glenoid
