// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/step/Stepper.h"
#include "simcore/study/truth/TruthProblem.h"

namespace glenoid::truth {

/// A scene of a problem at work: whole steps of the profile that is asked for.
class TruthRun {
 public:
  /// Fails as compileModel does.
  static Result<std::unique_ptr<TruthRun>> make(const TruthScene& scene, const TruthSetup& setup);

  /// False where a step was not finite and not taken.
  bool step();
  bool run(double seconds);
  /// Until no coordinate is faster than this, m/s, at most so many steps. False where it does not come to
  /// rest.
  bool settle(double speed, int steps);

  const ObjectLayout& layoutOf(int object) const {
    return m_model->objects[static_cast<std::size_t>(object)].layout;
  }
  const Model& model() const { return *m_model; }
  /// Where a material point of a soft object is that rested at x, m.
  Vec3 placeOf(int object, const Vec3& rest) const;

  State state;
  StepReport report;

 private:
  std::shared_ptr<const Model> m_model;
  std::unique_ptr<Stepper> m_stepper;
};

Error notAtRest();

}  // namespace glenoid::truth
