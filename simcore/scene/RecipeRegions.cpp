// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecipeRegions.h"

#include <algorithm>

#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/scene/SceneJson.h"

namespace glenoid {
namespace {

std::vector<int> trianglesInBall(const TriMesh& mesh, const Vec3& centre, double radius) {
  std::vector<int> out;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int corner : mesh.triangles[static_cast<std::size_t>(t)]) middle += mesh.vertices[static_cast<std::size_t>(corner)] / 3;
    if ((middle - centre).norm() <= radius) out.push_back(t);
  }
  return out;
}

class Finder {
 public:
  Finder(const std::vector<PartRecipe>& parts, const PartRecipe& part, std::size_t known) : m_parts(parts), m_part(part), m_known(known) {}

  /// The triangles that one formula stands for; nothing, with `unknown` told, where it names what is not there.
  std::optional<std::vector<int>> find(const JsonValue& json) {
    std::optional<std::vector<int>> out;
    // Several in one region are what they have in common: near the humerus, and in the ball.
    const auto take = [&](std::optional<std::vector<int>> more) {
      if (!more) return false;
      out = out ? common(*out, *more) : std::move(*more);
      return true;
    };
    if (const JsonValue* near = json.find("near"))
      if (!take(nearTo((*near)["part"].text(), (*near)["within"].number()))) return std::nullopt;
    if (const JsonValue* ball = json.find("ball"); ball && !take(trianglesInBall(*m_part.visual, scene_json::toVec3((*ball)["centre"]), (*ball)["radius"].number()))) return std::nullopt;
    for (const char* key : {"union", "intersection", "difference"})
      if (const JsonValue* names = json.find(key))
        if (!take(combined(key, names->items()))) return std::nullopt;
    if (const JsonValue* other = json.find("complement")) {
      const auto set = named(other->text());
      if (!set || !take(inverted(*m_part.visual, *set))) return std::nullopt;
    }
    return out;
  }
  const std::string& unknown() const { return m_unknown; }
  const char* kind() const { return m_kind; }

 private:
  std::optional<std::vector<int>> nearTo(const std::string& id, double within) {
    const auto other = std::find_if(m_parts.begin(), m_parts.end(), [&](const PartRecipe& p) { return p.id == id; });
    if (other != m_parts.end() && id != m_part.id) return trianglesNear(*m_part.visual, *other->visual, within);
    m_unknown = id, m_kind = "another part";
    return std::nullopt;
  }

  std::optional<std::vector<int>> named(const std::string& id) {
    for (std::size_t r = 0; r < m_known; ++r)
      if (m_part.regions[r].id == id) return trianglesOf(m_part.regions[r]);
    m_unknown = id, m_kind = "a region of the same part that stands before it";
    return std::nullopt;
  }

  std::optional<std::vector<int>> combined(std::string_view how, const JsonValue::Items& names) {
    std::optional<std::vector<int>> out;
    for (const JsonValue& name : names) {
      auto set = named(name.text());
      if (!set) return std::nullopt;
      if (!out) out = std::move(set);
      else out = how == "union" ? united(*out, *set) : how == "intersection" ? common(*out, *set) : without(*out, *set);
    }
    return out;
  }

  const std::vector<PartRecipe>& m_parts;
  const PartRecipe& m_part;
  std::size_t m_known;
  std::string m_unknown;
  const char* m_kind = "";
};

}  // namespace

Result<Done> fillRegions(std::vector<PartRecipe>& parts, const JsonValue& json, const std::string& file) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    PartRecipe& part = parts[p];
    const JsonValue& regions = json["parts"][p]["regions"];
    for (std::size_t r = 0; r < part.regions.size(); ++r) {
      if (regions[r].find("triangles")) continue;
      const Place place{file, pointerTo(pointerTo("/parts", p) + "/regions", r), part.id, {}};
      Finder finder(parts, part, r);
      const auto triangles = finder.find(regions[r]);
      if (!triangles) return Error{Fault::UnknownId, place, {finder.unknown(), finder.kind()}, "a region of a recipe"};
      if (triangles->empty()) return Error{Fault::Unusable, place, {"the region “" + part.regions[r].id + "” has no triangle of the surface"}, "a region of a recipe"};
      part.regions[r].triangles = runsOf(*triangles);
    }
  }
  return Done{};
}

}  // namespace glenoid
