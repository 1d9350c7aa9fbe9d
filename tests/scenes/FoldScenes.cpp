// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/FoldScenes.h"

#include <cmath>
#include <numbers>

#include "simcore/mesh/TetTools.h"

namespace glenoid::scenes {

namespace {

constexpr double kPi = std::numbers::pi;

/// A path of straight stretches and half circles in the plane of X and Y, by the way along it: place and normal.
struct Path {
  struct Piece {
    double length;
    Vec3 from, along;
    double turn;  ///< rad, to the left; 0: straight
  };
  std::vector<Piece> pieces;
  double length = 0;

  void straight(double l) { add({l, at(length), direction(length), 0}); }
  void bend(double radius, double turn) { add({radius * std::abs(turn), at(length), direction(length), turn}); }
  void add(const Piece& piece) {
    pieces.push_back(piece);
    length += piece.length;
  }
  static Vec3 left(const Vec3& d) { return {-d.y(), d.x(), 0}; }
  const Piece& pieceAt(double& s) const {
    std::size_t i = 0;
    while (i + 1 < pieces.size() && s > pieces[i].length) s -= pieces[i++].length;
    return pieces[i];
  }
  Vec3 direction(double s) const {
    if (pieces.empty()) return Vec3::UnitX();
    const Piece& p = pieceAt(s);
    const double angle = p.turn * s / p.length;
    return std::cos(angle) * p.along + std::sin(angle) * left(p.along);
  }
  Vec3 at(double s) const {
    if (pieces.empty()) return Vec3::Zero();
    const Piece& p = pieceAt(s);
    if (p.turn == 0) return p.from + s * p.along;
    const double radius = p.length / p.turn, angle = s / radius;
    return p.from + radius * (std::sin(angle) * p.along + (1 - std::cos(angle)) * left(p.along));
  }
};

/// A band along a path that keeps it in its middle; ends of stretches fall between cells if the cells are even.
Place along(const Path& path, double thickness, double width) {
  return [=](const Vec3& uvw) -> Vec3 {
    const double s = uvw.x() * path.length;
    return path.at(s) + (uvw.y() - 0.5) * thickness * Path::left(path.direction(s)) + Vec3(0, 0, (uvw.z() - 0.5) * width);
  };
}

}  // namespace

Part bandPart(const std::string& id, int number, int nx, int ny, int nz, bool round, const Place& place) {
  TetMesh mesh = boxVolume(Vec3::Zero(), Vec3::Ones(), nx, ny, nz);
  if (round) {  // the last layer of nodes is the first
    const auto node = [&](int x, int y, int z) { return x + (nx + 1) * (y + (ny + 1) * z); };
    std::vector<int> name(mesh.nodes.size());
    std::vector<Vec3> nodes;
    for (int z = 0; z <= nz; ++z)
      for (int y = 0; y <= ny; ++y)
        for (int x = 0; x <= nx; ++x) {
          if (x < nx) {
            name[node(x, y, z)] = static_cast<int>(nodes.size());
            nodes.push_back(mesh.nodes[node(x, y, z)]);
          } else {
            name[node(x, y, z)] = name[node(0, y, z)];
          }
        }
    for (auto& tet : mesh.tets)
      for (int& corner : tet) corner = name[corner];
    mesh.nodes = nodes;
  }
  for (Vec3& x : mesh.nodes) x = place(x);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (tetVolume(mesh, static_cast<int>(t)) < 0) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
  Part part;
  part.id = part.name = id;
  part.number = number;
  part.kind = PartKind::Soft;
  part.visual = part.collision = std::make_shared<TriMesh>(boundaryOf(mesh));
  part.volume = std::make_shared<TetMesh>(mesh);
  part.cellSize = (place({1.0 / nx, 0, 0}) - place(Vec3::Zero())).norm();
  part.materials = {{"tissue", ""}};
  return part;
}

Part hairpinPart(const Hairpin& h) {
  constexpr int kBend = 8;
  const double radius = 0.5 * (h.gap + h.thickness), leg = h.length / h.cellsAlong, above = h.above / h.cellsAlong;
  Path path;  // from the tip of the lower leg
  path.add({h.length, Vec3(h.length, 0.5 * h.thickness, 0), -Vec3::UnitX(), 0});
  path.bend(radius, -kPi);
  path.straight(h.above);
  // Cells of a leg and of the bend are of different lengths: u counts cells.
  const int cells = 2 * h.cellsAlong + kBend;
  const double bend = kPi * radius / kBend;
  const auto way = [=](double u) {
    const double n = u * cells;
    if (n <= h.cellsAlong) return n * leg;
    if (n <= h.cellsAlong + kBend) return h.length + (n - h.cellsAlong) * bend;
    return h.length + kPi * radius + (n - h.cellsAlong - kBend) * above;
  };
  const Place band = along(path, h.thickness, h.width);
  Part part = bandPart("hairpin", 1, cells, h.cellsThrough, h.cellsAcross, false,
                       [=](const Vec3& uvw) { return band(Vec3(way(uvw.x()) / path.length, uvw.y(), uvw.z())); });
  const double top = 2 * h.thickness + h.gap, tiny = 1e-6;
  part.regions.push_back(regionIn(part, "below", Box3(Vec3(-1, -tiny, -1), Vec3(1, tiny, 1))));
  part.regions.push_back(regionIn(part, "above", Box3(Vec3(-1, top - tiny, -1), Vec3(1, top + tiny, 1))));
  return part;
}

Joint hairpinJoint(const Hairpin& hairpin) {
  Joint joint;
  joint.id = joint.name = "hairpin";
  addMaterials(joint);
  joint.parts.push_back(hairpinPart(hairpin));
  return joint;
}

Scenario pressedHairpin(double force) {
  Scenario scenario;
  scenario.id = scenario.name = "pressed-hairpin";
  scenario.elements = wishedElements();
  scenario.gravity_W.setZero();
  scenario.supports.push_back({"hairpin", "below", {}, 1e7, 1e-2});
  const double area = 0.053 * 0.016;
  scenario.pressures.push_back({"hairpin", "above", force / area});
  scenario.selfContactParts = {"hairpin"};
  return scenario;
}

Joint ringJoint(double radius, double thickness, int around, int through) {
  Joint joint;
  joint.id = joint.name = "ring";
  addMaterials(joint);
  const double width = 0.012;
  joint.parts.push_back(bandPart("ring", 1, around, through, 4, true, [=](const Vec3& uvw) {
    const double angle = 2 * kPi * uvw.x(), r = radius + (uvw.y() - 0.5) * thickness;
    return Vec3(r * std::sin(angle), r * std::cos(angle), (uvw.z() - 0.5) * width);
  }));
  const double out = radius + 0.5 * thickness, span = 2 * out;
  joint.parts.push_back(boxPart("lower", 2, PartKind::Rigid, Vec3(-span, -out - 0.01, -0.02), Vec3(span, -out - 1e-5, 0.02)));
  joint.parts.push_back(boxPart("upper", 3, PartKind::Rigid, Vec3(-span, out + 1e-5, -0.02), Vec3(span, out + 0.01, 0.02)));
  return joint;
}

Scenario squeezedRing(double travel) {
  Scenario scenario;
  scenario.id = scenario.name = "squeezed-ring";
  scenario.elements = wishedElements();
  scenario.gravity_W.setZero();
  scenario.fixedParts = {"lower", "upper"};
  const auto come = [&](const char* part, double way) {
    Motion motion;
    motion.part = part;
    motion.keys.resize(2);
    motion.keys[1].time = 1;
    motion.keys[1].displacement_W = Vec3(0, way, 0);
    scenario.motions.push_back(motion);
  };
  come("lower", 0.5 * travel);
  come("upper", -0.5 * travel);
  scenario.selfContactParts = {"ring"};
  return scenario;
}

Joint zigzagJoint(double gap) {
  constexpr double kLeg = 0.04, kThickness = 0.004;
  constexpr int kLegCells = 8, kBend = 8;
  Joint joint;
  joint.id = joint.name = "zigzag";
  addMaterials(joint);
  const double radius = 0.5 * (gap + kThickness);
  Path path;
  path.add({kLeg, Vec3(kLeg, 0.5 * kThickness + 1e-5, 0), -Vec3::UnitX(), 0});
  path.bend(radius, -kPi);
  path.straight(kLeg);
  path.bend(radius, kPi);
  path.straight(kLeg);
  const int cells = 3 * kLegCells + 2 * kBend;
  const auto way = [=](double u) {
    double n = u * cells, s = 0;
    for (int piece = 0; piece < 5; ++piece) {
      const int count = piece % 2 ? kBend : kLegCells;
      const double length = piece % 2 ? kPi * radius : kLeg;
      if (n <= count) return s + n / count * length;
      n -= count;
      s += length;
    }
    return s;
  };
  const Place band = along(path, kThickness, 0.016);
  joint.parts.push_back(bandPart("zigzag", 1, cells, 2, 4, false, [=](const Vec3& uvw) { return band(Vec3(way(uvw.x()) / path.length, uvw.y(), uvw.z())); }));
  joint.parts.push_back(boxPart("floor", 2, PartKind::Rigid, Vec3(-0.05, -0.02, -0.04), Vec3(0.09, 0, 0.04)));
  return joint;
}

Joint sheetJoint() {
  Joint joint;
  joint.id = joint.name = "sheet";
  addMaterials(joint);
  constexpr double kLength = 0.1, kThickness = 0.003, kWidth = 0.02, kClamp = 0.01;
  Part sheet = bandPart("sheet", 1, 32, 2, 6, false, [=](const Vec3& uvw) {
    return Vec3(kLength * (uvw.x() - 0.5), kThickness * uvw.y(), kWidth * (uvw.z() - 0.5));
  });
  // Gripped from below: what comes to lie inside is free.
  const double end = kLength / 2, tiny = 1e-6;
  sheet.regions.push_back(regionIn(sheet, "left", Box3(Vec3(-1, -tiny, -1), Vec3(-end + kClamp, tiny, 1))));
  sheet.regions.push_back(regionIn(sheet, "right", Box3(Vec3(end - kClamp, -tiny, -1), Vec3(1, tiny, 1))));
  joint.parts.push_back(sheet);
  const double half = kWidth / 2;
  joint.parts.push_back(boxPart("still", 2, PartKind::Rigid, Vec3(-end, -0.005, -half), Vec3(-end + kClamp, 0, half)));
  joint.parts.push_back(boxPart("swung", 3, PartKind::Rigid, Vec3(end - kClamp, -0.005, -half), Vec3(end, 0, half)));
  joint.couplings.push_back({"grip-left", "sheet", "still", "left", 1e8, 1e-2, ""});
  joint.couplings.push_back({"grip-right", "sheet", "swung", "right", 1e8, 1e-2, ""});
  joint.exclusions.push_back({"still", "swung", ""});
  joint.exclusions.push_back({"sheet", "still", ""});
  joint.exclusions.push_back({"sheet", "swung", ""});
  return joint;
}

Scenario foldedSheet() {
  Scenario scenario;
  scenario.id = scenario.name = "folded-sheet";
  scenario.elements = wishedElements();
  scenario.gravity_W.setZero();
  scenario.fixedParts = {"still", "swung"};
  // Half a turn about Z through the middle of the sheet, lifted enough on the way for the sheet to bow; at the end the two
  // upper sides would lie 3 mm in each other, were the sheet not there.
  Motion motion;
  motion.part = "swung";
  constexpr int kKeys = 16;
  constexpr double kTime = 1.5, kOver = 0.003;
  for (int i = 0; i <= kKeys; ++i) {
    const double share = double(i) / kKeys, angle = kPi * share;
    MotionKey key;
    key.time = kTime * share;
    key.displacement_W = Vec3(0, 0.012 * std::sin(angle) + (0.006 + 0.004) * share, 0);
    key.turn_W = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    motion.keys.push_back(key);
  }
  MotionKey down = motion.keys.back();
  down.time = 2;
  down.displacement_W.y() = 2 * 0.003 - kOver;
  motion.keys.push_back(down);
  scenario.motions.push_back(motion);
  scenario.selfContactParts = {"sheet"};
  return scenario;
}

}  // namespace glenoid::scenes
