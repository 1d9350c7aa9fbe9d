// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/SeparateStart.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/author/MakeCage.h"
#include "simcore/author/OwnFrame.h"
#include "simcore/author/SeparationBody.h"
#include "simcore/mesh/MeshHealth.h"

namespace glenoid {
namespace {

using namespace separation;

// Penalty of a constraint, against a stiffness whose mean diagonal is one: small at first, so that a part moves as a whole
// before it is dented.
constexpr double kFirstPenalty = 5, kLastPenalty = 2e3;
constexpr int kPenaltySweeps = 12;

class Separation {
 public:
  Separation(Joint& joint, const StartWishes& wishes, const SeparationProgress& progress)
      : m_joint(joint), m_wishes(wishes), m_progress(progress), m_pairs(pairsThatMayCollide(joint)) {}

  Result<SeparationOutcome> run() {
    if (const auto made = begin(); !made) return made.error();
    SeparationOutcome outcome;
    std::vector<Overlap> overlaps = measure();
    outcome.overlapsBefore = static_cast<int>(overlaps.size());
    for (const Overlap& overlap : overlaps) outcome.depthBefore = std::max(outcome.depthBefore, overlap.depth);
    int handles = m_wishes.handles;
    for (int round = 0; round <= m_wishes.refinements && canHelp(overlaps); ++round, handles *= 2) {
      if (const auto caged = cageThose(overlaps, handles, round > 0); !caged) return caged.error();
      for (int sweep = 0; sweep < m_wishes.iterations && canHelp(overlaps); ++sweep, ++outcome.sweeps) {
        const double done = static_cast<double>(outcome.sweeps) / (m_wishes.iterations * (1 + m_wishes.refinements));
        if (m_progress && !m_progress(done, static_cast<int>(overlaps.size())))
          return Error{Fault::Cancelled, {}, {}, "separating the start"};
        if (!sweepOnce(std::min(kLastPenalty, kFirstPenalty * std::pow(kLastPenalty / kFirstPenalty, sweep / double(kPenaltySweeps))))) break;
        overlaps = measure();
        chooseSides(overlaps);
        // Whoever was pushed into a part without a cage gets company.
        if (const auto caged = cageThose(overlaps, handles, false); !caged) return caged.error();
      }
    }
    finish(outcome);
    return outcome;
  }

 private:
  bool mayMove(const Part& part) const {
    if (part.kind != PartKind::Soft) return false;
    return m_wishes.parts.empty() || std::find(m_wishes.parts.begin(), m_wishes.parts.end(), part.id) != m_wishes.parts.end();
  }

  /// Whether a part of any of them may move: two rigid parts stay in each other's way whatever is tried.
  bool canHelp(const std::vector<Overlap>& overlaps) const {
    return std::any_of(overlaps.begin(), overlaps.end(),
                       [&](const Overlap& overlap) { return mayMove(m_joint.parts[overlap.partA]) || mayMove(m_joint.parts[overlap.partB]); });
  }

  Result<Done> begin() {
    for (const std::string& id : m_wishes.parts)
      if (findPart(m_joint, id) < 0) return Error{Fault::UnknownId, {}, {id, "part"}, "separating the start"};
    m_bodies.resize(m_joint.parts.size());
    auto surfaces = startSurfaces(m_joint, SurfaceKind::Collision);
    if (!surfaces) return surfaces.error();
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      body.part = &m_joint.parts[i];
      body.surface = std::move((*surfaces)[i]);
      body.edges = edgesOf(body.surface);
      body.refresh();
      const Cage* cage = findCage(m_joint, body.part->id);
      if (!cage || !mayMove(*body.part)) continue;
      if (const auto put = putInCage(body, *cage); !put) return put.error();
    }
    return Done{};
  }

  std::vector<Overlap> measure() const {
    std::vector<TriMesh> surfaces;
    for (const Body& body : m_bodies) surfaces.push_back(body.surface);
    return findOverlaps(m_joint, surfaces);
  }

  /// Gives parts of overlaps a cage; with `finer` also those that have one. A finer cage begins at rest: what the
  /// coarse one did would stay in it as a form that nothing asks for.
  Result<Done> cageThose(const std::vector<Overlap>& overlaps, int handles, bool finer) {
    std::vector<char> wanted(m_bodies.size(), 0);
    for (const Overlap& overlap : overlaps) wanted[overlap.partA] = wanted[overlap.partB] = 1;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      if (!wanted[i] || !mayMove(*body.part) || (body.caged && !finer)) continue;
      if (body.caged && findCage(m_joint, body.part->id)) continue;  // the author's own stays as it was drawn
      const auto cage = makeCage(*body.part, std::min(handles, 2000));
      if (!cage) return cage.error();
      if (const auto put = putInCage(body, *cage); !put) return put.error();
    }
    return Done{};
  }

  /// False when nothing could move.
  bool sweepOnce(double penalty) {
    bool any = false;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
      Body& body = m_bodies[i];
      if (!body.caged) continue;
      std::vector<Wish> wishes;
      for (const auto& [a, b] : m_pairs) {
        if (a != static_cast<int>(i) && b != static_cast<int>(i)) continue;
        const int o = a == static_cast<int>(i) ? b : a;
        const Body& other = m_bodies[o];
        const auto stuck = m_stuck.find({a, b});
        if (stuck != m_stuck.end() && stuck->second.mover == o) continue;
        if (stuck != m_stuck.end() && stuck->second.mover == static_cast<int>(i)) {
          const std::size_t before = wishes.size();
          wishesToward(body, other, stuck->second.side, m_wishes.clearance, wishes);
          if (wishes.size() > before) continue;
        }
        wishesAgainst(body, other, m_wishes.clearance, other.caged ? 0.5 : 1.0, wishes);
      }
      if (wishes.empty()) continue;
      any = true;
      take(body, leastEnergy(body, wishes, penalty));
    }
    return any;
  }

  /// Of two soft parts that stay in each other's way the thinner one has to come to one side of the other: first to the
  /// side to which there is less to go, then to the opposite one.
  void chooseSides(const std::vector<Overlap>& overlaps) {
    constexpr int kPatience = 10, kTry = 30;
    std::map<std::array<int, 2>, Stuck> still;
    for (const Overlap& overlap : overlaps) {
      const std::array<int, 2> pair{overlap.partA, overlap.partB};
      Stuck stuck = m_stuck[pair];
      ++stuck.sweeps;
      const Body &a = m_bodies[pair[0]], &b = m_bodies[pair[1]];
      if (a.caged && b.caged && stuck.sweeps % kTry == kPatience) {
        const bool first = thicknessOf(*a.part->collision) < thicknessOf(*b.part->collision);
        const auto sides = first ? sidesOf(a, b) : sidesOf(b, a);
        if (sides[0].norm() > 0) {
          stuck.side = stuck.tries++ == 0 ? sides[0] : Vec3(-stuck.side);
          stuck.mover = pair[first ? 0 : 1];
        }
      }
      still[pair] = stuck;
    }
    m_stuck = std::move(still);
  }
  static double thicknessOf(const TriMesh& mesh) { return 2 * enclosedVolume(mesh) / healthOf(mesh).area; }

  void finish(SeparationOutcome& outcome) {
    for (const Body& body : m_bodies) {
      if (!body.caged) continue;
      double most = 0;
      for (std::size_t v = 0; v < body.surface.vertices.size(); ++v)
        most = std::max(most, (body.surface.vertices[v] - body.part->collision->vertices[v]).norm());
      if (most < 1e-9 && !findCage(m_joint, body.part->id)) continue;
      outcome.maxShift = std::max(outcome.maxShift, most);
      outcome.movedParts.push_back(body.part->id);
      outcome.shifts.push_back(most);
      putCage(m_joint, body.caged->cage());
    }
  }

  /// A pair that overlaps for some sweeps by now.
  struct Stuck {
    int sweeps = 0, tries = 0;
    int mover = -1;  ///< body that goes to one side; −1: both as it comes
    Vec3 side = Vec3::Zero();
  };

  Joint& m_joint;
  const StartWishes& m_wishes;
  const SeparationProgress& m_progress;
  std::vector<std::array<int, 2>> m_pairs;
  std::vector<Body> m_bodies;
  std::map<std::array<int, 2>, Stuck> m_stuck;
};

/// The cage as it came out. One that was there before keeps its own rest, and what did not move of it stays to the bit.
void takeOver(Joint& joint, const Cage& cage, const OwnFrame& own) {
  const Isometry toW = own.own_W.inverse();
  Cage out = cage;
  if (const Cage* before = findCage(joint, cage.part)) {
    out = *before;
    for (std::size_t i = 0; i < out.rest_W.size(); ++i) {
      const Vec3 moved = cage.moved_W[i], began = own.own_W * before->moved_W[i];
      if ((moved - began).norm() > own.grid) out.moved_W[i] = toW * moved;
    }
  } else {
    for (auto* handles : {&out.rest_W, &out.moved_W})
      for (Vec3& handle : *handles) handle = toW * handle;
    if (toW.mirrors())
      for (auto& t : out.triangles) std::swap(t[1], t[2]);
  }
  putCage(joint, std::move(out));
}

}  // namespace

Result<SeparationOutcome> separateStart(Joint& joint, const StartWishes& wishes, const SeparationProgress& progress) {
  if (!(wishes.clearance > 0) || !std::isfinite(wishes.clearance))
    return Error{Fault::OutOfRange, {}, {std::to_string(wishes.clearance), "0", "inf"}, "clearance of the start"};
  // What happens along the way hangs on single contacts, so it must not see where W lies: it happens in the joint's own frame.
  const OwnFrame own = ownFrameOf(joint);
  Joint freed = own.toOwn(joint);
  auto outcome = Separation(freed, wishes, progress).run();
  if (!outcome) return outcome;
  Joint copy = joint;
  for (const Cage& cage : freed.cages) takeOver(copy, cage, own);
  auto check = checkStart(copy);
  if (!check) return check.error();
  outcome->check = std::move(*check);
  copy.startProof = outcome->check.proof;
  joint = std::move(copy);
  return outcome;
}

}  // namespace glenoid
