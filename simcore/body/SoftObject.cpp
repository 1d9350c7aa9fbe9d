// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/SoftObject.h"

#include "simcore/body/CellObject.h"
#include "simcore/body/TetObject.h"

namespace glenoid {

SoftObject::SoftObject(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, int rotationOffset)
    : ContactObject(layout), m_mesh(std::move(mesh)), m_rotationOffset(rotationOffset) {}

Result<std::unique_ptr<SoftObject>> SoftObject::make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                     const std::vector<ElementTissue>& tissue, int rotationOffset) {
  return TetObject::make(layout, std::move(mesh), tissue, rotationOffset);
}

Result<std::unique_ptr<SoftObject>> SoftObject::makeOfCells(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                            const CellMesh& cells, const std::vector<ElementTissue>& tissue,
                                                            int rotationOffset) {
  return CellObject::make(layout, std::move(mesh), cells, tissue, rotationOffset);
}

void SoftObject::setMass(std::vector<MassPair> loose) { m_mass = MassMatrix(static_cast<int>(m_mesh->nodes.size()), std::move(loose)); }

void SoftObject::appendMassEntries(const BlockSymbolic& symbolic, int base, std::vector<BlockEntry>& entries) const {
  for (const MassPair& pair : m_mass.pairs()) entries.push_back(symbolic.entry(base + pair.row, base + pair.col));
}

void SoftObject::assembleMass(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, BlockMatrix& A,
                              Eigen::Ref<VecX> b) const {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const MassPair& pair = m_mass.pairs()[k];
    const double mass = pair.mass + (settings.damping ? settings.dt * pair.drag : 0);
    double* slot = A.slot(entries[k].slot);
    for (int c = 0; c < 3; ++c) slot[5 * c] += mass;
  }
  m_mass.addProduct(state.v.segment(layout().vOffset, layout().vSize), settings.dt * settings.gravity_W, b);
}

void SoftObject::advance(double dt, State& state) const {
  if (!layout().free) return;
  state.q.segment(layout().qOffset, layout().qSize) += dt * state.v.segment(layout().vOffset, layout().vSize);
}

Vec3 SoftObject::position(const MaterialPoint& point, const VecX& q) const {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < point.count; ++i) p += point.weight[i] * q.segment<3>(layout().qOffset + 3 * point.node[i]);
  return p;
}

Vec3 SoftObject::velocity(const MaterialPoint& point, const VecX&, const VecX& v) const {
  if (!layout().free) return Vec3::Zero();
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < point.count; ++i) p += point.weight[i] * v.segment<3>(layout().vOffset + 3 * point.node[i]);
  return p;
}

int SoftObject::rowTerms(const MaterialPoint& point, const Vec3& d, const VecX&, int base, RowTerm* terms) const {
  if (!layout().free) return 0;
  for (int i = 0; i < point.count; ++i) terms[i] = {base + point.node[i], point.weight[i] * d};
  return point.count;
}

void SoftObject::addSharedMass(Eigen::Ref<VecX> perNode) const {
  for (const MassPair& pair : m_mass.pairs()) {
    if (pair.row == pair.col) continue;
    perNode[pair.row] += pair.mass;
    perNode[pair.col] += pair.mass;
  }
}

double SoftObject::mass() const { return m_mass.total(); }

double SoftObject::kineticEnergy(const State& state) const {
  if (!layout().free) return 0;
  const auto v = state.v.segment(layout().vOffset, layout().vSize);
  VecX momentum = VecX::Zero(layout().vSize);
  m_mass.addProduct(v, Vec3::Zero(), momentum);
  return 0.5 * v.dot(momentum);
}

Vec6 SoftObject::momentum(const State& state) const {
  if (!layout().free) return Vec6::Zero();
  return momentumOf(state.q, state.v.segment(layout().vOffset, layout().vSize));
}

Vec6 SoftObject::momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const {
  VecX momentum = VecX::Zero(v.size());
  m_mass.addProduct(v, Vec3::Zero(), momentum);
  Vec6 sum = Vec6::Zero();
  for (int node = 0; node < layout().nodeCount; ++node) {
    const Vec3 p = momentum.segment<3>(3 * node);
    sum.head<3>() += p;
    sum.tail<3>() += q.segment<3>(layout().qOffset + 3 * node).cross(p);
  }
  return sum;
}

void SoftObject::addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const {
  for (const MassPair& pair : m_mass.pairs()) {
    f.segment<3>(3 * pair.row) += pair.mass * acceleration_W;
    if (pair.row != pair.col) f.segment<3>(3 * pair.col) += pair.mass * acceleration_W;
  }
}

}  // namespace glenoid
