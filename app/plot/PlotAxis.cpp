// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plot/PlotAxis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace glenoid {

PlotAxis::PlotAxis(const std::vector<double>& values, double pixelFrom, double pixelTo) : m_from(HUGE_VAL), m_to(0), m_pixelFrom(pixelFrom), m_pixelTo(pixelTo) {
  for (const double value : values) {
    if (!hasPlace(value)) continue;
    m_from = std::min(m_from, value);
    m_to = std::max(m_to, value);
  }
  if (m_to == 0) m_from = 0.1, m_to = 10;
  const double decades = std::log10(m_to / m_from), more = std::max(0.08 * decades, 0.5 * (1 - decades));
  m_from /= std::pow(10, more);
  m_to *= std::pow(10, more);
}

bool PlotAxis::hasPlace(double value) { return std::isfinite(value) && value > 0; }

double PlotAxis::at(double value) const { return m_pixelFrom + (m_pixelTo - m_pixelFrom) * std::log(value / m_from) / std::log(m_to / m_from); }

std::vector<PlotAxis::Tick> PlotAxis::ticks() const {
  const bool wide = std::abs(m_pixelTo - m_pixelFrom) / std::log10(m_to / m_from) > 110;  // room for 2 and 5 in each decade
  std::vector<Tick> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(m_from))); power <= static_cast<int>(std::ceil(std::log10(m_to))); ++power)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (value < m_from || value > m_to) continue;
      const bool named = digit == 1 || (wide && (digit == 2 || digit == 5));
      ticks.push_back({value, digit == 1, named ? axisNumber(value) : std::string()});
    }
  return ticks;
}

std::string axisNumber(double value) {
  char text[64];
  if (value >= 0.99e-3 && value < 1e5) {
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
  }
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const int digit = static_cast<int>(std::lround(value / std::pow(10.0, power)));
  std::string out = digit == 1 ? "10" : std::to_string(digit) + "·10";
  if (power < 0) out += "⁻";
  for (const char c : std::to_string(std::abs(power))) out += digits[c - '0'];
  return out;
}

}  // namespace glenoid
