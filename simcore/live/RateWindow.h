// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>

namespace glenoid {

/// Steps per second and time per step over about the last half second (at most 256 steps). Times in seconds
/// of a steady clock. Allocates nothing.
class RateWindow {
 public:
  static constexpr double kLength = 0.5;  ///< s

  void restart(double now) {
    m_begin = now;
    m_count = 0;
  }

  void add(double end, double duration) {
    m_entries[m_next] = {end, duration};
    m_next = (m_next + 1) % m_entries.size();
    if (m_count < m_entries.size()) ++m_count;
    while (m_count > 2 && entry(0).end < end - kLength) {
      m_begin = entry(0).end;
      --m_count;
    }
    if (m_count == m_entries.size()) m_begin = entry(0).end - entry(0).duration;
  }

  double stepsPerSecond() const {
    if (m_count == 0) return 0;
    const double span = entry(m_count - 1).end - m_begin;
    return span > 0 ? static_cast<double>(m_count) / span : 0;
  }

  double secondsPerStep() const {
    double sum = 0;
    for (std::size_t i = 0; i < m_count; ++i) sum += entry(i).duration;
    return m_count > 0 ? sum / static_cast<double>(m_count) : 0;
  }

 private:
  struct Entry {
    double end = 0, duration = 0;
  };
  const Entry& entry(std::size_t i) const {  // 0: oldest
    return m_entries[(m_next + m_entries.size() - m_count + i) % m_entries.size()];
  }

  std::array<Entry, 256> m_entries{};
  std::size_t m_next = 0, m_count = 0;
  double m_begin = 0;  // when the oldest entry began to count
};

}  // namespace glenoid
