// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/CellObject.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cstdio>

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
      : Celled(surface, embedInCells(surface, surface, cell).value(), nu, beta) {}
  Celled(const TriMesh& surface, const TetMesh& cut, double nu, double beta) : cells(wholeCells(cut, surface).value()) {
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

/// A place of a band bent along an arc: at an angle from its top, across it, and so much off its middle surface. Its ends are
/// upright, so that one that is glued lies along the cells of a grid that follows it.
Vec3 inArc(double radius, double angle, double across, double off) {
  return {radius * std::sin(angle), across, radius * std::cos(angle) + off / std::cos(angle)};
}

/// Such a band of radius R that turns by `angle` in all; `n` pieces along it.
TriMesh arc(double radius, double angle, double width, double thickness, int n = 48) {
  TriMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k < 4; ++k) {
      const double a = angle * (static_cast<double>(i) / n - 0.5);
      mesh.vertices.push_back(inArc(radius, a, (k == 1 || k == 2 ? 0.5 : -0.5) * width, (k & 2 ? 0.5 : -0.5) * thickness));
    }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      mesh.triangles.push_back({a, b, b + 4});
      mesh.triangles.push_back({a, b + 4, a + 4});
    }
  const int last = 4 * n;
  for (const auto& t : {std::array{0, 2, 1}, {0, 3, 2}}) mesh.triangles.push_back(t);
  for (const auto& t : {std::array{last, last + 1, last + 2}, {last, last + 2, last + 3}}) mesh.triangles.push_back(t);
  return mesh;
}

/// How far the end of such a band, glued at the other, gives along its radius under a force that way, over the closed form
/// of a slender ring's piece: F R³/EI (α/2 − sin 2α/4).
double arcRatio(double radius, double angle, double width, double thickness, double nu, GridAxes axes) {
  const TriMesh surface = arc(radius, angle, width, thickness);
  EXPECT_GT(enclosedVolume(surface), 0);
  Celled band(surface, embedAlong(surface, surface, 0.008, axes).value(), nu, 0);
  const int nodes = band.layout.nodeCount;
  StepSettings settings;
  settings.dt = 1e3;
  settings.damping = false;
  BlockMatrix A(band.symbolic);
  VecX b, f = VecX::Zero(3 * nodes);
  band.assemble(settings, A, b);
  MatX K = A.toDense() / (settings.dt * settings.dt);
  const double stiff = 100 * K.diagonal().maxCoeff(), load = 1e-6;
  std::vector<Vec3> ends[2];
  for (int i = 0; i < 25; ++i)
    for (const int end : {0, 1})
      ends[end].push_back(inArc(radius, (end - 0.5) * angle, 0.98 * width * (i % 5 / 4.0 - 0.5), 0.98 * thickness * (i / 5 / 4.0 - 0.5)));
  for (const VertexBinding& at : bindToTets(band.cells.mesh, ends[0]))
    for (int p = 0; p < 4; ++p)
      for (int q = 0; q < 4; ++q) K.block<3, 3>(3 * at.node[p], 3 * at.node[q]).diagonal().array() += stiff / 25 * at.weight[p] * at.weight[q];
  const Vec3 radial(std::sin(angle / 2), 0, std::cos(angle / 2));
  for (const VertexBinding& at : bindToTets(band.cells.mesh, ends[1]))
    for (int p = 0; p < 4; ++p) f.segment<3>(3 * at.node[p]) += load / 25 * at.weight[p] * radial;
  const double inertia = width * std::pow(thickness, 3) / 12;
  return K.ldlt().solve(f).dot(f) / load / (load * std::pow(radius, 3) / (5e4 * inertia) * (angle / 2 - std::sin(2 * angle) / 4));
}

TEST(CellObject, aGridThatFollowsABentBandLetsItBendLikeOne) {
  for (const double thickness : {0.0012, 0.002})
    for (const double angle : {0.5, 1.0}) {
      const double radius = 0.028 / std::sin(angle / 2);  // seven cells across its chord, so that it is glued at their faces
      const double boxes = arcRatio(radius, angle, 0.008, thickness, 0.45, GridAxes::Principal);
      const double along = arcRatio(radius, angle, 0.008, thickness, 0.45, GridAxes::Band);
      std::printf("arc of %.1f rad, %.1f mm thick: %.3f in boxes, %.3f in a grid along it\n", angle, 1e3 * thickness, boxes, along);
      EXPECT_GT(along, 0.85);
      EXPECT_LT(along, 1.05);
    }
}

TEST(CellObject, cellsAlongABandPassThePatchTestAndHoldItsMass) {
  const TriMesh surface = arc(0.05, 1.0, 0.012, 0.002);
  Celled band(surface, embedAlong(surface, surface, 0.008, GridAxes::Band).value(), 0.4, 0);
  ASSERT_TRUE(band.cells.band);
  // An affine strain: no force at nodes that no cut face touches is too few here, so the forces' work in any affine field
  // must be the stress's: Σ f ⊗ x = −V σ.
  Mat3 strain;
  strain << 1e-6, 2e-7, 0, 2e-7, -4e-7, 3e-7, 0, 3e-7, 5e-7;
  for (int node = 0; node < band.layout.nodeCount; ++node)
    band.state.q.segment<3>(3 * node) = (Mat3::Identity() + strain) * band.cells.mesh.nodes[node];
  const Lame lame = lameFrom(5e4, 0.4);
  const Mat3 stress = 2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity();
  BlockMatrix A(band.symbolic);
  VecX b;
  StepSettings settings;
  band.assemble(settings, A, b);
  Mat3 virial = Mat3::Zero();
  for (int node = 0; node < band.layout.nodeCount; ++node)
    virial += b.segment<3>(3 * node) / settings.dt * band.cells.mesh.nodes[node].transpose();
  const double volume = enclosedVolume(surface);
  EXPECT_LT((virial + volume * stress).norm(), 1e-5 * volume * stress.norm());
  std::vector<ElementReading> readings;
  band.soft->readSamples(band.state, readings);
  for (const ElementReading& read : readings) EXPECT_LT((read.strain_W - strain).norm(), 1e-5 * strain.norm());
  const MassProperties wanted = massPropertiesOf(surface, kDensity).value();
  EXPECT_NEAR(band.soft->mass() / wanted.mass, 1, 1e-6);
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
