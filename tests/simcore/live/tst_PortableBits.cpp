// SPDX-License-Identifier: GPL-3.0-or-later
// A portable recording ends in the same bits on any x86-64. Another processor is played by the C library: told that some
// instructions are missing, it takes other code for its elementary functions. It is told before a program starts, so the
// test starts itself again.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "simcore/live/Run.h"
#include "tests/simcore/study/ShippedScene.h"

namespace glenoid {
namespace {

constexpr int kSteps = 600;  ///< 3 s: hands turn from the first second on, the first press begins at 2.45 s

/// What a run of this program prints: the last state's hash, and a hash of what the C library says of many sines.
struct Printed {
  std::string state, sines;
};

Printed printedBy(const std::string& environment) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = environment + " '" + self + "' --gtest_also_run_disabled_tests --gtest_filter='PortableBits.DISABLED_print*'";
  Printed printed;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return printed;
  std::string text;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  pclose(pipe);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word == "state:") words >> printed.state;
    if (word == "sines:") words >> printed.sines;
  }
  return printed;
}

TEST(PortableBits, DISABLED_printsTheHashOfAState) {
  const StudyScene scene = test::shippedScene();
  RunOptions options;
  options.steps = kSteps;
  options.stepper.portable = true;
  options.input = &scene.input;
  options.checks = false;
  const auto run = runScenario(compileModel(scene.joint, scene.scenario).value(), options);
  ASSERT_TRUE(run.ok());
  std::vector<double> sines;
  for (int i = 0; i < 100000; ++i) {
    const volatile double x = 1e-4 * i;  // or the compiler works them out
    sines.push_back(std::sin(x));
    sines.push_back(std::exp(-x));
    sines.push_back(std::atan2(x, 1.0));
  }
  std::printf("state: %s\nsines: %s\n", run->report.stateHash.c_str(),
              toHex(hashBytes(sines.data(), sizeof(double) * sines.size(), 0)).c_str());
}

TEST(PortableBits, aRecordingDoesNotDependOnTheProcessorsInstructions) {
  const Printed here = printedBy("GLIBC_TUNABLES="),
                older = printedBy("GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX512F,-AVX512VL");
  ASSERT_EQ(here.state.size(), 32u);
  EXPECT_EQ(here.state, older.state);
  if (here.sines == older.sines) std::printf("this processor has no fused multiply-add, or this C library no use for it\n");
}

}  // namespace
}  // namespace glenoid
