// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RunHaptics.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/ThreadClock.h"

namespace glenoid {

namespace {
/// A step in time is done long before the next one begins, and its problem is used from then on for Δt.
constexpr double kStepsAhead = 1;
}  // namespace

/// One tool, its device and its thread. `thread` is last: it ends before what it uses.
struct RunHaptics::Hand {
  int tool = -1;
  HandTrack track;
  TripleBuffer<LocalProblem> problems;
  std::vector<HapticSample> log;
  std::vector<double> times;  ///< of the track, by sample
  const LiveHand* live = nullptr;
  HandTrack taken;            ///< of a live hand
  std::unique_ptr<RecordedHand> device;  ///< of one that is not
  std::unique_ptr<HapticThread> thread;
};

std::string RunHaptics::reasonAgainst(const Model& model, Profile profile) {
  if (model.scenario.effects.haptics == Wish::Off) return "asked-off";
  if (profile == Profile::Paper) return "profile-paper";
  if (!model.effectOn("contact")) return "no-contact";
  return model.scenario.tools.empty() ? "no-tool" : "";
}

RunHaptics::RunHaptics(const Model& model, Stepper& stepper, const Recording* input, const HapticWishes& wishes, double seconds)
    : m_model(model), m_input(input), m_wishes(wishes), m_seconds(seconds), m_publisher(stepper, kStepsAhead) {
  const auto room = static_cast<std::size_t>(std::ceil(std::max(0.0, std::min(seconds, wishes.compareSeconds)) * wishes.device.rate));
  for (std::size_t tool = 0; tool < model.scenario.tools.size(); ++tool) {
    if (!model.scenario.tools[tool].link.empty()) continue;
    auto hand = std::make_unique<Hand>();
    hand->tool = static_cast<int>(tool);
    if (input)
      for (const HandTrack& track : input->tracks)
        if (track.tool == model.scenario.tools[tool].id) hand->track = track;
    for (const LiveHand& live : m_wishes.live)
      if (live.tool == model.scenario.tools[tool].id) hand->live = &live;
    if (hand->live) {
      hand->taken.tool = hand->live->tool;
      hand->taken.keys.reserve(static_cast<std::size_t>(seconds / model.scenario.dt) + 2);
    } else {
      hand->log.resize(room);
      hand->times.resize(room);
    }
    m_hands.push_back(std::move(hand));
  }
  m_publishMs.reserve(static_cast<std::size_t>(seconds / model.scenario.dt) + 1);
}

RunHaptics::~RunHaptics() = default;

void RunHaptics::beginStep() {
  m_stamp = steadyNow();
  if (std::exchange(m_started, true)) return;
  for (const auto& hand : m_hands) {
    const Pose& home = m_model.scenario.tools[static_cast<std::size_t>(hand->tool)].home;
    const HapticSettings settings{m_wishes.device, m_wishes.device.rate, 0};
    if (hand->live) {
      hand->thread = std::make_unique<HapticThread>(settings, *hand->live->device, hand->problems);
      continue;
    }
    hand->device = std::make_unique<RecordedHand>(hand->track, home, m_stamp, m_model.scenario.dt);
    hand->device->setLog(hand->times);
    hand->thread = std::make_unique<HapticThread>(settings, *hand->device, hand->problems, hand->log);
  }
}

void RunHaptics::takeHands(double time, std::vector<Pose>& hands) {
  for (const auto& hand : m_hands) {
    if (!hand->live || !hand->thread) continue;
    const HandWord& word = hand->thread->hand();
    Pose& pose = hands[static_cast<std::size_t>(hand->tool)];
    pose = word.known ? word.hand : m_model.scenario.tools[static_cast<std::size_t>(hand->tool)].home;
    hand->taken.keys.push_back({time, pose});
  }
}

std::vector<HandTrack> RunHaptics::liveTracks() const {
  std::vector<HandTrack> tracks;
  for (const auto& hand : m_hands)
    if (hand->live && !hand->taken.keys.empty()) tracks.push_back(hand->taken);
  return tracks;
}

void RunHaptics::endStep(const StepReport& step, const State& state, double behind) {
  const double begin = threadCpuMs();
  m_publisher.stepped(step);
  for (const auto& hand : m_hands) {
    if (hand->device) hand->device->setBehind(behind);
    LocalProblem& problem = hand->problems.back();
    m_publisher.read(state, hand->tool, problem);
    if (!problem.valid) continue;  // the last one that was stays, and grows old
    problem.stamp = m_stamp;
    hand->problems.publish();
  }
  m_publishMs.push_back(static_cast<float>(threadCpuMs() - begin));
}

double RunHaptics::publishMs() { return timingOf(m_publishMs).median; }

HapticReport RunHaptics::finish(const std::function<bool(double)>& progress) {
  HapticReport report;
  report.device = m_wishes.device.id;
  report.rateHz = m_hands.empty() || !m_started ? 0 : 1e300;
  for (const auto& hand : m_hands) {
    if (!hand->thread) continue;
    hand->thread->stop();
    const HapticStatus& status = hand->thread->status();
    const HapticCounts& counts = status.counts;
    HapticToolReport& tool = report.tools.emplace_back();
    tool.tool = m_model.scenario.tools[static_cast<std::size_t>(hand->tool)].id;
    tool.stiffness = counts.gains.stiffness;
    tool.damping = counts.gains.damping;
    tool.bound = counts.gains.bound;
    tool.saturated = counts.gains.limit != GainLimit::Wish;
    tool.forceMaxN = counts.forceMax;
    tool.energyMaxJ = counts.energyMax;
    tool.rowsMax = counts.rowsMax;
    tool.overflowTicks = counts.overflow;
    tool.clampedTicks = counts.clamped;
    tool.slewedTicks = counts.slewed;
    tool.lostTicks = counts.lost;
    tool.silentTicks = counts.silent;
    tool.heldBackTicks = counts.heldBack;
    if (hand->live) {
      const double lost = static_cast<double>(counts.lostOnceHeard) / m_wishes.device.rate;
      tool.live = LiveHandReport{hand->live->word, counts.heard > 0, lost, lost > 0 ? counts.lostFrom : 0};
    }
    tool.problemAgeMaxMs = 1e3 * counts.problemAgeMax;
    report.ticks += counts.ticks;
    report.missed += status.missed;
    report.realTimeScheduling = report.realTimeScheduling && status.scheduling == HapticScheduling::Fifo;
    report.rateHz = std::min(report.rateHz, status.rateHz);
    report.latenessP50Ms = std::max(report.latenessP50Ms, 1e-3 * status.latenessP50Us);
    report.latenessP99Ms = std::max(report.latenessP99Ms, 1e-3 * status.latenessP99Us);
    report.latenessP999Ms = std::max(report.latenessP999Ms, 1e-3 * status.latenessP999Us);
    report.latenessMaxMs = std::max(report.latenessMaxMs, 1e-3 * status.latenessMaxUs);
    report.forceMaxN = std::max(report.forceMaxN, counts.forceMax);
    report.energyMaxJ = std::max(report.energyMaxJ, counts.energyMax);
  }
  const double seconds = std::min(m_seconds, m_wishes.compareSeconds);
  const bool live = !m_wishes.live.empty();  // what was felt depends on every hand
  if (seconds > 0 && !report.tools.empty() && !live) compare(seconds, progress, report);
  return report;
}

void RunHaptics::compare(double seconds, const std::function<bool(double)>& progress, HapticReport& report) const {
  const double period = 1 / m_wishes.device.rate;
  Scenario scenario = m_model.scenario;
  scenario.dt = period;
  const auto fine = compileModel(m_model.joint, scenario);
  if (!fine) return;
  Stepper stepper(*fine, {m_model.scenario.profile});
  LocalPublisher publisher(stepper);
  State state = (*fine)->start;
  Inputs inputs;
  inputs.hands.resize(scenario.tools.size());
  const auto ticks = static_cast<long>(std::ceil(seconds / period)) + 1;
  std::vector<LocalProxy> proxies(m_hands.size());
  std::vector<std::vector<Vec3>> exact(m_hands.size(), std::vector<Vec3>(static_cast<std::size_t>(ticks) + 1, Vec3::Zero()));
  LocalProblem problem;
  for (long k = 1; k <= ticks; ++k) {
    for (std::size_t tool = 0; tool < inputs.hands.size(); ++tool) inputs.hands[tool] = scenario.tools[tool].home;
    for (const auto& hand : m_hands)
      if (!hand->track.keys.empty()) inputs.hands[static_cast<std::size_t>(hand->tool)] = handAt(hand->track, static_cast<double>(k) * period);
    publisher.stepped(stepper.step(inputs, state));
    for (std::size_t h = 0; h < m_hands.size(); ++h) {
      publisher.read(state, m_hands[h]->tool, problem);
      const HapticToolReport& tool = report.tools[h];
      exact[h][static_cast<std::size_t>(k)] = proxies[h].solve(problem, inputs.hands[static_cast<std::size_t>(m_hands[h]->tool)],
                                                              {tool.stiffness, tool.damping, problem.angularStiffness, 0}, period, 0).force;
    }
    if (progress && k % 100 == 0 && !progress(static_cast<double>(k) / static_cast<double>(ticks))) return;
  }
  double worst = -1;
  for (std::size_t h = 0; h < m_hands.size(); ++h) {
    const Hand& hand = *m_hands[h];
    double error = 0, scale = 0;
    long count = 0;
    for (std::size_t i = 0; i < hand.thread->logged(); ++i) {
      const double at = hand.times[i] / period;
      const auto k = static_cast<long>(std::floor(at));
      if (k < 0 || k + 1 > ticks) continue;
      const double share = at - static_cast<double>(k);
      const Vec3 force = (1 - share) * exact[h][static_cast<std::size_t>(k)] + share * exact[h][static_cast<std::size_t>(k) + 1];
      if (force.isZero(0) && hand.log[i].shown.isZero(0)) continue;
      error += (hand.log[i].shown - force).squaredNorm();
      scale += force.squaredNorm();
      ++count;
    }
    HapticToolReport& tool = report.tools[h];
    tool.forceErrorRms = count > 0 ? std::sqrt(error / static_cast<double>(count)) : 0;
    tool.forceRms = count > 0 ? std::sqrt(scale / static_cast<double>(count)) : 0;
    worst = std::max(worst, *tool.forceErrorRms);
  }
  report.forceErrorRms = worst;
  report.comparedSeconds = seconds;
}

}  // namespace glenoid
