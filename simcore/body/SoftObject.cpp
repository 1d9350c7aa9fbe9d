// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/SoftObject.h"

#include <algorithm>

#include "simcore/fem/Rotation.h"

namespace glenoid {

namespace {
/// The ten blocks of an element on and below the diagonal, by local node.
constexpr auto& kPairs = kPackPairs;

/// Share of an element's whole mass that is added where it holds next to nothing, so that M is definite: far above the
/// round-off of the moments, far below a millionth of a part.
constexpr double kMassFloor = 1e-9, kNextToNothing = 0.01;

/// ∫ λ λᵀ over the tissue of a tetrahedron, m³, with the floor.
Eigen::Matrix4d massShape(const ElementTissue& tissue, double volume) {
  const Eigen::Matrix4d whole = volume / 20 * (Eigen::Matrix4d::Ones() + Eigen::Matrix4d::Identity());
  if (!tissue.moments) return tissue.fill * whole;
  return *tissue.moments + (tissue.moments->sum() < kNextToNothing * volume ? kMassFloor : 0) * whole;
}
}  // namespace

SoftObject::SoftObject(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, int rotationOffset)
    : ContactObject(layout), m_mesh(std::move(mesh)), m_rotationOffset(rotationOffset) {}

Result<std::unique_ptr<SoftObject>> SoftObject::make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                     const std::vector<ElementTissue>& tissue, int rotationOffset) {
  std::unique_ptr<SoftObject> soft(new SoftObject(layout, std::move(mesh), rotationOffset));
  const TetMesh& tets = *soft->m_mesh;
  std::vector<MassPair> masses;
  for (std::size_t e = 0; e < tets.tets.size(); ++e) {
    Mat34 x0;
    for (int i = 0; i < 4; ++i) x0.col(i) = tets.nodes[tets.tets[e][i]];
    Result<CorotTet> element = makeCorotTet(x0, tissue[e].lame, tissue[e].fill);
    if (!element) {
      element.error().place.element = static_cast<long>(e);
      return element.error();
    }
    const Eigen::Matrix4d shape = massShape(tissue[e], element->volume / tissue[e].fill);
    for (const auto& [i, j] : kPairs) {
      const double mass = tissue[e].density * shape(i, j);
      const auto [low, high] = std::minmax(tets.tets[e][i], tets.tets[e][j]);
      masses.push_back({high, low, mass, mass * tissue[e].massDamping});
    }
    soft->m_elements.push_back(*element);
    soft->m_stiffnessDamping.push_back(tissue[e].stiffnessDamping);
  }
  soft->m_mass = MassMatrix(static_cast<int>(tets.nodes.size()), std::move(masses));
  soft->buildPacks();
  return soft;
}

void SoftObject::buildPacks() {
  for (int first = 0; first < elementCount(); first += 4) {
    ElementPack& pack = m_packs.emplace_back();
    pack.count = std::min(4, elementCount() - first);
    for (int lane = 0; lane < 4; ++lane) {
      const int e = std::min(first + lane, elementCount() - 1);
      const bool used = lane < pack.count;
      const CorotTet& tet = m_elements[e];
      for (int i = 0; i < 4; ++i) {
        pack.node[lane][i] = m_mesh->tets[e][i];
        for (int axis = 0; axis < 3; ++axis) pack.gradients[i][axis][lane] = tet.gradients_E(axis, i);
      }
      pack.lambda[lane] = used ? tet.volume * tet.lame.lambda : 0;
      pack.mu[lane] = used ? tet.volume * tet.lame.mu : 0;
      pack.stiffnessDamping[lane] = used ? m_stiffnessDamping[e] : 0;
    }
  }
}

void SoftObject::appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const {
  for (const auto& tet : m_mesh->tets)
    for (int k = 4; k < 10; ++k) pairs.push_back({base + tet[kPairs[k][0]], base + tet[kPairs[k][1]]});
}

std::vector<BlockEntry> SoftObject::blockEntries(const BlockSymbolic& symbolic, int base) const {
  std::vector<BlockEntry> entries;
  entries.reserve(m_mesh->tets.size() * 10 + m_mass.pairs().size());
  for (const auto& tet : m_mesh->tets)
    for (const auto& pair : kPairs) entries.push_back(symbolic.entry(base + tet[pair[0]], base + tet[pair[1]]));
  for (const MassPair& pair : m_mass.pairs()) entries.push_back(symbolic.entry(base + pair.row, base + pair.col));
  return entries;
}

Mat34 SoftObject::nodesOf(int element, const VecX& q) const {
  Mat34 x;
  const auto& tet = m_mesh->tets[element];
  for (int i = 0; i < 4; ++i) x.col(i) = q.segment<3>(layout().qOffset + 3 * tet[i]);
  return x;
}

void SoftObject::assembleElement(int e, const StepSettings& settings, const VecX& q, const BlockEntry* entries,
                                 Eigen::Map<Quat> rotation, BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  const CorotTet& tet = m_elements[e];
  const Mat3 F = deformationGradient(tet, nodesOf(e, q));
  Quat R = rotation;
  if (settings.rotationsBySvd && F.allFinite())
    R = rotationBySvd(F);
  else
    nearestRotation(F, R);
  rotation = R;
  const Mat3 R_WE = R.toRotationMatrix();
  const Mat34 force = elasticForce(tet, F, R_WE);
  for (int i = 0; i < 4; ++i) b.segment<3>(3 * m_mesh->tets[e][i]) += dt * force.col(i);
  const double scale = dt * dt + (settings.damping ? dt * m_stiffnessDamping[e] : 0);
  const Mat34 g = rotatedGradients(tet, R_WE);
  const double turning = settings.tension ? dt * dt * tensionStiffness(tet, F, R_WE) : 0;
  for (int k = 0; k < 10; ++k) {
    const Vec3 gi = g.col(kPairs[k][0]), gj = g.col(kPairs[k][1]);
    A.add(entries[k], scale * stiffnessBlock(tet, gi, gj) + tensionBlock(turning, gi, gj));
  }
}

void SoftObject::assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries,
                          VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  const auto rotationOf = [&](int e) { return rotations.data() + m_rotationOffset + 4 * e; };
  if (settings.rotationsBySvd) {
    for (int e = 0; e < elementCount(); ++e)
      assembleElement(e, settings, state.q, &entries[10 * e], Eigen::Map<Quat>(rotationOf(e)), A, b);
  } else {
    const PackKernel kernel = packKernel(settings.portable);
    PackTarget target;
    target.tension = settings.tension ? 1 : 0;
    PackResult result;
    for (std::size_t p = 0; p < m_packs.size(); ++p) {
      const ElementPack& pack = m_packs[p];
      const int first = 4 * static_cast<int>(p);
      const double* guesses[4];
      for (int lane = 0; lane < 4; ++lane) {
        const int e = std::min(first + lane, elementCount() - 1);
        guesses[lane] = rotationOf(e);
        for (int k = 0; k < 10; ++k) {
          const BlockEntry entry = entries[10 * e + k];
          target.slot[lane][k] = lane < pack.count ? A.slot(entry.slot) : nullptr;
          target.turned[lane][k] = entry.transposed;
        }
      }
      kernel(pack, state.q.data() + layout().qOffset, guesses, dt, settings.damping ? 1 : 0, target, result);
      for (int lane = 0; lane < pack.count; ++lane) {
        const int e = first + lane;
        if (!result.settled[lane]) {
          assembleElement(e, settings, state.q, &entries[10 * e], Eigen::Map<Quat>(rotationOf(e)), A, b);
          continue;
        }
        std::copy_n(result.quaternion[lane], 4, rotationOf(e));
        for (int i = 0; i < 4; ++i)
          for (int axis = 0; axis < 3; ++axis) b[3 * pack.node[lane][i] + axis] += dt * result.force[i][axis][lane];
      }
    }
  }
  const std::span<const BlockEntry> massEntries = entries.subspan(10 * m_elements.size());
  for (std::size_t k = 0; k < massEntries.size(); ++k) {
    const MassPair& pair = m_mass.pairs()[k];
    const double mass = pair.mass + (settings.damping ? dt * pair.drag : 0);
    double* slot = A.slot(massEntries[k].slot);
    for (int c = 0; c < 3; ++c) slot[5 * c] += mass;
  }
  m_mass.addProduct(state.v.segment(layout().vOffset, layout().vSize), dt * settings.gravity_W, b);
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

Mat3 SoftObject::rotationOf(int element, const Mat3& F, const State& state) const {
  Quat R = Eigen::Map<const Quat>(state.rotations.data() + m_rotationOffset + 4 * element);
  nearestRotation(F, R);
  return R.toRotationMatrix();
}

double SoftObject::elasticEnergy(const State& state) const {
  double energy = 0;
  for (int e = 0; e < elementCount(); ++e) {
    const Mat3 F = deformationGradient(m_elements[e], nodesOf(e, state.q));
    energy += glenoid::elasticEnergy(m_elements[e], F, rotationOf(e, F, state));
  }
  return energy;
}

ElementReading SoftObject::readElement(int element, const State& state) const {
  const CorotTet& tet = m_elements[element];
  const Mat3 F = deformationGradient(tet, nodesOf(element, state.q)), R = rotationOf(element, F, state);
  // R (sym(RᵀF) − I) Rᵀ without going through the element's frame.
  const Mat3 stretch = F * R.transpose();
  const Mat3 strain = 0.5 * (stretch + stretch.transpose()) - Mat3::Identity();
  return {strain, 2 * tet.lame.mu * strain + tet.lame.lambda * strain.trace() * Mat3::Identity()};
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
