// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies far from rest, of both kinds of elements: the law of fem/StretchLaw.h in force, energy, A and readings.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "simcore/body/SoftObject.h"
#include "simcore/embed/Cells.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

/// A rounded sheet in cells of 8 mm, cut by them, as tetrahedra or as cells.
struct Body {
  explicit Body(bool asCells, double nu = 0.45)
      : cells(wholeCells(embedInCells(surface(), surface(), 0.008).value(), surface()).value()), lame(lameFrom(5e4, nu)) {
    const int nodes = static_cast<int>(cells.mesh.nodes.size());
    layout = {false, true, 0, 3 * nodes, 0, 3 * nodes, nodes};
    const auto mesh = std::make_shared<TetMesh>(cells.mesh);
    const std::vector<ElementTissue> tissue(cells.mesh.tets.size(), {lame, 1100, 0.5, 1e-3, 1});
    soft = asCells ? SoftObject::makeOfCells(layout, mesh, cells, tissue, 0).value() : SoftObject::make(layout, mesh, tissue, 0).value();
    state.q.resize(3 * nodes);
    state.v.setZero(3 * nodes);
    state.rotations.setZero(4 * soft->rotationCount());
    for (int i = 3; i < state.rotations.size(); i += 4) state.rotations[i] = 1;
    std::vector<std::array<int, 2>> pairs;
    soft->appendBlockPairs(0, pairs);
    symbolic = std::make_shared<BlockSymbolic>(nodes, pairs);
    entries = soft->blockEntries(*symbolic, 0);
  }
  static TriMesh surface() { return shapes::sheet(0.034, 0.02, 0.0034, 0.4); }

  /// Nodes at F x, and off it by `off` m.
  void place(const Mat3& F, double off) {
    for (int node = 0; node < layout.nodeCount; ++node) {
      const Vec3 x = cells.mesh.nodes[node];
      state.q.segment<3>(3 * node) = F * x + off * Vec3(std::sin(12.9 * node), std::sin(7.3 * node), std::sin(9.1 * node));
    }
  }
  void assemble(const StepSettings& settings, BlockMatrix& A, VecX& b) {
    A.setZero();
    b.setZero(layout.vSize);
    soft->assemble(settings, state, entries, state.rotations, A, b);
  }

  CellMesh cells;
  Lame lame;
  ObjectLayout layout;
  std::unique_ptr<SoftObject> soft;
  State state;
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::vector<BlockEntry> entries;
};

const Mat3 kTurn = (Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized())).toRotationMatrix();

/// Stretched, crushed, and drawn along two axes.
std::vector<Mat3> farStates() {
  std::vector<Mat3> states;
  for (const Vec3& s : {Vec3(2.5, 0.6, 0.6), Vec3(0.3, 1.1, 1.1), Vec3(1.7, 1.6, 0.4), Vec3(1.5, 0.9, 0.08)})
    states.push_back(kTurn * s.asDiagonal());
  return states;
}

TEST(StretchedBody, forceIsTheSlopeOfTheEnergy) {
  for (const bool asCells : {false, true})
    for (const Mat3& F : farStates()) {
      Body body(asCells);
      body.place(F, 2e-4);
      BlockMatrix A(body.symbolic);
      VecX b;
      StepSettings settings;
      body.assemble(settings, A, b);
      const double h = 1e-8, size = b.lpNorm<Eigen::Infinity>() / settings.dt;
      for (Eigen::Index i = 0; i < body.state.q.size(); i += 13) {
        State plus = body.state, minus = body.state;
        plus.q[i] += h;
        minus.q[i] -= h;
        const double force = -(body.soft->elasticEnergy(plus) - body.soft->elasticEnergy(minus)) / (2 * h);
        EXPECT_NEAR(b[i] / settings.dt, force, 1e-5 * size) << asCells;
      }
    }
}

TEST(StretchedBody, fourAtATimePortableAndSinglyAreTheSame) {
  for (const bool asCells : {false, true})
    for (const Mat3& F : farStates()) {
      Body body(asCells);
      body.place(F, 2e-4);
      const VecX guess = body.state.rotations;
      BlockMatrix vectors(body.symbolic), portable(body.symbolic), singly(body.symbolic), linear(body.symbolic);
      VecX bVectors, bPortable, bSingly, bLinear;
      StepSettings settings;
      body.assemble(settings, vectors, bVectors);
      body.state.rotations = guess;
      settings.portable = true;
      body.assemble(settings, portable, bPortable);
      EXPECT_EQ(bVectors, bPortable) << "bits do not depend on the instruction set";
      EXPECT_EQ(vectors.toDense(), portable.toDense());
      settings.rotationsBySvd = true;
      body.assemble(settings, singly, bSingly);
      EXPECT_LT((vectors.toDense() - singly.toDense()).norm(), 1e-9 * singly.toDense().norm());
      EXPECT_LT((bVectors - bSingly).norm(), 1e-9 * bSingly.norm());
      settings = {};
      settings.stretchLaw = false;
      body.state.rotations = guess;
      body.assemble(settings, linear, bLinear);
      // Crushed all over it is beyond what the law holds, and linear again (lawRange).
      if (F.colwise().norm().maxCoeff() > 1.6) {
        EXPECT_GT((bVectors - bLinear).norm(), 0.05 * bLinear.norm()) << "the law is in force";
      }
    }
}

TEST(StretchedBody, nearRestItIsTheLinearLawToTheLastBit) {
  for (const bool asCells : {false, true}) {
    Body body(asCells);
    body.place(kTurn * Vec3(1.15, 0.9, 0.5).asDiagonal(), 0);
    const VecX guess = body.state.rotations;
    BlockMatrix with(body.symbolic), without(body.symbolic);
    VecX bWith, bWithout;
    StepSettings settings;
    body.assemble(settings, with, bWith);
    body.state.rotations = guess;
    settings.stretchLaw = false;
    body.assemble(settings, without, bWithout);
    EXPECT_EQ(bWith, bWithout);
    EXPECT_EQ(with.toDense(), without.toDense());
  }
}

TEST(StretchedBody, readsTheLawsStressAndAIsDefinite) {
  for (const bool asCells : {false, true})
    for (const Mat3& F : farStates()) {
      Body body(asCells);
      body.place(F, 0);
      const Vec3 s = (kTurn.transpose() * F).diagonal();
      const Mat3 stress = kTurn * Mat3(principalStress(body.lame, s).asDiagonal()) * kTurn.transpose();
      std::vector<ElementReading> samples;
      body.soft->readSamples(body.state, samples);
      for (int tet = 0; tet < body.soft->elementCount(); ++tet)
        EXPECT_LT((body.soft->readElement(tet, body.state).stress_W - stress).norm(), 1e-9 * stress.norm());
      for (const ElementReading& sample : samples) EXPECT_LT((sample.stress_W - stress).norm(), 1e-6 * stress.norm()) << asCells;
      BlockMatrix A(body.symbolic);
      VecX b;
      body.assemble({}, A, b);
      const MatX dense = A.toDense();
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatX>(dense).eigenvalues()[0], 0);
      EXPECT_LT((dense - dense.transpose()).norm(), 1e-12 * dense.norm());
      const TissueTrouble trouble = body.soft->troubleOf(body.state.q, true);
      EXPECT_EQ(trouble.insideOut, 0);
      EXPECT_EQ(trouble.pressed, principalStress(body.lame, s).minCoeff() < -1.5e5 ? body.soft->rotationCount() : 0) << s.transpose();
    }
}

TEST(StretchedBody, aCellOfTwoTissuesNeverGivesForNothing) {
  // What is left of a mixed cell's stiffness beside the law of the mean compliance is not negative: with rising stretch the
  // energy rises, however the two tissues lie.
  for (const int axis : {0, 1, 2}) {
    Body body(true);
    std::vector<ElementTissue> tissue(body.cells.mesh.tets.size(), {lameFrom(5e4, 0.49), 1100, 0.5, 1e-3, 1});
    for (std::size_t tet = 0; tet < tissue.size(); tet += 2) tissue[tet].lame = lameFrom(2e6, 0.2);
    const auto soft =
        SoftObject::makeOfCells(body.layout, std::make_shared<TetMesh>(body.cells.mesh), body.cells, tissue, 0).value();
    double last = 0;
    for (double s = 1.05; s < 5; s += 0.05) {
      Vec3 stretch = Vec3::Constant(std::pow(s, -0.4));
      stretch[axis] = s;
      body.place(stretch.asDiagonal(), 0);
      const double energy = soft->elasticEnergy(body.state);
      EXPECT_GT(energy, last) << s;
      last = energy;
    }
  }
}

}  // namespace
}  // namespace glenoid
