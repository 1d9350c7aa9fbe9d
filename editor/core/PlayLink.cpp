// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/PlayLink.h"

#include <algorithm>
#include <utility>

#include "simcore/live/BuildId.h"
#include "simcore/live/RunReport.h"

namespace glenoid {

PlayLink::PlayLink(Document& document, Compiler compiler, StepMaker maker, WatchMaker watchMaker, QObject* parent)
    : QObject(parent), m_document(document), m_compiler(std::move(compiler)), m_simulation(maker ? std::move(maker) : m_meter.maker(), std::move(watchMaker)) {
  m_workers.setMaxThreadCount(1);
  connect(&document, &Document::changed, this, &PlayLink::onChanged);
  // Looking costs one atomic read; nothing is drawn unless something was published.
  m_look.setInterval(16);
  m_look.setTimerType(Qt::PreciseTimer);
  connect(&m_look, &QTimer::timeout, this, &PlayLink::look);
  m_look.start();
  if (!document.isEmpty()) compile(false);
}

PlayLink::~PlayLink() {
  m_workers.clear();
  m_workers.waitForDone();
}

void PlayLink::look() {
  if (!m_simulation.takeSnapshot()) return;
  emit snapshotChanged();
  if (snapshot().notices == m_told) return;
  m_told = snapshot().notices;
  m_notices = m_told ? *m_told : std::vector<Notice>();
  std::stable_sort(m_notices.begin(), m_notices.end(), [](const Notice& a, const Notice& b) { return isGrave(a.kind) && !isGrave(b.kind); });
  emit noticesChanged();
}

void PlayLink::askForSession(std::function<void(std::optional<Recording>)> answer) {
  m_simulation.askForSession([this, guest = m_guest, answer = std::move(answer)](std::optional<SimulationThread::Session> session) {
    std::optional<Recording> recording;
    if (session && !guest) {  // a guest is no run of the scene that is open
      recording = std::move(session->recording);
      recording->profile = profileName(session->model->scenario.profile);
      recording->build = buildId();
      recording->isa = kernelIsa(false);
    }
    QMetaObject::invokeMethod(this, [answer, recording = std::move(recording)] { answer(recording); }, Qt::QueuedConnection);
  });
}

void PlayLink::onChanged(const ChangeSet& changes) {
  if (changes.everything || changes.restart) {
    m_wishes.clear();
    m_simulation.setHands(m_wishes);
    m_simulation.pause();
    m_carry = false;
  }
  // Who stopped following in one scene did not mean the next.
  if (changes.everything && !m_followRecording) {
    m_followRecording = true;
    emit followChanged();
  }
  if (changes.model) compile(m_carry);
}

void PlayLink::compile(bool carry) {
  m_workers.clear();  // one that has not begun is out of date
  const long generation = ++m_generation;
  m_compiling = 1;
  emit compilingChanged();
  m_workers.start([this, generation, carry, scene = m_document.scene()] {
    auto result = m_compiler(scene.joint, scene.scenario);
    QMetaObject::invokeMethod(
        this, [this, generation, carry, result = std::move(result)] { onCompiled(generation, carry, result); },
        Qt::QueuedConnection);
  });
}

void PlayLink::onCompiled(long generation, bool carry, Result<std::shared_ptr<const Model>> result) {
  if (generation != m_generation) return;  // a newer one is on its way
  m_compiling = 0;
  emit compilingChanged();
  if (!result.ok()) {
    emit problem(result.error());
    return;
  }
  StepperOptions options;
  options.profile = result.value()->scenario.profile;
  if (!carry) m_simulation.setRecording(m_followRecording ? m_document.scene().input : nullptr);
  m_simulation.setModel(result.value(), options, carry);
  m_carry = true;
  if (std::exchange(m_guest, false)) emit guestChanged();
  emit compiled();
}

void PlayLink::playGuest(std::shared_ptr<const Model> model, StepMaker maker) {
  m_workers.clear();
  ++m_generation;  // what is being compiled would take the guest's place
  if (std::exchange(m_compiling, 0)) emit compilingChanged();
  m_wishes.clear();
  m_simulation.setHands(m_wishes);
  m_simulation.setRecording(nullptr);
  StepperOptions options;
  options.profile = model->scenario.profile;
  m_simulation.setModel(std::move(model), options, false, std::move(maker));
  m_carry = false;
  m_guest = true;
  emit guestChanged();
  m_simulation.play();
}

void PlayLink::endGuest() {
  if (!m_guest) return;
  m_simulation.pause();
  compile(false);
}

void PlayLink::reset() {
  m_wishes.assign(m_wishes.size(), {});
  m_simulation.setHands(m_wishes);
  m_simulation.reset();
}

void PlayLink::setFollowRecording(bool follow) {
  if (m_followRecording == follow) return;
  m_followRecording = follow;
  emit followChanged();
  m_simulation.setRecording(follow ? m_document.scene().input : nullptr);
}

void PlayLink::holdTool(int tool, const Pose& hand) {
  if (tool < 0) return;
  if (static_cast<int>(m_wishes.size()) <= tool) m_wishes.resize(tool + 1);
  m_wishes[tool] = {true, hand};
  m_simulation.setHands(m_wishes);
}

void PlayLink::releaseTool(int tool) {
  if (!isHeld(tool)) return;
  m_wishes[tool].held = false;
  m_simulation.setHands(m_wishes);
}

bool PlayLink::isHeld(int tool) const {
  return tool >= 0 && tool < static_cast<int>(m_wishes.size()) && m_wishes[tool].held;
}

Pose PlayLink::handOf(int tool) const {
  if (isHeld(tool)) return m_wishes[tool].hand;
  const std::vector<Pose>& hands = snapshot().hands;
  return tool >= 0 && tool < static_cast<int>(hands.size()) ? hands[tool] : Pose{};
}

}  // namespace glenoid
