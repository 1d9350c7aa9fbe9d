// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ScenarioFile.h"

#include <algorithm>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Schema.h"
#include "simcore/scene/ScenarioJson.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChainMax = 16;
constexpr const char* kBuiltin = "builtin:";

/// Objects member by member; anything else is replaced. Depth is bounded by the parser.
void mergeOnto(JsonValue& base, const JsonValue& over) {
  for (const auto& [key, value] : over.members()) {
    const JsonValue* below = base.find(key);
    if (below && below->isObject() && value.isObject()) {
      JsonValue merged = *below;
      mergeOnto(merged, value);
      base.set(key, std::move(merged));
    } else {
      base.set(key, value);
    }
  }
}

/// A path that was relative to a file in `folder`, relative to the folder from which `folder` is named.
void rebase(JsonValue& json, const char* member, const fs::path& folder) {
  const std::string reference = json[member].text();
  if (reference.empty() || reference.rfind(kBuiltin, 0) == 0 || fs::path(reference).is_absolute()) return;
  json.set(member, (folder / reference).lexically_normal().string());
}

class ScenarioChain {
 public:
  /// The whole document behind `path`, which fits the schema. `chain` holds the files that led here.
  Result<JsonValue> load(const std::string& path) {
    Result<JsonValue> json = readJson(path);
    if (!json) return json;
    if (const auto known = checkVersion(*json, Schema::Scenario, path); !known) return known.error();
    if (const JsonValue* extends = json->find("extends")) {
      Result<JsonValue> base = loadBase(path, *extends);
      if (!base) return base;
      json->erase("extends");
      mergeOnto(*base, *json);
      *json = std::move(*base);
    }
    if (const auto valid = validate(*json, Schema::Scenario, path); !valid) return valid.error();
    return json;
  }

 private:
  Result<JsonValue> loadBase(const std::string& path, const JsonValue& extends) {
    const Place place{path, "/extends", {}, {}};
    const std::string& reference = extends.text();
    if (!extends.isText()) return Error{Fault::SchemaMismatch, place, {"must be of type string"}, {}};
    const fs::path relative(reference);
    if (reference.empty() || reference.rfind(kBuiltin, 0) == 0 || relative.is_absolute())
      return Error{Fault::BadReference, place, {reference}, {}};
    m_files.push_back(identity(path));
    const std::string next = (fs::path(path).parent_path() / relative).string();
    if (std::find(m_files.begin(), m_files.end(), identity(next)) != m_files.end())
      return Error{Fault::CyclicReference, place, {reference}, {}};
    if (m_files.size() >= kChainMax) return Error{Fault::TooDeep, place, {std::to_string(kChainMax)}, {}};
    Result<JsonValue> base = load(next);
    if (!base) return base;
    for (const char* member : {"joint", "input"}) rebase(*base, member, relative.parent_path());
    return base;
  }

  /// One name for one file, however it was reached.
  static std::string identity(const std::string& path) {
    std::error_code failed;
    const fs::path canonical = fs::weakly_canonical(path, failed);
    return failed ? path : canonical.string();
  }

  std::vector<std::string> m_files;
};

/// The first save over a file of an older form keeps it for the program that wrote it.
Result<Done> keepOlder(const std::string& path) {
  const Result<JsonValue> before = readJson(path);
  if (!before) return Done{};  // nothing there that an older program could read
  const auto version = (*before)["schemaVersion"].integer();
  if (version < 1 || version >= schemaVersion(Schema::Scenario)) return Done{};
  const fs::path copy = fs::path(path).replace_extension(".v" + std::to_string(version) + ".json");
  std::error_code ignored;
  if (fs::exists(copy, ignored)) return Done{};
  const auto bytes = readWholeFile(path);
  if (!bytes) return bytes.error();
  return writeWholeFile(copy.string(), *bytes);
}

}  // namespace

Result<Scenario> loadScenario(const std::string& path) {
  const Result<JsonValue> json = ScenarioChain().load(path);
  if (!json) return json.error();
  Scenario scenario = scene_json::toScenario(*json);
  if (const auto good = checkScenario(scenario, path); !good) return good.error();
  return scenario;
}

Result<Done> saveScenario(const Scenario& scenario, const std::string& path) {
  if (const auto good = checkScenario(scenario, path); !good) return good;
  if (const auto kept = keepOlder(path); !kept) return kept;
  return writeJson(path, scene_json::fromScenario(scenario));
}

}  // namespace glenoid
