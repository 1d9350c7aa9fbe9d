// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <dirent.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "simcore/import/ImportSurfaces.h"
#include "simcore/import/SurfaceWire.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/import/SampleFiles.h"

// The reader dies in every way it can; the program that asked gets a fault, soon, and nothing is left behind.
namespace glenoid {
namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

int openDescriptors() {
  int count = 0;
  DIR* folder = ::opendir("/proc/self/fd");
  while (::readdir(folder)) ++count;
  ::closedir(folder);
  return count;
}

class ImportWorker : public ::testing::Test {
 protected:
  void TearDown() override { ::unsetenv("GLENOID_IMPORT_TEST"); }
  Error breakDown(const char* how, const ImportLimits& limits = {}) {
    ::setenv("GLENOID_IMPORT_TEST", how, 1);
    const int before = openDescriptors();
    const auto file = importSurfaces(m_file, limits);
    EXPECT_EQ(openDescriptors(), before) << how;
    EXPECT_FALSE(file.ok()) << how;
    return file ? Error{} : file.error();
  }
  TemporaryFolder m_folder;
  std::string m_file = m_folder.put("box.stl", samples::stlBinary());
};

TEST_F(ImportWorker, aReaderThatBreaksDownIsAFault) {
  for (const char* how : {"abort", "crash", "exit", "silent", "babble"}) {
    const Error error = breakDown(how);
    EXPECT_EQ(error.fault, Fault::ReaderStopped) << how;
    EXPECT_EQ(error.place.file, m_file) << how;
  }
}

TEST_F(ImportWorker, aReaderThatHangsIsStoppedAtTheLimit) {
  for (const char* how : {"hang", "spin"}) {
    ImportLimits limits;
    limits.seconds = 0.5;
    const auto start = Clock::now();
    const Error error = breakDown(how, limits);
    EXPECT_EQ(error.fault, Fault::TimedOut) << how;
    EXPECT_EQ(error.arguments, Arguments{"0.5"}) << how;
    EXPECT_LT(since(start), 2) << how;  // a loaded machine
  }
}

TEST_F(ImportWorker, memoryHasALimit) {
  ImportLimits limits;
  limits.memory = 512ull << 20;
  const Error error = breakDown("allocate", limits);
  EXPECT_EQ(error.fault, Fault::OutOfMemory);
  EXPECT_EQ(error.arguments, Arguments{"512 MiB"});
  limits.memory = 64ull << 20;
  EXPECT_EQ(breakDown("flood", limits).fault, Fault::OutOfMemory);  // the answer has one, too
}

TEST_F(ImportWorker, cancelEndsItAtOnce) {
  ImportLimits limits;
  const auto start = Clock::now();
  limits.cancelled = [&] { return since(start) > 0.3; };
  EXPECT_EQ(breakDown("hang", limits).fault, Fault::Cancelled);
  EXPECT_LT(since(start), 0.5);  // asked after 0.3 s, within 0.2 s of that
}

TEST_F(ImportWorker, manyAtOnceFromThreads) {
  std::vector<std::thread> threads;
  std::array<bool, 8> good{};
  for (std::size_t i = 0; i < good.size(); ++i) threads.emplace_back([&, i] { good[i] = importSurfaces(m_file).ok(); });
  for (std::thread& thread : threads) thread.join();
  for (const bool one : good) EXPECT_TRUE(one);
}

TEST(SurfaceWire, comesBackAsItWas) {
  ImportedFile file;
  file.format = "OBJ";
  file.metresPerUnit = 0.0254;
  file.notes = {{ImportNote::PointsJoined, 7}, {ImportNote::LinesDropped, 2}};
  file.surfaces.push_back({"a", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-300}}, {{0, 1, 2}, {2, 1, 0}}}});
  file.surfaces.push_back({"", {{{0, 0, 0}}, {{0, 0, 0}}}});
  const auto back = fromWire(toWire(file), "x");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->format, file.format);
  EXPECT_EQ(back->metresPerUnit, file.metresPerUnit);
  EXPECT_EQ(back->notes, file.notes);
  ASSERT_EQ(back->surfaces.size(), 2u);
  EXPECT_EQ(back->surfaces[0].name, "a");
  EXPECT_EQ(back->surfaces[0].mesh, file.surfaces[0].mesh);
  const Error error{Fault::BadIndex, {"y", {}, {}, 12}, {"3", "2"}, "why"};
  const auto failed = fromWire(toWire(error), "x");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().fault, Fault::BadIndex);
  EXPECT_EQ(failed.error().place.file, "x");
  EXPECT_EQ(failed.error().place.element, 12);
  EXPECT_EQ(failed.error().arguments, error.arguments);
}

TEST(SurfaceWire, noByteOfItIsTrusted) {
  ImportedFile file;
  file.format = "OBJ";
  file.notes = {{ImportNote::PointsJoined, 7}};
  file.surfaces.push_back({"a", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
  const std::string whole = toWire(file);
  for (std::size_t cut = 0; cut < whole.size(); ++cut) EXPECT_FALSE(fromWire(whole.substr(0, cut), "x").ok()) << cut;
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char value : {'\xff', '\x7f', '\x00', '\x01'}) {
      std::string bad = whole;
      bad[at] = value;
      const auto back = fromWire(bad, "x");
      refused += !back.ok();
      if (!back) continue;
      for (const ImportedSurface& surface : back->surfaces)  // whatever is believed can be used
        for (const auto& t : surface.mesh.triangles)
          for (const int i : t) ASSERT_LT(static_cast<std::size_t>(i), surface.mesh.vertices.size());
    }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace glenoid
