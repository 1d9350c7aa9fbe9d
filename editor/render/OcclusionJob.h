// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "editor/render/Occlusion.h"

namespace glenoid {

/// Casts a scene's occlusion beside the thread that draws. Starting another scene, or the end of the job, stops the
/// one that runs. For one thread only.
class OcclusionJob {
 public:
  OcclusionJob() = default;
  ~OcclusionJob() { stop(); }
  OcclusionJob(const OcclusionJob&) = delete;
  OcclusionJob& operator=(const OcclusionJob&) = delete;

  void start(const SceneGeometry& scene, const VecX& q);
  bool running() const { return m_worker.joinable(); }
  /// The answer, once, when it is there; with `wait` it is there afterwards if anything was started.
  std::shared_ptr<const Occlusion> take(bool wait);

 private:
  void stop();

  std::thread m_worker;
  std::atomic<bool> m_cancelled{false}, m_done{false};
  std::shared_ptr<const Occlusion> m_answer;  ///< the worker's until m_done
};

}  // namespace glenoid
