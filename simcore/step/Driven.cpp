// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed parts that move as prescribed. They join no island: what touches them or is coupled to them sees their place at the
// start of a step and the steady velocity that takes them to where they are at its end.
#include <cmath>

#include "simcore/base/PlainMath.h"
#include "simcore/step/Actions.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

void placeDriven(const Model& model, const StepModel& inside, double time, VecX& q) {
  for (const DrivenObject& driven : inside.driven) {
    const ObjectLayout& layout = model.objects[driven.object].layout;
    const Pose pose = motionAt(model.scenario.motions[driven.motion], time);
    for (std::size_t k = 0; k < driven.rest_W.size(); ++k)
      q.segment<3>(layout.qOffset + 3 * static_cast<int>(k)) = pose * driven.rest_W[k];
    if (layout.rigid) setPoseAt(q, layout.qOffset, {pose * driven.rest_W[0], pose.q_WB});
  }
}

Twist twistOf(const Motion& motion, double begin, double end) {
  const Pose from = motionAt(motion, begin), to = motionAt(motion, end);
  Quat turn = to.q_WB * from.q_WB.conjugate();
  if (turn.w() < 0) turn.coeffs() *= -1;  // the short way round
  const double sine = turn.vec().norm();
  const Vec3 angle = sine > 1e-12 ? Vec3(2 * plain::arcTangent(sine, turn.w()) / sine * turn.vec()) : Vec3(2 * turn.vec());
  Twist twist;
  twist.at_W = from * motion.centre_W;
  twist.linear_W = (to * motion.centre_W - twist.at_W) / (end - begin);
  twist.omega_W = angle / (end - begin);
  return twist;
}

void foreseeDriven(Stepper::Work& work) {
  for (std::size_t i = 0; i < work.inside->driven.size(); ++i) {
    const Motion& motion = work.model->scenario.motions[work.inside->driven[i].motion];
    work.drivenTwists[i] = twistOf(motion, work.partBegin, work.partBegin + work.settings.dt);
  }
}

Vec3 drivenVelocity(const Stepper::Work& work, int object, const Vec3& p_W) {
  const int driven = work.inside->drivenOfObject[object];
  return driven < 0 ? Vec3::Zero().eval() : work.drivenTwists[driven].of(p_W);
}

void drivenSurfaces(Stepper::Work& work, int motion) {
  for (const DrivenObject& driven : work.inside->driven)
    for (std::size_t k = 0; k < work.positions[driven.object].size(); ++k)
      work.velocities[motion][driven.object][k] = drivenVelocity(work, driven.object, work.positions[driven.object][k]);
}

void driftContacts(Stepper::Work& work) {
  if (work.inside->driven.empty()) return;
  for (StepContact& contact : work.contacts) {
    const auto carried = [&](int object, const FeaturePoint& feature) {
      if (work.inside->drivenOfObject[object] < 0) return Vec3::Zero().eval();
      Vec3 p = Vec3::Zero();
      for (int i = 0; i < feature.count; ++i) p += feature.weight[i] * work.positions[object][feature.vertex[i]];
      return drivenVelocity(work, object, p);
    };
    contact.drift_W = carried(contact.objectA, contact.near->a) - carried(contact.objectB, contact.near->b);
  }
}

}  // namespace glenoid
