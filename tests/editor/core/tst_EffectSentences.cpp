// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "editor/core/EffectSentences.h"

namespace glenoid {
namespace {

std::string said(const EffectFacts& facts) {
  return effectSentence(facts).toStdString();
}

TEST(EffectSentences, sayWhatTheyFoundWithItsFigures) {
  EXPECT_EQ(said({"friction", true, "auto-present", {{"materials", 3}, {"tools", 1}}}),
            "on, because a friction coefficient is given to 3 materials and one tool");
  EXPECT_EQ(said({"friction", true, "asked-on", {{"materials", 0}, {"tools", 2}}}),
            "on, because the scenario asks for it and a friction coefficient is given to 2 tools");
  EXPECT_EQ(said({"contact", true, "auto-present", {{"pairs", 23}}}),
            "on, because 23 pairs of parts and tools can touch");
  EXPECT_EQ(said({"gravity", true, "auto-present", {{"movingParts", 1}, {"acceleration", 9.81}}}),
            "on, because one part can move and gravity is 9.81 m/s²");
}

TEST(EffectSentences, sayWhatIsMissing) {
  EXPECT_EQ(said({"friction", false, "nothing-to-act-on", {{"materials", 0}, {"tools", 0}}}),
            "off, because no material and no tool has a friction coefficient");
  EXPECT_EQ(said({"friction", false, "nothing-to-act-on", {{"materials", 1}, {"tools", 0}}}),
            "off, because of no two surfaces that can touch have both a friction coefficient");
  EXPECT_EQ(said({"selfContact", false, "nothing-to-act-on", {{"parts", 0}, {"softParts", 4}}}),
            "off, because the scenario names no part that may fold onto itself");
  EXPECT_EQ(said({"dent", false, "no-contact", {}}), "off, because contact is off");
}

TEST(EffectSentences, everyEffectHasSentencesOfItsOwnBothWays) {
  std::set<std::string> on, off;
  const char* const names[] = {"gravity",  "couplings", "contact", "selfContact",
                               "friction", "damping",   "bursa",   "dent"};
  for (const char* name : names) {
    EffectFacts facts{name, true, "auto-present", {}};
    for (const char* what : {"movingParts", "acceleration", "couplings", "springs", "pairs", "parts",
                             "materials", "tools", "bursae"})
      facts.counts.push_back({what, 2});
    on.insert(said(facts));
    off.insert(said({name, false, "nothing-to-act-on", {}}));
    EXPECT_EQ(said({name, false, "asked-off", {}}), "off, because the scenario switches it off");
  }
  EXPECT_EQ(on.size(), std::size(names));
  EXPECT_EQ(off.size(), std::size(names));
}

}  // namespace
}  // namespace glenoid
