// SPDX-License-Identifier: GPL-3.0-or-later
/// `glenoid_peers [--json] [--stiffness NAME]… [--dt S]… [--seconds T] [--limit T] [--without-bullet]`: runs the scene
/// of the peers in ours and, where it was built, in Bullet, which runs in its own process; one row each. Without a
/// choice: all stiffnesses at 1, 5 and 20 ms. `--limit`: computing time given to each Bullet run, s.
/// Exit status 0 done, 1 failed, 2 usage.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "simcore/file/Json.h"
#include "simcore/study/PeerProgram.h"

namespace {

using namespace glenoid;
using namespace glenoid::peers;

struct Choice {
  std::vector<Stiffness> stiffnesses;
  std::vector<double> dts;
  double seconds = kSeconds, limit = 20;
  bool json = false, bullet = true;
};

bool parse(int argc, char** argv, Choice& choice) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--json") {
      choice.json = true;
    } else if (word == "--without-bullet") {
      choice.bullet = false;
    } else if (i + 1 == argc) {
      return false;
    } else if (word == "--stiffness") {
      const std::string name = argv[++i];
      bool known = false;
      for (const Stiffness stiffness : kStiffnesses)
        if (name == stiffnessName(stiffness)) {
          choice.stiffnesses.push_back(stiffness);
          known = true;
        }
      if (!known) return false;
    } else {
      const double value = std::atof(argv[++i]);
      if (!(value > 0)) return false;
      if (word == "--dt") choice.dts.push_back(value);
      else if (word == "--seconds") choice.seconds = value;
      else if (word == "--limit") choice.limit = value;
      else return false;
    }
  }
  if (choice.stiffnesses.empty()) choice.stiffnesses.assign(kStiffnesses.begin(), kStiffnesses.end());
  if (choice.dts.empty()) choice.dts = {1e-3, 5e-3, 20e-3};
  return true;
}

void print(const Row& row) {
  std::printf("%-14s %-7s %4.0f %7.3f %7.3f %7.3f  %-8s %8.3f %8.3f %8.3f %7.3f %7.4f %7.1f %5d  %-4s %8.1e %6.2f\n",
              row.simulator.c_str(), row.stiffness.c_str(), 1e3 * row.dt, row.msMedian, row.msP95, row.msP99,
              row.stable ? "stable" : (row.finite ? "unstable" : "nan"), 1e3 * row.ballDepth, 1e3 * row.sphereDepth,
              1e3 * row.anyDepth, row.volumeRatioMin, 1e3 * row.bindingGap, row.contactsMean, row.contactsMax,
              row.contactConverged ? "yes" : "no", row.complementarity, row.simulated);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Choice choice;
  if (!parse(argc, argv, choice)) {
    std::fprintf(stderr, "usage: glenoid_peers [--json] [--stiffness soft|firm|mixed|tendon]... [--dt S]... [--seconds T] "
                         "[--limit T] [--without-bullet]\n");
    return 2;
  }
  std::error_code ignored;
  const std::filesystem::path bullet = std::filesystem::canonical("/proc/self/exe", ignored).parent_path() / "bullet_peer";
  const bool beside = choice.bullet && std::filesystem::exists(bullet, ignored);
  if (!choice.json)
    std::printf("%-14s %-7s %4s %7s %7s %7s  %-8s %8s %8s %8s %7s %7s %7s %5s  %-4s %8s %6s\n", "", "set", "dt", "median",
                "p95", "p99", "", "ball", "sphere", "any", "J min", "gap", "mean", "max", "conv", "compl", "s");
  JsonValue rows = JsonValue::array();
  for (const Stiffness stiffness : choice.stiffnesses)
    for (const double dt : choice.dts) {
      std::vector<Result<Row>> made;
      made.push_back(measure(stiffness, dt, {choice.seconds, {}, {}}));
      if (beside) made.push_back(runProgram(bullet.string(), stiffness, dt, choice.seconds, choice.limit));
      for (const Result<Row>& row : made) {
        if (!row) {
          std::fprintf(stderr, "%s\n", toLogLine(row.error()).c_str());
          return 1;
        }
        if (choice.json) rows.append(toJson(*row));
        else print(*row);
      }
    }
  if (choice.json) std::printf("%s", toText(rows).c_str());
  return 0;
}
