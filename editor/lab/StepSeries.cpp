// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StepSeries.h"

#include <cmath>

#include "simcore/live/RunReport.h"

namespace glenoid {
namespace {

StepSeries::Figures figuresOf(std::vector<float> values) {
  if (values.empty()) return {std::nan(""), std::nan("")};
  const Timing timing = timingOf(values);
  return {timing.median, timing.p95};
}

}  // namespace

void StepSeries::closeBucket() {
  const Figures figures = figuresOf(m_bucket);
  m_moments.push_back({m_bucketEnd - 0.5 * kBucket, figures.p50, figures.p95});
  m_bucket.clear();
  m_bucketEnd += kBucket;
  while (!m_moments.empty() && m_moments.back().at - m_moments.front().at > kKept) m_moments.pop_front();
}

void StepSeries::add(double now, const StepMeter::Reading& reading) {
  if (m_bucketEnd < 0 || now > m_bucketEnd + kKept) {
    m_bucketEnd = now + kBucket;
    m_bucket.clear();
  }
  while (now >= m_bucketEnd) closeBucket();
  for (const StepMeter::Step& step : reading.steps) {
    m_bucket.push_back(step.cpuMs);
    m_recent.push_back({now, step});
  }
  while (!m_recent.empty() && m_recent.front().at < now - kRecent) m_recent.pop_front();
}

void StepSeries::clear() {
  m_moments.clear();
  m_recent.clear();
  m_bucket.clear();
  m_bucketEnd = -1;
}

StepSeries::Figures StepSeries::step() const {
  std::vector<float> values;
  for (const Recent& recent : m_recent) values.push_back(recent.step.cpuMs);
  return figuresOf(std::move(values));
}

StepSeries::Figures StepSeries::stages(const std::vector<Stage>& stages) const {
  std::vector<float> values;
  for (const Recent& recent : m_recent) {
    float sum = 0;
    for (const Stage stage : stages) sum += recent.step.stages[static_cast<std::size_t>(stage)];
    values.push_back(sum);
  }
  return figuresOf(std::move(values));
}

}  // namespace glenoid
