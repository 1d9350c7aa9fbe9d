// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/render/TestScene.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace glenoid::test {
namespace {

/// Box of eight nodes cut into five tetrahedra: the middle one and four corners.
TetMesh fiveTets(const Vec3& low, const Vec3& high) {
  TetMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.nodes.push_back(
        Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()));
  mesh.tets = {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 6, 3}, {4, 0, 5, 6}, {7, 3, 6, 5}};
  for (int t = 0; t < 5; ++t)
    if (tetVolume(mesh, t) < 0) std::swap(mesh.tets[t][2], mesh.tets[t][3]);
  return mesh;
}

VertexBinding embed(const Vec3& x, const TetMesh& mesh) {
  VertexBinding best;
  double bestLow = -1e30;
  for (const auto& tet : mesh.tets) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = mesh.nodes[tet[k + 1]] - mesh.nodes[tet[0]];
    const Vec3 w = edges.inverse() * (x - mesh.nodes[tet[0]]);
    const double low = std::min(w.minCoeff(), 1 - w.sum());
    if (low <= bestLow) continue;
    bestLow = low;
    best.node = tet;
    best.weight = {1 - w.sum(), w[0], w[1], w[2]};
  }
  return best;
}

SurfaceBinding rigidSurface(TriMesh mesh, const Vec3& center) {
  SurfaceBinding surface;
  for (const Vec3& x : mesh.vertices) {
    VertexBinding b;
    b.r_B = x - center;
    surface.vertices.push_back(b);
  }
  surface.mesh = std::make_shared<TriMesh>(std::move(mesh));
  return surface;
}

void addRigid(Model& model, const char* id, const TriMesh& visual, const TriMesh& collision,
              const Vec3& center, std::array<float, 3> color) {
  SceneObject object;
  object.id = object.name = id;
  object.number = static_cast<int>(model.objects.size()) + 1;
  object.color = color;
  object.layout = {
      true, true, static_cast<int>(model.start.q.size()), 7, static_cast<int>(model.start.v.size()), 6, 0};
  object.visual = rigidSurface(visual, center);
  object.collision = rigidSurface(collision, center);
  model.start.q.conservativeResize(model.start.q.size() + 7);
  model.start.q.tail<7>() << center, 0, 0, 0, 1;
  model.start.v.conservativeResize(model.start.v.size() + 6);
  model.start.v.tail<6>().setZero();
  model.objects.push_back(std::move(object));
}

TriMesh moved(TriMesh mesh, const Vec3& by) {
  for (Vec3& x : mesh.vertices) x += by;
  return mesh;
}

}  // namespace

TriMesh sphereMesh(const Vec3& center, double radius, int rings) {
  TriMesh mesh;
  const int around = 2 * rings;
  mesh.vertices.push_back(center + Vec3(0, radius, 0));
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / around;
      mesh.vertices.push_back(
          center + radius * Vec3(std::sin(a) * std::cos(b), std::cos(a), -std::sin(a) * std::sin(b)));
    }
  mesh.vertices.push_back(center - Vec3(0, radius, 0));
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.push_back({at(rings - 1, j), last, at(rings - 1, j + 1)});
  }
  return mesh;
}

TriMesh boxMesh(const Vec3& half) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z()));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Model smallScene() {
  Model model;
  model.start.q.resize(0);
  model.start.v.resize(0);
  const Vec3 box(0, -0.03, -0.05), sphere(0.02, 0.05, -0.03), ball(0, 0, 0.05);
  const TriMesh cuboid = moved(boxMesh(Vec3(0.03, 0.045, 0.025)), box);
  addRigid(model, "box", cuboid, cuboid, box, {0.90f, 0.85f, 0.74f});
  addRigid(model, "sphere", sphereMesh(sphere, 0.028, 20), sphereMesh(sphere, 0.028, 6), sphere,
           {0.36f, 0.58f, 0.78f});

  SceneObject soft;
  soft.id = soft.name = "ball";
  soft.number = 3;
  soft.color = {0.75f, 0.26f, 0.22f};
  const TetMesh cells = fiveTets(ball - Vec3::Constant(0.042), ball + Vec3::Constant(0.042));
  soft.layout = {
      false, true, static_cast<int>(model.start.q.size()), 24, static_cast<int>(model.start.v.size()), 24, 8};
  for (const int rings : {24, 8}) {
    SurfaceBinding surface;
    TriMesh mesh = sphereMesh(ball, 0.04, rings);
    for (const Vec3& x : mesh.vertices) surface.vertices.push_back(embed(x, cells));
    surface.mesh = std::make_shared<TriMesh>(std::move(mesh));
    (rings == 24 ? soft.visual : soft.collision) = surface;
  }
  model.start.q.conservativeResize(model.start.q.size() + 24);
  for (int node = 0; node < 8; ++node)
    model.start.q.segment<3>(soft.layout.qOffset + 3 * node) = cells.nodes[node];
  model.start.v.conservativeResize(model.start.v.size() + 24);
  model.start.v.tail<24>().setZero();
  soft.volume = std::make_shared<TetMesh>(cells);
  model.objects.push_back(soft);

  const Vec3 tip(0.05, 0.03, 0.03);
  TriMesh shaft = sphereMesh(Vec3::Zero(), 0.004, 10);
  for (Vec3& x : shaft.vertices) {
    if (x.y() > 0) x.y() += 0.06;  // a capsule that stands on its tip
    x += tip;
  }
  addRigid(model, "probe", shaft, shaft, tip, {0.70f, 0.72f, 0.75f});
  model.objects.back().tool = true;
  model.objects.back().number = 0;
  model.objects.back().toolIndex = 0;

  for (int i = 0; i < 4; ++i) {
    SpringView spring{0, kBall, kBox, {}, {}, 100};
    spring.a = soft.visual.vertices[1 + 7 * i + 240];
    spring.b.r_B = Vec3(-0.02 + 0.013 * i, 0.03, 0.025);
    model.springs.push_back(spring);
  }
  Part part;
  part.id = "ball";
  part.regions.push_back({"cap", "Cap", "groove", SurfaceKind::Visual, {{0, 300}}});
  model.joint.parts.push_back(part);
  return model;
}

State movedState(const Model& model) {
  State state = model.start;
  const Quat turn(Eigen::AngleAxisd(0.8, Vec3(1, 2, -1).normalized()));
  const int box = model.objects[kBox].layout.qOffset;
  state.q.segment<3>(box) += Vec3(0.005, 0.01, -0.01);
  state.q.segment<4>(box + 3) = turn.coeffs();  // x y z w
  const int ball = model.objects[kBall].layout.qOffset;
  for (int node = 0; node < 8; ++node) {
    auto x = state.q.segment<3>(ball + 3 * node);
    x = Vec3(1.15 * x.x() + 0.2 * x.y(), 0.8 * x.y() + 0.01 * (node & 1), x.z() - 0.15 * x.x());
  }
  return state;
}

Model withFlippedSurface(Model model, int object) {
  TriMesh mesh = *model.objects[object].visual.mesh;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  model.objects[object].visual.mesh = std::make_shared<TriMesh>(std::move(mesh));
  return model;
}

Vec3 expectedPosition(const SceneObject& object, const VertexBinding& binding, const VecX& q) {
  const int at = object.layout.qOffset;
  if (object.layout.rigid) {
    const Quat turn(q[at + 6], q[at + 3], q[at + 4], q[at + 5]);
    return q.segment<3>(at) + turn.toRotationMatrix() * binding.r_B;
  }
  Vec3 p = Vec3::Zero();
  for (int k = 0; k < 4; ++k) p += binding.weight[k] * q.segment<3>(at + 3 * binding.node[k]);
  return p;
}

}  // namespace glenoid::test
