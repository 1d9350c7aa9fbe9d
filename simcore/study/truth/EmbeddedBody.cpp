// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/EmbeddedBody.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/embed/Bind.h"
#include "simcore/embed/Fill.h"
#include "simcore/embed/WholeCells.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/reading/StressRecovery.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::truth {

namespace {
constexpr double kSpreadInCells = 0.5;  ///< longest edge of the pieces a surface is spread by

void cut(const Vec3& a, const Vec3& b, const Vec3& c, double longest,
         const std::function<void(const Vec3&, const Vec3&, const Vec3&)>& piece) {
  if (std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) <= longest) return piece(a, b, c);
  const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  cut(a, ab, ca, longest, piece);
  cut(ab, b, bc, longest, piece);
  cut(ca, bc, c, longest, piece);
  cut(ab, bc, ca, longest, piece);
}
}  // namespace

MarkedSurface prism(const std::function<Vec2(double, double)>& map, int ns, int nt,
                    const std::vector<double>& levels, int band) {
  MarkedSurface surface;
  const int nz = static_cast<int>(levels.size()) - 1;
  std::map<std::array<int, 3>, int> known;
  const auto at = [&](int i, int j, int k) {
    const auto [entry, fresh] = known.try_emplace({i, j, k}, static_cast<int>(surface.mesh.vertices.size()));
    if (fresh) {
      const Vec2 p = map(static_cast<double>(i) / ns, static_cast<double>(j) / nt);
      surface.mesh.vertices.push_back({p.x(), p.y(), levels[k]});
    }
    return entry->second;
  };
  const auto quad = [&](int a, int b, int c, int d, char mark) {
    surface.mesh.triangles.push_back({a, b, c});
    surface.mesh.triangles.push_back({a, c, d});
    surface.mark.insert(surface.mark.end(), 2, mark);
  };
  for (int i = 0; i < ns; ++i)
    for (int j = 0; j < nt; ++j) {
      quad(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0), '-');
      quad(at(i, j, nz), at(i + 1, j, nz), at(i + 1, j + 1, nz), at(i, j + 1, nz), '+');
    }
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < nt; ++j) {
      quad(at(0, j, k), at(0, j, k + 1), at(0, j + 1, k + 1), at(0, j + 1, k), 'a');
      quad(at(ns, j, k), at(ns, j + 1, k), at(ns, j + 1, k + 1), at(ns, j, k + 1), 'b');
    }
    for (int i = 0; i < ns; ++i) {
      quad(at(i, 0, k), at(i + 1, 0, k), at(i + 1, 0, k + 1), at(i, 0, k + 1), 'c');
      quad(at(i, nt, k), at(i, nt, k + 1), at(i + 1, nt, k + 1), at(i + 1, nt, k), k == band ? 'e' : 'd');
    }
  }
  return surface;
}

EmbeddedBody::EmbeddedBody(MarkedSurface surface, const Vec3& cell, Elements elements, double young,
                           double poisson, double density, GridAxes axes)
    : m_surface(std::move(surface)),
      m_young(young),
      m_cell(std::cbrt(cell.prod())),
      m_lame(lameFrom(young, poisson)) {
  const TriMesh& mesh = m_surface.mesh;
  TetMesh cut = (axes == GridAxes::World ? embedInCells(mesh, mesh, CellGrid{{}, cell})
                                         : embedAlong(mesh, mesh, cell.x(), axes))
                    .value();
  const ElementTissue alike{lameFrom(young, poisson), density};
  const auto layoutOf = [](const TetMesh& tets) {
    const int n = static_cast<int>(tets.nodes.size());
    return ObjectLayout{false, true, 0, 3 * n, 0, 3 * n, n};
  };
  if (elements == Elements::Cells) {
    const CellMesh cells = wholeCells(cut, mesh).value();
    m_mesh = std::make_shared<TetMesh>(cells.mesh);
    m_layout = layoutOf(*m_mesh);
    m_soft = SoftObject::makeOfCells(m_layout, m_mesh, cells,
                                     std::vector<ElementTissue>(m_mesh->tets.size(), alike), 0)
                 .value();
  } else {
    const std::vector<Eigen::Matrix4d> moments = enclosedMoments(cut, mesh);
    const std::vector<double> fill = fillFractions(cut, mesh);
    std::vector<ElementTissue> tissue(cut.tets.size(), alike);
    for (std::size_t t = 0; t < tissue.size(); ++t) tissue[t].fill = fill[t], tissue[t].moments = moments[t];
    m_mesh = std::make_shared<TetMesh>(std::move(cut));
    m_layout = layoutOf(*m_mesh);
    m_soft = SoftObject::make(m_layout, m_mesh, tissue, 0).value();
  }
  m_rest.q.resize(m_layout.qSize);
  for (int i = 0; i < nodes(); ++i) m_rest.q.segment<3>(3 * i) = m_mesh->nodes[i];
  m_rest.v.setZero(m_layout.vSize);
  m_rest.rotations.setZero(4 * m_soft->rotationCount());
  for (Eigen::Index i = 3; i < m_rest.rotations.size(); i += 4) m_rest.rotations[i] = 1;
  std::vector<std::array<int, 2>> pairs;
  m_soft->appendBlockPairs(0, pairs);
  m_symbolic = std::make_shared<BlockSymbolic>(nodes(), pairs);
  m_entries = m_soft->blockEntries(*m_symbolic, 0);
  m_pull.setZero(m_layout.vSize);
}

std::vector<EmbeddedBody::Spread> EmbeddedBody::spreadOver(std::string_view marks) const {
  std::vector<Vec3> places;
  std::vector<Spread> spread;
  for (std::size_t t = 0; t < m_surface.mark.size(); ++t) {
    if (marks.find(m_surface.mark[t]) == std::string_view::npos) continue;
    const auto& corner = m_surface.mesh.triangles[t];
    const auto& x = m_surface.mesh.vertices;
    cut(x[corner[0]], x[corner[1]], x[corner[2]], kSpreadInCells * m_cell,
        [&](const Vec3& a, const Vec3& b, const Vec3& c) {
          const Vec3 area = 0.5 * (b - a).cross(c - a);
          for (const Vec3& middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {  // exact for quadratics
            places.push_back(middle);
            spread.push_back({middle, {}, area.norm() / 3, area.normalized()});
          }
        });
  }
  const std::vector<VertexBinding> bound = bindToTets(*m_mesh, places);
  for (std::size_t i = 0; i < spread.size(); ++i) spread[i].at = bound[i];
  return spread;
}

void EmbeddedBody::hold(std::string_view marks, int axis, double stiff) {
  draw(marks, axis, stiff, [](const Vec3&) { return 0.0; });
}

void EmbeddedBody::draw(std::string_view marks, int axis, double stiff,
                        const std::function<double(const Vec3&)>& towards) {
  for (const Spread& place : spreadOver(marks)) m_held.push_back({place, axis, stiff, towards(place.x)});
}

void EmbeddedBody::pull(char mark, const std::function<Vec3(const Vec3&, const Vec3&)>& traction) {
  for (const Spread& place : spreadOver(std::string_view(&mark, 1)))
    for (int k = 0; k < 4; ++k)
      m_pull.segment<3>(3 * place.at.node[k]) +=
          place.at.weight[k] * place.area * traction(place.x, place.normal);
}

void EmbeddedBody::pull(char mark, const std::function<Vec3(const Vec3&)>& traction) {
  pull(mark, [&](const Vec3&, const Vec3& normal) { return traction(normal); });
}

BlockMatrix EmbeddedBody::assembled(double dt) const {
  StepSettings settings;
  settings.dt = dt;
  settings.damping = false;
  BlockMatrix A(m_symbolic);
  VecX b = VecX::Zero(m_layout.vSize), rotations = m_rest.rotations;
  m_soft->assemble(settings, m_rest, m_entries, rotations, A, b);
  return A;
}

BlockMatrix EmbeddedBody::held() const {
  // M + Δt² K for a Δt over which the mass is nothing, over Δt².
  BlockMatrix K = assembled(1), M = assembled(0);
  for (std::size_t i = 0; i < K.values().size(); ++i) K.values()[i] -= M.values()[i];
  for (const auto& [place, axis, stiff, towards] : m_held)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j) {
        if (place.at.weight[i] == 0 || place.at.weight[j] == 0) continue;
        Mat3 spring = Mat3::Zero();
        spring(axis, axis) = stiff * m_young / m_cell * place.area * place.at.weight[i] * place.at.weight[j];
        K.add(m_symbolic->entry(place.at.node[i], place.at.node[j]), spring);
      }
  return K;
}

VecX EmbeddedBody::solve() const {
  BlockCholesky factor(m_symbolic);
  if (!factor.factor(held())) return VecX::Constant(m_pull.size(), NAN);
  VecX u = m_pull;
  for (const auto& [place, axis, stiff, towards] : m_held)
    for (int i = 0; i < 4; ++i)
      u[3 * place.at.node[i] + axis] += stiff * m_young / m_cell * place.area * place.at.weight[i] * towards;
  factor.solve(u);
  return u;
}

bool EmbeddedBody::isDeep(const TriangleTree& surface, int node) const {
  const Vec3& x = m_mesh->nodes[static_cast<std::size_t>(node)];
  return surface.inside(x) && (surface.closest(x).point - x).norm() > 2 * m_cell;
}

VecX EmbeddedBody::solveInside(const std::function<Vec3(const Vec3&)>& field) const {
  constexpr double kPinned = 1e9;  // of a node's own stiffness
  const TriangleTree surface(m_surface.mesh);
  BlockMatrix K = held();
  VecX u = m_pull;
  const Mat3 pin = kPinned * m_young * m_cell * Mat3::Identity();
  for (int i = 0; i < nodes(); ++i) {
    if (isDeep(surface, i)) continue;
    K.add(m_symbolic->entry(i, i), pin);
    u.segment<3>(3 * i) += pin * field(m_mesh->nodes[static_cast<std::size_t>(i)]);
  }
  BlockCholesky factor(m_symbolic);
  if (!factor.factor(K)) return VecX::Constant(m_pull.size(), NAN);
  factor.solve(u);
  return u;
}

std::vector<double> EmbeddedBody::frequencies(int count, std::vector<VecX>* shapes) const {
  const BlockMatrix K = held(), M = assembled(0);
  BlockCholesky factor(m_symbolic);
  if (!factor.factor(K)) return {};
  // Subspace iteration (Bathe and Wilson 1973) with twice the vectors wanted.
  MatX X = MatX::Zero(m_pull.size(), 2 * count + 4), Y = X, Z = X;
  for (Eigen::Index c = 0; c < X.cols(); ++c)
    for (Eigen::Index r = 0; r < X.rows(); ++r)
      X(r, c) = std::sin(0.37 * (1 + c) * (1 + r % 97) + 0.11 * c * (r / 97));
  VecX squares;
  for (int round = 0; round < 30; ++round) {
    VecX column;
    for (Eigen::Index c = 0; c < X.cols(); ++c) {
      M.multiply(X.col(c), column);
      factor.solve(column);
      X.col(c) = column;
    }
    for (Eigen::Index c = 0; c < X.cols(); ++c) {
      K.multiply(X.col(c), column);
      Y.col(c) = column;
      M.multiply(X.col(c), column);
      Z.col(c) = column;
    }
    const MatX stiff = X.transpose() * Y, heavy = X.transpose() * Z;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatX> small(0.5 * (stiff + stiff.transpose()),
                                                               0.5 * (heavy + heavy.transpose()));
    X = X * small.eigenvectors();
    const VecX before = squares;
    squares = small.eigenvalues().head(count);
    if (before.size() == count && (squares - before).cwiseQuotient(squares).cwiseAbs().maxCoeff() < 1e-8)
      break;
  }
  std::vector<double> frequencies;
  for (int i = 0; i < count; ++i) frequencies.push_back(std::sqrt(squares[i]) / (2 * M_PI));
  if (shapes)
    for (int i = 0; i < count; ++i) shapes->push_back(X.col(i));
  return frequencies;
}

double EmbeddedBody::radialShare(const VecX& shape) const {
  double reach = 0, radial = 0;
  for (const Vec3& x : m_mesh->nodes) reach = std::max(reach, x.norm());
  for (int i = 0; i < nodes(); ++i)
    if (m_mesh->nodes[i].norm() > 0.1 * reach)
      radial += std::pow(shape.segment<3>(3 * i).dot(m_mesh->nodes[i].normalized()), 2);
  return radial / shape.squaredNorm();
}

double EmbeddedBody::affineImbalance(const Mat3& F) const {
  State state = m_rest;
  for (int i = 0; i < nodes(); ++i) state.q.segment<3>(3 * i) = F * m_rest.q.segment<3>(3 * i);
  StepSettings settings;
  settings.dt = 1;
  settings.damping = false;
  BlockMatrix A(m_symbolic);
  VecX forces = VecX::Zero(m_layout.vSize), rotations = m_rest.rotations;
  m_soft->assemble(settings, state, m_entries, rotations, A, forces);  // b = Δt F + M v with v = 0
  const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 R = svd.matrixU() * svd.matrixV().transpose(), strain = R.transpose() * F - Mat3::Identity();
  const Mat3 wanted = -enclosedVolume(m_surface.mesh) * R *
                      (2 * m_lame.mu * strain + m_lame.lambda * strain.trace() * Mat3::Identity());
  const TriangleTree surface(m_surface.mesh);
  Mat3 moment = Mat3::Zero();
  double inside = 0;
  for (int i = 0; i < nodes(); ++i) {
    const Vec3 X = m_rest.q.segment<3>(3 * i), force = forces.segment<3>(3 * i);
    moment += force * X.transpose();
    if (isDeep(surface, i)) inside = std::max(inside, force.lpNorm<Eigen::Infinity>());
  }
  return std::max(inside / forces.lpNorm<Eigen::Infinity>(), (moment - wanted).norm() / wanted.norm());
}

Vec3 EmbeddedBody::displacementAt(const VecX& u, const Vec3& x) const {
  return displacementsAt(u, std::span(&x, 1))[0];
}

std::vector<Vec3> EmbeddedBody::displacementsAt(const VecX& u, std::span<const Vec3> places) const {
  const std::vector<VertexBinding> bound =
      bindToTets(*m_mesh, std::vector<Vec3>(places.begin(), places.end()));
  std::vector<Vec3> found;
  for (const VertexBinding& at : bound) {
    Vec3& sum = found.emplace_back(Vec3::Zero());
    for (int k = 0; k < 4; ++k) sum += at.weight[k] * u.segment<3>(3 * at.node[k]);
  }
  return found;
}

Mat3 EmbeddedBody::stressAt(const VecX& u, const Vec3& x) const {
  // So small a displacement that nothing turns: the answer of linear elasticity.
  const double share = 1e-6 * m_cell / u.lpNorm<Eigen::Infinity>();
  State state = m_rest;
  state.q += share * u;
  std::vector<ElementReading> readings;
  m_soft->readSamples(state, readings);
  const auto weights = recoveryWeights(m_soft->samples(), x, recoveryReach(*m_mesh));
  return recovered(weights, readings).stress_W / share;
}

}  // namespace glenoid::truth
