// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/Stepper.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "simcore/linear/Kernels.h"
#include "simcore/collide/FeatureKey.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

const char* stageName(Stage stage) {
  switch (stage) {
    case Stage::Assemble: return "assemble";
    case Stage::Factor: return "factor";
    case Stage::Unconstrained: return "unconstrained";
    case Stage::Surfaces: return "surfaces";
    case Stage::Collide: return "collide";
    case Stage::SelfContact: return "selfContact";
    case Stage::Islands: return "islands";
    case Stage::Delassus: return "delassus";
    case Stage::Contact: return "contact";
    case Stage::Friction: return "friction";
    case Stage::Bursa: return "bursa";
    case Stage::Dent: return "dent";
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
  work.paper = options.paperLimits;
  work.additions = options.profile == Profile::Paper ? options.paper : PaperSettings::all();
  work.settings.tension = work.additions.tension;
  work.settings.stretchLaw = work.additions.stretchLaw;
  work.recoverySpeedMax = work.additions.recoveryCap ? work.model->scenario.recoverySpeedMax : std::numeric_limits<double>::infinity();
  for (const CouplingIslandModel& island : work.inside->islands) {
    IslandWork& scratch = work.islands.emplace_back(island);
    work.budget.own += static_cast<double>(island.symbolic->updateCount());
    if (options.profile == Profile::Direct) scratch.response = makeCholeskyResponse(island.symbolic, options.portable);
    if (options.profile == Profile::Reference) scratch.response = makeReferenceResponse(island.symbolic);
    if (options.profile == Profile::Paper && work.inside->contact) makeSplittings(island, *work.inside, options.portable, scratch);
    scratch.b.resize(3 * island.blockCount);
    scratch.v.resize(3 * island.blockCount);
  }
  work.islandBuilder = std::make_unique<ContactIslandBuilder>(static_cast<int>(work.islands.size()));
  work.report.toolForces.resize(work.model->scenario.tools.size());
  work.wanted.resize(work.model->scenario.tools.size());
  work.hands.resize(work.model->scenario.tools.size());
  work.drivenTwists.resize(work.inside->driven.size());
  for (const CouplingIslandModel& island : work.inside->islands)
    for (const BoundPressure& pressure : island.pressures)
      if (2 * pressure.points.size() > work.pressureScratch.size()) work.pressureScratch.resize(2 * pressure.points.size());
  work.turnStiffness = turnStiffnessOf(*work.inside);
  work.solved.setZero(work.model->start.v.size());
  work.velocitySystems.resize(work.islands.size());
  if (!work.inside->contact) return;  // an effect that is off allocates nothing
  work.finder = std::make_unique<ProximityFinder>(work.model->collisionSurfaces, work.model->collisionPairs);
  for (const FilmModel& film : work.inside->films)
    work.filmSearches.emplace_back(film.sides, work.model->collisionSurfaces, film.thickness, film.firstKey);
  work.films.resize(work.filmSearches.size());
  for (const SceneObject& object : work.model->objects) work.positions.emplace_back(object.collision.vertices.size());
  work.positionSpans.assign(work.positions.begin(), work.positions.end());
  for (std::size_t motion = 0; motion < work.velocities.size(); ++motion) {
    for (const SceneObject& object : work.model->objects)
      work.velocities[motion].emplace_back(object.collision.vertices.size(), Vec3::Zero());
    work.velocitySpans[motion].assign(work.velocities[motion].begin(), work.velocities[motion].end());
  }
  if (options.threads > 1) work.worker = std::make_unique<Worker>([&work] { work.findProximities(*work.stateSeen); });
}

Stepper::~Stepper() = default;

const Model& Stepper::model() const { return *m_work->model; }

namespace {

/// The velocities of all objects out of their islands.
void gatherVelocities(const Stepper::Work& work, VecX& v) {
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    const CouplingIslandModel& island = work.inside->islands[i];
    for (std::size_t k = 0; k < island.objects.size(); ++k) {
      const ObjectLayout& layout = work.inside->objects[island.objects[k]]->layout();
      v.segment(layout.vOffset, layout.vSize) = work.islands[i].v.segment(3 * island.base[k], layout.vSize);
    }
  }
}

}  // namespace

void Stepper::Work::findProximities(const State& state) {
  collideReport.cpuMs.fill(0);
  {
    const StageClock clock(collideReport, Stage::Surfaces);
    for (std::size_t i = 0; i < model->objects.size(); ++i) {
      const SceneObject& object = model->objects[i];
      surfacePositions(object.collision, object.layout, state.q, positions[i]);
      if (object.layout.free) surfaceVelocities(object.collision, object.layout, state.q, state.v, velocities[0][i]);
    }
    drivenSurfaces(*this, 0);
  }
  motionCount = 1;
  const StageClock clock(collideReport, Stage::Collide);
  lastNormals.clear();
  for (const State::Impulse& impulse : state.impulses)
    if (!FeatureKey::isTouch(impulse.key)) lastNormals.push_back({impulse.key, impulse.normal_W});  // a touch is of no features
  proximities = &finder->find(positionSpans, velocitySpans[0], model->scenario.contactDistance, settings.dt, lastNormals);
  const double selfMs = finder->counts().selfMs;
  collideReport.cpuMs[static_cast<int>(Stage::SelfContact)] += selfMs;
  collideReport.cpuMs[static_cast<int>(Stage::Collide)] -= selfMs;  // the clock of the whole search adds it
  if (inside->films.empty()) return;
  const StageClock filmClock(collideReport, Stage::Bursa);
  for (std::size_t f = 0; f < films.size(); ++f) films[f] = &filmSearches[f].find(positionSpans);
}

void Stepper::Work::countSearch() {
  // Products of blocks that take about as long.
  constexpr double kPair = 4, kTest = 10, kDepth = 200;
  const ProximityFinder::Counts& counts = finder->counts();
  budget.spent += kPair * static_cast<double>(counts.trianglePairs) + kTest * static_cast<double>(counts.vertexFace + counts.edgeEdge) +
                  kDepth * static_cast<double>(counts.depthQueries);
  report.deepOverlaps = static_cast<int>(counts.deepOverlaps);
}

bool Stepper::Work::searchAgain(const State& state) {
  if (motionCount == ProximityFinder::kMotionsMost) return false;
  Surfaces& now = velocities[motionCount];
  bool outran = false;
  {
    const StageClock clock(report, Stage::Surfaces);
    gatherVelocities(*this, solved);
    const double slack = 0.5 * model->scenario.contactDistance / settings.dt;  // m/s, of each of two surfaces
    for (std::size_t i = 0; i < model->objects.size(); ++i) {
      const SceneObject& object = model->objects[i];
      if (!object.layout.free) continue;
      surfaceVelocities(object.collision, object.layout, state.q, solved, now[i]);
      // One foreseen motion has to fit the whole surface: mixtures of two were not searched.
      bool foreseen = false;
      for (int motion = 0; motion < motionCount && !foreseen; ++motion) {
        double most = 0;
        for (std::size_t k = 0; k < now[i].size(); ++k) most = std::max(most, (now[i][k] - velocities[motion][i][k]).squaredNorm());
        foreseen = most <= slack * slack;
      }
      outran = outran || !foreseen;
    }
    drivenSurfaces(*this, motionCount);
  }
  if (!outran) return false;
  if (!budget.left()) {
    ++report.bounded.searches;
    return false;
  }
  ++motionCount;
  std::array<ProximityFinder::Motion, ProximityFinder::kMotionsMost> motions;
  for (int motion = 0; motion < motionCount; ++motion) motions[motion] = velocitySpans[motion];
  const StageClock clock(report, Stage::Collide);
  const std::span<const ProximityFinder::Motion> used(motions.data(), static_cast<std::size_t>(motionCount));
  proximities = &finder->findAlong(positionSpans, used, model->scenario.contactDistance, settings.dt, lastNormals);
  report.cpuMs[static_cast<int>(Stage::SelfContact)] += finder->counts().selfMs;
  report.cpuMs[static_cast<int>(Stage::Collide)] -= finder->counts().selfMs;
  countSearch();
  return true;
}

namespace {

bool velocitiesFinite(const std::vector<IslandWork>& islands) {
  for (const IslandWork& island : islands)
    if (!island.v.allFinite()) return false;
  return true;
}

/// Writes velocities back and moves everything by them.
void integrate(Stepper::Work& work, State& state) {
  const StageClock clock(work.report, Stage::Integrate);
  state.v = work.solved;
  for (const auto& object : work.inside->objects) object->advance(work.settings.dt, state);
  work.partBegin += work.settings.dt;
  placeDriven(*work.model, *work.inside, work.partBegin, state.q);
  state.rotations = work.rotations;
  state.impulses.clear();
  if (work.inside->contact) {
    for (std::size_t c = 0; c < work.contacts.size(); ++c)
      if (const StepContact& contact = work.contacts[c]; contact.impulse > 0 && !contact.bed) {
        // The law of a touch asks for its force, so its impulse is kept as of a whole step.
        const double whole = contact.touch >= 0 ? work.model->scenario.dt / work.settings.dt : 1.0;
        state.impulses.push_back({contact.near->key, whole * contact.impulse, whole * contact.friction_W, contact.near->normal_W});
      }
    if (!work.touches.empty())
      std::sort(state.impulses.begin(), state.impulses.end(), [](const State::Impulse& a, const State::Impulse& b) { return a.key < b.key; });
  }
  for (std::size_t tool = 0; tool < work.hands.size(); ++tool) setPoseAt(state.hands, 7 * static_cast<int>(tool), work.hands[tool]);
}

/// Contacts as the detector has them now, and their solve.
void solveContacts(Stepper::Work& work, const State& state) {
  StepReport& report = work.report;
  report.active = report.pressing = report.droppedRows = report.pivotsExhausted = 0;
  report.complementarity = 0;
  report.contactSolver = {};
  report.contactViews.clear();
  for (Vec3& force : report.toolForces) force.setZero();
  findTouches(work, state);
  buildContacts(work, state);
  buildTouches(work, state);
  buildFilmContacts(work, state);
  driftContacts(work);
  solveConstrained(work, state);
}

/// The last good state stays where it is; rest is the one velocity that is certainly harmless.
void rejectStep(State& state) {
  state.v.setZero();
  state.impulses.clear();
}

/// Velocities at the end of a step of work.settings.dt into work.solved; false where there is no finite answer.
bool solveStep(Stepper::Work& work, const State& state) {
  work.rotations = state.rotations;
  foreseeDriven(work);
  if (work.inside->contact && work.worker) {
    work.stateSeen = &state;
    work.worker->start();  // finding what is near needs positions only, so it runs beside the free solve
  }
  assembleIslands(work, state);
  bool good = solveUnconstrained(work, state);
  if (work.inside->contact) {
    if (work.worker)
      work.worker->wait();
    else
      work.findProximities(state);
    work.countSearch();
    for (const Stage stage : {Stage::Surfaces, Stage::Collide, Stage::SelfContact, Stage::Bursa}) {
      work.report.cpuMs[static_cast<int>(stage)] += work.collideReport.cpuMs[static_cast<int>(stage)];
      work.workerMs += work.collideReport.cpuMs[static_cast<int>(stage)];
    }
    if (good) {
      for (IslandWork& island : work.islands) island.free = island.v;
      solveContacts(work, state);
      while (work.additions.searchAgain && velocitiesFinite(work.islands) && work.searchAgain(state)) {
        for (IslandWork& island : work.islands) island.v = island.free;
        solveContacts(work, state);
      }
    }
  }
  good = good && velocitiesFinite(work.islands);
  if (good) gatherVelocities(work, work.solved);
  return good;
}

}  // namespace

const StepReport& Stepper::step(const Inputs& inputs, State& state) {
  Work& work = *m_work;
  StepReport& report = work.report;
  const auto wallBegin = std::chrono::steady_clock::now();
  const double cpuBegin = StageClock::nowMs();
  report.taken = true;
  report.parts = 1;
  report.refusedHands = report.contacts = report.active = report.pressing = report.filmContacts = report.contactIslands = report.droppedRows = report.pivotsExhausted = 0;
  report.residual = report.complementarity = 0;
  report.contactSolver = {};
  report.bounded = {};
  report.deepOverlaps = 0;
  work.budget.spent = 0;
  report.cpuMs.fill(0);
  work.workerMs = 0;
  report.paper = {};
  report.contactViews.clear();
  report.dents.clear();
  for (Vec3& force : report.toolForces) force.setZero();

  if (work.views) beginViews(work);
  takeHands(work, inputs, state);
  moveHands(work, state, 1);
  work.partBegin = state.time;
  placeDriven(*work.model, *work.inside, work.partBegin, state.q);
  const double dt = work.settings.dt;
  bool good = solveStep(work, state);
  if (good && work.additions.parts) {
    const int wanted = partsOf(work, state);
    report.parts = work.budget.parts(wanted);
    report.bounded.parts = wanted - report.parts;
  }
  work.settings.dt = dt / report.parts;
  for (int left = report.parts; good && left > 0; --left) {
    if (report.parts > 1) {  // the trial over the whole step is thrown away
      moveHands(work, state, left);
      good = solveStep(work, state);
      if (!good) break;
    }
    integrate(work, state);
    if (work.options.afterPart) work.options.afterPart(state, work.settings.dt);
  }
  work.settings.dt = dt;
  if (!good) rejectStep(state);
  report.taken = good;
  report.contactWork = work.budget.spent;
  ++state.step;
  state.time = static_cast<double>(state.step) * work.settings.dt;
  report.stepCpuMs = StageClock::nowMs() - cpuBegin;
  if (work.worker) report.stepCpuMs += work.workerMs;
  report.stepWallMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wallBegin).count();
  return report;
}

}  // namespace glenoid
