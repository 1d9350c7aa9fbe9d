// SPDX-License-Identifier: GPL-3.0-or-later
// One complementarity problem for each contact island. Most contacts are near without touching: the problem starts
// with those that the free motion would violate or that pressed in the last step, and takes in others only when its
// answer violates them. That ends with every contact right, so it is exact, and its cost follows what touches.
#include <algorithm>
#include <cmath>
#include <optional>

#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

/// The friction solve is done when Coulomb's law holds to this share of what gravity alone gives in a step, Δt g: what is
/// left moves a block at rest by less than a micron an hour. Where many stiff contacts depend on each other and steps bring
/// no more, a hundred times that. Without gravity, what moves a tenth of that share of the contact distance in a step.
constexpr double kFeelable = 1e-9, kFeelableAtMost = 1e-7;
/// From so many rows on W, which is dense, would cost more than a sparse factorization for each Newton step; from kManyRows
/// on where not even four times as many unknowns stand behind them.
constexpr int kRowsInImpulses = 800;

/// w_n = J v + n·drift + C λ − c of every contact of an island, from the velocities and impulses as they stand.
void normalSpeeds(Stepper::Work& work, const ContactIsland& island) {
  for (const int c : island.contacts) {
    StepContact& contact = work.contacts[c];
    const double required = contact.target - contact.near->normal_W.dot(contact.drift_W);
    contact.speed = (contact.chosen ? contact.compliance * contact.impulse : 0.0) - required;
  }
  for (const int index : island.couplingIslands) {
    const IslandWork& part = work.islands[index];
    for (int row = 0; row < part.rows.count(); ++row) work.contacts[part.rows.contactOf(row)].speed += dot(part.rows.row(row), part.v);
  }
}

/// Contacts that the velocities violate become unknowns; how many did.
int chooseViolated(Stepper::Work& work, const ContactIsland& island) {
  int more = 0;
  for (const int c : island.contacts) {
    StepContact& contact = work.contacts[c];
    if (contact.chosen || contact.leftOut || contact.speed >= 0) continue;
    contact.chosen = true;
    ++more;
  }
  return more;
}

/// W = J A⁻¹ Jᵀ + C of the chosen rows, and d = J v − c with the free velocities.
void buildDelassus(Stepper::Work& work, const ContactIsland& island, int n) {
  const StageClock clock(work.report, Stage::Delassus);
  sizeDelassus(work, n);
  auto W = work.W.topLeftCorner(n, n);
  W.setZero();
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    for (std::size_t k = 0; k < part.chosen.size(); ++k) work.d[part.chosenIds[k]] += dot(part.chosen[k], part.free);
    part.response->prepare(part.chosen);
    part.response->addDelassus(part.chosenIds, W);
  }
  addCompliance(work);
}

/// ‖A v − b − Jᵀλ‖ / ‖b‖ over all islands: a tool that nothing pulls has b = 0 and no scale of its own.
double momentumResidual(std::vector<IslandWork>& islands) {
  double error = 0, scale = 0;
  for (IslandWork& island : islands) {
    island.A.multiply(island.v, island.residual);
    island.residual -= island.b;
    for (std::size_t k = 0; k < island.chosen.size(); ++k) addTransposed(island.chosen[k], -island.lambda[k], island.residual);
    error += island.residual.squaredNorm();
    scale += island.b.squaredNorm();
  }
  return std::sqrt(error / (scale > 0 ? scale : 1));
}

/// Whether the island's problem is better put in velocities: more rows than unknowns behind them, or very many rows.
bool inVelocities(const Stepper::Work& work, const ContactIsland& island, int n) {
  if (work.options.profile != Profile::Direct) return false;
  int unknowns = 0;
  for (const int index : island.couplingIslands) unknowns += static_cast<int>(work.islands[index].b.size());
  return n > kRowsInImpulses || (n > kManyRows && 4 * n > unknowns) || (work.tangentialRows > 0 && n >= unknowns);
}

/// Solves with the sparse matrix of the island's own velocities; they and the impulses are the answer. Nothing where contacts join
/// so much that this would cost too much.
std::optional<LcpReport> solveInVelocities(Stepper::Work& work, const ContactIsland& island, int n, LcpLimits limits) {
  const StageClock clock(work.report, work.tangentialRows ? Stage::Friction : Stage::Contact);
  std::vector<VelocityIsland>& parts = work.velocityIslands;
  parts.clear();
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    parts.push_back({&part.A, &part.b, part.response.get(), part.chosen, part.chosenIds, &part.v});
  }
  work.compliances.clear();
  for (const int c : work.unknownContacts) work.compliances.push_back(work.contacts[c].compliance);
  constexpr double kAsked = 5e5;  // products of blocks, for an ordering
  auto& system = work.velocitySystems[island.couplingIslands.front()];
  if (!system) system = std::make_unique<VelocitySystem>(work.options.portable);
  if (!system->set(parts, work.unknowns, work.compliances, work.d.head(n), work.budget.factorMost())) {
    work.budget.spent += kAsked;
    return std::nullopt;
  }
  limits.stepsMost = work.budget.steps(system->updates());
  const LcpReport solved = solveCones(*system, work.lambda.head(n), coneLimits(limits, work.d.head(n)), work.coulomb.cones);
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    part.lambda.clear();
    for (const int id : part.chosenIds) part.lambda.push_back(work.lambda[id]);
  }
  constexpr double kSymbolic = 4;  // factorizations
  work.budget.spent += (solved.pivots + (system->renewed() ? kSymbolic : 0)) * system->updates();
  return solved;
}

LcpReport solveInImpulses(Stepper::Work& work, const ContactIsland& island, int n, LcpLimits limits) {
  limits.stepsMost = work.budget.steps(ContactBudget::dense(n));
  buildDelassus(work, island, n);
  const StageClock clock(work.report, work.tangentialRows ? Stage::Friction : Stage::Contact);
  const LcpReport solved = solveChosen(work, n, limits);
  work.budget.spent += (1 + solved.pivots) * ContactBudget::dense(n) + solved.rowSteps * static_cast<double>(n) * n / 27;
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    part.lambda.clear();
    for (const int id : part.chosenIds) part.lambda.push_back(work.lambda[id]);
    part.v = part.free;
    part.response->addImpulses(part.lambda, part.v);
  }
  return solved;
}

/// Into the report: which method ended the island's problem, and how.
void countSolve(StepReport& report, bool velocities, bool tangential, int n, int newton, const LcpReport& solved) {
  ContactSolverCounts& counts = report.contactSolver;
  (velocities ? counts.velocities : tangential ? counts.impulses : counts.pivoting) += 1;
  counts.convex += solved.convex;
  counts.newtonMax = std::max(counts.newtonMax, newton);
  counts.rowsMax = std::max(counts.rowsMax, n);
  if (!solved.exact) ++report.pivotsExhausted;
  report.complementarity = std::max(report.complementarity, solved.error);
}

void solveContactIsland(Stepper::Work& work, const State& state, const ContactIsland& island) {
  StepReport& report = work.report;
  for (const int c : island.contacts) {
    work.contacts[c].chosen = work.contacts[c].impulse > 0;
    work.contacts[c].leftOut = false;
  }
  {
    const StageClock clock(report, Stage::Contact);
    normalSpeeds(work, island);
    chooseViolated(work, island);
  }
  int newton = 0;
  bool cycles = false;    // W did not do on some of the rows, and will not on more
  bool thorough = false;  // what is not settled is worth the convex law once it is known which contacts take part
  for (int round = 0;; ++round) {
    const int n = chooseRows(work, state, island);
    if (n == 0) return;
    LcpLimits limits;
    limits.turns = thorough ? limits.turns : 0;
    if (work.tangentialRows) {
      const double dt = work.settings.dt;
      const double gravity = work.model->scenario.gravity_W.norm();
      const double felt = gravity > 0 ? dt * gravity : 0.1 * work.model->scenario.contactDistance / dt;
      limits.tolerance = kFeelable * felt;
      limits.enough = kFeelableAtMost * felt;
    }
    const bool tangential = work.tangentialRows > 0;
    bool velocities = cycles || inVelocities(work, island, n);
    limits.sweepsLast = work.options.profile != Profile::Direct || n > ContactBudget::kRowsMost;
    LcpReport solved;
    if (velocities) {
      const std::optional<LcpReport> answer = solveInVelocities(work, island, n, limits);
      if (!answer && n > ContactBudget::kRowsMost) {
        keepDeepest(work, island, ContactBudget::kRowsMost);
        continue;
      }
      velocities = answer.has_value();
      solved = answer ? *answer : solveInImpulses(work, island, n, limits);
    } else {
      solved = solveInImpulses(work, island, n, limits);
      if (!solved.exact && !limits.sweepsLast && !tangential) {
        // Rows that round-off makes dependent do no harm in velocities. Their d is without the free velocities, which W's has taken in.
        chooseRows(work, state, island);
        if (const std::optional<LcpReport> answer = solveInVelocities(work, island, n, limits)) {
          cycles = velocities = true;
          solved = *answer;
        }
      }
    }
    if (tangential || velocities) newton += solved.pivots;
    const StageClock clock(report, tangential ? Stage::Friction : Stage::Contact);
    takeImpulses(work);
    normalSpeeds(work, island);
    // The set only grows, so this ends; past a few rounds all are taken at once.
    constexpr int kRounds = 6;
    int more = chooseViolated(work, island);
    if (more > 0 && round >= kRounds)
      for (const int c : island.contacts)
        if (!work.contacts[c].leftOut) more += !std::exchange(work.contacts[c].chosen, true);
    if (more > 0 && !work.budget.left()) {
      ++report.bounded.rounds;
      more = 0;
    }
    if (more > 0) {
      thorough = thorough && n > kManyRows;
      continue;
    }
    if (work.budget.left() && !solved.exact && (tangential || velocities) && !std::exchange(thorough, true)) continue;
    countSolve(report, velocities, tangential, n, newton, solved);
    return;
  }
}

}  // namespace

int chooseRows(Stepper::Work& work, const State& state, const ContactIsland& island) {
  const StageClock clock(work.report, Stage::Islands);
  int n = 0;
  work.unknowns.clear();
  work.unknownContacts.clear();
  work.tangentialRows = 0;
  for (const int index : island.couplingIslands) work.islands[index].tangents.clear();
  for (const int c : island.contacts) {
    StepContact& contact = work.contacts[c];
    if (!contact.chosen) continue;
    contact.unknown = static_cast<int>(work.unknowns.size());
    const ContactUnknowns& unknown = work.unknowns.emplace_back(n, contact.coefficient > 0, contact.coefficient);
    work.unknownContacts.push_back(c);
    n += unknown.rows();
    if (!unknown.tangential) continue;
    work.tangentialRows += 2;
    for (const Vec3& tangent : contact.tangent_W) appendContactRow(work, state, c, tangent, &IslandWork::tangents);
  }
  if (work.d.size() < n) {
    const Eigen::Index room = n + n / 2 + 8;
    work.d.resize(room);
    work.lambda.resize(room);
  }
  for (std::size_t k = 0; k < work.unknowns.size(); ++k) {
    const StepContact& contact = work.contacts[work.unknownContacts[k]];
    const int row = work.unknowns[k].row;
    work.d[row] = contact.near->normal_W.dot(contact.drift_W) - contact.target;
    work.lambda[row] = contact.impulse;
    for (int t = 0; t + 1 < work.unknowns[k].rows(); ++t) {
      work.d[row + 1 + t] = contact.drift_W.dot(contact.tangent_W[t]);
      work.lambda[row + 1 + t] = contact.friction_W.dot(contact.tangent_W[t]);
    }
  }
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    part.chosen.clear();
    part.chosenIds.clear();
    for (int row = 0; row < part.rows.count(); ++row) {
      const StepContact& contact = work.contacts[part.rows.contactOf(row)];
      if (!contact.chosen) continue;
      part.chosen.push_back(part.rows.row(row));
      part.chosenIds.push_back(work.unknowns[contact.unknown].row);
    }
    for (int row = 0; row < part.tangents.count(); ++row) {
      const StepContact& contact = work.contacts[part.tangents.contactOf(row)];
      part.chosen.push_back(part.tangents.row(row));
      part.chosenIds.push_back(work.unknowns[contact.unknown].row + 1 + row % 2);  // a contact's two stand together
    }
  }
  return n;
}

void sizeDelassus(Stepper::Work& work, int n) {
  if (work.W.rows() < n) work.W.resize(n + n / 2 + 8, n + n / 2 + 8);
}

void addCompliance(Stepper::Work& work) {
  for (std::size_t k = 0; k < work.unknowns.size(); ++k) {
    const int row = work.unknowns[k].row;
    work.W(row, row) += work.contacts[work.unknownContacts[k]].compliance;
  }
}

LcpReport solveChosen(Stepper::Work& work, int n, const LcpLimits& limits) {
  const auto W = work.W.topLeftCorner(n, n);
  const auto d = work.d.head(n);
  return work.tangentialRows ? solveCoulomb(W, d, work.unknowns, work.lambda.head(n), limits, work.coulomb)
                             : solveLcp(W, d, work.lambda.head(n), limits, work.lcp);
}

void takeImpulses(Stepper::Work& work) {
  for (std::size_t k = 0; k < work.unknowns.size(); ++k) {
    StepContact& contact = work.contacts[work.unknownContacts[k]];
    const int row = work.unknowns[k].row;
    contact.impulse = work.lambda[row];
    contact.friction_W.setZero();
    if (work.unknowns[k].tangential)
      contact.friction_W = work.lambda[row + 1] * contact.tangent_W[0] + work.lambda[row + 2] * contact.tangent_W[1];
  }
}

namespace {

/// Below these a row has no part in carrying anything: N, and share of the largest force in its island.
constexpr double kPressingForce = 1e-3, kPressingShare = 1e-3;

int countPressing(const Stepper::Work& work, const ContactIsland& island) {
  const double dt = work.settings.dt;
  const auto counts = [&](const StepContact& contact) { return !contact.film && !contact.bed; };
  double most = 0;
  for (const int c : island.contacts)
    if (counts(work.contacts[c])) most = std::max(most, work.contacts[c].impulse / dt);
  const double least = std::max(kPressingForce, kPressingShare * most);
  int pressing = 0;
  for (const int c : island.contacts) pressing += counts(work.contacts[c]) && work.contacts[c].impulse / dt >= least;
  return pressing;
}

}  // namespace

void solveConstrained(Stepper::Work& work, const State& state) {
  StepReport& report = work.report;
  const std::span<const ContactIsland> islands = work.islandBuilder->build(work.sides);
  report.contactIslands = static_cast<int>(islands.size());
  for (IslandWork& island : work.islands) {
    island.chosen.clear();
    island.lambda.clear();
  }
  const auto solve = [&](const ContactIsland& island) {
    if (work.options.profile == Profile::Paper)
      solveContactIslandBySplitting(work, state, island);
    else
      solveContactIsland(work, state, island);
  };
  if (work.views) work.views->contact.clear();
  for (const ContactIsland& island : islands) {
    if (!work.views) {
      solve(island);
      continue;
    }
    work.unknowns.clear();  // an island without any leaves the last one's
    const ContactSolverCounts before = report.contactSolver;
    const double worst = std::exchange(report.complementarity, 0.0), begin = StageClock::nowMs();
    solve(island);
    viewIsland(work, island, before, begin);
    report.complementarity = std::max(worst, report.complementarity);
  }
  const StageClock clock(report, Stage::Contact);
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const int pressing = countPressing(work, islands[i]);
    report.pressing += pressing;
    if (work.views) work.views->contact[i].pressing = pressing;
  }
  report.residual = momentumResidual(work.islands);
  if (work.views)
    for (ContactIslandView& view : work.views->contact) viewResidual(work, view);
  if (work.options.profile == Profile::Paper) report.paper.outerResidual = report.residual;
  showContacts(work);
}

}  // namespace glenoid
