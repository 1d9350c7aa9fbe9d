// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/RunWatch.h"

#include <algorithm>
#include <cmath>

#include "simcore/scene/SceneWords.h"
#include "simcore/step/StepModel.h"

namespace glenoid {
namespace {

Vec3 middleOf(const ObjectLayout& layout, const VecX& q) {
  if (layout.rigid) return q.segment<3>(layout.qOffset);
  Vec3 sum = Vec3::Zero();
  for (int node = 0; node < layout.nodeCount; ++node) sum += q.segment<3>(layout.qOffset + 3 * node);
  return sum / std::max(layout.nodeCount, 1);
}

std::vector<std::array<int, 2>> edgesOf(const TetMesh& mesh) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& tet : mesh.tets)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) edges.push_back({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// How far the straight way between the hand's poses at two steps' ends passes by a key that lies between them.
double passedBy(const HandTrack& track, const HandKey& key, double dt) {
  const double before = std::floor(key.time / dt) * dt, share = (key.time - before) / dt;
  const Vec3 a = handAt(track, before).p_WB, b = handAt(track, before + dt).p_WB;
  return (key.hand.p_WB - (a + share * (b - a))).norm();
}

}  // namespace

const char* noticeName(NoticeKind kind) {
  switch (kind) {
    case NoticeKind::UnusedSetting: return "unused-setting";
    case NoticeKind::EffectIdle: return "effect-idle";
    case NoticeKind::TooDeep: return "too-deep";
    case NoticeKind::TornAway: return "torn-away";
    case NoticeKind::Overstretched: return "overstretched";
    case NoticeKind::InsideOut: return "inside-out";
    case NoticeKind::Pressed: return "pressed";
    case NoticeKind::MarkMissed: return "mark-missed";
    case NoticeKind::PathCut: return "path-cut";
    case NoticeKind::Bounded: return "bounded";
    case NoticeKind::TimeUp: return "time-up";
  }
  return "";
}

RunWatch::RunWatch(const Model& model, bool stretchLaw) : m_model(model), m_stretchLaw(stretchLaw) {
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (object.tool || !object.layout.free) continue;
    Watched watched{static_cast<int>(i), middleOf(object.layout, model.start.q), boundsOf(*object.visual.mesh).diagonal().norm(), {}, {}, false, false, {}};
    if (object.volume) {
      watched.edges = edgesOf(*object.volume);
      for (const auto& [a, b] : watched.edges)
        watched.longest2.push_back(kStretchMost * kStretchMost * (object.volume->nodes[a] - object.volume->nodes[b]).squaredNorm());
    }
    m_watched.push_back(std::move(watched));
  }
}

void RunWatch::look(const State& state) {
  for (Watched& watched : m_watched) {
    const SceneObject& object = m_model.objects[watched.object];
    const ObjectLayout& layout = object.layout;
    if (!watched.away) {
      const double way = (middleOf(layout, state.q) - watched.start_W).norm();
      watched.away = way > kSizesAway * watched.size;
      if (watched.away) m_notices.push_back({NoticeKind::TornAway, object.id, "", way, watched.size, state.time, state.step, {}});
    }
    if (object.volume) countElements(watched, state);
    if (watched.stretched) continue;
    const auto node = [&](int k) { return state.q.segment<3>(layout.qOffset + 3 * k); };
    double ratio2 = 0;  // of the most stretched edge, over the limit
    for (std::size_t e = 0; e < watched.edges.size(); ++e)
      ratio2 = std::max(ratio2, (node(watched.edges[e][0]) - node(watched.edges[e][1])).squaredNorm() / watched.longest2[e]);
    watched.stretched = ratio2 > 1;
    if (watched.stretched)
      m_notices.push_back({NoticeKind::Overstretched, object.id, "", kStretchMost * std::sqrt(ratio2), kStretchMost, state.time, state.step, {}});
  }
}

void RunWatch::countElements(Watched& watched, const State& state) {
  const auto& soft = static_cast<const SoftObject&>(*m_model.inside->objects[watched.object]);
  const TissueTrouble now = soft.troubleOf(state.q, m_stretchLaw);
  const std::string& id = m_model.objects[watched.object].id;
  const auto tell = [&](NoticeKind kind, int count, int& most) {
    if (count <= most) return;
    most = count;
    auto notice = std::find_if(m_notices.begin(), m_notices.end(), [&](const Notice& n) { return n.kind == kind && n.subject == id; });
    if (notice == m_notices.end())
      notice = m_notices.insert(notice, {kind, id, "", 0, static_cast<double>(soft.rotationCount()), 0, 0, {}});
    notice->figure = count;
    notice->time = state.time;
    notice->step = state.step;
  };
  tell(NoticeKind::InsideOut, now.insideOut, watched.most.insideOut);
  tell(NoticeKind::Pressed, now.pressed, watched.most.pressed);
}

std::optional<TissueTrouble> RunWatch::troubleMost(int object) const {
  for (const Watched& watched : m_watched)
    if (watched.object == object && m_model.objects[object].volume) return watched.most;
  return {};
}

std::vector<Notice> noticesBefore(const Model& model, const Recording* input, double seconds) {
  std::vector<Notice> notices;
  for (const UnusedSetting& unused : unusedSettings(model.scenario)) {
    Notice notice;
    notice.subject = unused.name;
    notice.unused = unused;
    notices.push_back(std::move(notice));
  }
  for (const EffectPlan& plan : model.effects) {
    if (plan.on || plan.reason != "nothing-to-act-on") continue;
    for (const auto& [word, wish] : scene_words::kEffects)
      if (plan.name == word && model.scenario.effects.*wish == Wish::On) notices.push_back({NoticeKind::EffectIdle, plan.name, "", 0, 0, 0, 0, {}});
  }
  if (!input) return notices;
  const double dt = model.scenario.dt;
  for (const HandTrack& track : input->tracks) {
    double most = 0, when = 0;
    for (const HandKey& key : track.keys) {
      if (key.time > seconds) break;
      if (const double gap = passedBy(track, key, dt); gap > most) most = gap, when = key.time;
    }
    if (most > model.scenario.contactDistance)
      notices.push_back({NoticeKind::PathCut, track.tool, "", most, model.scenario.contactDistance, when, std::lround(when / dt), {}});
  }
  return notices;
}

bool isMissed(const MarkReport& mark) { return (!mark.tool.empty() || !mark.part.empty()) && !(mark.seconds > 0); }

Notice missedMark(const MarkReport& mark, double dt) {
  const std::string between = mark.tool.empty() || mark.part.empty() ? "" : " / ";
  return {NoticeKind::MarkMissed, mark.name, mark.tool + between + mark.part, dt, 0, mark.begin, std::lround(mark.begin / dt), {}};
}

std::vector<Notice> missedMarks(const RunReport& report) {
  std::vector<Notice> notices;
  const bool contact = std::any_of(report.effects.begin(), report.effects.end(),
                                   [](const EffectReport& effect) { return effect.name == "contact" && effect.state == "on"; });
  if (!contact) return notices;
  for (const MarkReport& mark : report.marks)
    if (isMissed(mark) && mark.end <= report.seconds + 0.5 * report.dt) notices.push_back(missedMark(mark, report.dt));
  return notices;
}

}  // namespace glenoid
