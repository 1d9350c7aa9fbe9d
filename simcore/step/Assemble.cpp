// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Turns.h"
#include "simcore/body/RigidObject.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

void takeHands(Stepper::Work& work, const Inputs& inputs, const State& state) {
  for (std::size_t tool = 0; tool < work.wanted.size(); ++tool) {
    work.wanted[tool] = poseAt(state.hands, 7 * static_cast<int>(tool));
    if (tool >= inputs.hands.size()) continue;
    if (isHandPose(inputs.hands[tool])) {
      work.wanted[tool] = {inputs.hands[tool].p_WB, inputs.hands[tool].q_WB.normalized()};
    } else {
      ++work.report.refusedHands;
    }
  }
}

void moveHands(Stepper::Work& work, const State& state, int partsLeft) {
  for (std::size_t tool = 0; tool < work.hands.size(); ++tool) {
    work.hands[tool] = work.wanted[tool];
    if (partsLeft == 1) continue;
    const Pose last = poseAt(state.hands, 7 * static_cast<int>(tool));
    work.hands[tool].p_WB = last.p_WB + (work.wanted[tool].p_WB - last.p_WB) / partsLeft;
    work.hands[tool].q_WB = turnTowards(last.q_WB, work.wanted[tool].q_WB, 1.0 / partsLeft);
  }
}

void assembleIslands(Stepper::Work& work, const State& state) {
  const StageClock clock(work.report, Stage::Assemble);
  const double dt = work.settings.dt, loaded = dt * loadShareAt(work.model->scenario, state.time + dt);
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    const double begin = work.views ? StageClock::nowMs() : 0;
    const CouplingIslandModel& model = work.inside->islands[i];
    IslandWork& island = work.islands[i];
    island.A.setZero();
    island.b.setZero();
    for (std::size_t k = 0; k < model.objects.size(); ++k) {
      const ContactObject& object = *work.inside->objects[model.objects[k]];
      object.assemble(work.settings, state, model.entries[k], work.rotations, island.A,
                      island.b.segment(3 * model.base[k], 3 * object.blockCount()));
    }
    for (const BoundSpring& spring : model.springs) {
      Vec3 drift = Vec3::Zero();
      if (!work.inside->driven.empty())
        drift = drivenVelocity(work, spring.objectA, spring.a->position(spring.pointA, state.q)) -
                drivenVelocity(work, spring.objectB, spring.b->position(spring.pointB, state.q));
      assembleSpring(spring, dt, state.q, island.A, island.b, drift);
    }
    for (const BoundLoad& load : model.loads) assembleLoad(load, *work.inside->objects[load.object], loaded, state.q, island.b);
    for (const BoundPressure& pressure : model.pressures)
      assemblePressure(pressure, *work.inside->objects[pressure.object], dt, state.q, work.pressureScratch, island.b);
    for (const BoundSupport& support : model.supports) assembleSupport(support, dt, state.q, island.A, island.b);
    for (const BoundPoseSpring& bound : model.poseSprings) {
      const auto& body = static_cast<const RigidObject&>(*work.inside->objects[bound.object]);
      PoseTarget target = bound.rest;
      if (bound.tool >= 0) {
        target = handTarget(work.hands[bound.tool], poseAt(state.hands, 7 * bound.tool), dt);
      }
      assemblePoseSpring(bound.spring, body, target, dt, state, bound.entries, island.A, island.b.segment<6>(3 * bound.base));
    }
    if (work.views) work.views->coupling[i].assembleMs += StageClock::nowMs() - begin;
  }
}

bool solveUnconstrained(Stepper::Work& work, const State& state) {
  bool good = true;
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    const double begin = work.views ? StageClock::nowMs() : 0;
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
    if (work.views) work.views->coupling[i].solveMs += StageClock::nowMs() - begin;
  }
  return good;
}

}  // namespace glenoid
