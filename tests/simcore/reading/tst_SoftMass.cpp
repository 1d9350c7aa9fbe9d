// SPDX-License-Identifier: GPL-3.0-or-later
// A soft ball in cells as large as its radius, through the whole way from a joint to a reading of its running model.
#include <gtest/gtest.h>

#include <numbers>

#include "simcore/body/RigidObject.h"
#include "simcore/embed/Cells.h"
#include "simcore/reading/Readings.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/spatial/Shapes.h"

namespace glenoid {
namespace {

TEST(SoftMass, aCoarselyEmbeddedBallTurnsLikeABall) {
  const double a = 0.02, density = 1000;
  Joint joint;
  joint.id = joint.name = "ball";
  scenes::addMaterials(joint);
  Part part;
  part.id = part.name = "ball";
  part.number = 1;
  part.kind = PartKind::Soft;
  part.visual = part.collision = std::make_shared<TriMesh>(shapes::sphere(Vec3(0.01, -0.02, 0.005), a, 4));
  part.materials = {{"tissue", ""}};
  part.cellSize = a;
  part.volume = std::make_shared<TetMesh>(embedInCells(*part.visual, *part.collision, a).value());
  joint.parts = {part};
  Scenario scenario;
  scenario.id = "ball";
  const auto model = compileModel(joint, scenario).value();
  const PartReading ball = readPart(*model, model->start, 0);
  const MassProperties surface = massPropertiesOf(*part.visual, density).value();
  EXPECT_NEAR(ball.mass / surface.mass, 1, 1e-6);
  EXPECT_LT((ball.centre_W - surface.centre).norm(), 1e-6 * a);
  EXPECT_LT((ball.inertia_W - surface.inertia).norm(), 1e-6 * surface.inertia.norm());
  // 2/5 m a² with m = 4/3 π a³ ρ: 5.36e-6 kg·m². Its 2048 facets take half a per cent of the volume and five thirds of that
  // of the inertia.
  const double mass = 4.0 / 3 * std::numbers::pi * a * a * a * density;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(ball.inertia_W(k, k) / (0.4 * mass * a * a), 1, 0.02);
}

}  // namespace
}  // namespace glenoid
