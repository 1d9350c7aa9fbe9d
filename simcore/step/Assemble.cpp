// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/RigidObject.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

/// Where the hand wants the tip, and how fast it moves there, from this and the last hand pose.
PoseTarget handTarget(const Pose& hand, const Pose& last, double dt) {
  PoseTarget target;
  target.anchor_W = hand.p_WB;
  target.q_WB = hand.q_WB;
  target.velocity_W = (hand.p_WB - last.p_WB) / dt;
  Quat turn = hand.q_WB * last.q_WB.conjugate();
  if (turn.w() < 0) turn.coeffs() *= -1;
  target.omega_W = 2 * turn.vec() / dt;  // hands turn by little in a step
  return target;
}

}  // namespace

void assembleIslands(Stepper::Work& work, const Inputs& inputs, const State& state) {
  const StageClock clock(work.report, Stage::Assemble);
  const double dt = work.settings.dt;
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    const CouplingIslandModel& model = work.inside->islands[i];
    IslandWork& island = work.islands[i];
    island.A.setZero();
    island.b.setZero();
    for (std::size_t k = 0; k < model.objects.size(); ++k) {
      const ContactObject& object = *work.inside->objects[model.objects[k]];
      object.assemble(work.settings, state, model.entries[k], work.rotations, island.A,
                      island.b.segment(3 * model.base[k], 3 * object.blockCount()));
    }
    for (const BoundSpring& spring : model.springs) assembleSpring(spring, dt, state.q, island.A, island.b);
    for (const BoundPoseSpring& bound : model.poseSprings) {
      const auto& body = static_cast<const RigidObject&>(*work.inside->objects[bound.object]);
      PoseTarget target = bound.rest;
      if (bound.tool >= 0) {
        const Pose last = poseAt(state.hands, 7 * bound.tool);
        const bool held = bound.tool < static_cast<int>(inputs.hands.size());
        target = handTarget(held ? inputs.hands[bound.tool] : last, last, dt);
      }
      assemblePoseSpring(bound.spring, body, target, dt, state, bound.entries, island.A, island.b.segment<6>(3 * bound.base));
    }
  }
}

bool solveUnconstrained(Stepper::Work& work, const State& state) {
  bool good = true;
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    IslandWork& island = work.islands[i];
    if (island.response) {
      {
        const StageClock clock(work.report, Stage::Factor);
        if (!island.b.allFinite() || !island.response->factor(island.A)) return false;
      }
      const StageClock clock(work.report, Stage::Unconstrained);
      island.v = island.b;
      island.response->solve(island.v);
    } else {
      const StageClock clock(work.report, Stage::Unconstrained);
      const CouplingIslandModel& model = work.inside->islands[i];
      for (std::size_t k = 0; k < model.objects.size(); ++k) {
        const ObjectLayout& layout = work.inside->objects[model.objects[k]]->layout();
        island.v.segment(3 * model.base[k], layout.vSize) = state.v.segment(layout.vOffset, layout.vSize);
      }
      const CgReport cg = solveConjugateGradients(island.A, island.b, island.v, {work.paper.cgTolerance, work.paper.cgIterations},
                                                  island.cg, true);
      PaperReport& paper = work.report.paper;
      paper.cgIterations = std::max(paper.cgIterations, cg.iterations);
      paper.cgResidual = std::max(paper.cgResidual, cg.residual);
      paper.cgCapped = paper.cgCapped || cg.capped;
      good = good && cg.finite;
    }
  }
  return good;
}

}  // namespace glenoid
