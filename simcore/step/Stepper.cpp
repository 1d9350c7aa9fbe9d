// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/Stepper.h"

#include <chrono>

#include "simcore/linear/Kernels.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

const char* stageName(Stage stage) {
  switch (stage) {
    case Stage::Assemble: return "assemble";
    case Stage::Factor: return "factor";
    case Stage::Unconstrained: return "unconstrained";
    case Stage::Surfaces: return "surfaces";
    case Stage::Collide: return "collide";
    case Stage::Islands: return "islands";
    case Stage::Delassus: return "delassus";
    case Stage::Contact: return "contact";
    case Stage::Integrate: return "integrate";
    case Stage::Count: break;
  }
  return "";
}

const char* solverName(const Model& model, Profile profile) {
  switch (profile) {
    case Profile::Direct:
      for (const CouplingIslandModel& island : model.inside->islands)
        if (island.symbolic->ordering() == BlockOrdering::NestedDissection) return "block-cholesky-dissected";
      return "block-cholesky";
    case Profile::Reference: return "cholmod";
    case Profile::Paper: break;
  }
  return "conjugate-gradients";
}

const char* kernelIsa(bool portable) { return kernelIsaName(portable); }

Stepper::Stepper(std::shared_ptr<const Model> model, const StepperOptions& options) : m_work(std::make_unique<Work>()) {
  Work& work = *m_work;
  work.model = std::move(model);
  work.inside = work.model->inside.get();
  work.options = options;
  work.settings = work.inside->settings;
  work.settings.portable = options.portable;
  work.settings.rotationsBySvd = options.profile == Profile::Reference;
  for (const CouplingIslandModel& island : work.inside->islands) {
    IslandWork& scratch = work.islands.emplace_back(island);
    if (options.profile == Profile::Direct) scratch.response = makeCholeskyResponse(island.symbolic, options.portable);
    if (options.profile == Profile::Reference) scratch.response = makeReferenceResponse(island.symbolic);
    if (options.profile == Profile::Paper && work.inside->contact) makeSplittings(island, *work.inside, options.portable, scratch);
    scratch.b.resize(3 * island.blockCount);
    scratch.v.resize(3 * island.blockCount);
  }
  work.islandBuilder = std::make_unique<ContactIslandBuilder>(static_cast<int>(work.islands.size()));
  work.report.toolForces.resize(work.model->scenario.tools.size());
  if (!work.inside->contact) return;  // an effect that is off allocates nothing
  work.finder = std::make_unique<ProximityFinder>(work.model->collisionSurfaces, work.model->collisionPairs);
  for (const SceneObject& object : work.model->objects) {
    work.positions.emplace_back(object.collision.vertices.size());
    work.velocities.emplace_back(object.collision.vertices.size(), Vec3::Zero());
  }
  for (std::size_t i = 0; i < work.positions.size(); ++i) {
    work.positionSpans.emplace_back(work.positions[i]);
    work.velocitySpans.emplace_back(work.velocities[i]);
  }
  if (options.threads > 1) work.worker = std::make_unique<Worker>([&work] { work.findProximities(*work.stateSeen); });
}

Stepper::~Stepper() = default;

const Model& Stepper::model() const { return *m_work->model; }

void Stepper::Work::findProximities(const State& state) {
  collideReport.cpuMs.fill(0);
  {
    const StageClock clock(collideReport, Stage::Surfaces);
    for (std::size_t i = 0; i < model->objects.size(); ++i) {
      const SceneObject& object = model->objects[i];
      surfacePositions(object.collision, object.layout, state.q, positions[i]);
      if (object.layout.free) surfaceVelocities(object.collision, object.layout, state.q, state.v, velocities[i]);
    }
  }
  const StageClock clock(collideReport, Stage::Collide);
  proximities = &finder->find(positionSpans, velocitySpans, model->scenario.contactDistance, settings.dt);
}

namespace {

bool velocitiesFinite(const std::vector<IslandWork>& islands) {
  for (const IslandWork& island : islands)
    if (!island.v.allFinite()) return false;
  return true;
}

/// Writes velocities back and moves everything by them.
void integrate(Stepper::Work& work, const Inputs& inputs, State& state) {
  const StageClock clock(work.report, Stage::Integrate);
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    const CouplingIslandModel& island = work.inside->islands[i];
    for (std::size_t k = 0; k < island.objects.size(); ++k) {
      const ObjectLayout& layout = work.inside->objects[island.objects[k]]->layout();
      state.v.segment(layout.vOffset, layout.vSize) = work.islands[i].v.segment(3 * island.base[k], layout.vSize);
    }
  }
  for (const auto& object : work.inside->objects) object->advance(work.settings.dt, state);
  state.rotations = work.rotations;
  state.impulses.clear();
  if (work.inside->contact)
    for (std::size_t c = 0; c < work.contacts.size(); ++c)
      if (work.impulses[c] > 0) state.impulses.push_back({(*work.proximities)[c].key, work.impulses[c]});
  for (std::size_t tool = 0; tool < inputs.hands.size() && 7 * (tool + 1) <= static_cast<std::size_t>(state.hands.size()); ++tool)
    setPoseAt(state.hands, 7 * static_cast<int>(tool), inputs.hands[tool]);
}

/// The last good state stays where it is; rest is the one velocity that is certainly harmless.
void rejectStep(State& state) {
  state.v.setZero();
  state.impulses.clear();
}

}  // namespace

const StepReport& Stepper::step(const Inputs& inputs, State& state) {
  Work& work = *m_work;
  StepReport& report = work.report;
  const auto wallBegin = std::chrono::steady_clock::now();
  const double cpuBegin = StageClock::nowMs();
  report.taken = true;
  report.contacts = report.active = report.contactIslands = report.droppedRows = report.pivotsExhausted = 0;
  report.residual = report.complementarity = 0;
  report.cpuMs.fill(0);
  report.paper = {};
  report.contactViews.clear();
  for (Vec3& force : report.toolForces) force.setZero();
  work.rotations = state.rotations;

  if (work.inside->contact && work.worker) {
    work.stateSeen = &state;
    work.worker->start();  // finding what is near needs positions only, so it runs beside the free solve
  }
  assembleIslands(work, inputs, state);
  bool good = solveUnconstrained(work, state);
  if (work.inside->contact) {
    if (work.worker)
      work.worker->wait();
    else
      work.findProximities(state);
    for (const Stage stage : {Stage::Surfaces, Stage::Collide})
      report.cpuMs[static_cast<int>(stage)] = work.collideReport.cpuMs[static_cast<int>(stage)];
    if (good) {
      buildContacts(work, state);
      solveConstrained(work, state);
    }
  }
  good = good && velocitiesFinite(work.islands);
  if (good)
    integrate(work, inputs, state);
  else
    rejectStep(state);
  report.taken = good;
  ++state.step;
  state.time = static_cast<double>(state.step) * work.settings.dt;
  report.stepCpuMs = StageClock::nowMs() - cpuBegin;
  if (work.worker)
    report.stepCpuMs += work.collideReport.cpuMs[static_cast<int>(Stage::Surfaces)] + work.collideReport.cpuMs[static_cast<int>(Stage::Collide)];
  report.stepWallMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wallBegin).count();
  return report;
}

}  // namespace glenoid
