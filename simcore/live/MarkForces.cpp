// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/MarkForces.h"

#include <algorithm>

namespace glenoid {
namespace {

int objectOf(const Model& model, const std::string& id, bool tool) {
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (model.objects[i].tool == tool && model.objects[i].id == id) return static_cast<int>(i);
  return -1;
}

/// Net force that contacts put on `first` from `second` (either may be −1: any object of that side), N.
/// A contact's normal points from b to a, so a is pushed along it.
Vec3 netForce(const std::vector<ContactView>& contacts, int first, int second) {
  Vec3 sum = Vec3::Zero();
  for (const ContactView& c : contacts) {
    if (c.objectA == first && (second < 0 || c.objectB == second)) sum += c.force * c.normal_W + c.friction_W;
    else if (c.objectB == first && (second < 0 || c.objectA == second)) sum -= c.force * c.normal_W + c.friction_W;
  }
  return sum;
}

}  // namespace

MarkForces::MarkForces(const Model& model, const Recording* input) : m_model(model) {
  if (!input) return;
  for (const RecordingMark& mark : input->marks) {
    m_reports.push_back({mark.name, mark.tool, mark.part, mark.begin, mark.end, 0, 0});
    m_sides.push_back({mark.tool.empty() ? -1 : objectOf(model, mark.tool, true), mark.part.empty() ? -1 : objectOf(model, mark.part, false)});
  }
}

void MarkForces::add(const StepReport& step, double time) {
  const double dt = m_model.scenario.dt;
  for (std::size_t i = 0; i < m_reports.size(); ++i) {
    MarkReport& mark = m_reports[i];
    const auto [tool, part] = m_sides[i];
    // Half a step of slack: times are sums of steps and carry their round-off.
    if (time < mark.begin - dt / 2 || time >= mark.end - dt / 2) continue;
    double force = 0;
    if (tool >= 0) {
      force = netForce(step.contactViews, tool, part).norm();
    } else {  // any tool: the one that pushes hardest
      for (std::size_t k = 0; k < m_model.objects.size(); ++k)
        if (m_model.objects[k].tool)
          force = std::max(force, netForce(step.contactViews, static_cast<int>(k), part).norm());
    }
    mark.forceMax = std::max(mark.forceMax, force);
    if (force >= kTouch) mark.seconds += dt;
  }
}

}  // namespace glenoid
