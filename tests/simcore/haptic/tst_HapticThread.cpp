// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "simcore/haptic/HapticThread.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

/// A hand that stands 2 mm deep in a wall, and once takes its time.
class Standing : public HapticDevice {
 public:
  bool read(std::int64_t now, ToolInput& input) noexcept override {
    input.pose = test::handAtHeight(-0.002);
    input.stamp = now;
    if (m_sleepMs.exchange(0) > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++reads;
    return true;
  }
  void write(const Vec3& force, const Vec3&) noexcept override {
    last = force.y();
    most = std::max(most.load(), force.y());
  }
  void sleepOnce() { m_sleepMs = 20; }
  std::atomic<long> reads{0};
  std::atomic<double> last{0}, most{0};

 private:
  std::atomic<int> m_sleepMs{0};
};

HapticSettings settings() {
  HapticSettings all;
  all.device = unknownDevice();
  all.device.damping = 2;
  return all;
}

void speak(TripleBuffer<LocalProblem>& problems, double compliance) {
  problems.back() = test::wall(compliance);
  // Every number of a problem says the same: a torn one would show.
  for (std::size_t i = 0; i < LocalProblem::kRows; ++i) problems.back().approach[i] = compliance;
  problems.back().stamp = steadyNow();
  problems.publish();
}

// Simulation, haptics and whoever looks at it, each in a thread of its own: the thread sanitizer watches.
TEST(HapticThread, takesProblemsWhileItRunsAndTellsHowItGoes) {
  Standing device;
  TripleBuffer<LocalProblem> problems;
  std::vector<HapticSample> log(5000);
  HapticThread thread(settings(), device, problems, log);
  long looks = 0;
  for (int step = 0; step < 60; ++step) {
    speak(problems, step % 2 ? 0.0 : 1e-4);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    looks += thread.status().counts.ticks > 0;
  }
  thread.stop();
  EXPECT_GT(looks, 0);
  const HapticStatus& status = thread.status();
  EXPECT_NEAR(device.most, 1.6, 0.05);  // the spring, and the damper where the wall gives way by 0.15 mm in a tick
  EXPECT_EQ(device.last, 0) << "no force is left on a hand";
  EXPECT_EQ(status.counts.ticks, device.reads);
  EXPECT_EQ(static_cast<long>(thread.logged()), status.counts.ticks);
  EXPECT_GT(status.counts.ticks, 50);
  // On an absolute clock what is done and what is missed fill the time, whatever the machine does besides.
  EXPECT_NEAR(static_cast<double>(status.counts.ticks + status.missed), 1000 * status.seconds, 1.5);
  EXPECT_LE(status.latenessP50Us, status.latenessP99Us);
  EXPECT_LE(status.latenessP99Us, status.latenessMaxUs + 1);
}

TEST(HapticThread, missedTicksAreCountedAndNotCaughtUp) {
  Standing device;
  TripleBuffer<LocalProblem> problems;
  HapticThread thread(settings(), device, problems);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  device.sleepOnce();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  thread.stop();
  const HapticStatus& status = thread.status();
  EXPECT_GE(status.missed, 18);
  EXPECT_NEAR(static_cast<double>(status.counts.ticks + status.missed), 1000 * status.seconds, 1.5);
}

TEST(HapticThread, withoutASimulationThereIsNoForce) {
  Standing device;
  TripleBuffer<LocalProblem> problems;
  HapticThread thread(settings(), device, problems);
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
  speak(problems, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(120));  // and then it is silent for longer than that is borne
  thread.stop();
  EXPECT_GT(device.most, 0.5);
  EXPECT_GT(thread.status().counts.silent, 20);
}

}  // namespace
}  // namespace glenoid
