// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RunReport.h"

#include <algorithm>
#include <cmath>

#include "simcore/file/JsonObject.h"

namespace glenoid {
namespace {

using Json = JsonValue;

constexpr auto object = jsonObject;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json toJson(const Timing& t) {
  return object({{"median", t.median}, {"p95", t.p95}, {"p99", t.p99}, {"p999", t.p999}, {"max", t.max}});
}

Json toJson(const PartReport& part) {
  Json couplings = Json::array();
  for (const PartCoupling& c : part.couplings)
    couplings.append(object({{"id", c.id}, {"part", c.part}, {"partId", c.partId}, {"springs", c.springs},
                             {"stiffness", c.stiffness}}));
  return object({{"id", part.id}, {"number", part.number}, {"name", part.name}, {"kind", part.rigid ? "rigid" : "soft"},
                 {"renderTriangles", part.renderTriangles}, {"collisionTriangles", part.collisionTriangles},
                 {"tetrahedra", part.rigid ? Json() : Json(part.tetrahedra)}, {"cells", part.rigid ? Json() : Json(part.cells)},
                 {"insideOutMax", orNull(part.insideOutMax)}, {"pressedMax", orNull(part.pressedMax)}, {"couplings", couplings}});
}

Json toJson(const ContactCounts& c) {
  Json json = object({{"rest", orNull(c.rest)}, {"mean", c.mean}, {"max", c.max}, {"pressingRest", orNull(c.pressingRest)},
                      {"pressingMean", c.pressingMean}, {"pressingMax", c.pressingMax}, {"droppedMax", c.droppedMax}});
  if (!c.rest) json.set("restReason", c.restReason);
  return json;
}

Json wordsOf(const std::vector<std::string>& words) {
  Json list = Json::array();
  for (const std::string& word : words) list.append(word);
  return list;
}

Json toJson(const Notice& n) {
  Json json = object({{"kind", noticeName(n.kind)}, {"subject", n.subject}});
  if (n.kind == NoticeKind::UnusedSetting) json.set("why", unusedName(n.unused.why));
  if (!n.other.empty()) json.set("other", n.other);
  if (n.figure > 0) json.set("figure", n.figure);
  if (n.limit > 0) json.set("limit", n.limit);
  if (n.step > 0) json.set("time", n.time), json.set("step", n.step);
  return json;
}

Json toJson(const PaperSummary& p) {
  return object({{"dNodeSteps", p.nodeSteps}, {"dObjectSteps", p.objectSteps}, {"lambdaMax", p.lambdaMax},
                 {"cgIterationsMax", p.cgIterationsMax}, {"cgResidualMax", p.cgResidualMax},
                 {"cgCappedSteps", p.cgCappedSteps}, {"outerIterationsMax", p.outerIterationsMax},
                 {"outerIterationsMean", p.outerIterationsMean}, {"outerResidualMax", p.outerResidualMax},
                 {"outerCappedSteps", p.outerCappedSteps}, {"divergedSteps", p.divergedSteps},
                 {"departures", wordsOf(p.departures)}});
}

Json toJson(const EffectReport& e) {
  Json json = object({{"name", e.name}, {"state", e.state}, {"reason", e.reason}, {"ms", orNull(e.ms)}});
  if (!e.timedWith.empty()) json.set("timedWith", e.timedWith);
  return json;
}

Json toJson(const MarkReport& m) {
  return object({{"name", m.name}, {"tool", m.tool}, {"part", m.part}, {"begin", m.begin}, {"end", m.end},
                 {"seconds", m.seconds}, {"forceMaxN", m.forceMax}});
}

Json toJson(const HapticToolReport& t) {
  Json json = object({{"tool", t.tool}, {"stiffness", t.stiffness}, {"damping", t.damping}, {"bound", t.bound}, {"saturated", t.saturated},
                      {"forceMaxN", t.forceMaxN}, {"energyMaxJ", t.energyMaxJ}, {"forceErrorRms", orNull(t.forceErrorRms)},
                      {"forceRms", orNull(t.forceRms)}, {"rowsMax", t.rowsMax}});
  json.set("ticks", object({{"overflow", t.overflowTicks}, {"clamped", t.clampedTicks}, {"slewed", t.slewedTicks}, {"lost", t.lostTicks},
                            {"silent", t.silentTicks}, {"heldBack", t.heldBackTicks}}));
  json.set("problemAgeMaxMs", t.problemAgeMaxMs);
  if (t.live) json.set("live", object({{"device", t.live->device}, {"heard", t.live->heard}, {"lostSeconds", t.live->lostSeconds}, {"lostFrom", t.live->lostFrom}}));
  return json;
}

template <class T>
Json listOf(const std::vector<T>& entries) {
  Json list = Json::array();
  for (const T& entry : entries) list.append(toJson(entry));
  return list;
}

Json timesOf(const RunReport& r) {
  Json ms = object({{"clock", "thread CPU time"}, {"step", toJson(r.step)}});
  for (int s = 0; s < kStageCount; ++s) ms.set(stageName(static_cast<Stage>(s)), toJson(r.stages[s]));
  ms.set("stepWall", toJson(r.stepWall));
  return ms;
}

Json toJson(const HapticReport& h) {
  return object({{"device", h.device}, {"realTimeScheduling", h.realTimeScheduling}, {"rateHz", h.rateHz}, {"latenessP50Ms", h.latenessP50Ms},
                 {"latenessP99Ms", h.latenessP99Ms}, {"latenessP999Ms", h.latenessP999Ms}, {"latenessMaxMs", h.latenessMaxMs},
                 {"ticks", h.ticks}, {"missed", h.missed}, {"forceMaxN", h.forceMaxN}, {"energyMaxJ", h.energyMaxJ},
                 {"forceErrorRms", orNull(h.forceErrorRms)}, {"comparedSeconds", h.comparedSeconds}, {"tools", listOf(h.tools)}});
}

}  // namespace

Timing timingOf(std::vector<float>& milliseconds) {
  if (milliseconds.empty()) return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto rank = [&](double share) {
    const double n = static_cast<double>(milliseconds.size());
    const long index = std::lround(std::ceil(share * n)) - 1;
    return static_cast<double>(milliseconds[std::clamp<long>(index, 0, static_cast<long>(milliseconds.size()) - 1)]);
  };
  return {rank(0.5), rank(0.95), rank(0.99), rank(0.999), milliseconds.back()};
}

std::vector<PartReport> partReports(const Model& model) {
  std::vector<int> springs(model.joint.couplings.size(), 0);
  std::vector<double> stiffness(model.joint.couplings.size(), 0.0);
  for (const SpringView& spring : model.springs) {
    ++springs[spring.coupling];
    stiffness[spring.coupling] += spring.stiffness;
  }
  std::vector<PartReport> reports;
  for (const Part& part : model.joint.parts) {
    PartReport report;
    report.id = part.id;
    report.name = part.name;
    report.number = part.number;
    report.rigid = part.kind == PartKind::Rigid;
    if (part.visual) report.renderTriangles = static_cast<int>(part.visual->triangles.size());
    if (part.collision) report.collisionTriangles = static_cast<int>(part.collision->triangles.size());
    const auto object = std::find_if(model.objects.begin(), model.objects.end(), [&](const SceneObject& o) { return o.id == part.id; });
    if (part.volume && object != model.objects.end()) {
      report.tetrahedra = object->authoredTets;
      report.cells = object->cells ? object->elements : 0;
    }
    for (std::size_t c = 0; c < model.joint.couplings.size(); ++c) {
      const Coupling& coupling = model.joint.couplings[c];
      for (const auto& [here, there] : {std::pair(coupling.partA, coupling.partB), std::pair(coupling.partB, coupling.partA)}) {
        if (here != part.id) continue;
        const int other = findPart(model.joint, there);
        report.couplings.push_back({coupling.id, other < 0 ? 0 : model.joint.parts[other].number, there, springs[c], stiffness[c]});
      }
    }
    std::stable_sort(report.couplings.begin(), report.couplings.end(),
                     [](const PartCoupling& a, const PartCoupling& b) { return a.part < b.part; });
    reports.push_back(std::move(report));
  }
  return reports;
}

std::string toJson(const RunReport& r, const std::function<std::string(const Notice&)>& sentence) {
  Json notices = Json::array();
  for (const Notice& notice : r.notices) {
    Json json = toJson(notice);
    if (sentence) json.set("sentence", sentence(notice));
    notices.append(std::move(json));
  }
  Json json = object(
      {{"schemaVersion", 1}, {"scenario", r.scenario}, {"profile", r.profile}, {"solver", r.solver}, {"dt", r.dt}, {"steps", r.steps},
       {"seconds", r.seconds}, {"build", r.build}, {"isa", r.isa}, {"seed", r.seed}, {"threads", r.threads},
       {"realtime", r.realtime}, {"finite", r.finite}, {"diverged", r.diverged}, {"rejectedSteps", r.rejectedSteps},
       {"cutSteps", r.cutSteps}, {"boundedSteps", r.boundedSteps}, {"deepOverlapSteps", r.deepOverlapSteps}, {"refusedHands", r.refusedHands},
       {"stepsPerSecond", r.stepsPerSecond}, {"stepsPerCpuSecond", r.stepsPerCpuSecond},
       {"residual", r.residual}, {"complementarity", r.complementarity},
       {"pivotsExhausted", r.pivotsExhausted},
       {"contactSolver", object({{"pivoting", r.contactSolver.pivoting}, {"impulses", r.contactSolver.impulses}, {"velocities", r.contactSolver.velocities},
                                 {"convex", r.contactSolver.convex}, {"newtonMax", r.contactSolver.newtonMax}, {"rowsMax", r.contactSolver.rowsMax}})},
       {"jointHash", r.jointHash}, {"stateHash", r.stateHash},
       {"tissueLaw", r.tissueLaw}, {"parts", listOf(r.parts)},
       {"islands", object({{"coupling", r.couplingIslands}, {"contactMax", r.contactIslandsMax}})},
       {"contacts", toJson(r.contacts)}, {"ms", timesOf(r)}, {"penetrationMax", r.penetrationMax},
       {"penetrationPair", r.penetrationPair}, {"visualPenetrationMax", orNull(r.visualPenetrationMax)},
       {"visualPenetrationPair", r.visualPenetrationPair}, {"visualPenetrationEvery", r.visualPenetrationEvery}, {"effects", listOf(r.effects)}, {"marks", listOf(r.marks)}, {"notices", notices}});
  if (r.paper) json.set("paper", toJson(*r.paper));
  if (r.training) {
    json.set("tasks", tasksJson(*r.training));
    json.set("training", trainingJson(*r.training));
  }
  if (r.pace) {
    json.set("pace", object({{"wallSeconds", r.pace->wallSeconds}, {"lateSteps", r.pace->lateSteps},
                             {"latenessMaxMs", r.pace->latenessMaxMs}, {"slowedSeconds", r.pace->slowedSeconds}}));
    json.set("haptic", r.haptic ? toJson(*r.haptic) : Json());
    if (!r.haptic) json.set("hapticReason", r.hapticReason);
  }
  return toText(json);
}

const char* profileName(Profile profile) {
  switch (profile) {
    case Profile::Paper: return "paper";
    case Profile::Direct: return "direct";
    case Profile::Reference: return "reference";
  }
  return "";
}

std::optional<Profile> profileNamed(const std::string& name) {
  for (const Profile profile : {Profile::Paper, Profile::Direct, Profile::Reference})
    if (name == profileName(profile)) return profile;
  return std::nullopt;
}

}  // namespace glenoid
