// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/OcclusionJob.h"

#include <algorithm>

namespace glenoid {

void OcclusionJob::start(const SceneGeometry& scene, const VecX& q) {
  stop();
  m_cancelled = m_done = false;
  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  m_worker = std::thread([this, threads, copy = std::make_shared<const SceneGeometry>(scene), q] {
    m_answer = std::make_shared<const Occlusion>(*copy, q, threads, m_cancelled);
    m_done = true;
  });
}

std::shared_ptr<const Occlusion> OcclusionJob::take(bool wait) {
  if (!m_worker.joinable() || (!wait && !m_done)) return nullptr;
  m_worker.join();
  return std::move(m_answer);
}

void OcclusionJob::stop() {
  m_cancelled = true;
  if (m_worker.joinable()) m_worker.join();
  m_answer.reset();
}

}  // namespace glenoid
