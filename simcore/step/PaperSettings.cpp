// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/PaperSettings.h"

namespace glenoid {

namespace {
struct Row {
  const char* word;
  bool PaperSettings::* setting;
};
constexpr Row kRows[] = {{"tension", &PaperSettings::tension},
                         {"recovery-cap", &PaperSettings::recoveryCap},
                         {"parts", &PaperSettings::parts},
                         {"search-again", &PaperSettings::searchAgain},
                         {"stretch-law", &PaperSettings::stretchLaw}};
}  // namespace

bool* paperSetting(PaperSettings& settings, const std::string& word) {
  for (const Row& row : kRows)
    if (word == row.word) return &(settings.*row.setting);
  return nullptr;
}

std::vector<std::string> paperDepartures(const PaperSettings& settings, bool regions) {
  std::vector<std::string> departures;
  for (const Row& row : kRows)
    if (settings.*row.setting) departures.push_back(row.word);
  for (const char* always : {"explicit-b", "geometric-left-out"}) departures.push_back(always);
  if (regions) departures.push_back("springs-in-regions");
  return departures;
}

}  // namespace glenoid
