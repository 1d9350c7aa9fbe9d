// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecipeSource.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "simcore/base/PlainMath.h"
#include "simcore/file/Json.h"
#include "simcore/file/Ply.h"
#include "simcore/import/ImportSurfaces.h"
#include "simcore/import/LengthUnit.h"
#include "simcore/import/MeshFormat.h"
#include "simcore/scene/SceneJson.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

/// The part's entries, and the recipe's where the part has none.
JsonValue merged(const JsonValue& general, const JsonValue& own) {
  JsonValue out = general.isObject() ? general : JsonValue::object();
  for (const auto& [key, value] : own.members()) out.set(key, value);
  return out;
}

/// Turns by quarters are exact.
Mat3 turnAbout(int axis, double angle) {
  const auto tidy = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : std::abs(std::abs(x) - 1) < 1e-15 ? std::copysign(1.0, x) : x; };
  const double c = tidy(plain::cosine(angle)), s = tidy(plain::sine(angle));
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  Mat3 R = Mat3::Identity();
  R(i, i) = R(j, j) = c;
  R(i, j) = -s;
  R(j, i) = s;
  return R;
}

/// The schema has judged the form.
Result<SurfaceSource> toSource(const JsonValue& json, const Place& place, bool visual) {
  SurfaceSource source;
  const auto wrong = [&](const char* key, const std::string& what) {
    Place at = place;
    at.pointer = at.pointer.substr(0, at.pointer.rfind('/')) + "/source/" + key;
    return Error{Fault::SchemaMismatch, at, {what}, {}};
  };
  if (const std::string& unit = json["unit"].text(); !unit.empty()) source.metresPerUnit = metresIn(unit);
  if (json["axes"].items().size() == 3) {
    const auto map = axisMapFrom({json["axes"][0].text(), json["axes"][1].text(), json["axes"][2].text()});
    if (!map) return wrong("axes", map.error().arguments[0]);
    source.axes = *map;
  }
  // About X, then about Y, then about Z; only with a turn or a scale, so that others keep their bits.
  if (json.find("turn") || json.find("scale")) {
    const Vec3 radians = scene_json::toVec3(json["turn"]) * (std::numbers::pi / 180);
    source.turn_W = json["scale"].number(1) * (turnAbout(2, radians.z()) * turnAbout(1, radians.y()) * turnAbout(0, radians.x()));
    source.about_W = scene_json::toVec3(json["about"]);
  }
  if (json.find("translate")) source.translate_W = scene_json::toVec3(json["translate"]);
  source.surface = json["surface"].text();
  if (json["shell"].isText()) source.shell = 0;  // "largest"
  if (json["shell"].isInteger()) source.shell = static_cast<int>(json["shell"].integer());
  for (const JsonValue& word : json["repairs"].items()) {
    const auto step = repairStepFrom(word.text());
    if (!step) return wrong("repairs", step.error().arguments[0]);
    source.repairs.push_back(*step);
  }
  source.thicken = json["thicken"].number();
  if (visual) source.simplify = static_cast<int>(json["simplifyVisual"].integer());
  return source;
}

}  // namespace

Result<std::shared_ptr<const TriMesh>> RecipeSurfaces::load(const std::string& name, const JsonValue& own, const Place& place, bool visual) {
  if (!scene_json::staysInside(name)) return Error{Fault::BadReference, place, {name}, {}};
  const bool prepared = m_general.isObject() || own.isObject() || formatByEnding(name) != MeshFormat::Ply;
  const JsonValue wishes = merged(m_general, own);
  const std::string key = prepared ? name + '\n' + toText(wishes) + (visual ? "v" : "c") : name;
  if (const auto found = m_known.find(key); found != m_known.end()) return found->second;
  const std::string path = (fs::path(m_folder) / name).string();
  const auto inPart = [&](Error error) {
    error.place.part = place.part;
    if (error.place.file.empty()) error.place.file = path;
    return error;
  };
  if (!prepared) {
    Result<TriMesh> mesh = readPly(path);
    if (!mesh) return inPart(mesh.error());
    return m_known[key] = std::make_shared<const TriMesh>(std::move(*mesh));
  }
  const Result<SurfaceSource> source = toSource(wishes, place, visual);
  if (!source) return source.error();
  auto file = m_files.find(name);
  if (file == m_files.end()) {
    Result<ImportedFile> read = importSurfaces(path);
    if (!read) return inPart(read.error());
    file = m_files.emplace(name, std::move(*read)).first;
  }
  Result<PreparedSurface> surface = prepareSurface(file->second, *source);
  if (!surface) {  // a wish that does not fit the file is the recipe's, a mesh that cannot be mended the file's
    const bool wish = surface.error().fault == Fault::SchemaMismatch || surface.error().fault == Fault::UnknownId;
    if (!wish) return inPart(surface.error());
    surface.error().place = place;
    return surface.error();
  }
  m_reports.push_back({place.part, name, surface->format, surface->metresPerUnit, surface->notes, surface->changes, surface->trianglesBefore,
                       static_cast<long>(surface->mesh.triangles.size())});
  return m_known[key] = std::make_shared<const TriMesh>(std::move(surface->mesh));
}

}  // namespace glenoid
