// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/study/StabilityCases.h"
#include "simcore/study/StabilityRun.h"
#include "simcore/study/StabilityScene.h"

namespace glenoid {

/// One case, for one of what it is run for, at one Δt.
struct StabilityTrial {
  const StabilityCase* what = nullptr;
  std::string subject;   ///< "probe-humerus", "humerus+x", "labrum", "2"; empty for the scene
  double dt = 0;         ///< s
  int index = 0;         ///< touch, object or seed
  Vec3 direction = Vec3::Zero();
  std::string id() const;  ///< "press.probe-humerus.5ms": the name of its files, and of what a recording replays
};

/// A scene at rest under one profile, and all that the gauntlet does to it. Any number of threads may ask.
class StabilityStage {
 public:
  /// Fails as compiling does.
  static Result<std::unique_ptr<StabilityStage>> make(StabilityScene scene, Profile profile);

  /// All trials in the order of the table, those of the scene's own Δt first; of the short form those that are quick.
  std::vector<StabilityTrial> trials(bool quick) const;
  /// The run of a trial. Fails as compiling does.
  Result<StabilityRun> runOf(const StabilityTrial& trial);
  /// Whether the matter of a trial can carry itself and its loads (carriedShare).
  CarriedShare carried(const StabilityTrial& trial) const;

  const Model& model() const { return *m_model; }
  const StabilityScene& scene() const { return m_scene; }
  Profile profile() const { return m_profile; }
  bool comesToRest() const { return m_rests; }  ///< left alone, at its own Δt

 private:
  StabilityStage() = default;
  StabilityScene varied(const StabilityTrial& trial) const;
  Result<std::shared_ptr<const Model>> compiled(const StabilityScene& scene) const;
  /// The state in which the scene has come to rest, or after three seconds.
  Result<State> restAt(double dt);

  StabilityScene m_scene;
  Profile m_profile = Profile::Direct;
  std::shared_ptr<const Model> m_model;
  std::vector<Touch> m_touches;
  std::vector<int> m_bones, m_soft;  ///< objects
  bool m_rests = false;
  std::mutex m_mutex;
  struct Rest {
    std::once_flag once;
    State state;
    std::optional<Error> error;
  };
  std::map<double, std::unique_ptr<Rest>> m_rest;
};

}  // namespace glenoid
