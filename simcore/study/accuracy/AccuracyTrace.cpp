// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyTrace.h"

#include <algorithm>
#include <cmath>

#include "simcore/live/CarryState.h"
#include "simcore/live/Run.h"
#include "simcore/step/StepModel.h"
#include "simcore/study/RefineJoint.h"

namespace glenoid {
namespace {

constexpr int kPlacesEach = 150;  ///< about so many vertices of each object are compared

bool sameCells(const Model& a, const Model& b) {
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const SceneObject &one = a.objects[i], &other = b.objects[i];
    if (!one.volume != !other.volume || one.cells != other.cells) return false;
    if (one.volume && one.volume != other.volume && (one.volume->nodes != other.volume->nodes || one.volume->tets != other.volume->tets)) return false;
  }
  return true;
}

}  // namespace

AccuracyPlayer::AccuracyPlayer(std::shared_ptr<const Model> base, std::shared_ptr<const Model> model,
                               const StepperOptions& options, const Recording& input,
                               std::shared_ptr<const Model> judge)
    : m_base(std::move(base)),
      m_model(std::move(model)),
      m_judge(judge ? std::move(judge) : m_model),
      m_input(input),
      m_stepper(m_model, options),
      m_collision(*m_judge, SurfaceKind::Collision),
      m_visual(*m_judge, SurfaceKind::Visual),
      m_sameCells(sameCells(*m_base, *m_model)) {
  for (const SceneObject& object : m_model->objects) {
    std::vector<int>& vertices = m_vertices.emplace_back();
    m_surface.emplace_back(object.visual.vertices.size());
    if (!object.layout.free) continue;
    const int count = static_cast<int>(object.visual.vertices.size());
    for (int k = 0; k < count; k += std::max(1, count / kPlacesEach)) vertices.push_back(k);
  }
}

State AccuracyPlayer::begin(const AccuracyWindow& window) const {
  State state = m_sameCells ? carryState(*m_base, window.state, *m_model) : carryToRefined(*m_base, window.state, *m_model);
  // A step reads the time off its number.
  state.step = std::lround(window.time / m_model->scenario.dt);
  state.time = static_cast<double>(state.step) * m_model->scenario.dt;
  return state;
}

const Inputs& AccuracyPlayer::inputsAt(const State& state) {
  handsAt(m_model->scenario, &m_input, static_cast<double>(state.step + 1) * m_model->scenario.dt, m_inputs.hands);
  return m_inputs;
}

AccuracyTrace AccuracyPlayer::play(const AccuracyWindow& window, const WindowWishes& wishes) {
  const double dt = m_model->scenario.dt;
  const long each = std::lround(wishes.grid / dt), places = std::lround(wishes.seconds / wishes.grid);
  const std::size_t count = m_model->objects.size();
  AccuracyTrace trace;
  State state = begin(window);
  std::vector<DentView> dents;
  for (long place = 0; place < places; ++place) {
    AccuracySample& sample = trace.samples.emplace_back();
    sample.pairForces.assign(count * count, Vec3::Zero());
    sample.handForces.assign(m_model->scenario.tools.size(), Vec3::Zero());
    for (long s = 0; s < each; ++s) {
      const Inputs& inputs = inputsAt(state);
      const VecX before = state.hands;
      const StepReport& report = m_stepper.step(inputs, state);
      ++trace.steps;
      trace.notTaken += !report.taken;
      trace.diverged += report.paper.diverged;
      trace.capped += report.paper.cgCapped || report.paper.outerCapped;
      trace.unsolved += report.pivotsExhausted;
      trace.contacts += report.contacts;
      trace.cpuMs += report.stepCpuMs;
      for (const ContactView& contact : report.contactViews) {
        const auto a = static_cast<std::size_t>(contact.objectA), b = static_cast<std::size_t>(contact.objectB);
        const Vec3 force = (contact.force * contact.normal_W + contact.friction_W) / static_cast<double>(each);
        if (a <= b) sample.pairForces[a * count + b] += force;
        else sample.pairForces[b * count + a] -= force;
      }
      const std::vector<Vec3> hands = handForces(*m_model, state, inputs.hands, before);
      for (std::size_t tool = 0; tool < hands.size(); ++tool) sample.handForces[tool] += hands[tool] / static_cast<double>(each);
      dents = report.dents;
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<Vec3>& chosen = sample.places.emplace_back();
      if (m_vertices[i].empty()) continue;
      const SceneObject& object = m_model->objects[i];
      surfacePositions(object.visual, object.layout, state.q, m_surface[i]);
      if (m_dents) sinkInto(dents, static_cast<int>(i), m_surface[i]);
      for (const int vertex : m_vertices[i]) chosen.push_back(m_surface[i][static_cast<std::size_t>(vertex)]);
    }
    m_collision.look(state.q, dents);
    for (std::size_t p = 0; p < m_collision.lastLook().size(); ++p) {
      const double depth = m_collision.lastLook()[p].depth;
      if (depth <= trace.deepest) continue;
      trace.deepest = depth;
      const CollisionPair& pair = m_judge->collisionPairs[p];
      trace.deepestWhere = m_model->objects[static_cast<std::size_t>(pair.surfaceA)].id + " / " +
                           m_model->objects[static_cast<std::size_t>(pair.surfaceB)].id;
    }
  }
  m_visual.look(state.q, dents);
  trace.depths.assign(count * count, 0.0);
  for (std::size_t p = 0; p < m_visual.lastLook().size(); ++p) {
    const CollisionPair& pair = m_judge->collisionPairs[p];
    const auto a = static_cast<std::size_t>(std::min(pair.surfaceA, pair.surfaceB)),
               b = static_cast<std::size_t>(std::max(pair.surfaceA, pair.surfaceB));
    trace.depths[a * count + b] = m_visual.lastLook()[p].depth;
  }
  trace.contacts /= static_cast<double>(std::max(1L, trace.steps));
  return trace;
}

void sinkInto(std::span<const DentView> dents, int object, std::vector<Vec3>& positions) {
  const std::vector<Vec3> before = dents.empty() ? std::vector<Vec3>() : positions;
  for (const DentView& dent : dents) {
    if (dent.object != object || !(dent.radius > 0)) continue;
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] -= dent.depth *
                      std::exp(-(before[v] - dent.point_W).squaredNorm() / (2 * dent.radius * dent.radius)) *
                      dent.normal_W;
  }
}

std::vector<Vec3> handForces(const Model& model, const State& state, const std::vector<Pose>& hands,
                             const VecX& before) {
  std::vector<Vec3> forces(model.scenario.tools.size(), Vec3::Zero());
  for (const CouplingIslandModel& island : model.inside->islands)
    for (const BoundPoseSpring& bound : island.poseSprings) {
      if (bound.tool < 0) continue;
      const auto& body = static_cast<const RigidObject&>(*model.inside->objects[static_cast<std::size_t>(bound.object)]);
      const PoseTarget target = handTarget(hands[static_cast<std::size_t>(bound.tool)], poseAt(before, 7 * bound.tool), model.scenario.dt);
      const Pose pose = body.pose(state.q);
      const int at = body.layout().vOffset;
      const Vec3 speed = state.v.segment<3>(at) + state.v.segment<3>(at + 3).cross(pose.q_WB * bound.spring.anchor_B);
      forces[static_cast<std::size_t>(bound.tool)] = bound.spring.damping * bound.spring.axes.cwiseProduct(speed) -
                                                     driveWrench(bound.spring, body, target, state.q).head<3>();
    }
  return forces;
}

}  // namespace glenoid
