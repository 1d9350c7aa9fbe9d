// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/gltf/GltfNodes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace glenoid {
namespace {

/// The numbers of an array of just that many; nothing for another length or what is no number.
template <int N>
std::optional<Eigen::Matrix<double, N, 1>> numbersIn(const JsonValue& json, const Eigen::Matrix<double, N, 1>& otherwise) {
  if (json.isNull()) return otherwise;
  if (json.items().size() != N) return std::nullopt;
  Eigen::Matrix<double, N, 1> out;
  for (int i = 0; i < N; ++i) {
    if (!json[i].isNumber()) return std::nullopt;
    out[i] = json[i].number();
  }
  return out;
}

std::optional<Eigen::Matrix4d> ownTransform(const JsonValue& node) {
  using Vec16 = Eigen::Matrix<double, 16, 1>;
  if (!node["matrix"].isNull()) {
    const auto columns = numbersIn<16>(node["matrix"], Vec16::Zero());
    if (!columns) return std::nullopt;
    return Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix4d>(columns->data()));
  }
  const auto shift = numbersIn<3>(node["translation"], Eigen::Vector3d::Zero()), scale = numbersIn<3>(node["scale"], Eigen::Vector3d::Ones());
  const auto turn = numbersIn<4>(node["rotation"], Eigen::Vector4d(0, 0, 0, 1));
  if (!shift || !scale || !turn || turn->norm() == 0) return std::nullopt;
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = Eigen::Quaterniond(turn->normalized()).toRotationMatrix() * scale->asDiagonal();
  m.topRightCorner<3, 1>() = *shift;
  return m;
}

}  // namespace

Result<GltfNodes> placeNodes(const GltfFile& file, const std::string& path) {
  const JsonValue& nodes = file.json()["nodes"];
  const std::size_t count = nodes.items().size();
  const auto badIndex = [&](std::int64_t index) { return Error{Fault::BadIndex, {path, "/nodes", {}, {}}, {std::to_string(index), std::to_string(count)}, "glTF"}; };
  GltfNodes out;
  out.toRoot.assign(count, Eigen::Matrix4d::Identity());
  out.shown.assign(count, false);
  std::vector<std::int64_t> parent(count, -1), root;
  for (std::size_t i = 0; i < count; ++i) {
    const auto own = ownTransform(nodes[i]);
    if (!own) return file.bad("the transform of a node is none", pointerTo("/nodes", i));
    out.toRoot[i] = *own;
    for (const JsonValue& child : nodes[i]["children"].items()) {
      const std::int64_t c = child.integer(-1);
      if (c < 0 || c >= static_cast<std::int64_t>(count)) return badIndex(c);
      parent[static_cast<std::size_t>(c)] = static_cast<std::int64_t>(i);
    }
  }
  const std::vector<Eigen::Matrix4d> own = out.toRoot;
  std::vector<std::int64_t> top(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t steps = 0;
    top[i] = static_cast<std::int64_t>(i);
    for (std::int64_t p = parent[i]; p >= 0; p = parent[static_cast<std::size_t>(p)]) {
      if (++steps > count || steps > 1000) return Error{Fault::CyclicReference, {path, pointerTo("/nodes", i), {}, {}}, {"node " + std::to_string(i)}, "glTF"};
      out.toRoot[i] = own[static_cast<std::size_t>(p)] * out.toRoot[i];
      top[i] = p;
    }
  }
  const JsonValue& scenes = file.json()["scenes"];
  if (scenes.items().empty()) return out;
  out.scene = file.json()["scene"].integer(0);
  if (out.scene < 0 || out.scene >= static_cast<std::int64_t>(scenes.items().size())) out.scene = 0;
  std::vector<bool> shownTop(count, false);
  for (const JsonValue& node : scenes[static_cast<std::size_t>(out.scene)]["nodes"].items()) {
    const std::int64_t i = node.integer(-1);
    if (i < 0 || i >= static_cast<std::int64_t>(count)) return badIndex(i);
    shownTop[static_cast<std::size_t>(i)] = true;
  }
  for (std::size_t i = 0; i < count; ++i) out.shown[i] = shownTop[static_cast<std::size_t>(top[i])];
  return out;
}

Result<SkinnedPoints> skinnedPoints(GltfFile& file, const GltfNodes& nodes, const JsonValue& skin, const JsonValue& attributes) {
  const auto points = file.values(attributes["POSITION"].integer(-1));
  if (!points) return points.error();
  const auto& joints = skin["joints"].items();
  std::vector<Eigen::Matrix4d> move(joints.size(), Eigen::Matrix4d::Identity());
  if (!skin["inverseBindMatrices"].isNull()) {
    const auto binds = file.values(skin["inverseBindMatrices"].integer(-1));
    if (!binds) return binds.error();
    if (binds->rows() != 16 || binds->cols() < static_cast<Eigen::Index>(joints.size())) return file.bad("a skin has fewer matrices than joints");
    for (std::size_t j = 0; j < joints.size(); ++j) move[j] = Eigen::Map<const Eigen::Matrix4d>(binds->col(static_cast<Eigen::Index>(j)).data());
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::int64_t node = joints[j].integer(-1);
    if (node < 0 || node >= static_cast<std::int64_t>(nodes.toRoot.size()))
      return Error{Fault::BadIndex, file.bad({}).place, {std::to_string(node), std::to_string(nodes.toRoot.size())}, "glTF"};
    move[j] = nodes.toRoot[static_cast<std::size_t>(node)] * move[j];
  }
  const Eigen::Index count = points->cols();
  std::vector<Eigen::Matrix4d> blend(static_cast<std::size_t>(count), Eigen::Matrix4d::Zero());
  std::vector<double> total(static_cast<std::size_t>(count), 0);
  bool any = false;
  for (int set = 0;; ++set) {
    const JsonValue &named = attributes["JOINTS_" + std::to_string(set)], &weighed = attributes["WEIGHTS_" + std::to_string(set)];
    if (named.isNull() || weighed.isNull()) break;
    const auto which = file.values(named.integer(-1)), weights = file.values(weighed.integer(-1));
    if (!which) return which.error();
    if (!weights) return weights.error();
    if (which->rows() != 4 || weights->rows() != 4 || which->cols() != count || weights->cols() != count) return file.bad("a surface has fewer joints than points");
    any = true;
    for (Eigen::Index i = 0; i < count; ++i)
      for (int k = 0; k < 4; ++k) {
        const double w = (*weights)(k, i);
        if (!(w > 0)) continue;
        const double j = (*which)(k, i);
        if (!(j < static_cast<double>(move.size()))) return Error{Fault::BadIndex, file.bad({}).place, {std::to_string(static_cast<long long>(j)), std::to_string(move.size())}, "glTF"};
        blend[static_cast<std::size_t>(i)] += w * move[static_cast<std::size_t>(j)];
        total[static_cast<std::size_t>(i)] += w;
      }
  }
  if (points->rows() != 3 || !any) return file.bad("a surface with a skin has no joints at its points");
  SkinnedPoints out;
  out.points.resize(3, count);
  Eigen::Index mirrored = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double sum = total[static_cast<std::size_t>(i)];
    const Eigen::Matrix4d m = sum > 0 ? Eigen::Matrix4d(blend[static_cast<std::size_t>(i)] / sum) : Eigen::Matrix4d(Eigen::Matrix4d::Identity());  // weights that are bytes do not add up to one
    out.points.col(i) = m.topLeftCorner<3, 3>() * points->col(i) + m.topRightCorner<3, 1>();
    mirrored += m.topLeftCorner<3, 3>().determinant() < 0;
  }
  out.mirrored = 2 * mirrored > count;
  return out;
}

}  // namespace glenoid
