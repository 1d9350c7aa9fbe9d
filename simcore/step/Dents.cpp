// SPDX-License-Identifier: GPL-3.0-or-later
// What a soft part gives under the tip of a tool beyond its coarse tetrahedra. The tip may lie as deep in the surface as
// the forces on it say: with n contacts of one tool on one part,
//   g_i + Δt (J v)_i + Σ_j C_ij f_j ≥ 0,   C_ij = √(c_i c_j) (n_i·n_j) exp(−|p_i − p_j|²/(2 s²)),
// which is symmetric and positive semi-definite as a product of such kernels, so the problem stays what it was. The dent
// has no state of its own: it follows from the forces of the step, and goes with them.
#include <cmath>

#include "simcore/base/PlainMath.h"
#include "simcore/scene/JointFile.h"
#include "simcore/step/CompileObjects.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

constexpr double kLeast = 1e-9;   ///< m/N: what counts as hard, so that logarithms are finite
constexpr double kNear = 1e-3;    ///< m: samples nearer than this count alike
constexpr double kSharing = 2.0;  ///< s over the radius of a tip: contacts of one tip share one dent

/// What the samples say at a place of the surface at rest.
struct Softness {
  double compliance = 0, depthMost = 0;
};
Softness softnessAt(const DentModel& dents, const Vec3& at_W) {
  double sum = 0, compliance = 0, depth = 0;
  for (std::size_t i = 0; i < dents.at_W.size(); ++i) {
    const double square = (dents.at_W[i] - at_W).squaredNorm() + kNear * kNear, weight = 1 / (square * square);
    sum += weight;
    compliance += weight * dents.logCompliance[i];
    depth += weight * dents.depthMost[i];
  }
  return {plain::exponential(compliance / sum), depth / sum};
}

Vec3 along(const FeaturePoint& feature, std::span<const Vec3> vertices) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < feature.count; ++i) p += feature.weight[i] * vertices[feature.vertex[i]];
  return p;
}

}  // namespace

std::vector<DentModel> compileDents(const Model& model) {
  std::vector<DentModel> dents(model.objects.size());
  bool any = false;
  for (std::size_t i = 0; i < model.joint.parts.size(); ++i) {  // parts come first, in the joint's order
    const Part& part = model.joint.parts[i];
    if (!part.dents || model.objects[i].cells || part.dents->basis != dentBasis(model.joint, part)) continue;
    dents[i].radius = part.dents->radius;
    for (const DentSample& sample : part.dents->samples) {
      dents[i].at_W.push_back(sample.at_W);
      dents[i].logCompliance.push_back(plain::logarithm(std::max(sample.compliance, kLeast)));
      dents[i].depthMost.push_back(sample.depthMost);
      any = true;
    }
  }
  if (!any || model.scenario.tools.empty()) dents.clear();
  return dents;
}

double dentCompliance(const Stepper::Work& work, const DentContact& a, const DentContact& b) {
  const double share = kSharing * a.radius, dt = work.settings.dt;
  const Vec3 &n = work.contacts[a.contact].near->normal_W, &m = work.contacts[b.contact].near->normal_W;
  return a.rootCompliance * b.rootCompliance * n.dot(m) * plain::exponential(-(a.point_W - b.point_W).squaredNorm() / (2 * share * share)) / (dt * dt);
}

double dentSpeed(const Stepper::Work& work, const StepContact& contact) {
  const DentContact& own = work.dents[contact.dent];
  double speed = 0;
  const auto add = [&](const DentContact& other) {
    const StepContact& pressed = work.contacts[other.contact];
    if (pressed.chosen && pressed.impulse > 0) speed += dentCompliance(work, own, other) * pressed.impulse;
  };
  for (int k = contact.dent; k >= 0 && work.dents[k].group == own.group; --k) add(work.dents[k]);
  for (int k = contact.dent + 1; k < static_cast<int>(work.dents.size()) && work.dents[k].group == own.group; ++k) add(work.dents[k]);
  return speed;
}

void buildDents(Stepper::Work& work, const State& state) {
  work.dents.clear();
  if (work.inside->dents.empty()) return;
  const StageClock clock(work.report, Stage::Dent);
  const double dt = work.settings.dt, fastest = work.recoverySpeedMax;
  const std::size_t found = work.contacts.size();
  for (std::size_t c = 0; c < found; ++c) {
    const StepContact& contact = work.contacts[c];
    const bool softA = work.model->objects[contact.objectB].tool;
    const int soft = softA ? contact.objectA : contact.objectB, tool = softA ? contact.objectB : contact.objectA;
    if (!work.model->objects[tool].tool || work.inside->dents[soft].at_W.empty() || work.sides[c][0] + work.sides[c][1] == -2) continue;
    const FeaturePoint& feature = softA ? contact.near->a : contact.near->b;
    const Softness softness = softnessAt(work.inside->dents[soft], along(feature, work.model->objects[soft].collision.mesh->vertices));
    const double gap = contact.near->gap;
    // The hard bottom of the dent: the same row, so much lower. It is there at any gap, for a tip may come fast.
    StepContact bed = contact;
    bed.bed = true;
    bed.impulse = 0;
    bed.friction_W.setZero();
    bed.target = std::min(-(gap + softness.depthMost) / dt, fastest);
    work.contacts.push_back(bed);
    work.sides.push_back(work.sides[c]);
    appendContactRow(work, state, static_cast<int>(work.contacts.size()) - 1, bed.near->normal_W, &IslandWork::rows);
    StepContact& dented = work.contacts[c];
    // As deep as the tool can press at all nothing has to be undone; beyond that as for any contact.
    const double forceMost = work.model->scenario.tools[work.model->objects[tool].toolIndex].forceMax;
    dented.target = std::min(-gap / dt, fastest + softness.compliance * forceMost / dt);
    dented.compliance = softness.compliance / (dt * dt);
    dented.dent = static_cast<int>(work.dents.size());
    work.dents.push_back({static_cast<int>(c), dented.near->pair, std::sqrt(softness.compliance), work.inside->dents[soft].radius,
                          along(feature, work.positions[soft])});
  }
}

void showDents(Stepper::Work& work) {
  work.report.dents.clear();
  for (const DentContact& each : work.dents) {
    const StepContact& contact = work.contacts[each.contact];
    if (!(contact.impulse > 0)) continue;
    const double depth = dentSpeed(work, contact) * work.settings.dt;
    if (!(depth > 0)) continue;
    const bool softA = work.model->objects[contact.objectB].tool;
    const int soft = softA ? contact.objectA : contact.objectB, tool = softA ? contact.objectB : contact.objectA;
    const Vec3 outwards = softA ? Vec3(-contact.near->normal_W) : contact.near->normal_W;
    std::vector<DentView>& dents = work.report.dents;
    if (dents.empty() || dents.back().object != soft || dents.back().tool != tool)
      dents.push_back({soft, tool, each.point_W, outwards, depth, kSharing * each.radius});
    else if (depth > dents.back().depth)
      dents.back() = {soft, tool, each.point_W, outwards, depth, kSharing * each.radius};
  }
}

}  // namespace glenoid
