// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/CellObject.h"

#include <algorithm>
#include <numeric>

#include "simcore/body/StretchAssembly.h"
#include "simcore/embed/Fill.h"
#include "simcore/fem/Rotation.h"

namespace glenoid {

namespace {

constexpr auto& kPairs = kCellPairs.pair;

/// As for tetrahedra (TetObject.cpp).
constexpr double kMassFloor = 1e-9, kNextToNothing = 0.01;

/// The tissue of a cell by material, and its mean Rayleigh β.
struct CellContent {
  std::vector<CellTissue> tissue;
  double stiffnessDamping = 0;
};

CellContent contentOf(const BoxMoments* moments, const ElementTissue* tissue, double whole) {
  CellContent content;
  double volume = 0;
  int fullest = 0;
  for (int five = 0; five < 5; ++five) {
    if (moments[five].volume() > moments[fullest].volume()) fullest = five;
    volume += moments[five].volume();
  }
  std::array<BoxMoments, 5> all;
  std::copy_n(moments, 5, all.begin());
  if (volume < kFillFloor * whole) all[fullest] += fullBox(kFillFloor * whole - volume);
  volume = 0;
  for (int five = 0; five < 5; ++five) {
    if (all[five].volume() == 0) continue;
    const Lame& lame = tissue[five].lame;
    auto same = std::find_if(content.tissue.begin(), content.tissue.end(),
                             [&](const CellTissue& t) { return t.lame.lambda == lame.lambda && t.lame.mu == lame.mu; });
    if (same == content.tissue.end())
      content.tissue.push_back({all[five], lame});
    else
      same->moments += all[five];
    content.stiffnessDamping += all[five].volume() * tissue[five].stiffnessDamping;
    volume += all[five].volume();
  }
  content.stiffnessDamping /= volume;
  return content;
}

/// Eight places about the tissue's centroid with its variances: they stand for its mean and spread along the box's axes.
std::array<Vec3, 8> placesIn(const BoxMoments& moments) {
  const Vec3 mean = meanOf(moments), spread = varianceOf(moments).cwiseMax(0).cwiseSqrt();
  std::array<Vec3, 8> places;
  for (int k = 0; k < 8; ++k)
    for (int a = 0; a < 3; ++a) places[k][a] = mean[a] + (k >> a & 1 ? spread[a] : -spread[a]);
  return places;
}

/// The place with these coordinates in a cell.
Vec3 placeAt(const Mat38& corners, const Vec3& xi) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 8; ++i)
    p += 0.125 * (1 + (i & 1 ? xi.x() : -xi.x())) * (1 + (i & 2 ? xi.y() : -xi.y())) * (1 + (i & 4 ? xi.z() : -xi.z())) * corners.col(i);
  return p;
}

/// Mass and drag of each two corners of a cell.
void appendMasses(const BoxMoments* moments, const ElementTissue* tissue, double whole, const std::array<int, 8>& corners,
                  std::vector<MassPair>& masses) {
  double volume = 0;
  for (int five = 0; five < 5; ++five) volume += moments[five].volume();
  Mat8 mass = Mat8::Zero(), drag = Mat8::Zero();
  if (volume < kNextToNothing * whole) mass = tissue[0].density * kMassFloor * cellMassShape(fullBox(whole));
  for (int five = 0; five < 5; ++five) {
    if (moments[five].volume() == 0) continue;
    const Mat8 shape = tissue[five].density * cellMassShape(moments[five]);
    mass += shape;
    drag += tissue[five].massDamping * shape;
  }
  for (const auto& [i, j] : kPairs) {
    const auto [low, high] = std::minmax(corners[i], corners[j]);
    masses.push_back({high, low, mass(i, j), drag(i, j)});
  }
}

}  // namespace

Result<std::unique_ptr<SoftObject>> CellObject::make(const ObjectLayout& layout, std::shared_ptr<const TetMesh> mesh, const CellMesh& cells,
                                                     const std::vector<ElementTissue>& tissue, int rotationOffset) {
  std::unique_ptr<CellObject> soft(new CellObject(layout, std::move(mesh), rotationOffset));
  std::vector<MassPair> masses;
  std::vector<TissueSample> samples;
  for (std::size_t c = 0; c < cells.boxes.size(); ++c) {
    const double whole = cells.boxes[c].edges.prod();
    const CellContent content = contentOf(&cells.tissue[5 * c], &tissue[5 * c], whole);
    CellModes modes;
    Mat38 corners;
    for (int i = 0; i < 8; ++i) corners.col(i) = soft->mesh().nodes[cells.corners[c][i]];
    Result<CorotCell> cell = makeCorotCell(corners, content.tissue, &modes);
    if (!cell) {
      cell.error().place.element = static_cast<long>(5 * c);
      return cell.error();
    }
    appendMasses(&cells.tissue[5 * c], &tissue[5 * c], whole, cells.corners[c], masses);
    for (const CellTissue& each : content.tissue)
      for (const Vec3& xi : placesIn(each.moments)) {
        soft->m_places.push_back({static_cast<int>(c), xi});
        samples.push_back({placeAt(corners, xi), each.moments.volume() / 8, each.lame});
      }
    soft->m_modes.push_back(modes);
    soft->m_cells.push_back(*cell);
    soft->m_stiffnessDamping.push_back(content.stiffnessDamping);
    for (int five = 0; five < 5; ++five) soft->m_lameOfTet.push_back(tissue[5 * c + five].lame);
  }
  soft->m_corners = cells.corners;
  soft->setMass(std::move(masses));
  soft->setSamples(std::move(samples));
  soft->buildPacks();
  return std::unique_ptr<SoftObject>(std::move(soft));
}

void CellObject::buildPacks() {
  for (int first = 0; first < rotationCount(); first += 4) {
    CellPack& pack = m_packs.emplace_back();
    pack.count = std::min(4, rotationCount() - first);
    for (int lane = 0; lane < 4; ++lane) {
      const int c = std::min(first + lane, rotationCount() - 1);
      const double used = lane < pack.count ? 1 : 0;
      const CorotCell& cell = m_cells[c];
      for (int i = 0; i < 8; ++i) {
        pack.node[lane][i] = m_corners[c][i];
        for (int axis = 0; axis < 3; ++axis) {
          pack.rest[i][axis][lane] = cell.x0_E(axis, i);
          pack.gradients[i][axis][lane] = cell.gradients_E(axis, i);
        }
      }
      for (int k = 0; k < kCellBlocks; ++k)
        for (int r = 0; r < 3; ++r)
          for (int col = 0; col < 3; ++col)
            pack.stiffness[k][r][col][lane] = used * cell.K_E(3 * kPairs[k][0] + r, 3 * kPairs[k][1] + col);
      pack.lambda[lane] = used * cell.volume * cell.lame.lambda;
      pack.mu[lane] = used * cell.volume * cell.lame.mu;
      pack.stiffnessDamping[lane] = used * m_stiffnessDamping[c];
    }
  }
}

void CellObject::appendBlockPairs(int base, std::vector<std::array<int, 2>>& pairs) const {
  for (const auto& corners : m_corners)
    for (int k = 8; k < kCellBlocks; ++k) pairs.push_back({base + corners[kPairs[k][0]], base + corners[kPairs[k][1]]});
}

std::vector<BlockEntry> CellObject::blockEntries(const BlockSymbolic& symbolic, int base) const {
  std::vector<BlockEntry> entries;
  entries.reserve(m_corners.size() * kCellBlocks + massMatrix().pairs().size());
  for (const auto& corners : m_corners)
    for (const auto& pair : kPairs) entries.push_back(symbolic.entry(base + corners[pair[0]], base + corners[pair[1]]));
  appendMassEntries(symbolic, base, entries);
  return entries;
}

Mat38 CellObject::cornersAt(int cell, const VecX& q) const {
  Mat38 x;
  for (int i = 0; i < 8; ++i) x.col(i) = nodeAt(q, m_corners[cell][i]);
  return x;
}

void CellObject::assembleCell(int c, const StepSettings& settings, const VecX& q, const BlockEntry* entries, Eigen::Map<Quat> rotation,
                              BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  const CorotCell& cell = m_cells[c];
  const Mat38 x = cornersAt(c, q);
  const Mat3 F = deformationGradient(cell, x);
  Quat R = rotation;
  if (settings.rotationsBySvd && F.allFinite())
    R = rotationBySvd(F);
  else
    nearestRotation(F, R);
  rotation = R;
  const Mat3 R_WE = R.toRotationMatrix();
  const Mat38 force = elasticForce(cell, x, F, R_WE), g = R_WE * cell.gradients_E;
  for (int i = 0; i < 8; ++i) b.segment<3>(3 * m_corners[c][i]) += dt * force.col(i);
  const double scale = dt * dt + (settings.damping ? dt * m_stiffnessDamping[c] : 0);
  const double turning = settings.tension ? dt * dt * tensionStiffness(cell, F, R_WE) : 0;
  for (int k = 0; k < kCellBlocks; ++k) {
    const int i = kPairs[k][0], j = kPairs[k][1];
    const Mat3 K = cell.K_E.block<3, 3>(3 * i, 3 * j);
    A.add(entries[k], scale * (R_WE * K * R_WE.transpose()) + tensionBlock(turning, g.col(i), g.col(j)));
  }
}

LawRange CellObject::rangeOf(std::span<const int> elements, const VecX& q) const {
  int notSound = 0;
  for (const int e : elements)
    notSound += tissueState(m_cells[e].lameLow, deformationGradient(m_cells[e], cornersAt(e, q)), true) != TissueState::Sound;
  return lawRange(notSound, rotationCount());
}

void CellObject::addStretchLaw(std::vector<int>& elements, const StepSettings& settings, const VecX& q,
                              std::span<const BlockEntry> entries, const VecX& rotations, BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const auto rotationAt = [&](int e) { return Eigen::Map<const Quat>(rotations.data() + rotationOffset() + 4 * e).toRotationMatrix(); };
  std::erase_if(elements, [&](int e) {
    const Mat3 U = rotationAt(e).transpose() * deformationGradient(m_cells[e], cornersAt(e, q));
    return plainlySound(m_cells[e].lameLow, 0.5 * (U + U.transpose()));
  });
  const LawRange range = rangeOf(elements, q);
  if (range == LawRange::Linear) return;
  for (const int e : elements) {
    const auto& element = m_cells[e];
    const Mat3 R_WE = rotationAt(e);
    if (const auto more = stretchCorrection(element.lameLow, element.lame, deformationGradient(element, cornersAt(e, q)), R_WE, range == LawRange::Whole))
      addStretchCorrection<8>(*more, element.volume, settings, R_WE, element.gradients_E, kPairs, m_corners[e].data(), &entries[kCellBlocks * e], A, b);
  }
}

void CellObject::assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX& rotations,
                          BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  std::vector<int>& far = elementScratch(rotationCount());
  const auto rotationOf = [&](int c) { return rotations.data() + rotationOffset() + 4 * c; };
  if (settings.rotationsBySvd) {
    for (int c = 0; c < rotationCount(); ++c) {
      assembleCell(c, settings, state.q, &entries[kCellBlocks * c], Eigen::Map<Quat>(rotationOf(c)), A, b);
      far.push_back(c);
    }
  } else {
    const CellKernel kernel = cellKernel(settings.portable);
    CellTarget target;
    target.tension = settings.tension ? 1 : 0;
    CellResult result;
    for (std::size_t p = 0; p < m_packs.size(); ++p) {
      const CellPack& pack = m_packs[p];
      const int first = 4 * static_cast<int>(p);
      const double* guesses[4];
      for (int lane = 0; lane < 4; ++lane) {
        const int c = std::min(first + lane, rotationCount() - 1);
        guesses[lane] = rotationOf(c);
        for (int k = 0; k < kCellBlocks; ++k) {
          const BlockEntry entry = entries[kCellBlocks * c + k];
          target.slot[lane][k] = lane < pack.count ? A.slot(entry.slot) : nullptr;
          target.turned[lane][k] = entry.transposed;
        }
      }
      kernel(pack, state.q.data() + layout().qOffset, guesses, dt, settings.damping ? 1 : 0, target, result);
      for (int lane = 0; lane < pack.count; ++lane) {
        const int c = first + lane;
        if (!result.settled[lane]) {
          assembleCell(c, settings, state.q, &entries[kCellBlocks * c], Eigen::Map<Quat>(rotationOf(c)), A, b);
          far.push_back(c);
          continue;
        }
        std::copy_n(result.quaternion[lane], 4, rotationOf(c));
        for (int i = 0; i < 8; ++i)
          for (int axis = 0; axis < 3; ++axis) b[3 * pack.node[lane][i] + axis] += dt * result.force[i][axis][lane];
        if (result.strained[lane]) far.push_back(c);
      }
    }
  }
  if (settings.stretchLaw && !far.empty()) addStretchLaw(far, settings, state.q, entries, rotations, A, b);
  assembleMass(settings, state, entries.subspan(kCellBlocks * m_cells.size()), A, b);
}

Mat3 CellObject::rotationOf(int cell, const Mat3& F, const State& state) const {
  Quat R = Eigen::Map<const Quat>(state.rotations.data() + rotationOffset() + 4 * cell);
  nearestRotation(F, R);
  return R.toRotationMatrix();
}

double CellObject::elasticEnergy(const State& state) const {
  double energy = 0;
  std::vector<int> all(rotationCount());
  std::iota(all.begin(), all.end(), 0);
  const LawRange range = rangeOf(all, state.q);
  for (int c = 0; c < rotationCount(); ++c) {
    const Mat38 x = cornersAt(c, state.q);
    const Mat3 F = deformationGradient(m_cells[c], x), R = rotationOf(c, F, state);
    energy += glenoid::elasticEnergy(m_cells[c], x, R);
    if (range == LawRange::Linear) continue;
    if (const auto more = stretchCorrection(m_cells[c].lameLow, m_cells[c].lame, F, R, range == LawRange::Whole)) energy += m_cells[c].volume * more->energy;
  }
  return energy;
}

ElementReading CellObject::readElement(int tet, const State& state, bool stretchLaw) const {
  const int c = tet / 5;
  const Mat3 F = deformationGradient(m_cells[c], cornersAt(c, state.q)), R = rotationOf(c, F, state);
  const Mat3 stretch = F * R.transpose();
  const Mat3 strain = 0.5 * (stretch + stretch.transpose()) - Mat3::Identity();
  const Lame& lame = m_lameOfTet[tet];
  Mat3 stress = 2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity();
  if (stretchLaw)
    if (const auto more = stretchCorrection(lame, lame, F, R)) stress += R * more->stress_E * R.transpose();
  return {strain, stress};
}

TissueTrouble CellObject::troubleOf(const VecX& q, bool stretchLaw) const {
  TissueTrouble trouble;
  for (int c = 0; c < rotationCount(); ++c)
    trouble.count(tissueState(m_cells[c].lameLow, deformationGradient(m_cells[c], cornersAt(c, q)), stretchLaw));
  return trouble;
}

void CellObject::readSamples(const State& state, std::vector<ElementReading>& readings, bool stretchLaw) const {
  readings.clear();
  for (std::size_t first = 0, k = 0; k < m_places.size(); first = k) {
    const int c = m_places[first].cell;
    const Mat38 x = cornersAt(c, state.q);
    const Mat3 F = deformationGradient(m_cells[c], x), R = rotationOf(c, F, state);
    const Mat38 u = R.transpose() * (x.colwise() - x.col(0)) - m_cells[c].x0_E;
    for (; k < m_places.size() && m_places[k].cell == c; ++k) {
      const Mat3 strain = R * strainAt(m_modes[c], m_places[k].xi, u) * R.transpose();
      const Lame& lame = samples()[k].lame;
      Mat3 stress = 2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity();
      // Like the cell's forces: what the law adds is that of the mean stretch.
      if (stretchLaw)
        if (const auto more = stretchCorrection(lame, lame, F, R)) stress += R * more->stress_E * R.transpose();
      readings.push_back({strain, stress});
    }
  }
}

}  // namespace glenoid
