// SPDX-License-Identifier: GPL-3.0-or-later
// A round tool on tissue that gives under it. All features of a tool that are near one place of a soft part are one contact,
// that of the ball which the tool is there (tool/ToolBalls.h): its force f is spread over a patch x_k, w_k of the part's visual
// surface, and the ball may lie as deep in that as
//
//   e(f) = Δ(f) − f nᵀJ K⁻¹ Jᵀn,      J = Σ w_k J_k
//
// where Δ is what the tissue gives in truth (TipLaw.h, from the part's table) and the rest what the part's own coarse elements
// give at this very place (StaticResponse.h). In all the ball sinks by Δ(f), wherever the grid of elements lies. What they tilt
// under the force is no slope of the tissue either: n is the patch's normal without it. e is taken along its slope at the force
// that the ball's approach foresees, so the problem stays a complementarity problem of rows J v + C λ ≥ c.
#include <algorithm>
#include <cmath>

#include "simcore/collide/FeatureKey.h"
#include "simcore/step/StepWork.h"
#include "simcore/step/TouchPlace.h"

namespace glenoid {

namespace {

constexpr double kOneTouch = 2;       ///< radii of a ball: features of one tool nearer than this are one touch

/// Mean velocity of the patch, W.
Vec3 patchVelocity(const ContactObject& part, const Touch& touch, const State& state) {
  Vec3 v = Vec3::Zero();
  for (std::size_t k = 0; k < touch.points.size(); ++k) v += kTouchWeights[k] * part.velocity(touch.points[k], state.q, state.v);
  return v;
}

/// Touches of one tool on one part: its features that the detector found, from `begin` to `end`.
void findTouchesOf(Stepper::Work& work, const State& state, std::size_t begin, std::size_t end) {
  const std::vector<Proximity>& found = *work.proximities;
  const auto near = [&](int f) -> const Proximity& { return found[static_cast<std::size_t>(f)]; };
  const auto touchOf = [&](int f) -> int& { return work.touchOf[static_cast<std::size_t>(f)]; };
  const auto toolIndex = static_cast<std::size_t>(work.finder->pairs()[static_cast<std::size_t>(found[begin].pair)].surfaceB);
  const SceneObject& tool = work.model->objects[toolIndex];
  const std::vector<ToolBall>& balls = work.inside->balls[toolIndex];
  work.deepestFirst.clear();
  for (std::size_t f = begin; f < end; ++f) work.deepestFirst.push_back(static_cast<int>(f));
  std::sort(work.deepestFirst.begin(), work.deepestFirst.end(),
            [&](int a, int b) { return near(a).gap < near(b).gap || (near(a).gap == near(b).gap && a < b); });
  for (const int start : work.deepestFirst) {
    if (touchOf(start) >= 0) continue;
    const Vec3 at_B = inBody(tool, near(start).b);
    int first = nearestBall(balls, at_B), last = first;
    const double reach = kOneTouch * balls[static_cast<std::size_t>(first)].radius;
    for (const int f : work.deepestFirst) {
      const Vec3 other_B = inBody(tool, near(f).b);
      if (touchOf(f) >= 0 || (other_B - at_B).norm() > reach) continue;
      touchOf(f) = static_cast<int>(work.touches.size());
      const int its = nearestBall(balls, other_B);
      first = std::min(first, its);
      last = std::max(last, its);
    }
    placeTouch(work, state, near(start), first, last, work.touches.emplace_back());
  }
}

/// The contact of a touch: what presses, and how far that may take it.
StepContact contactOf(Stepper::Work& work, const State& state, int index) {
  const Touch& touch = work.touches[static_cast<std::size_t>(index)];
  const CollisionPair& pair = work.finder->pairs()[static_cast<std::size_t>(touch.near.pair)];
  const auto softIndex = static_cast<std::size_t>(pair.surfaceA), toolIndex = static_cast<std::size_t>(pair.surfaceB);
  const ContactObject &part = *work.inside->objects[softIndex], &body = *work.inside->objects[toolIndex];
  const double dt = work.settings.dt, whole = work.model->scenario.dt;
  StepContact contact;
  contact.near = &touch.near;
  contact.touch = index;
  contact.objectA = pair.surfaceA;
  contact.objectB = pair.surfaceB;
  contact.islandA = work.inside->islandOfObject[softIndex];
  contact.islandB = work.inside->islandOfObject[toolIndex];
  contact.a = touch.middle;
  contact.b = touch.onTool;
  contact.impulse = dt / whole * touch.lastImpulse;
  contact.friction_W = dt / whole * touch.lastFriction_W;
  if (work.inside->friction) {
    contact.coefficient = coefficientOf(work, contact);
    contact.tangent_W[0] = touch.near.normal_W.unitOrthogonal();
    contact.tangent_W[1] = touch.near.normal_W.cross(contact.tangent_W[0]);
  }
  // The force that the approach of this step leads to, by the law of the tissue from the one there is.
  const TipLaw& law = touch.law;
  const Vec3 apart = patchVelocity(part, touch, state) - body.velocity(touch.onTool, state.q, state.v);
  const double foreseen = -(touch.near.gap + dt * touch.near.normal_W.dot(apart));
  const double force = law.force(std::max(0.0, foreseen + touch.ownCompliance * touch.lastImpulse / whole));
  const double lies = law.depth(force) - touch.ownCompliance * force;
  const double gives = std::max(0.0, law.slope(force) - touch.ownCompliance);
  const double forceMost = work.model->scenario.tools[static_cast<std::size_t>(work.model->objects[toolIndex].toolIndex)].forceMax;
  contact.compliance = gives / (dt * dt);
  contact.target = std::min(-(touch.near.gap + lies - gives * force) / dt, work.recoverySpeedMax + gives * forceMost / dt);
  return contact;
}

}  // namespace

void findTouches(Stepper::Work& work, const State& state) {
  work.touches.clear();
  work.touchOf.clear();
  if (work.inside->dents.empty()) return;
  const StageClock clock(work.report, Stage::Dent);
  const std::vector<Proximity>& found = *work.proximities;
  work.touchOf.assign(found.size(), -1);
  const auto gives = [&](const Proximity& near) {
    const CollisionPair& pair = work.finder->pairs()[static_cast<std::size_t>(near.pair)];
    return !work.inside->dents[static_cast<std::size_t>(pair.surfaceA)].field.empty() && !work.inside->balls[static_cast<std::size_t>(pair.surfaceB)].empty();
  };
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    for (end = begin + 1; end < found.size() && found[end].pair == found[begin].pair;) ++end;
    if (!gives(found[begin])) continue;
    findTouchesOf(work, state, begin, end);
  }
}

void buildTouches(Stepper::Work& work, const State& state) {
  if (work.touches.empty()) return;
  const StageClock clock(work.report, Stage::Dent);
  const auto append = [&](const StepContact& one) {
    work.contacts.push_back(one);
    work.sides.push_back({one.islandA, one.islandB});
    if (appendContactRow(work, state, static_cast<int>(work.contacts.size()) - 1, one.near->normal_W, &IslandWork::rows)) return;
    work.sides.back() = {-1, -1};
    work.contacts.back().impulse = 0;
    work.contacts.back().friction_W.setZero();
  };
  for (std::size_t t = 0; t < work.touches.size(); ++t) {
    const StepContact contact = contactOf(work, state, static_cast<int>(t));
    append(contact);
    // The hard bottom of the dent: the same row, so much lower. It is there at any gap, for a tip may come fast.
    StepContact bed = contact;
    bed.bed = true;
    bed.impulse = 0;
    bed.friction_W.setZero();
    bed.compliance = 0;
    bed.target = std::min(-(work.touches[t].near.gap + work.touches[t].law.give.depthMost) / work.settings.dt, work.recoverySpeedMax);
    append(bed);
  }
}

void showDents(Stepper::Work& work) {
  work.report.dents.clear();
  for (const StepContact& contact : work.contacts) {
    if (contact.touch < 0 || contact.bed || !(contact.impulse > 0)) continue;
    const Touch& touch = work.touches[static_cast<std::size_t>(contact.touch)];
    const double force = contact.impulse / work.settings.dt;
    const double depth = std::min(touch.law.depth(force) - touch.ownCompliance * force, touch.law.give.depthMost);
    if (!(depth > 0)) continue;
    const DentView view{contact.objectA, contact.objectB, touch.place_W, -touch.near.normal_W, depth, 2 * touch.law.radius};
    std::vector<DentView>& dents = work.report.dents;
    const auto same = std::find_if(dents.begin(), dents.end(), [&](const DentView& d) { return d.object == view.object && d.tool == view.tool; });
    if (same == dents.end())
      dents.push_back(view);
    else if (depth > same->depth)
      *same = view;
  }
}

}  // namespace glenoid
