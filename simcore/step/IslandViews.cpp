// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/IslandViews.h"

#include <algorithm>
#include <cmath>

#include "simcore/step/StepWork.h"

namespace glenoid {
namespace {

void addJoint(std::vector<ContactIslandView::Joint>& joints, const StepContact& contact, double dt) {
  const int a = std::min(contact.objectA, contact.objectB), b = std::max(contact.objectA, contact.objectB);
  const auto at = std::lower_bound(joints.begin(), joints.end(), std::pair(a, b),
                                   [](const auto& one, const auto& pair) { return std::pair(one.objectA, one.objectB) < pair; });
  auto joint = at != joints.end() && at->objectA == a && at->objectB == b ? at : joints.insert(at, {a, b, 0, 0});
  ++joint->contacts;
  joint->force += contact.impulse / dt;
}

}  // namespace

void watchIslands(Stepper& stepper, bool wanted) {
  Stepper::Work& work = stepper.work();
  if (!wanted) work.views.reset();
  else if (!work.views) work.views = std::make_unique<IslandViews>();
}

const IslandViews* islandViews(Stepper& stepper) { return stepper.work().views.get(); }

void beginViews(Stepper::Work& work) {
  work.views->contact.clear();
  work.views->coupling.assign(work.islands.size(), {});
  for (std::size_t i = 0; i < work.islands.size(); ++i) work.views->coupling[i].unknowns = static_cast<int>(work.islands[i].b.size());
}

void viewIsland(Stepper::Work& work, const ContactIsland& island, const ContactSolverCounts& then, double beginMs) {
  ContactIslandView& view = work.views->contact.emplace_back();
  const StepReport& report = work.report;
  view.ms = StageClock::nowMs() - beginMs;
  view.couplingIslands.assign(island.couplingIslands.begin(), island.couplingIslands.end());
  for (const ContactUnknowns& unknown : work.unknowns) view.rows += unknown.rows();
  const ContactSolverCounts& now = report.contactSolver;
  view.method = work.options.profile == Profile::Paper   ? IslandMethod::Splitting
                : now.velocities > then.velocities       ? IslandMethod::Velocities
                : now.impulses > then.impulses           ? IslandMethod::Impulses
                : now.pivoting > then.pivoting           ? IslandMethod::Pivoting
                                                         : IslandMethod::Nothing;
  view.error = report.complementarity;
  for (const int c : island.contacts) {
    const StepContact& contact = work.contacts[c];
    view.contacts += !contact.film && !contact.bed;
    addJoint(view.joinedBy, contact, work.settings.dt);
  }
}

void viewResidual(Stepper::Work& work, ContactIslandView& view) {
  double error = 0, scale = 0;
  for (const int index : view.couplingIslands) {
    error += work.islands[index].residual.squaredNorm();
    scale += work.islands[index].b.squaredNorm();
  }
  view.residual = std::sqrt(error / (scale > 0 ? scale : 1));
}

}  // namespace glenoid
