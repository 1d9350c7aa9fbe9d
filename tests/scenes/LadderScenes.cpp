// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/LadderScenes.h"

#include "simcore/study/truth/TruthContacts.h"
#include "simcore/study/truth/TruthMotions.h"

namespace glenoid::scenes {

namespace {

Box3 slab(int axis, double at) {
  Vec3 low(-1, -1, -1), high(1, 1, 1);
  low[axis] = at - 1e-6;
  high[axis] = at + 1e-6;
  return {low, high};
}

/// With the elements that the environment asks for.
LadderScene wished(LadderScene scene) {
  scene.scenario.elements = wishedElements();
  return scene;
}

LadderScene named(const char* id) {
  return wished(truth::namedScene(id));
}

}  // namespace

LadderScene twoFallingBoxes() {
  return wished(truth::twoFallingBoxes());
}
LadderScene twoBoxesOnASpring(double stiffness) {
  return wished(truth::twoBoxesOnASpring(stiffness));
}
LadderScene hangingBar(int cells, double youngsModulus, double density) {
  return wished(truth::hangingBar(cells, youngsModulus, density));
}
LadderScene ballOnBlock(double radius, double mass, double youngsModulus, double cell, double growth,
                        double reach) {
  return wished(truth::ballOnBlock(radius, mass, youngsModulus, cell, growth, reach));
}

LadderScene chainAndLooseBlock() {
  LadderScene scene;
  scene.joint = figure4Joint();
  scene.joint.parts.push_back(
      boxPart("loose", 4, PartKind::Soft, Vec3(-0.01, 0.022, 0.002), Vec3(0.01, 0.04, 0.018)));
  scene.scenario.id = scene.scenario.name = "chain";
  scene.scenario.elements = wishedElements();
  scene.scenario.gravity_W.setZero();
  return scene;
}

LadderScene bandBetweenWalls() {
  LadderScene scene = named("band");
  const Vec3 low(-0.04, -0.0025, -0.005), high(0.04, 0.0025, 0.005);
  scene.joint.parts.push_back(
      boxPart("left", 1, PartKind::Rigid, Vec3(-0.06, -0.01, -0.01), Vec3(-0.04, 0.01, 0.01)));
  Part band = boxPart("band", 2, PartKind::Soft, low, high);
  band.volume = std::make_shared<TetMesh>(boxVolume(low, high, 16, 1, 2));
  band.regions.push_back(regionIn(band, "left-end", slab(0, -0.04)));
  band.regions.push_back(regionIn(band, "right-end", slab(0, 0.04)));
  scene.joint.parts.push_back(band);
  scene.joint.parts.push_back(
      boxPart("right", 3, PartKind::Rigid, Vec3(0.04, -0.01, -0.01), Vec3(0.06, 0.01, 0.01)));
  scene.joint.couplings.push_back({"c12", "band", "left", "left-end", 1e10, 0});
  scene.joint.couplings.push_back({"c23", "band", "right", "right-end", 1e10, 0});
  scene.scenario.fixedParts = {"left", "right"};
  scene.scenario.effects.gravity = scene.scenario.effects.contact = Wish::Off;
  return scene;
}

}  // namespace glenoid::scenes
