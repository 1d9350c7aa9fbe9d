// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/HapticBench.h"

#include <atomic>
#include <cmath>
#include <thread>

#include "simcore/haptic/ZWidth.h"
#include "simcore/live/Run.h"
#include "simcore/study/HapticRecorded.h"

namespace glenoid {

namespace {
constexpr Silences kSilences{0.7, 0.06};
}

Result<StudyTable> hapticContactTable(const DeviceProfile& device, const std::vector<double>& delays, double seconds, const HapticBars& bars,
                                      const std::function<bool(double)>& progress) {
  StudyTable table;
  table.id = "haptic-contact";
  const VirtualHandSettings hand;
  table.facts = {{"device", device.id}, {"deviceDampingNsPerM", device.damping}, {"rateHz", device.rate}, {"simulationStepMs", 5.0},
                 {"secondsEach", seconds}, {"handMassKg", hand.mass + device.mass}, {"handStiffnessNPerM", hand.stiffness},
                 {"handDampingNsPerM", hand.damping}};
  table.columns = {"surface", "addedDelayMs", "stiffnessNPerM", "dampingNsPerM", "boundNPerM", "renderedNPerM", "renderedOfBound", "energyMadeMJ",
                   "loopEnergyMadeMJ", "forceMaxN", "forceRmsN", "forceErrorRmsN", "forceErrorShare", "kept"};
  const double total = static_cast<double>(std::size(kHapticSurfaces) * delays.size());
  double done = 0;
  for (const HapticSurface surface : kHapticSurfaces)
    for (const double delay : delays) {
      HapticTrial trial;
      trial.surface = surface;
      trial.device = device;
      trial.delay = delay;
      trial.seconds = seconds;
      trial.compare = delay == 0;
      const auto result = runHapticTrial(trial);
      if (!result) return result.error();
      const bool bone = surface == HapticSurface::Bone;
      const double share = result->renderedStiffness / result->gains.bound;
      const bool near = !trial.compare || result->forceError <= bars.forceError || result->forceErrorShare <= bars.forceErrorShare;
      const bool kept = result->energyMade <= bars.energy && (!bone || share >= bars.stiffnessShare) && near;
      const auto figure = [](bool there, double value) { return there ? StudyCell(value) : StudyCell(); };
      table.rows.push_back({std::string(hapticSurfaceName(surface)), 1e3 * delay, result->gains.stiffness, result->gains.damping, result->gains.bound,
                            result->renderedStiffness, figure(bone, share), 1e3 * result->energyMade, 1e3 * result->loopEnergyMade, result->forceMax,
                            result->forceRms, figure(trial.compare, result->forceError), figure(trial.compare, result->forceErrorShare), kept});
      if (progress && !progress(++done / total)) return Error{Fault::Cancelled, {}, {}, "bench haptics"};
    }
  return table;
}

Result<StudyTable> hapticSilenceTable(const DeviceProfile& device, double seconds, const HapticBars& bars, const std::function<bool(double)>& progress) {
  StudyTable table;
  table.id = "haptic-silence";
  table.facts = {{"device", device.id}, {"silentEveryS", kSilences.every}, {"silentForMs", 1e3 * kSilences.length}, {"secondsEach", seconds}};
  table.columns = {"surface", "energyMadeMJ", "loopEnergyMadeMJ", "forceMaxN", "silentTicks", "heldBackTicks", "kept"};
  double done = 0;
  for (const HapticSurface surface : kHapticSurfaces) {
    HapticTrial trial;
    trial.surface = surface;
    trial.device = device;
    trial.seconds = seconds;
    trial.silentEvery = kSilences.every;
    trial.silentFor = kSilences.length;
    const auto result = runHapticTrial(trial);
    if (!result) return result.error();
    table.rows.push_back({std::string(hapticSurfaceName(surface)), 1e3 * result->energyMade, 1e3 * result->loopEnergyMade, result->forceMax,
                          result->counts.silent, result->counts.heldBack, result->energyMade <= bars.energy});
    if (progress && !progress(++done / static_cast<double>(std::size(kHapticSurfaces)))) return Error{Fault::Cancelled, {}, {}, "bench haptics"};
  }
  return table;
}

StudyTable zWidthTable(const DeviceProfile& device, const std::vector<double>& delays) {
  StudyTable table;
  table.id = "haptic-z-width";
  const double mass = device.mass > 0 ? device.mass : 0.1;
  table.facts = {{"device", device.id}, {"massKg", mass}, {"deviceDampingNsPerM", device.damping}, {"rateHz", device.rate}};
  table.columns = {"addedDelayMs", "wallDampingNsPerM", "stableNPerM", "passiveNPerM", "chosenNPerM"};
  for (const double delay : delays) {
    const WallDevice wall{mass, device.damping, 1 / device.rate, static_cast<int>(std::lround((device.delay + delay) * device.rate))};
    const CouplingGains chosen = gainsFor(device, 1e9, device.rate, delay);
    for (int i = 0; i <= 20; ++i) {
      const double damping = 0.1 * i * device.damping;
      const bool here = std::abs(damping - chosen.damping) < 1e-9;
      table.rows.push_back({1e3 * delay, damping, stiffestStable(wall, damping), stiffestPassive(wall, damping), here ? StudyCell(chosen.stiffness) : StudyCell()});
    }
  }
  return table;
}

Result<StudyTable> hapticRecordedTable(const std::vector<std::pair<std::string, StudyScene>>& scenes, const DeviceProfile& device, double seconds,
                                       const std::function<bool(double)>& progress) {
  StudyTable table;
  table.id = "haptic-recorded";
  table.facts = {{"device", device.id}, {"rateHz", device.rate}};
  table.columns = {"scenario", "tool", "seconds", "forceMaxN", "forceRmsN", "forceErrorRmsN", "forceErrorMedianN", "energyMadeMJ", "rowsMax", "overflowMax",
                   "publishMs", "tickMs"};
  double done = 0;
  for (const auto& [name, scene] : scenes) {
    const double length = std::min(seconds, inputSeconds(scene.input));
    const auto felt = feelRecording(scene, device, length, [&](double fraction) { return !progress || progress((done + fraction) / static_cast<double>(scenes.size())); });
    if (!felt) return felt.error();
    ++done;
    for (const RecordedFeel& row : *felt)
      table.rows.push_back({name, row.tool, row.seconds, row.forceMax, row.forceRms, row.forceError, row.steadyError, 1e3 * row.energyMade,
                            static_cast<long>(row.rowsMax), static_cast<long>(row.overflowMax), row.publishMs, 1e-3 * row.tickUs});
  }
  return table;
}

Result<StudyTable> hapticRecordedLateTable(const std::vector<std::pair<std::string, StudyScene>>& scenes, const DeviceProfile& device, double seconds,
                                           const HapticBars& bars, const std::function<bool(double)>& progress) {
  StudyTable table;
  table.id = "haptic-recorded-late";
  table.facts = {{"device", device.id}, {"rateHz", device.rate}, {"silentEveryS", kSilences.every}, {"silentForMs", 1e3 * kSilences.length}};
  table.columns = {"scenario", "tool", "seconds", "forceMaxN", "energyMadeMJ", "silentTicks", "heldBackTicks", "kept"};
  double done = 0;
  for (const auto& [name, scene] : scenes) {
    const double length = std::min(seconds, inputSeconds(scene.input));
    const auto felt = feelRecording(scene, device, length, [&](double fraction) { return !progress || progress((done + fraction) / static_cast<double>(scenes.size())); }, kSilences);
    if (!felt) return felt.error();
    ++done;
    for (const RecordedFeel& row : *felt)
      table.rows.push_back({name, row.tool, row.seconds, row.forceMax, 1e3 * row.energyMade, row.silent, row.heldBack, row.energyMade <= bars.energy});
  }
  return table;
}

StudyTable emptyHapticClockTable() {
  StudyTable table;
  table.id = "haptic-clock";
  table.facts = {{"processors", static_cast<long>(std::thread::hardware_concurrency())}};
  table.columns = {"load", "seconds", "scheduling", "rateHz", "missed", "latenessP50Ms", "latenessP99Ms", "latenessP999Ms", "latenessMaxMs",
                   "problemAgeMaxMs", "silentTicks", "lateSteps", "kept"};
  return table;
}

namespace {

/// As many threads that only burn as there are processors, while it lives.
class Burners {
 public:
  explicit Burners(unsigned count) {
    for (unsigned i = 0; i < count; ++i)
      m_threads.emplace_back([this] {
        while (!m_quit.load(std::memory_order_relaxed)) {}
      });
  }
  ~Burners() {
    m_quit = true;
    for (std::thread& thread : m_threads) thread.join();
  }

 private:
  std::atomic<bool> m_quit{false};
  std::vector<std::thread> m_threads;
};

/// Down and up once in 2 s, for as long as asked.
Recording pressing(const Model& model, double seconds) {
  Recording recording;
  HandTrack& track = recording.tracks.emplace_back();
  track.tool = model.scenario.tools[0].id;
  Pose down = model.scenario.tools[0].home;
  down.p_WB.y() = -0.004;
  for (double t = 0; t < seconds; t += 2) {
    track.keys.push_back({t, model.scenario.tools[0].home});
    track.keys.push_back({t + 1, down});
  }
  return recording;
}

}  // namespace

Result<std::vector<StudyCell>> hapticClockRow(const DeviceProfile& device, double seconds, bool load, const HapticBars& bars,
                                              const std::function<bool(double)>& progress) {
  const auto model = makeHapticScene(HapticSurface::Soft, 800, 0.005, Vec3(0.0017, 0.003, 0.0023));
  if (!model) return model.error();
  const Recording input = pressing(**model, seconds);
  RunOptions options;
  options.seconds = seconds;
  options.input = &input;
  options.realtime = true;
  options.checks = false;
  options.haptic = HapticWishes{device, 0, {}};
  options.progress = progress;
  const Burners burners(load ? std::thread::hardware_concurrency() : 0);
  const auto run = runScenario(*model, options);
  if (!run) return run.error();
  const HapticReport& haptic = *run->report.haptic;
  const HapticToolReport& tool = haptic.tools.front();
  const bool kept = std::abs(haptic.rateHz / device.rate - 1) <= bars.rateOff && haptic.latenessP99Ms <= bars.latenessP99 && haptic.latenessP999Ms <= bars.latenessP999;
  return std::vector<StudyCell>{load, seconds, std::string(haptic.realTimeScheduling ? "fifo" : "ordinary"), haptic.rateHz, haptic.missed,
                                haptic.latenessP50Ms, haptic.latenessP99Ms, haptic.latenessP999Ms, haptic.latenessMaxMs, tool.problemAgeMaxMs,
                                tool.silentTicks, run->report.pace->lateSteps, kept};
}

}  // namespace glenoid
