// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/Metric.h"

#include <array>

namespace glenoid {
namespace {

// All of them are experimental here: what is published about path, jerk or force was found with other simulators and tasks
// (Metric.h), and no study with this program exists.
constexpr std::array<MetricKind, 17> kKinds{{
    {"tasks", "1", "Σ wᵢ sᵢ / Σ wᵢ, score sᵢ and weight wᵢ of each task", ""},
    {"errors", "1", "errors of tasks + of limits + of order", ""},
    {"order", "1", "pairs of tasks done the other way round than listed", ""},
    {"time", "s", "t(last task ended) − t(first task opened)", ""},
    {"path", "m", "Σ ‖xᵢ₊₁ − xᵢ‖ of the tip, every step", ""},
    {"economy", "1", "Σ ‖straight way from task to task‖ / path", ""},
    {"jerk", "1", "ln(∫ ‖d³x/dt³‖² dt · T⁵ / L²), x through a Gaussian of 10 Hz, L its path, T its time", ""},
    {"speed", "m/s", "path / time", ""},
    {"forceMax", "N", "max ‖F‖ of all contacts in a step", ""},
    {"forceMean", "N", "∫ ‖F‖ dt / time with ‖F‖ > 0.1 N", ""},
    {"touchSeconds", "s", "time with ‖F‖ > 0.1 N", ""},
    {"tooHardSeconds", "s", "time with ‖F‖ above the limit", ""},
    {"tooHard", "1", "times that ‖F‖ passed the limit, after 0.1 s below it", ""},
    {"steadiness", "rad/s", "√(mean of ‖d axis/dt‖²) of the view", ""},
    {"inView", "1", "time with the sought place in sight / time of the tasks to look", ""},
    {"distance", "m", "mean distance of what was found from the place sought", ""},
    {"depth", "m", "mean depth of places found behind what was pressed, along the push", ""},
}};

}  // namespace

std::span<const MetricKind> metricKinds() { return kKinds; }

const MetricKind* metricKind(const std::string& name) {
  const std::string word = name.substr(name.rfind('.') + 1);  // npos + 1 is 0
  for (const MetricKind& kind : kKinds)
    if (word == kind.word) return &kind;
  return nullptr;
}

}  // namespace glenoid
