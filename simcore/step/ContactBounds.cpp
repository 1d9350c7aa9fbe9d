// SPDX-License-Identifier: GPL-3.0-or-later
// What gives way where a contact problem has too many rows for the bound on a step: of each pair of surfaces the deepest stay.
#include <algorithm>

#include "simcore/step/StepWork.h"

namespace glenoid {

void keepDeepest(Stepper::Work& work, const ContactIsland& island, int rowsMost) {
  struct Place {
    int pair, contact, rank;
    double gap;
  };
  std::vector<Place> places;
  for (const int c : island.contacts)
    if (const StepContact& contact = work.contacts[c]; contact.chosen) places.push_back({contact.near->pair, c, 0, contact.near->gap});
  const auto deeper = [](const Place& i, const Place& j) { return i.gap != j.gap ? i.gap < j.gap : i.contact < j.contact; };
  std::sort(places.begin(), places.end(), [&](const Place& i, const Place& j) { return i.pair != j.pair ? i.pair < j.pair : deeper(i, j); });
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i].pair == places[i - 1].pair) places[i].rank = places[i - 1].rank + 1;
  std::sort(places.begin(), places.end(), [&](const Place& i, const Place& j) { return i.rank != j.rank ? i.rank < j.rank : deeper(i, j); });
  int rows = 0;
  for (const Place& place : places) {
    StepContact& contact = work.contacts[place.contact];
    rows += contact.coefficient > 0 ? 3 : 1;
    if (rows <= rowsMost) continue;
    contact.chosen = false;
    contact.leftOut = true;
    contact.impulse = 0;
    contact.friction_W.setZero();
    ++work.report.bounded.rows;
  }
}

}  // namespace glenoid
