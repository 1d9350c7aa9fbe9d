// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/MaterialLibrary.h"

#include <set>

#include "simcore/file/Json.h"
#include "simcore/file/Schema.h"
#include "simcore/scene/SceneJson.h"

namespace glenoid {

Result<std::vector<Material>> parseMaterialLibrary(std::string_view text, const std::string& file) {
  auto json = parseJson(text, file);
  if (!json) return json.error();
  // A library is what a joint holds beside its parts, so one schema says what a material is; the part is a
  // stand-in.
  JsonValue joint = std::move(*json);
  if (joint.isObject()) {
    joint.set("id", JsonValue("library"));
    joint.set("name", JsonValue("library"));
    JsonValue part, parts = JsonValue::array();
    part.set("id", JsonValue("part"));
    part.set("number", JsonValue(1));
    part.set("kind", JsonValue("rigid"));
    part.set("visual", JsonValue("none"));
    part.set("collision", JsonValue("none"));
    parts.append(std::move(part));
    joint.set("parts", std::move(parts));
  }
  if (const auto valid = validate(joint, Schema::Joint, file); !valid) return valid.error();
  std::vector<Material> materials = scene_json::vectorOf(joint["materials"], scene_json::toMaterial);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (!ids.insert(materials[i].id).second)
      return Error{Fault::DuplicateId,
                   {file, "/materials/" + std::to_string(i) + "/id", {}, {}},
                   {materials[i].id},
                   {}};
  return materials;
}

}  // namespace glenoid
