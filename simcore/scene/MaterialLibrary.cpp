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
  // A library is what a joint without parts holds, so one schema says what a material is.
  JsonValue joint = std::move(*json);
  if (joint.isObject()) {
    joint.set("id", JsonValue("library"));
    joint.set("name", JsonValue("library"));
    joint.set("parts", JsonValue::array());
  }
  if (const auto valid = validate(joint, Schema::Joint, file); !valid) return valid.error();
  std::vector<Material> materials = scene_json::vectorOf(joint["materials"], scene_json::toMaterial);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (!ids.insert(materials[i].id).second)
      return Error{Fault::DuplicateId, {file, "/materials/" + std::to_string(i) + "/id", {}, {}}, {materials[i].id}, {}};
  return materials;
}

}  // namespace glenoid
