// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/ToolTouch.h"

namespace glenoid {

ToolTouch toolTouch(const Model& model, const StepReport& step, int tool, int part, const std::function<bool(const Vec3&)>& counts) {
  ToolTouch touch;
  double weights = 0;
  for (const ContactView& contact : step.contactViews) {
    if (!(contact.force > 0)) continue;
    const int other = contact.objectA == tool ? contact.objectB : contact.objectB == tool ? contact.objectA : -1;
    if (other < 0 || (part >= 0 ? other != part : model.objects[other].tool)) continue;
    if (counts && !counts(contact.point_W)) continue;
    const double sign = contact.objectA == tool ? 1 : -1;  // the normal goes from b to a, and a is pushed along it
    touch.force_W += sign * (contact.force * contact.normal_W + contact.friction_W);
    touch.point_W += contact.force * contact.point_W;
    weights += contact.force;
  }
  if (weights > 0) touch.point_W /= weights;
  touch.force = touch.force_W.norm();
  return touch;
}

}  // namespace glenoid
