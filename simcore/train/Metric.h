// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string>

namespace glenoid {

/// A measured figure of a training run. The name is that of its kind, of a tool or of a limit before it with a dot:
/// "errors", "probe.path", "cartilage.forceMax".
struct Metric {
  std::string name;
  std::optional<double> value;  ///< SI; nothing where there was nothing to measure
};

/// What a kind of metric means. README.md has the definitions in full.
struct MetricKind {
  const char* word;      ///< last part of the name
  const char* unit;      ///< SI; "1": a number
  const char* formula;   ///< as people read it, in symbols
  /// Who found that it tells skilled from unskilled people, at what task and with whom; empty: nobody whom we know of did for this
  /// program, so it is shown as experimental.
  const char* evidence;
};

/// Every kind, in the order in which reports show them.
std::span<const MetricKind> metricKinds();

/// By the last part of a name; null for one that does not exist.
const MetricKind* metricKind(const std::string& name);

}  // namespace glenoid
