// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RunReport.h"

namespace glenoid {

std::vector<std::string> paperDepartures(const Model& model) {
  std::vector<std::string> words;
  if (!model.springs.empty()) words.push_back("couplings-at-integration-points");
  return words;
}

}  // namespace glenoid
