// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdlib>

#include "simcore/study/truth/BrickProblem.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid::truth {

/// Leaves a test out, saying so, where the program is not installed. tests/run.sh installs it, so in
/// continuous integration (CI is set) its absence is a failure.
#define NEEDS_CALCULIX()                                                                           \
  if (!hasCalculix()) {                                                                            \
    ASSERT_EQ(std::getenv("CI"), nullptr) << "CalculiX (calculix-ccx) should have been installed"; \
    GTEST_SKIP() << "CalculiX (calculix-ccx) is not installed";                                    \
  }

inline std::optional<Mat3> stressByCalculix(const BrickProblem& problem, double s, double t, double z) {
  const TemporaryFolder folder;
  return stressByCalculix(problem, s, t, z, folder.path(), "body");
}
inline std::optional<std::vector<double>> frequenciesByCalculix(const BrickProblem& problem, double density,
                                                                int count) {
  const TemporaryFolder folder;
  return frequenciesByCalculix(problem, density, count, folder.path(), "body");
}

}  // namespace glenoid::truth
