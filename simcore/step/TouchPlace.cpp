// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ball touches tissue (see Touches.cpp): the place of the part's surface that is nearest to the ball's centre, as it would lie
// without what the part's own coarse elements tilt there.
#include "simcore/step/TouchPlace.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "simcore/base/PlainMath.h"
#include "simcore/collide/FeatureKey.h"
#include "simcore/step/StaticResponse.h"
#include "simcore/step/TouchPatch.h"

namespace glenoid {

namespace {

constexpr double kEven = 0.02;        ///< radii: balls that lie alike deep to within this share a touch
/// Over how many cells a force is spread and a place looked at, where the part is thick enough: what is as large as the elements
/// hardly bends them, and bent ones answer otherwise than at rest.
constexpr double kSpreadCells = 1.5;
constexpr double kSpreadDepths = 0.6;  ///< no wider than this share of the tissue is deep
constexpr double kSeenRadii = 2;       ///< radii of the ball: what is farther has no part in the normal
constexpr int kCentrings = 12;        ///< most steps to the place under the ball
constexpr double kCentred = 1e-6;     ///< m
constexpr double kLeastShare = 0.1;   ///< of the way below the ball, in one such step
constexpr double kEvenTilt = 1e-3;    ///< what own elements tilt less than this moves the place by no more than a thousandth of the ball

struct BallAt {
  Vec3 centre_W = Vec3::Zero(), centre_B = Vec3::Zero();
  double radius = 0;
};

Vec3 restPlace(const FeaturePoint& feature, const std::vector<Vec3>& vertices) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < feature.count; ++i)
    p += feature.weight[static_cast<std::size_t>(i)] * vertices[static_cast<std::size_t>(feature.vertex[static_cast<std::size_t>(i)])];
  return p;
}

/// The ball of a stretch of a tool that lies deepest against a direction; of several alike their mean, so that it moves evenly
/// when the tool turns flat.
BallAt deepestBall(const std::vector<ToolBall>& balls, int first, int last, const Pose& tool, const Vec3& outwards_W) {
  const Vec3 outwards_B = tool.q_WB.conjugate() * outwards_W;
  const auto height = [&](int i) { return outwards_B.dot(balls[static_cast<std::size_t>(i)].centre_T) - balls[static_cast<std::size_t>(i)].radius; };
  double least = height(first), sum = 0;
  for (int i = first; i <= last; ++i) least = std::min(least, height(i));
  BallAt ball;
  for (int i = first; i <= last; ++i) {
    const ToolBall& each = balls[static_cast<std::size_t>(i)];
    const double off = (height(i) - least) / (kEven * each.radius);
    if (off > 30) continue;
    const double weight = plain::exponential(-off);
    ball.centre_B += weight * each.centre_T;
    ball.radius += weight * each.radius;
    sum += weight;
  }
  ball.centre_B /= sum;
  ball.radius /= sum;
  ball.centre_W = tool * ball.centre_B;
  return ball;
}

/// The last step's force of this touch; where the tool has turned or slid along itself it goes by another of its balls.
const State::Impulse* lastOf(const State& state, std::uint64_t key) {
  const State::Impulse* nearest = nullptr;
  int least = 0;
  const auto first = std::lower_bound(state.impulses.begin(), state.impulses.end(), FeatureKey::makeTouch(FeatureKey::pairOf(key), 0),
                                      [](const State::Impulse& impulse, std::uint64_t k) { return impulse.key < k; });
  for (auto it = first; it != state.impulses.end() && FeatureKey::isTouch(it->key) && FeatureKey::pairOf(it->key) == FeatureKey::pairOf(key); ++it) {
    const int off = std::abs(FeatureKey::idA(it->key) - FeatureKey::idA(key));
    if (!nearest || off < least) nearest = &*it, least = off;
  }
  return nearest;
}

/// How the part's own elements at rest answer one newton out of the part along a normal, spread over the points of a touch;
/// against the surface behind.
struct OwnAnswer {
  double mean = 0;                     ///< displacement of these points along it, m/N
  double patchMean = 0;                ///< of a patch's points, m/N
  std::array<double, 2> tilts{0, 0};   ///< of the patch's slopes, 1/N
};
OwnAnswer ownAnswer(Stepper::Work& work, const DentModel& dent, const ContactObject& part, const TouchPatch& patch, const Touch& touch, const VecX& q) {
  if (!dent.own) return {};
  work.touchRows.clear();
  std::array<int, 5> ids{};
  int count = 0;
  const auto row = [&](int id, std::span<const MaterialPoint> points, std::span<const double> weights) {
    work.touchRows.begin(id);
    for (std::size_t k = 0; k < points.size(); ++k) work.touchRows.append(part, points[k], weights[k] * patch.restNormal, q, 0);
    if (work.touchRows.finish()) ids[static_cast<std::size_t>(count++)] = id;
  };
  row(0, touch.points, kTouchWeights);
  row(1, patch.points, kTouchWeights);
  for (std::size_t s = 0; s < 2; ++s) row(static_cast<int>(s) + 2, patch.points, patch.slopeWeights[s]);
  const double whole = 1;
  if (patch.hasBack) row(4, {&patch.back, 1}, {&whole, 1});
  std::array<SparseRow, 5> rows;
  for (int r = 0; r < count; ++r) rows[static_cast<std::size_t>(r)] = work.touchRows.row(r);
  work.touchResponse.setZero();
  dent.own->add({rows.data(), static_cast<std::size_t>(count)}, {ids.data(), static_cast<std::size_t>(count)}, work.touchPanels, work.touchResponse);
  const auto answer = work.touchResponse.col(0);
  return {answer[0] - answer[4], answer[1] - answer[4], {answer[2], answer[3]}};
}

/// The way along the surface at rest from a patch to below a place, m; none where the patch is no surface.
std::optional<Vec3> wayBelow(const TouchPatch& patch, const Vec3& off_W) {
  const auto& [s, t] = patch.slopes;
  const double ss = s.squaredNorm(), st = s.dot(t), tt = t.squaredNorm(), determinant = ss * tt - st * st;
  if (!(determinant > 0)) return {};
  const double u = s.dot(off_W), v = t.dot(off_W);
  return (tt * u - st * v) / determinant * patch.e1 + (ss * v - st * u) / determinant * patch.e2;
}

/// What the search for the place under a ball stands on, and where it has come to.
struct Search {
  const DentModel& dent;
  const SceneObject& soft;
  const std::vector<ToolBall>& balls;
  int firstBall, lastBall;
  Pose tool;
  const VecX& q;
  double force;  ///< of the last step, N

  Vec3 place;                ///< at rest
  DentField::Facing facing;  ///< there
  Vec3 outwards;             ///< unit, W: the patch's normal now, without what its own elements tilt
  BallAt ball;
  TouchPatch patch;
  double wide = 0;           ///< radius that the force is spread over, m
};

/// Goes to the place nearest to the ball's centre: below it along the surface's own normal there. On a surface of curvature 1/R
/// and with the centre at a height h above it, a whole step to the foot of the centre goes 1 + h/R times too far, past the place
/// and, where h > R, ever farther: a rim as sharp as the tip. How far to go is told by what the last step changed (Aitken).
/// `tilt` is what has to be added to the patch's normal.
void goBelow(Search& search, const Vec3& tilt, TipLaw& law) {
  Vec3 before = Vec3::Zero();
  double share = 1;
  for (int n = 0; n < kCentrings; ++n) {
    search.ball = deepestBall(search.balls, search.firstBall, search.lastBall, search.tool, search.outwards);
    law.give = search.dent.field.at(search.place, search.facing);
    law.radius = search.ball.radius;
    const double contact = law.contactRadius(search.force);
    search.wide = std::max(contact, std::min(kSpreadCells * search.dent.cell, kSpreadDepths * depthAt(search.dent, search.place, search.facing.normal_W)));
    const double seen = std::max(contact, std::min(search.wide, kSeenRadii * search.ball.radius));
    search.patch = makeTouchPatch(search.dent, search.soft, search.place, seen, search.q);
    search.facing = {search.patch.restNormal, search.patch.tissue};
    search.outwards = (search.patch.slopes[0].cross(search.patch.slopes[1]).normalized() + tilt).normalized();
    Vec3 off = search.ball.centre_W - placeOf(search.soft, search.patch.middlePoint, search.q);
    off -= off.dot(search.outwards) * search.outwards;
    const std::optional<Vec3> way = wayBelow(search.patch, off);
    if (!way || !(way->norm() > kCentred) || !(way->norm() < 4 * search.ball.radius) || n + 1 == kCentrings) return;
    if (const Vec3 change = *way - before; n > 0 && change.squaredNorm() > 0)
      share = std::clamp(-share * before.dot(change) / change.squaredNorm(), kLeastShare, 1.0);
    before = *way;
    search.place = search.patch.middle + share * *way;
  }
}

}  // namespace

Vec3 inBody(const SceneObject& tool, const FeaturePoint& feature) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < feature.count; ++i)
    p += feature.weight[static_cast<std::size_t>(i)] * tool.collision.vertices[static_cast<std::size_t>(feature.vertex[static_cast<std::size_t>(i)])].r_B;
  return p;
}

int nearestBall(const std::vector<ToolBall>& balls, const Vec3& p_B) {
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (const double off = (balls[i].centre_T - p_B).norm() - balls[i].radius; off < least) best = i, least = off;
  return static_cast<int>(best);
}

void placeTouch(Stepper::Work& work, const State& state, const Proximity& deepest, int firstBall, int lastBall, Touch& touch) {
  const CollisionPair& pair = work.finder->pairs()[static_cast<std::size_t>(deepest.pair)];
  const auto softIndex = static_cast<std::size_t>(pair.surfaceA), toolIndex = static_cast<std::size_t>(pair.surfaceB);
  const SceneObject &soft = work.model->objects[softIndex], &tool = work.model->objects[toolIndex];
  const ContactObject& part = *work.inside->objects[softIndex];
  const DentModel& dent = work.inside->dents[softIndex];
  const std::vector<ToolBall>& balls = work.inside->balls[toolIndex];
  const Pose pose = poseAt(state.q, tool.layout.qOffset);

  touch.near = deepest;
  touch.near.key = FeatureKey::makeTouch(deepest.pair, nearestBall(balls, inBody(tool, deepest.b)));
  touch.lastImpulse = 0;
  touch.lastFriction_W.setZero();
  Vec3 outwards = -deepest.normal_W;
  if (const State::Impulse* last = lastOf(state, touch.near.key)) {
    touch.lastImpulse = last->value;
    touch.lastFriction_W = last->friction_W;
    outwards = -last->normal_W;
  }
  const double force = touch.lastImpulse / work.model->scenario.dt;
  touch.law.radii = dent.field.radii();
  const Vec3 place = restPlace(deepest.a, soft.collision.mesh->vertices);
  Search search{dent, soft, balls, firstBall, lastBall, pose, state.q, force, place, {outwards, dent.tissue[static_cast<std::size_t>(dent.surface->closest(place).triangle)]}, outwards, {}, {}};
  TouchPatch& patch = search.patch;
  OwnAnswer own;
  Vec3 n = outwards, tilt = Vec3::Zero();
  for (int pass = 0; pass < 2; ++pass) {  // once to know what its elements tilt there, and once with that
    goBelow(search, tilt, touch.law);
    touch.points = makeTouchPatch(dent, soft, patch.middle, search.wide, state.q).points;
    findBack(dent, soft, patch);
    own = ownAnswer(work, dent, part, patch, touch, state.q);
    const Vec3 tilted = patch.slopes[0].cross(patch.slopes[1]).normalized();
    n = tilted;
    const Vec3 untilted = (patch.slopes[0] + force * own.tilts[0] * n).cross(patch.slopes[1] + force * own.tilts[1] * n);
    if (untilted.squaredNorm() > 0) n = untilted.normalized();
    tilt = n - tilted;
    if (tilt.norm() < kEvenTilt) break;
  }
  const BallAt& ball = search.ball;
  touch.middle = patch.middlePoint;
  touch.ownCompliance = own.mean;
  const double bulge = patch.restNormal.dot(patch.middle - patch.rest);  // of a curved surface over its points
  touch.near.normal_W = -n;
  // As if the patch had sunk by no more than the points that the force is spread over.
  touch.near.gap = n.dot(ball.centre_W - patch.now) - bulge - ball.radius + (own.mean - own.patchMean) * force;
  touch.place_W = patch.now + bulge * n;
  touch.onTool = {};
  touch.onTool.r_B = ball.centre_B + pose.q_WB.conjugate() * Vec3(-ball.radius * n);
}

}  // namespace glenoid
