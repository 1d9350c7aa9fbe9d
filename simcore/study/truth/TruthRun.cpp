// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/TruthRun.h"

#include <cmath>

#include "simcore/embed/Bind.h"

namespace glenoid::truth {

Result<std::unique_ptr<TruthRun>> TruthRun::make(const TruthScene& scene, const TruthSetup& setup) {
  TruthScene own = scene;
  own.scenario.profile = setup.profile;
  own.scenario.elements = setup.elements;
  auto model = compileModel(own.joint, own.scenario);
  if (!model) return model.error();
  auto run = std::make_unique<TruthRun>();
  run->m_model = *model;
  run->state = run->m_model->start;
  StepperOptions options;
  options.profile = setup.profile;
  run->m_stepper = std::make_unique<Stepper>(run->m_model, options);
  return run;
}

bool TruthRun::step() {
  report = m_stepper->step({}, state);
  return report.taken;
}

bool TruthRun::run(double seconds) {
  const long steps = std::lround(seconds / m_model->scenario.dt);
  for (long i = 0; i < steps; ++i)
    if (!step()) return false;
  return true;
}

bool TruthRun::settle(double speed, int steps) {
  for (int i = 0; i < steps; ++i) {
    if (!step()) return false;
    if (state.v.lpNorm<Eigen::Infinity>() < speed) return true;
  }
  return false;
}

Vec3 TruthRun::placeOf(int object, const Vec3& rest) const {
  const SceneObject& part = m_model->objects[static_cast<std::size_t>(object)];
  const VertexBinding at = bindToTets(*part.volume, std::span(&rest, 1))[0];
  Vec3 place = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    place += at.weight[k] * state.q.segment<3>(part.layout.qOffset + 3 * at.node[k]);
  return place;
}

Error notAtRest() {
  return {Fault::Unusable, {}, {std::string("problem: it does not come to rest")}, "truth"};
}

}  // namespace glenoid::truth
