// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "simcore/file/Ply.h"
#include "simcore/import/ImportSurfaces.h"
#include "simcore/repair/Diagnose.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

/// CPU time of this program and of the readers it started, s: does not depend on what else the machine does.
double cpuSeconds() {
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return sum;
}

TEST(LargeMeshes, halfAMillionTrianglesAreReadAndJudgedInSeconds) {
  const auto since = [](double start) { return cpuSeconds() - start; };
  TriMesh large = shapes::revolved([](double s) { return Vec2((60 + 3 * std::sin(40 * s)) * std::sin(M_PI * s), -80 * std::cos(M_PI * s)); }, -80, 80, 500, 500);
  ASSERT_GT(large.triangles.size(), 499'000u);
  large.triangles.pop_back();
  const TemporaryFolder folder;
  ASSERT_TRUE(writePly(folder.path("large.ply"), large).ok());
  double start = cpuSeconds();
  const auto file = importSurfaces(folder.path("large.ply"));
  ASSERT_TRUE(file.ok()) << toLogLine(file.error());
  const double reading = since(start);
  start = cpuSeconds();
  const SurfaceDiagnosis d = diagnose(file->surfaces[0].mesh);
  const double judging = since(start);
  start = cpuSeconds();
  const auto outcome = repair(file->surfaces[0].mesh, automaticRepairs(d));
  const double mending = since(start);
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(d.holes, 1);
  EXPECT_TRUE(diagnose(outcome->mesh).healthy());
  std::printf("%zu triangles: read in %.2f s, judged in %.2f s, mended in %.2f s\n", large.triangles.size(), reading, judging, mending);
  EXPECT_LT(reading + judging + mending, 10);
}

}  // namespace
}  // namespace glenoid
