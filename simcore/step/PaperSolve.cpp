// SPDX-License-Identifier: GPL-3.0-or-later
// The published way to the same step: Jacobi over velocities outside, projected Gauss–Seidel inside (paper §5.3,
// equation 6). Measurements in the design show that D by 3×3 node diverges on tissue stiffness, hence the choice.
#include <algorithm>
#include <cmath>

#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

Splitting makeSplitting(const BlockSymbolic& A, int blockCount, const std::vector<std::array<int, 2>>& pairs, bool portable) {
  Splitting splitting;
  splitting.symbolic = std::make_shared<BlockSymbolic>(blockCount, pairs);
  std::vector<std::array<int, 2>> kept = pairs;
  for (int block = 0; block < blockCount; ++block) kept.push_back({block, block});
  for (auto& pair : kept)
    if (pair[0] < pair[1]) std::swap(pair[0], pair[1]);
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (const auto& [row, col] : kept) {
    const BlockEntry target = splitting.symbolic->entry(row, col), source = A.entry(row, col);
    splitting.slots.push_back({target.slot, source.slot});
    splitting.transposed.push_back(target.transposed != source.transposed);
  }
  splitting.D = std::make_unique<BlockMatrix>(splitting.symbolic);
  splitting.response = makeCholeskyResponse(splitting.symbolic, portable);
  return splitting;
}

/// Copies the blocks of A that D keeps, and factors; false where D is not positive definite.
bool fill(Splitting& splitting, const BlockMatrix& A) {
  splitting.D->setZero();
  for (std::size_t k = 0; k < splitting.slots.size(); ++k) {
    double* target = splitting.D->slot(splitting.slots[k][0]);
    const double* source = A.slot(splitting.slots[k][1]);
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) target[4 * c + r] = splitting.transposed[k] ? source[4 * r + c] : source[4 * c + r];
  }
  for (Eigen::Index block = 0; block < splitting.sharedMass.size(); ++block) {
    const int index = static_cast<int>(block);
    double* target = splitting.D->slot(splitting.symbolic->entry(index, index).slot);
    for (int c = 0; c < 3; ++c) target[5 * c] += splitting.sharedMass[block];
  }
  return splitting.response->factor(*splitting.D);
}

double lambdaMax(Splitting& splitting, IslandWork& island, int iterations) {
  return estimateLambdaMax(island.A, [&splitting](VecX& x) { splitting.response->solve(x); }, iterations, island.power);
}

}  // namespace

void makeSplittings(const CouplingIslandModel& model, const StepModel& inside, bool portable, IslandWork& island) {
  std::vector<std::array<int, 2>> nodes, objects;
  for (std::size_t k = 0; k < model.objects.size(); ++k) {
    const ContactObject& object = *inside.objects[model.objects[k]];
    if (object.layout().rigid) nodes.push_back({model.base[k] + 1, model.base[k]});  // a rigid body's 6×6 is one "node"
    object.appendBlockPairs(model.base[k], objects);
  }
  // Springs and holds may join blocks of one object: D by object takes every block of A inside an object.
  for (std::size_t k = 0; k < model.objects.size(); ++k) {
    const int base = model.base[k], count = inside.objects[model.objects[k]]->blockCount();
    for (int row = 0; row < count; ++row)
      for (int col = 0; col < row; ++col)
        if (model.symbolic->entry(base + row, base + col).slot >= 0) objects.push_back({base + row, base + col});
  }
  std::erase_if(nodes, [&](const auto& pair) { return model.symbolic->entry(pair[0], pair[1]).slot < 0; });
  island.byNode = makeSplitting(*model.symbolic, model.blockCount, nodes, portable);
  // A node's mass is its own and what it has together with its neighbours: with all of it on the diagonal the iteration
  // converges for M (D⁻¹M has rows that add up to one), and its answer is the same.
  island.byNode.sharedMass.setZero(model.blockCount);
  for (std::size_t k = 0; k < model.objects.size(); ++k) {
    const ContactObject& object = *inside.objects[model.objects[k]];
    object.addSharedMass(island.byNode.sharedMass.segment(model.base[k], object.blockCount()));
  }
  island.byObject = makeSplitting(*model.symbolic, model.blockCount, objects, portable);
}

void chooseSplitting(Stepper::Work& work, IslandWork& island) {
  PaperReport& paper = work.report.paper;
  island.splitting = &island.byNode;
  double estimate = fill(island.byNode, island.A) ? lambdaMax(island.byNode, island, work.paper.powerIterations) : 1e300;
  if (!(estimate < work.paper.lambdaMaxForNodes)) {
    island.splitting = &island.byObject;
    estimate = fill(island.byObject, island.A) ? lambdaMax(island.byObject, island, work.paper.powerIterations) : 1e300;
  }
  // The report names the largest structure that any island needed.
  if (paper.d != "object") paper.d = island.splitting == &island.byNode ? "node" : "object";
  paper.lambdaMax = std::max(paper.lambdaMax, estimate);
}

void solveContactIslandBySplitting(Stepper::Work& work, const State& state, const ContactIsland& island) {
  const PaperLimits& limits = work.paper;
  for (const int c : island.contacts) work.contacts[c].chosen = true;
  const int n = chooseRows(work, state, island);
  const StageClock clock(work.report, Stage::Contact);
  sizeDelassus(work, n);
  auto B = work.W.topLeftCorner(n, n);
  B.setZero();
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    chooseSplitting(work, part);
    part.splitting->response->prepare(part.chosen);
    part.splitting->response->addDelassus(part.chosenIds, B);
  }
  addCompliance(work);
  const VecX& target = work.target = work.d.head(n);  // n·drift − c, along tangents t·drift

  PaperReport& paper = work.report.paper;
  double firstChange = 0, change = 0;
  int iteration = 0;
  bool diverged = false;
  while (iteration < limits.outerIterations) {
    work.d.head(n) = target;
    for (const int index : island.couplingIslands) {
      // v + D⁻¹ (b − A v) = D⁻¹ (b + (L + U) v)
      IslandWork& part = work.islands[index];
      part.A.multiply(part.v, part.residual);
      part.change = part.b - part.residual;
      part.splitting->response->solve(part.change);
      part.residual = part.v;  // the last iterate
      part.v += part.change;
      for (std::size_t k = 0; k < part.chosen.size(); ++k) work.d[part.chosenIds[k]] += dot(part.chosen[k], part.v);
    }
    LcpLimits inner;
    inner.sweeps = limits.innerSweeps;
    inner.pivots = 0;
    const LcpReport lcp = solveChosen(work, n, inner);
    work.report.complementarity = std::max(work.report.complementarity, lcp.error);
    change = 0;
    double size = 0;
    for (const int index : island.couplingIslands) {
      IslandWork& part = work.islands[index];
      part.lambda.clear();
      for (const int id : part.chosenIds) part.lambda.push_back(work.lambda[id]);
      part.splitting->response->addImpulses(part.lambda, part.v);
      change += (part.v - part.residual).squaredNorm();
      size += part.v.squaredNorm();
    }
    ++iteration;
    change = std::sqrt(change);
    if (iteration == 1) firstChange = change;
    if (!std::isfinite(change) || change > 1e3 * firstChange + 1e-9) {
      diverged = true;
      break;
    }
    if (change <= limits.outerTolerance * std::sqrt(size) + 1e-12) break;
  }
  if (diverged) {
    paper.diverged = true;
    work.lambda.head(n).setZero();
    for (const int index : island.couplingIslands) {
      IslandWork& part = work.islands[index];
      part.v = part.free;
      std::fill(part.lambda.begin(), part.lambda.end(), 0.0);
    }
  }
  takeImpulses(work);
  paper.outerIterations = std::max(paper.outerIterations, iteration);
  paper.outerCapped = paper.outerCapped || (!diverged && iteration == limits.outerIterations);
}

}  // namespace glenoid
