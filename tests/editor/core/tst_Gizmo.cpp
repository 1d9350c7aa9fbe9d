// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/Gizmo.h"

#include <gtest/gtest.h>

#include "editor/core/tools/CageTool.h"
#include "editor/core/tools/StartSurfaces.h"
#include "simcore/author/MakeCage.h"
#include "simcore/scene/Start.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Viewport slanted() {
  Viewport viewport;
  viewport.view.eye_W = Vec3(0.2, 0.15, 0.25);
  viewport.view.target_W = Vec3(0.01, 0, 0);
  viewport.width = 900;
  viewport.height = 700;
  return viewport;
}

Vec2 pixelOf(const Viewport& viewport, const Vec3& p) { return *projected(viewport.view, p, viewport.width, viewport.height); }

TEST(Gizmo, whatIsGraspedStaysUnderTheCursor) {
  const Viewport viewport = slanted();
  const Vec3 centre(0.02, 0.01, -0.01);
  const Gizmo gizmo(viewport, centre);
  const Vec3 wanted(0.013, -0.02, 0.008);
  struct Case {
    Gizmo::Grip grip;
    Vec3 shift;
  };
  for (const Case& c : {Case{Gizmo::Grip::X, Vec3(0.013, 0, 0)}, Case{Gizmo::Grip::Y, Vec3(0, -0.02, 0)},
                        Case{Gizmo::Grip::Z, Vec3(0, 0, 0.008)}, Case{Gizmo::Grip::XY, Vec3(0.013, -0.02, 0)},
                        Case{Gizmo::Grip::YZ, Vec3(0, -0.02, 0.008)}, Case{Gizmo::Grip::ZX, Vec3(0.013, 0, 0.008)}}) {
    const Vec3 shift = gizmo.shift(c.grip, pixelOf(viewport, centre), pixelOf(viewport, centre + c.shift));
    EXPECT_LT((shift - c.shift).norm(), 1e-9) << static_cast<int>(c.grip);
  }
  const Vec3 free = gizmo.shift(Gizmo::Grip::Screen, pixelOf(viewport, centre), pixelOf(viewport, centre + wanted));
  EXPECT_NEAR(free.dot(axesOf(viewport.view).back_W), 0, 1e-9) << "in the plane that faces the viewer";
  EXPECT_LT((pixelOf(viewport, centre + free) - pixelOf(viewport, centre + wanted)).norm(), 1e-6);
}

TEST(Gizmo, gripsLieWhereTheyAreDrawn) {
  const Viewport viewport = slanted();
  const Vec3 centre(0.02, 0.01, -0.01);
  const Gizmo gizmo(viewport, centre);
  const Strokes strokes = gizmo.strokes(Gizmo::Grip::None);
  // Each axis: one line for the shaft, four for the head, four for the square of the plane across.
  ASSERT_EQ(strokes.lines.size(), 3u * 2 * 9);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 tip = strokes.lines[18 * axis + 1].at.cast<double>();
    EXPECT_EQ(gizmo.at(pixelOf(viewport, centre + 0.8 * (tip - centre))), static_cast<Gizmo::Grip>(1 + axis));
    const Vec3 a = strokes.lines[18 * axis + 10].at.cast<double>(), c = strokes.lines[18 * axis + 14].at.cast<double>();
    EXPECT_EQ(gizmo.at(pixelOf(viewport, (a + c) / 2)), static_cast<Gizmo::Grip>(4 + axis));
    EXPECT_NEAR((pixelOf(viewport, tip) - pixelOf(viewport, centre)).norm(), 78, 40) << "as large at any distance";
  }
  EXPECT_EQ(gizmo.at(pixelOf(viewport, centre) + Vec2(2, 2)), Gizmo::Grip::Screen);
  EXPECT_EQ(gizmo.at(Vec2(3, 3)), Gizmo::Grip::None);
}

TEST(Gizmo, anAxisSeenFromItsEndGivesNothing) {
  Viewport viewport = slanted();
  viewport.view.eye_W = Vec3(0, 0, 0.3);
  viewport.view.target_W = Vec3::Zero();
  const Gizmo gizmo(viewport, Vec3::Zero());
  const Vec2 middle(450, 350);
  EXPECT_NE(gizmo.at(middle + Vec2(12, 12)), Gizmo::Grip::Z);
  EXPECT_EQ(gizmo.shift(Gizmo::Grip::ZX, middle, middle + Vec2(30, 40)), Vec3(Vec3::Zero())) << "a plane seen edge on";
}

TEST(CageTool, picksWithModifiersAndMovesWhatIsPicked) {
  Cage cage;
  cage.id = "cage";
  cage.part = "block";
  const TriMesh box = scenes::boxSurface(Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.02), 2);
  cage.triangles = box.triangles;
  cage.rest_W = cage.moved_W = box.vertices;
  CageTool tool;
  tool.setCage(&cage);
  const Viewport viewport = slanted();
  const auto click = [&](const Vec3& p, bool shift, bool ctrl) {
    const Pointer pointer{pixelOf(viewport, p), shift, ctrl, false};
    tool.press(viewport, pointer);
    return tool.release(viewport, pointer);
  };
  EXPECT_EQ(click(cage.rest_W[0], false, false), CageTool::Done::Picked);
  EXPECT_EQ(tool.picked(), std::set<int>{0});
  EXPECT_EQ(click(cage.rest_W[5], true, false), CageTool::Done::Picked);
  EXPECT_EQ(tool.picked(), (std::set<int>{0, 5}));
  EXPECT_EQ(click(cage.rest_W[0], false, true), CageTool::Done::Picked);
  EXPECT_EQ(tool.picked(), std::set<int>{5});
  // By the middle of the arrows, anywhere in the plane that faces the viewer.
  const Pointer from{pixelOf(viewport, cage.rest_W[5])}, to{from.at + Vec2(40, -25)};
  tool.press(viewport, from);
  tool.move(viewport, to);
  EXPECT_TRUE(tool.isDragging());
  EXPECT_EQ(tool.release(viewport, to), CageTool::Done::Moved);
  for (std::size_t i = 0; i < cage.rest_W.size(); ++i) EXPECT_EQ(tool.moved_W()[i] == cage.rest_W[i], i != 5);
  EXPECT_LT((pixelOf(viewport, tool.moved_W()[5]) - to.at).norm(), 1e-6);
  const Vec3 mean(0.001, 0.002, 0.003);
  EXPECT_LT((tool.withMeanShift(mean)[5] - cage.rest_W[5] - mean).norm(), 1e-15);
  tool.press(viewport, {pixelOf(viewport, tool.moved_W()[5])});
  tool.cancel();
  EXPECT_FALSE(tool.busy());
  EXPECT_EQ(tool.moved_W(), cage.moved_W) << "a cancelled drag goes back to the document's";
  EXPECT_EQ(click(Vec3(0.3, 0.3, -0.3), false, false), CageTool::Done::Picked) << "beside all: none";
  EXPECT_TRUE(tool.picked().empty());
}

TEST(StartSurfaces, areThoseOfTheStart) {
  Joint joint = scenes::blockOnPlateJoint();
  auto cage = makeCage(joint.parts[1], 40);
  ASSERT_TRUE(cage.ok());
  for (std::size_t i = 0; i < cage->moved_W.size(); ++i) cage->moved_W[i] += 1e-3 * Vec3(i % 3, i % 2, i % 5);
  joint.cages = {*cage};
  StartSurfaces starts;
  const auto surfaces = starts.of(joint);
  ASSERT_TRUE(surfaces.ok());
  EXPECT_EQ((*surfaces)[0], *joint.parts[0].collision);
  const auto wanted = startSurface(joint, joint.parts[1], SurfaceKind::Collision);
  ASSERT_TRUE(wanted.ok());
  for (std::size_t v = 0; v < wanted->vertices.size(); ++v)
    EXPECT_LT(((*surfaces)[1].vertices[v] - wanted->vertices[v]).norm(), 1e-12);
  const auto first = starts.follower(joint.parts[1], *cage);
  cage->moved_W[0] += Vec3(0.01, 0, 0);
  EXPECT_EQ(*starts.follower(joint.parts[1], *cage), *first) << "other handles, the same coordinates";
  cage->rest_W[0] += Vec3(1e-4, 0, 0);
  EXPECT_NE(*starts.follower(joint.parts[1], *cage), *first);
  Part bone = joint.parts[0];
  EXPECT_EQ(starts.follower(bone, *cage).error().fault, Fault::Unusable);
}

}  // namespace
}  // namespace glenoid
