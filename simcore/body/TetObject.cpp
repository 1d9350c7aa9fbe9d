// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/TetObject.h"

#include <algorithm>
#include <numeric>

#include "simcore/body/StretchAssembly.h"
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

Result<std::unique_ptr<SoftObject>> TetObject::make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh,
                                                     const std::vector<ElementTissue>& tissue, int rotationOffset) {
  std::unique_ptr<TetObject> soft(new TetObject(layout, std::move(mesh), rotationOffset));
  const TetMesh& tets = soft->mesh();
  std::vector<MassPair> masses;
  std::vector<TissueSample> samples;
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
    if (const double volume = shape.sum(); shape.rowwise().sum().minCoeff() > -kMassFloor * volume && volume > 0) {
      samples.push_back({x0 * shape.rowwise().sum() / volume, volume, tissue[e].lame});
      soft->m_sampled.push_back(static_cast<int>(e));
    }
    soft->m_elements.push_back(*element);
    soft->m_stiffnessDamping.push_back(tissue[e].stiffnessDamping);
  }
  soft->setMass(std::move(masses));
  soft->setSamples(std::move(samples));
  soft->buildPacks();
  return std::unique_ptr<SoftObject>(std::move(soft));
}

void TetObject::buildPacks() {
  for (int first = 0; first < elementCount(); first += 4) {
    ElementPack& pack = m_packs.emplace_back();
    pack.count = std::min(4, elementCount() - first);
    for (int lane = 0; lane < 4; ++lane) {
      const int e = std::min(first + lane, elementCount() - 1);
      const bool used = lane < pack.count;
      const CorotTet& tet = m_elements[e];
      for (int i = 0; i < 4; ++i) {
        pack.node[lane][i] = mesh().tets[e][i];
        for (int axis = 0; axis < 3; ++axis) pack.gradients[i][axis][lane] = tet.gradients_E(axis, i);
      }
      pack.lambda[lane] = used ? tet.volume * tet.lame.lambda : 0;
      pack.mu[lane] = used ? tet.volume * tet.lame.mu : 0;
      pack.stiffnessDamping[lane] = used ? m_stiffnessDamping[e] : 0;
    }
  }
}

void TetObject::appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const {
  for (const auto& tet : mesh().tets)
    for (int k = 4; k < 10; ++k) pairs.push_back({base + tet[kPairs[k][0]], base + tet[kPairs[k][1]]});
}

std::vector<BlockEntry> TetObject::blockEntries(const BlockSymbolic& symbolic, int base) const {
  std::vector<BlockEntry> entries;
  entries.reserve(mesh().tets.size() * 10 + massMatrix().pairs().size());
  for (const auto& tet : mesh().tets)
    for (const auto& pair : kPairs) entries.push_back(symbolic.entry(base + tet[pair[0]], base + tet[pair[1]]));
  appendMassEntries(symbolic, base, entries);
  return entries;
}

Mat34 TetObject::nodesOf(int element, const VecX& q) const {
  Mat34 x;
  const auto& tet = mesh().tets[element];
  for (int i = 0; i < 4; ++i) x.col(i) = nodeAt(q, tet[i]);
  return x;
}

void TetObject::assembleElement(int e, const StepSettings& settings, const VecX& q, const BlockEntry* entries,
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
  for (int i = 0; i < 4; ++i) b.segment<3>(3 * mesh().tets[e][i]) += dt * force.col(i);
  const double scale = dt * dt + (settings.damping ? dt * m_stiffnessDamping[e] : 0);
  const Mat34 g = rotatedGradients(tet, R_WE);
  const double turning = settings.tension ? dt * dt * tensionStiffness(tet, F, R_WE) : 0;
  for (int k = 0; k < 10; ++k) {
    const Vec3 gi = g.col(kPairs[k][0]), gj = g.col(kPairs[k][1]);
    A.add(entries[k], scale * stiffnessBlock(tet, gi, gj) + tensionBlock(turning, gi, gj));
  }
}

LawRange TetObject::rangeOf(std::span<const int> elements, const VecX& q) const {
  int notSound = 0;
  for (const int e : elements)
    notSound += tissueState(m_elements[e].lame, deformationGradient(m_elements[e], nodesOf(e, q)), true) != TissueState::Sound;
  return lawRange(notSound, elementCount());
}

void TetObject::addStretchLaw(std::vector<int>& elements, const StepSettings& settings, const VecX& q,
                              std::span<const BlockEntry> entries, const VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const auto rotationAt = [&](int e) { return Eigen::Map<const Quat>(rotations.data() + rotationOffset() + 4 * e).toRotationMatrix(); };
  std::erase_if(elements, [&](int e) {
    const Mat3 U = rotationAt(e).transpose() * deformationGradient(m_elements[e], nodesOf(e, q));
    return plainlySound(m_elements[e].lame, 0.5 * (U + U.transpose()));
  });
  const LawRange range = rangeOf(elements, q);
  if (range == LawRange::Linear) return;
  for (const int e : elements) {
    const auto& element = m_elements[e];
    const Mat3 R_WE = rotationAt(e);
    if (const auto more = stretchCorrection(element.lame, element.lame, deformationGradient(element, nodesOf(e, q)), R_WE, range == LawRange::Whole))
      addStretchCorrection<4>(*more, element.volume, settings, R_WE, element.gradients_E, kPairs, mesh().tets[e].data(), &entries[10 * e], A, b);
  }
}

void TetObject::assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries,
                          VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  std::vector<int>& far = elementScratch(elementCount());
  const auto rotationOf = [&](int e) { return rotations.data() + rotationOffset() + 4 * e; };
  if (settings.rotationsBySvd) {
    for (int e = 0; e < elementCount(); ++e) {
      assembleElement(e, settings, state.q, &entries[10 * e], Eigen::Map<Quat>(rotationOf(e)), A, b);
      far.push_back(e);
    }
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
          far.push_back(e);
          continue;
        }
        std::copy_n(result.quaternion[lane], 4, rotationOf(e));
        for (int i = 0; i < 4; ++i)
          for (int axis = 0; axis < 3; ++axis) b[3 * pack.node[lane][i] + axis] += dt * result.force[i][axis][lane];
        if (result.strained[lane]) far.push_back(e);
      }
    }
  }
  if (settings.stretchLaw && !far.empty()) addStretchLaw(far, settings, state.q, entries, rotations, A, b);
  assembleMass(settings, state, entries.subspan(10 * m_elements.size()), A, b);
}

Mat3 TetObject::rotationOf(int element, const Mat3& F, const State& state) const {
  Quat R = Eigen::Map<const Quat>(state.rotations.data() + rotationOffset() + 4 * element);
  nearestRotation(F, R);
  return R.toRotationMatrix();
}

double TetObject::elasticEnergy(const State& state) const {
  double energy = 0;
  std::vector<int> all(elementCount());
  std::iota(all.begin(), all.end(), 0);
  const LawRange range = rangeOf(all, state.q);
  for (int e = 0; e < elementCount(); ++e) {
    const Mat3 F = deformationGradient(m_elements[e], nodesOf(e, state.q));
    const Mat3 R = rotationOf(e, F, state);
    energy += glenoid::elasticEnergy(m_elements[e], F, R);
    if (range == LawRange::Linear) continue;
    if (const auto more = stretchCorrection(m_elements[e].lame, m_elements[e].lame, F, R, range == LawRange::Whole)) energy += m_elements[e].volume * more->energy;
  }
  return energy;
}

ElementReading TetObject::readElement(int element, const State& state, bool stretchLaw) const {
  const CorotTet& tet = m_elements[element];
  const Mat3 F = deformationGradient(tet, nodesOf(element, state.q)), R = rotationOf(element, F, state);
  // R (sym(RᵀF) − I) Rᵀ without going through the element's frame.
  const Mat3 stretch = F * R.transpose();
  const Mat3 strain = 0.5 * (stretch + stretch.transpose()) - Mat3::Identity();
  Mat3 stress = 2 * tet.lame.mu * strain + tet.lame.lambda * strain.trace() * Mat3::Identity();
  if (stretchLaw)
    if (const auto more = stretchCorrection(tet.lame, tet.lame, F, R)) stress += R * more->stress_E * R.transpose();
  return {strain, stress};
}

TissueTrouble TetObject::troubleOf(const VecX& q, bool stretchLaw) const {
  TissueTrouble trouble;
  for (int e = 0; e < elementCount(); ++e)
    trouble.count(tissueState(m_elements[e].lame, deformationGradient(m_elements[e], nodesOf(e, q)), stretchLaw));
  return trouble;
}

void TetObject::readSamples(const State& state, std::vector<ElementReading>& readings, bool stretchLaw) const {
  readings.clear();
  for (const int element : m_sampled) readings.push_back(readElement(element, state, stretchLaw));
}

}  // namespace glenoid
