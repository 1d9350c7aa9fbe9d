// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>

namespace glenoid {

/// How late the ticks of a loop began: counts by the microsecond up to 20 ms, the rest together. Percentiles are by nearest
/// rank, rounded up to the microsecond. A value of 80 kB; allocates nothing.
class TickTimes {
 public:
  void add(std::int64_t latenessNs) {
    const auto at = static_cast<std::size_t>(latenessNs < 0 ? 0 : (latenessNs + 999) / 1000);
    ++m_counts[at < kBins ? at : kBins];
    if (latenessNs > m_worstNs) m_worstNs = latenessNs;
    ++m_total;
  }
  /// µs; 0 without ticks; the worst where the rank lies beyond 20 ms.
  double percentileUs(double share) const {
    const double wanted = share * static_cast<double>(m_total);
    double seen = 0;
    for (std::size_t i = 0; i < kBins; ++i)
      if (seen += m_counts[i]; m_counts[i] > 0 && seen >= wanted) return static_cast<double>(i);
    return worstUs();
  }
  double worstUs() const { return 1e-3 * static_cast<double>(m_worstNs); }
  long total() const { return m_total; }

 private:
  static constexpr std::size_t kBins = 20'000;
  std::array<std::uint32_t, kBins + 1> m_counts{};
  std::int64_t m_worstNs = 0;
  long m_total = 0;
};

}  // namespace glenoid
