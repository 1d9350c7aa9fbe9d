// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/Scenario.h"

namespace glenoid {

int findTool(const Scenario& scenario, const std::string& id) {
  for (std::size_t i = 0; i < scenario.tools.size(); ++i)
    if (scenario.tools[i].id == id) return static_cast<int>(i);
  return -1;
}

}  // namespace glenoid
