// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/TimeUp.h"

#include <algorithm>
#include <map>

namespace glenoid {

Notice timeUp(const Model& model, const StepReport& step, const State& state, double limit) {
  std::map<std::pair<int, int>, int> rows;
  for (const ContactView& contact : step.contactViews) ++rows[std::minmax(contact.objectA, contact.objectB)];
  const auto most = std::max_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  Notice notice{NoticeKind::TimeUp, "", "", static_cast<double>(step.contacts), limit, state.time, state.step, {}};
  if (most != rows.end()) {
    notice.subject = model.objects[static_cast<std::size_t>(most->first.first)].id;
    notice.other = model.objects[static_cast<std::size_t>(most->first.second)].id;
  }
  return notice;
}

}  // namespace glenoid
