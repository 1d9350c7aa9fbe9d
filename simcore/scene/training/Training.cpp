// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/training/Training.h"

#include <algorithm>

namespace glenoid {

std::vector<FormRow> defaultForm() { return {{"tasks", 80, 1, 0}, {"errors", 20, 0, 5}}; }

void dropFromTraining(Training& training, const std::string& part, const std::string& region) {
  const auto gone = [&](const TaskPlace& place) {
    return place.part == part && (region.empty() || place.region == region);
  };
  std::erase_if(training.tasks, [&](Task& task) {
    std::erase_if(task.places, gone);
    return task.places.size() < (task.kind == TaskKind::Trace ? 2u : 1u);
  });
  std::erase_if(training.limits, [&](const ForceLimit& limit) {
    return limit.part == part && (region.empty() || limit.region == region);
  });
}

}  // namespace glenoid
