// SPDX-License-Identifier: GPL-3.0-or-later
#include "SceneReader.h"

namespace bullet_peer {

namespace {

bool word(std::istream& in, const char* expected) {
  std::string found;
  return (in >> found) && found == expected;
}

bool point(std::istream& in, Point& p) { return static_cast<bool>(in >> p[0] >> p[1] >> p[2]); }

template <std::size_t N>
bool lists(std::istream& in, const char* name, std::vector<std::array<int, N>>& into) {
  std::size_t count = 0;
  if (!word(in, name) || !(in >> count)) return false;
  into.resize(count);
  for (auto& entry : into)
    for (int& i : entry) in >> i;
  return static_cast<bool>(in);
}

bool indices(std::istream& in, const char* name, std::vector<int>& into) {
  std::vector<std::array<int, 1>> list;
  if (!lists(in, name, list)) return false;
  for (const auto& entry : list) into.push_back(entry[0]);
  return true;
}

bool block(std::istream& in, BlockNumbers& b) {
  std::size_t count = 0;
  if (!(in >> b.name) || !word(in, "young") || !(in >> b.young) || !word(in, "poisson") || !(in >> b.poisson)) return false;
  if (!word(in, "nodes") || !(in >> count)) return false;
  b.nodes.resize(count);
  b.mass.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!point(in, b.nodes[i]) || !(in >> b.mass[i])) return false;
  return lists(in, "tets", b.tets) && lists(in, "faces", b.faces) && indices(in, "fixed", b.fixed) &&
         indices(in, "moving", b.moving);
}

}  // namespace

bool readScene(std::istream& in, SceneNumbers& scene) {
  if (!word(in, "dt") || !(in >> scene.dt) || !word(in, "steps") || !(in >> scene.steps) || !word(in, "radius") ||
      !(in >> scene.radius) || !word(in, "gravity") || !point(in, scene.gravity) || !word(in, "ridge") ||
      !point(in, scene.ridgeHalf) || !word(in, "bones") || !point(in, scene.boneHalf) ||
      !point(in, scene.movingCentre) || !point(in, scene.fixedCentre))
    return false;
  std::string heading;
  while (in >> heading && heading == "block")
    if (!block(in, scene.blocks.emplace_back())) return false;
  if (heading != "path" || scene.steps < 1) return false;
  for (long i = 0; i <= scene.steps; ++i)
    if (!point(in, scene.ball.emplace_back()) || !point(in, scene.ridge.emplace_back())) return false;
  return word(in, "end");
}

}  // namespace bullet_peer
