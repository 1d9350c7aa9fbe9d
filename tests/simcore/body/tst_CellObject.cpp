// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/CellObject.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "simcore/body/RigidObject.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/Cells.h"
#include "simcore/linear/BlockCholesky.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

constexpr double kDensity = 1100;

/// A shape in cells, all nodes free.
struct Celled {
  Celled(const TriMesh& surface, double cell, double nu = 0.3, double beta = 1e-3)
      : cells(wholeCells(embedInCells(surface, surface, cell).value(), surface).value()) {
    const int nodes = static_cast<int>(cells.mesh.nodes.size());
    layout = {false, true, 0, 3 * nodes, 0, 3 * nodes, nodes};
    soft = SoftObject::makeOfCells(layout, std::make_shared<TetMesh>(cells.mesh), cells,
                                   std::vector<ElementTissue>(cells.mesh.tets.size(), {lameFrom(5e4, nu), kDensity, 0.5, beta, 1}), 0)
               .value();
    state.q.resize(3 * nodes);
    for (int i = 0; i < nodes; ++i) state.q.segment<3>(3 * i) = cells.mesh.nodes[i];
    state.v.setZero(3 * nodes);
    state.rotations.setZero(4 * soft->rotationCount());
    for (int i = 3; i < state.rotations.size(); i += 4) state.rotations[i] = 1;
    std::vector<std::array<int, 2>> pairs;
    soft->appendBlockPairs(0, pairs);
    symbolic = std::make_shared<BlockSymbolic>(nodes, pairs);
    entries = soft->blockEntries(*symbolic, 0);
  }
  void assemble(const StepSettings& settings, BlockMatrix& A, VecX& b) {
    A.setZero();
    b.setZero(layout.vSize);
    soft->assemble(settings, state, entries, state.rotations, A, b);
  }
  CellMesh cells;
  ObjectLayout layout;
  std::unique_ptr<SoftObject> soft;
  State state;
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::vector<BlockEntry> entries;
};

TriMesh sheet() { return shapes::sheet(0.034, 0.02, 0.0014, 0.4); }

TEST(CellObject, fourAtATimeEqualsOneAtATime) {
  Celled part(sheet(), 0.008);
  const Mat3 turn = Eigen::AngleAxisd(1.3, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (int node = 0; node < part.layout.nodeCount; ++node) {
    const Vec3 x = part.cells.mesh.nodes[node];
    part.state.q.segment<3>(3 * node) = turn * (x + 1e-3 * Vec3(std::sin(300 * x.y()), x.x() * x.z() * 100, std::cos(200 * x.x()))) + Vec3(1, -2, 3);
  }
  part.state.q.segment<3>(3 * part.cells.corners[2][5]) += turn * Vec3(-0.02, 0.02, -0.02);  // one cell folded over
  BlockMatrix vectors(part.symbolic), portable(part.symbolic), singly(part.symbolic);
  VecX bVectors, bPortable, bSingly;
  const VecX guess = part.state.rotations;
  StepSettings settings;
  part.assemble(settings, vectors, bVectors);
  const VecX found = part.state.rotations;
  part.state.rotations = guess;
  settings.portable = true;
  part.assemble(settings, portable, bPortable);
  EXPECT_EQ(bVectors, bPortable) << "bits do not depend on the instruction set";
  EXPECT_EQ(found, part.state.rotations);
  settings.rotationsBySvd = true;
  part.assemble(settings, singly, bSingly);
  EXPECT_LT((vectors.toDense() - singly.toDense()).norm(), 1e-11 * singly.toDense().norm());
  // Three metres from the origin a coordinate keeps 4e-16 m, 1e-13 of strain in cells of a centimetre.
  EXPECT_LT((bVectors - bSingly).norm(), 1e-9 * bSingly.norm());
}

TEST(CellObject, rightHandSideIsTheForceOfTheEnergy) {
  Celled part(sheet(), 0.008);
  for (Eigen::Index i = 0; i < part.state.q.size(); ++i) part.state.q[i] += 4e-4 * std::sin(12.9 * i);
  BlockMatrix A(part.symbolic);
  VecX b;
  StepSettings settings;
  part.assemble(settings, A, b);
  const double h = 1e-8, size = b.lpNorm<Eigen::Infinity>() / settings.dt;
  for (Eigen::Index i = 0; i < part.state.q.size(); i += 17) {
    State plus = part.state, minus = part.state;
    plus.q[i] += h;
    minus.q[i] -= h;
    const double force = -(part.soft->elasticEnergy(plus) - part.soft->elasticEnergy(minus)) / (2 * h);
    EXPECT_NEAR(b[i] / settings.dt, force, 1e-5 * size);
  }
}

TEST(CellObject, massMatrixHoldsTheSurfacesMassCentreAndInertia) {
  for (const TriMesh& shape : {sheet(), shapes::sphere(0.02)}) {
    const Celled part(shape, 0.009);
    const MassProperties wanted = massPropertiesOf(shape, kDensity).value();
    const auto momentum = [&](const Vec3& velocity, const Vec3& omega, const Vec3& about) {
      VecX v(part.state.q.size());
      for (Eigen::Index i = 0; i < v.size(); i += 3) v.segment<3>(i) = velocity + omega.cross(part.state.q.segment<3>(i) - about);
      return part.soft->momentumOf(part.state.q, v);
    };
    EXPECT_NEAR(part.soft->mass() / wanted.mass, 1, 1e-6);
    for (int k = 0; k < 3; ++k) {
      // Turning about the mass centre has no linear momentum.
      const Vec6 turning = momentum(Vec3::Zero(), Vec3::Unit(k), wanted.centre);
      EXPECT_LT(turning.head<3>().norm(), 1e-6 * wanted.mass * 0.02);
      const Vec3 about = turning.tail<3>() - wanted.centre.cross(turning.head<3>());
      EXPECT_LT((about - wanted.inertia.col(k)).norm(), 1e-6 * wanted.inertia.norm());
    }
  }
}

TEST(CellObject, stepOfAFreeBodyKeepsItsMomenta) {
  Celled part(sheet(), 0.008, 0.4, 0);
  for (Eigen::Index i = 0; i < part.state.q.size(); ++i) part.state.q[i] += 3e-4 * std::sin(5.1 * i);
  BlockMatrix A(part.symbolic);
  BlockCholesky factor(part.symbolic);
  VecX b;
  StepSettings settings;
  settings.damping = false;
  part.assemble(settings, A, b);
  // The forces themselves have neither sum nor moment about any place.
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (Eigen::Index i = 0; i < b.size(); i += 3) force += b.segment<3>(i), moment += part.state.q.segment<3>(i).cross(b.segment<3>(i));
  EXPECT_LT(force.norm(), 1e-12 * b.norm());
  EXPECT_LT(moment.norm(), 1e-11 * b.norm() * 0.03);
  ASSERT_TRUE(factor.factor(A));
  VecX v = b;
  factor.solve(v);
  EXPECT_LT(part.soft->momentumOf(part.state.q, v).head<3>().norm(), 1e-10 * b.norm());
}

/// Deflection of a flat band, cut into cells of 8 mm, over that of a beam: its surface glued at one end, pulled at the other.
double bandRatio(double thickness, double width, double nu) {
  const double length = 0.056;
  Celled band(shapes::box(Vec3(0, -width / 2, -thickness / 2), Vec3(length, width / 2, thickness / 2)), 0.008, nu);
  const int nodes = band.layout.nodeCount;
  StepSettings settings;
  settings.dt = 1e3;  // so long a step is the static answer
  settings.damping = false;
  BlockMatrix A(band.symbolic);
  VecX b, f = VecX::Zero(3 * nodes);
  band.assemble(settings, A, b);
  MatX K = A.toDense() / (settings.dt * settings.dt);
  const double stiff = 100 * K.diagonal().maxCoeff(), load = 1e-6;
  std::vector<Vec3> ends[2];
  for (int i = 0; i < 25; ++i)
    for (const int end : {0, 1}) ends[end].push_back(Vec3(end * length, 0.98 * width * (i % 5 / 4.0 - 0.5), 0.98 * thickness * (i / 5 / 4.0 - 0.5)));
  for (const VertexBinding& at : bindToTets(band.cells.mesh, ends[0]))
    for (int p = 0; p < 4; ++p)
      for (int q = 0; q < 4; ++q) K.block<3, 3>(3 * at.node[p], 3 * at.node[q]).diagonal().array() += stiff / 25 * at.weight[p] * at.weight[q];
  for (const VertexBinding& at : bindToTets(band.cells.mesh, ends[1]))
    for (int p = 0; p < 4; ++p) f[3 * at.node[p] + 2] += load / 25 * at.weight[p];
  const double inertia = width * std::pow(thickness, 3) / 12;
  return K.ldlt().solve(f).dot(f) / load / (load * std::pow(length, 3) / (3 * 5e4 * inertia));
}

TEST(CellObject, aFlatBandThinnerThanItsCellsBendsLikeABeam) {
  // Glued, its end cannot widen, which takes up to a tenth; tetrahedra give 0.01 to 0.03.
  for (const double width : {0.008, 0.02})
    for (const double thickness : {0.0012, 0.002}) {
      const double ratio = bandRatio(thickness, width, 0.45);
      EXPECT_GT(ratio, 0.85) << width << " " << thickness;
      EXPECT_LT(ratio, 1.02);
    }
}

TEST(CellObject, affineStretchIsReadBackInEveryTetrahedron) {
  Celled part(sheet(), 0.008);
  Mat3 strain;
  strain << 0.01, 0.002, 0, 0.002, -0.004, 0.003, 0, 0.003, 0.005;
  const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, 1, 0).normalized()).toRotationMatrix();
  for (int node = 0; node < part.layout.nodeCount; ++node)
    part.state.q.segment<3>(3 * node) = turn * (Mat3::Identity() + strain) * part.cells.mesh.nodes[node];
  const Lame lame = lameFrom(5e4, 0.3);
  const Mat3 wanted = turn * strain * turn.transpose();
  for (int tet = 0; tet < part.soft->elementCount(); ++tet) {
    const ElementReading read = part.soft->readElement(tet, part.state);
    EXPECT_LT((read.strain_W - wanted).norm(), 1e-11);
    EXPECT_LT((read.stress_W - 2 * lame.mu * wanted - lame.lambda * wanted.trace() * Mat3::Identity()).norm(), 1e-11 * 1e6);
  }
}

}  // namespace
}  // namespace glenoid
