// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing on the way from a scenario's files to a state may call a function of the C library whose last digit depends on
// the processor or on the library's version: a recording would end in other bits elsewhere. The libraries themselves are
// read, so that what comes in through a header of Eigen counts as well.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace glenoid::layers {
namespace {

/// Functions that IEEE 754 or the C standard rounds exactly: sqrt, fma, floor, frexp … are not among these.
const std::regex& inexact() {
  static const std::regex pattern(
      "(sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|"
      "pow|cbrt|hypot|erf|erfc|tgamma|lgamma)(f|l)?(_finite)?");
  return pattern;
}

/// By object file: what it calls, and why no state depends on it. Those files are compiled alone (glenoid_alone); where a call comes
/// out of several that are compiled together, a build with -DGLENOID_UNITY=OFF tells which.
const std::map<std::string, std::string>& allowed() {
  static const std::map<std::string, std::string> list = {
      {"TetTools.cpp.o cbrt", "a figure of a mesh's quality, for people"},
      {"ChooseCells.cpp.o cbrt", "an author's choice of cells; the tetrahedra stand in the joint's file"},
      {"FingerShape.cpp.o cos", "the finger as it is drawn; it touches and weighs by ToolShape"},
      {"FingerShape.cpp.o sincos", "likewise"},
      {"FingerShape.cpp.o sin", "likewise"},
      {"FingerShape.cpp.o exp", "likewise"},
      {"FingerShape.cpp.o cbrt", "likewise"},
      {"FingerShape.cpp.o atan2", "likewise"},
  };
  return list;
}

std::string outputOf(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return text;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  pclose(pipe);
  return text;
}

/// "Object.cpp.o function" for each such call in what `nm -u -A` prints.
std::set<std::string> callsIn(const std::string& listing) {
  static const std::regex line("^[^ ]*[/:]([^:/ ]+\\.o): +U ([A-Za-z0-9_]+)(@.*)?$");
  std::set<std::string> calls;
  std::istringstream lines(listing);
  std::string text;
  while (std::getline(lines, text)) {
    std::smatch match;
    if (std::regex_match(text, match, line) && std::regex_match(match[2].str(), inexact()))
      calls.insert(match[1].str() + " " + match[2].str());
  }
  return calls;
}

std::string listing() {
  std::string text;
  std::istringstream archives(GLENOID_STATE_ARCHIVES);
  std::string archive;
  while (std::getline(archives, archive, '|')) text += outputOf("'" GLENOID_NM "' -u -A '" + archive + "' 2>/dev/null");
  return text;
}

TEST(PlainArithmetic, theLibrariesAreRead) {
  // What is known to be there: the rotations of elements take roots or allocate, the step reads the clock.
  const std::string text = listing();
  std::istringstream archives(GLENOID_STATE_ARCHIVES);
  std::string archive;
  int count = 0;
  for (; std::getline(archives, archive, '|'); ++count) EXPECT_NE(text.find(archive + ":"), std::string::npos) << archive;
  EXPECT_GT(count, 10);
  EXPECT_NE(text.find("clock_gettime"), std::string::npos);
  EXPECT_NE(text.find("TetTools.cpp.o"), std::string::npos);
}

TEST(PlainArithmetic, noStateDependsOnAFunctionThatIsRoundedByTheProcessor) {
  for (const std::string& call : callsIn(listing()))
    EXPECT_TRUE(allowed().count(call)) << call << ": simcore/base/PlainMath has it in plain arithmetic";
}

TEST(PlainArithmetic, whatIsAllowedIsStillCalled) {
  const std::set<std::string> calls = callsIn(listing());
  for (const auto& [call, reason] : allowed())
    if (call != "FingerShape.cpp.o sin") EXPECT_TRUE(calls.count(call)) << call << " can be struck from the list: " << reason;
}

TEST(PlainArithmeticRules, callsAreFoundAndExactOnesAreNot) {
  EXPECT_EQ(callsIn("lib/libx.a:A.cpp.o:                 U sin\nlib/libx.a:A.cpp.o:                 U sqrt\n"
                    "lib/libx.a:B.cpp.o:                 U _ZN3sinEv\nlib/libx.a:B.cpp.o:                 U atan2@GLIBC_2.2\n"
                    "lib/libx.a:B.cpp.o:                 U fma\nlib/libx.a:C.cpp.o:                 U powf\n"),
            (std::set<std::string>{"A.cpp.o sin", "B.cpp.o atan2", "C.cpp.o powf"}));
}

}  // namespace
}  // namespace glenoid::layers
