// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "editor/core/Sentences.h"

namespace glenoid {
namespace {

std::string text(const Error& error) { return sentenceOf(error).toStdString(); }

TEST(Sentences, everyFaultHasItsOwnSentence) {
  std::set<std::string> seen;
  for (int i = 0; i < kFaultCount; ++i) {
    const Error error{static_cast<Fault>(i), {}, {"one", "two", "three"}, ""};
    const std::string sentence = text(error);
    EXPECT_GT(sentence.size(), 20u) << faultName(error.fault);
    EXPECT_EQ(sentence.back(), '.') << faultName(error.fault);
    EXPECT_EQ(sentence.find('%'), std::string::npos) << sentence;
    EXPECT_TRUE(seen.insert(sentence).second) << "the same words for two faults: " << sentence;
  }
}

TEST(Sentences, missingArgumentsNeverShowPlaceholders) {
  for (int i = 0; i < kFaultCount; ++i) {
    EXPECT_EQ(text({static_cast<Fault>(i), {}, {}, ""}).find('%'), std::string::npos);
  }
}

TEST(Sentences, sayWhereAndWithWhichNumbers) {
  Error error{Fault::OutOfRange, {"a.json", "/parts/3", "humerus", 7}, {"9", "0", "1"}, ""};
  const std::string sentence = text(error);
  for (const char* word : {"a.json", "/parts/3", "humerus", "7", "9", "0", "1"}) {
    EXPECT_NE(sentence.find(word), std::string::npos) << word << " is not in: " << sentence;
  }
}

TEST(Sentences, aPercentSignInAnArgumentStaysWhatItIs) {
  const std::string sentence = text({Fault::UnknownId, {}, {"%2", "a part"}, ""});
  EXPECT_NE(sentence.find("“%2”"), std::string::npos) << sentence;
}

TEST(Sentences, theLogOfAnErrorIsNotShown) {
  EXPECT_EQ(text({Fault::Internal, {}, {}, "assertion in step 3"}).find("assertion"), std::string::npos);
}

TEST(Sentences, everyWordOfAnEffectPlanIsExplained) {
  for (const char* word : {"asked-on", "asked-off", "nothing-to-act-on", "auto-present", "not-built"}) {
    EXPECT_NE(effectReason(word), QString(word));
  }
  for (const char* word : {"gravity", "couplings", "contact", "selfContact", "friction", "damping", "bursa", "haptics"}) {
    EXPECT_NE(effectName(word), QString(word));
  }
}

}  // namespace
}  // namespace glenoid
