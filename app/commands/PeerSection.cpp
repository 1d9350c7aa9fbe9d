// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/PeerSection.h"

#include <filesystem>

#include "simcore/study/PeerProgram.h"

namespace glenoid {
namespace {

using namespace peers;

std::vector<StudyCell> cellsOf(const Row& row) {
  return {row.simulator, row.stiffness, 1e3 * row.dt, row.msMedian, row.msP95, row.msP99,
          std::string(row.stable ? "yes" : row.finite ? "no" : "not finite"), 1e3 * row.ballDepth, 1e3 * row.sphereDepth,
          row.volumeRatioMin, 1e3 * row.bindingGap, row.contactsMean, static_cast<long>(row.contactsMax),
          row.simulator == "glenoid" ? StudyCell(row.contactConverged) : StudyCell()};
}

/// How much of it: which steps, and for how long.
struct Extent {
  std::vector<Stiffness> stiffnesses;
  std::vector<double> dts;
  double seconds = kSeconds, limit = 12;  ///< s of the scene; s of computing after which a peer stops by itself
};

Extent extentOf(const BenchOptions& options) {
  if (options.slow.measured <= 3) return {{Stiffness::Mixed}, {0.02}, 0.2, 1};  // tests of the command
  if (options.tetrahedra.back() < 75'000) return {{Stiffness::Soft, Stiffness::Mixed}, {0.005, 0.02}, kSeconds, 8};
  return {{Stiffness::Soft, Stiffness::Firm, Stiffness::Mixed, Stiffness::Tendon}, {0.001, 0.005, 0.02}, kSeconds, 12};
}

Result<std::vector<StudyTable>> runPeers(const StudyScene&, const BenchOptions& options) {
  std::error_code ignored;
  const std::filesystem::path bullet = std::filesystem::canonical("/proc/self/exe", ignored).parent_path() / "bullet_peer";
  const bool beside = std::filesystem::exists(bullet, ignored);
  const Extent extent = extentOf(options);
  StudyTable table;
  table.id = "peers";
  table.columns = {"simulator", "tissue", "dtMs", "stepMedianMs", "stepP95Ms", "stepP99Ms", "stable", "ballDepthMm", "sphereDepthMm",
                   "volumeRatioMin", "bindingGapMm", "contactsMean", "contactsMax", "converged"};
  table.facts = {{"bullet", std::string(beside ? "beside" : "not built")}, {"seconds", extent.seconds}};
  const double parts = static_cast<double>(extent.stiffnesses.size() * extent.dts.size());
  double done = 0;
  for (const Stiffness stiffness : extent.stiffnesses)
    for (const double dt : extent.dts) {
      const Result<Row> ours = measure(stiffness, dt, {extent.seconds, {}, {}});
      if (!ours) return ours.error();
      table.rows.push_back(cellsOf(*ours));
      if (beside) {
        const Result<Row> theirs = runProgram(bullet.string(), stiffness, dt, extent.seconds, extent.limit);
        if (!theirs) return theirs.error();
        table.rows.push_back(cellsOf(*theirs));
      }
      if (options.progress && !options.progress("peers", ++done / parts)) return Error{Fault::Cancelled, {}, {}, "bench"};
    }
  return std::vector<StudyTable>{table};
}

}  // namespace

BenchSection peerSection() { return {"peers", runPeers}; }

}  // namespace glenoid
