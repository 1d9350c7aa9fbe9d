// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace glenoid {

/// A logarithmic axis from one value to another, both above zero, onto pixels.
class PlotAxis {
 public:
  /// Widened by a little on both sides, and to a decade at least. Values that have no place (not finite, not above zero) do not count;
  /// with none at all it goes from 0.1 to 10.
  PlotAxis(const std::vector<double>& values, double pixelFrom, double pixelTo);

  static bool hasPlace(double value);
  double at(double value) const;  ///< value must have a place; may lie outside
  double from() const { return m_from; }
  double to() const { return m_to; }

  struct Tick {
    double value;
    bool major;         ///< a power of ten
    std::string label;  ///< of major ticks, and where a decade has room for them of 2 and 5 as well
  };
  std::vector<Tick> ticks() const;

 private:
  double m_from, m_to, m_pixelFrom, m_pixelTo;
};

/// "0.02", "5", "10⁻⁵": as an axis names it.
std::string axisNumber(double value);

}  // namespace glenoid
