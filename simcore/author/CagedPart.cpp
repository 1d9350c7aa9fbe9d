// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/CagedPart.h"

#include "simcore/embed/Bind.h"
#include "simcore/fem/CorotTet.h"

namespace glenoid {

Result<CagedPart> CagedPart::make(const Part& part, const Cage& cage) {
  CagedPart caged;
  caged.m_part = &part;
  caged.m_cage = cage;
  const std::vector<Vec3>& nodes = part.volume->nodes;
  auto weights = cageWeights({cage.rest_W, cage.triangles}, nodes);
  if (!weights) {
    weights.error().place.part = part.id;
    return weights.error();
  }
  caged.m_nodeWeights = std::move(*weights);
  const std::vector<VertexBinding> bound = bindToTets(*part.volume, part.collision->vertices);
  caged.m_collisionWeights = MatX::Zero(static_cast<Eigen::Index>(bound.size()), caged.handleCount());
  for (std::size_t v = 0; v < bound.size(); ++v)
    for (int k = 0; k < 4; ++k)
      caged.m_collisionWeights.row(static_cast<Eigen::Index>(v)) +=
          bound[v].weight[k] * caged.m_nodeWeights.weights.row(bound[v].node[k]);
  caged.m_collision = *part.collision;
  VecX shifts(3 * caged.handleCount());
  for (int j = 0; j < caged.handleCount(); ++j) shifts.segment<3>(3 * j) = cage.moved_W[j] - cage.rest_W[j];
  caged.setShifts(shifts);
  return caged;
}

void CagedPart::setShifts(const VecX& shifts) {
  m_shifts = shifts;
  for (int j = 0; j < handleCount(); ++j) m_cage.moved_W[j] = m_cage.rest_W[j] + shifts.segment<3>(3 * j);
  m_nodes = followCage(m_nodeWeights, m_part->volume->nodes, m_cage.rest_W, m_cage.moved_W);
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> handles(shifts.data(), handleCount(), 3);
  const MatX moved = m_collisionWeights * handles;
  for (std::size_t v = 0; v < m_collision.vertices.size(); ++v)
    m_collision.vertices[v] = m_part->collision->vertices[v] + moved.row(static_cast<Eigen::Index>(v)).transpose();
}

std::vector<double> CagedPart::volumeRatios() const {
  const TetMesh& rest = *m_part->volume;
  const TetMesh moved{m_nodes, rest.tets};
  std::vector<double> ratios(rest.tets.size());
  for (int tet = 0; tet < static_cast<int>(ratios.size()); ++tet) ratios[tet] = tetVolume(moved, tet) / tetVolume(rest, tet);
  return ratios;
}

MatX CagedPart::stiffness(const std::vector<double>& hardness) const {
  constexpr double kWhole = 0.02;  // of the elastic resistance
  const TetMesh& mesh = *m_part->volume;
  const auto tets = static_cast<Eigen::Index>(mesh.tets.size());
  const int n = handleCount();
  const Lame lame = lameFrom(1, 0.3);  // compressible: squeezed tissue gives way instead of bulging elsewhere
  // Gradient of each handle's field in each tetrahedron, one matrix for each axis.
  std::array<MatX, 3> gradient;
  for (MatX& g : gradient) g.setZero(tets, n);
  VecX weight(tets);
  for (Eigen::Index t = 0; t < tets; ++t) {
    Mat34 x;
    for (int i = 0; i < 4; ++i) x.col(i) = mesh.nodes[mesh.tets[t][i]];
    const auto tet = makeCorotTet(x, lame, 1);
    weight[t] = tet ? tet->volume * (hardness.empty() ? 1 : hardness[t]) : 0;
    if (!tet) continue;
    for (int i = 0; i < 4; ++i)
      for (int a = 0; a < 3; ++a) gradient[a].row(t) += tet->gradients_E(a, i) * m_nodeWeights.weights.row(mesh.tets[t][i]);
  }
  std::array<std::array<MatX, 3>, 3> product;  // product[a][b](j, k) = Σ V G_a(j) G_b(k)
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      product[a][b] = gradient[a].transpose() * weight.asDiagonal() * gradient[b];
      if (b > a) product[b][a] = product[a][b].transpose();
    }
  const MatX trace = product[0][0] + product[1][1] + product[2][2];
  MatX stiffness(3 * n, 3 * n);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      MatX block = lame.lambda * product[a][b] + lame.mu * product[b][a];
      if (a == b) block += lame.mu * trace;
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) stiffness(3 * j + a, 3 * k + b) = block(j, k);
    }
  stiffness /= stiffness.diagonal().mean();
  const MatX mass = m_nodeWeights.weights.transpose() * m_nodeWeights.weights;
  const double scale = kWhole / mass.diagonal().mean();
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k)
      for (int a = 0; a < 3; ++a) stiffness(3 * j + a, 3 * k + a) += scale * mass(j, k);
  // A handle that no node follows would leave the matrix singular.
  stiffness.diagonal().array() += 1e-6;
  return stiffness;
}

}  // namespace glenoid
