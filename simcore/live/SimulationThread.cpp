// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/SimulationThread.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "simcore/live/CarryState.h"
#include "simcore/live/StepClock.h"
#include "simcore/live/RateWindow.h"
#include "simcore/live/TimeUp.h"

namespace glenoid {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point time) { return std::chrono::duration<double>(time.time_since_epoch()).count(); }

Clock::time_point timePoint(double seconds) {
  return Clock::time_point(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
}

struct SetModel {
  std::shared_ptr<const Model> model;
  StepperOptions options;
  bool carry;
  StepMaker maker;
};
struct SetRecording {
  std::shared_ptr<const Recording> recording;
};
struct AskForSession {
  std::function<void(std::optional<SimulationThread::Session>)> answer;
};
struct WantRotations {
  bool wanted;
};
enum class Order { Play, Pause, StepOnce, Reset, Publish, Quit };
using Command = std::variant<SetModel, SetRecording, AskForSession, WantRotations, Order>;

}  // namespace

// Everything below `commands` belongs to the simulation thread once that runs; `thread` is last, so that all is there.
struct SimulationThread::Run {
  TripleBuffer<Snapshot>& snapshots;
  TripleBuffer<std::vector<HandWish>>& wishes;
  StepMaker maker;
  WatchMaker watchMaker;

  std::mutex mutex;
  std::condition_variable wake;
  std::deque<Command> commands;  // under mutex

  std::shared_ptr<const Model> model;
  std::shared_ptr<const Recording> recording;
  StepFunction stepFunction;
  std::unique_ptr<StepWatch> watch;
  State state;
  Inputs inputs;
  StepReport report;
  HandInput hands;
  SessionRecorder session;
  StepClock clock;
  RateWindow window;
  bool playing = false, quit = false, rotationsWanted = false;
  long rejectedSteps = 0;
  double patience;
  double slowSince = 0;  ///< s: when the steps began that slowSteps counts
  long slowSteps = 0;
  std::thread thread;

  Run(TripleBuffer<Snapshot>& s, TripleBuffer<std::vector<HandWish>>& w, StepMaker m, WatchMaker watches, double patienceGiven)
      : snapshots(s), wishes(w), maker(std::move(m)), watchMaker(std::move(watches)), patience(patienceGiven), thread([this] { loop(); }) {}

  void send(Command command) {
    {
      const std::lock_guard lock(mutex);
      commands.push_back(std::move(command));
    }
    wake.notify_one();
  }

  bool runs() const { return playing && model != nullptr; }

  std::deque<Command> waitForWork() {
    std::unique_lock lock(mutex);
    const auto told = [this] { return !commands.empty(); };
    if (runs()) {
      wake.wait_until(lock, timePoint(clock.nextDue()), told);
    } else {
      wake.wait(lock, told);
    }
    return std::exchange(commands, {});
  }

  void loop() {
    while (!quit) {
      for (Command& command : waitForWork()) {
        std::visit([this](auto& what) { apply(what); }, command);
        publish();
      }
      if (!runs() || quit) continue;
      // Commands that come in between wait for at most this bounded number of steps.
      for (int due = clock.stepsDue(seconds(Clock::now())); due > 0 && playing; --due) stepAndPublish();
    }
  }

  void apply(SetModel& set) {
    const bool carry = set.carry && model != nullptr && set.model != nullptr;
    if (set.model) {
      state = carry ? carryState(*model, state, *set.model) : set.model->start;
      if (carry) {
        hands.change(set.model->scenario, recording);
        // What an edit before the first step moved is carried, and not where a run from a file begins.
        if (stateHash(state) == stateHash(set.model->start)) session.restart(set.model->scenario);
        else session.interrupt();
      } else {
        hands.restart(set.model->scenario, recording);
        session.restart(set.model->scenario);
      }
      stepFunction = (set.maker ? set.maker : maker)(set.model, set.options);
    } else {
      playing = false;
    }
    model = std::move(set.model);
    report = {};
    if (!carry) rejectedSteps = 0;
    watchAnew();
    startClock();
  }

  void watchAnew() {
    watch.reset();
    if (model && watchMaker) watch = watchMaker(model, recording, [this] { send(Order::Publish); });
  }

  void apply(SetRecording& set) {
    recording = std::move(set.recording);
    if (model) hands.change(model->scenario, recording);
    watchAnew();
  }

  void apply(AskForSession& ask) {
    std::optional<Session> answer;
    if (model && session.isWhole() && session.steps() == state.step && state.step > 0) {
      answer.emplace(Session{session.recording(), model});
      answer->recording.jointHash = model->jointHash;
      answer->recording.stateHash = toHex(stateHash(state));
    }
    ask.answer(std::move(answer));
  }

  void apply(WantRotations& want) { rotationsWanted = want.wanted; }

  void apply(Order order) {
    switch (order) {
      case Order::Play:
        playing = model != nullptr;
        startClock();
        break;
      case Order::Pause: playing = false; break;
      case Order::StepOnce:
        playing = false;
        if (model) takeStep();
        break;
      case Order::Reset:
        if (!model) break;
        state = model->start;
        hands.restart(model->scenario, recording);
        session.restart(model->scenario);
        report = {};
        rejectedSteps = 0;
        watchAnew();
        startClock();
        break;
      case Order::Publish: break;  // as after every command
      case Order::Quit: quit = true; break;
    }
  }

  void startClock() {
    if (!model) return;
    clock.restart(seconds(Clock::now()), model->scenario.dt);
    window.restart(seconds(Clock::now()));
    slowSince = seconds(Clock::now());
    slowSteps = 0;
  }

  void takeStep() {
    wishes.take();
    inputs.hands = hands.advance(wishes.front(), state.time + model->scenario.dt, model->scenario.dt);
    session.add(state.step + 1, inputs.hands);
    const double begin = seconds(Clock::now());
    report = stepFunction(inputs, state);
    const double end = seconds(Clock::now());
    if (!report.taken) ++rejectedSteps;
    window.add(end, end - begin);
    if (watch) watch->look(report, state, hands.onPath());
    stopWhereNobodyCanWait(end);
  }

  /// Contacts that run away, say: the window goes on, the run does not.
  void stopWhereNobodyCanWait(double now) {
    const double took = now - slowSince;
    if (++slowSteps >= SimulationThread::kFewSteps) {
      slowSince = now;
      slowSteps = 0;
    }
    if (took <= patience || !playing) return;
    playing = false;
    if (watch) watch->add(timeUp(*model, report, state, patience));
  }

  void stepAndPublish() {
    takeStep();
    publish();
  }

  void publish() {
    Snapshot& out = snapshots.back();
    out.model = model;
    if (model) out.q = state.q;
    if (rotationsWanted && model) {
      out.rotations = state.rotations;
    } else if (out.rotations.size() > 0) {
      out.rotations.resize(0);
    }
    out.time = state.time;
    out.step = state.step;
    out.playing = runs();
    out.report = report;
    out.hands = hands.hands();
    out.rates.stepsPerSecond = window.stepsPerSecond();
    out.rates.msPerStep = 1e3 * window.secondsPerStep();
    out.rates.realTimeFactor = model ? window.stepsPerSecond() * model->scenario.dt : 0;
    out.rates.forgiven = clock.forgiven();
    out.rejectedSteps = rejectedSteps;
    out.notices = watch ? watch->notices() : nullptr;
    out.rest = watch ? watch->rest() : RestState{};
    out.training = watch ? watch->training() : nullptr;
    snapshots.publish();
  }
};

SimulationThread::SimulationThread(StepMaker maker, WatchMaker watchMaker, double patience)
    : m_run(std::make_unique<Run>(m_snapshots, m_hands, std::move(maker), std::move(watchMaker), patience)) {}

SimulationThread::~SimulationThread() {
  m_run->send(Order::Quit);
  m_run->thread.join();
}

void SimulationThread::setModel(std::shared_ptr<const Model> model, const StepperOptions& options, bool carry, StepMaker maker) {
  m_run->send(SetModel{std::move(model), options, carry, std::move(maker)});
}

void SimulationThread::setRecording(std::shared_ptr<const Recording> recording) {
  m_run->send(SetRecording{std::move(recording)});
}

void SimulationThread::play() { m_run->send(Order::Play); }
void SimulationThread::pause() { m_run->send(Order::Pause); }
void SimulationThread::stepOnce() { m_run->send(Order::StepOnce); }
void SimulationThread::reset() { m_run->send(Order::Reset); }

void SimulationThread::setRotationsWanted(bool wanted) { m_run->send(WantRotations{wanted}); }

void SimulationThread::askForSession(std::function<void(std::optional<Session>)> answer) { m_run->send(AskForSession{std::move(answer)}); }

void SimulationThread::setHands(const std::vector<HandWish>& wishes) {
  m_hands.back() = wishes;
  m_hands.publish();
}

}  // namespace glenoid
