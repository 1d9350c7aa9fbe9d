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

namespace {
/// What is asked is an energy, whose error is of second order in this.
constexpr double kResidual = 1e-3;
}  // namespace

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
  for (std::size_t i = 0; i < joint.parts.size(); ++i) parts.push_back({&joint.parts[i], Vec3::Zero(), whole.parts[i].volume.get()});
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
  if (holds->empty()) return Error{Fault::Unusable, {"", "", part.id, {}}, {"no coupling holds the part, so nothing can press a dent into it; bond it to another part first"}, "nothing holds the part"};
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
  auto inside = std::make_unique<Inside>();
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(mesh->nodes.size());
  inside->K.resize(size, size);
  inside->K.setFromTriplets(entries.begin(), entries.end());
  inside->mesh = std::move(mesh);
  inside->solver.setTolerance(kResidual);
  inside->solver.setMaxIterations(20000);
  inside->solver.compute(inside->K);
  if (inside->solver.info() != Eigen::Success) {
    inside->plain.emplace();
    inside->plain->setTolerance(kResidual);
    inside->plain->setMaxIterations(20000);
    inside->plain->compute(inside->K);
  }
  return StaticPart(std::move(inside));
}

namespace {

/// One newton along a direction, spread over points of the mesh.
VecX loadOn(const TetMesh& mesh, const TipPatch& patch, const Vec3& normal) {
  const std::vector<VertexBinding> bindings = bindToTets(mesh, patch.points_W);
  VecX load = VecX::Zero(3 * static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t s = 0; s < bindings.size(); ++s)
    for (int i = 0; i < 4; ++i) load.segment<3>(3 * bindings[s].node[i]) += patch.weights[s] * bindings[s].weight[i] * normal;
  return load;
}

/// Displacement u under a load f; `moved` is the guess, then the answer. The mean along the load as 2 f·u − u·K u, which is of
/// second order in the error of u whatever it began with, less the mean along `back`, m/N.
template <class Solver>
double answer(const Solver& solver, const Eigen::SparseMatrix<double>& K, const VecX& load, const VecX& back, VecX& moved) {
  moved = moved.size() ? VecX(solver.solveWithGuess(load, moved)) : VecX(solver.solve(load));
  return 2 * load.dot(moved) - moved.dot(K * moved) - back.dot(moved);
}

}  // namespace

std::vector<double> StaticPart::compliances(std::span<const TipPatch> patches, const TipPatch& back) const {
  const std::lock_guard lock(m_inside->solving);
  VecX moved;
  std::vector<double> found;
  for (const TipPatch& patch : patches) {
    const VecX load = loadOn(*m_inside->mesh, patch, patch.normal_W), behind = loadOn(*m_inside->mesh, back, patch.normal_W);
    found.push_back(m_inside->plain ? answer(*m_inside->plain, m_inside->K, load, behind, moved) : answer(m_inside->solver, m_inside->K, load, behind, moved));
  }
  return found;
}

double StaticPart::compliance(const TipPatch& patch) const { return compliances({&patch, 1}, {}).front(); }

double StaticPart::compliance(const Vec3& point_W, const Vec3& normal_W) const {
  TipPatch point;
  point.normal_W = normal_W;
  point.points_W = {point_W};
  point.weights = {1};
  return compliance(point);
}

}  // namespace glenoid
