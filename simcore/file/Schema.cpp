// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Schema.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#define VALIJSON_USE_EXCEPTIONS 1  // otherwise a broken schema ends the program
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "simcore/file/SchemaTexts.h"

namespace glenoid {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

struct Known {
  const char* fileName;
  std::string_view text;
  int version;
  JsonLimits limits;
};

/// A recording holds a pose for every step; the others are written by hand or nearly so.
const Known& knownOf(Schema schema) {
  constexpr JsonLimits byHand{64, 64ull << 20}, byClock{64, 256ull << 20};
  static const Known all[kSchemaCount] = {{"joint.schema.json", schema_texts::kJoint, 2, byHand},
                                          {"scenario.schema.json", schema_texts::kScenario, 2, byHand},
                                          {"recording.schema.json", schema_texts::kRecording, 1, byClock},
                                          {"run-report.schema.json", schema_texts::kRunReport, 1, byHand},
                                          {"recipe.schema.json", schema_texts::kRecipe, 1, byHand},
                                          {"run-state.schema.json", schema_texts::kRunState, 1, byClock}};
  return all[static_cast<int>(schema)];
}

/// For valijson; arrays are cut to their first `itemsMax` items.
nlohmann::json toLibrary(const JsonValue& json, std::size_t itemsMax) {
  if (json.isBoolean()) return json.boolean();
  if (json.isInteger()) return json.integer();
  if (json.isNumber()) return json.number();
  if (json.isText()) return json.text();
  if (json.isArray()) {
    nlohmann::json array = nlohmann::json::array();
    const std::size_t count = std::min(itemsMax, json.items().size());
    for (std::size_t i = 0; i < count; ++i) array.push_back(toLibrary(json.items()[i], itemsMax));
    return array;
  }
  if (json.isObject()) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, value] : json.members()) object[key] = toLibrary(value, itemsMax);
    return object;
  }
  return nullptr;
}

std::size_t longestArray(const JsonValue& json) {
  std::size_t longest = json.items().size();
  for (const JsonValue& item : json.items()) longest = std::max(longest, longestArray(item));
  for (const auto& member : json.members()) longest = std::max(longest, longestArray(member.second));
  return longest;
}

/// "<root>", "[parts]", "[3]" → /parts/3
std::string pointerOf(const std::vector<std::string>& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i)
    pointer = pointerTo(pointer, std::string_view(context[i]).substr(1, context[i].size() - 2));
  return pointer;
}

const JsonValue& resolved(const JsonValue& root, const JsonValue& schema) {
  const JsonValue* at = &schema;
  for (int hops = 0; hops < 16; ++hops) {
    const JsonValue* reference = at->find("$ref");
    if (!reference || reference->text().empty() || reference->text()[0] != '#') break;
    const JsonValue* next = valueAt(root, std::string_view(reference->text()).substr(1));
    if (!next) break;
    at = next;
  }
  return *at;
}

/// The part of the schema that speaks about a place of the document, through properties, items and $ref.
const JsonValue& schemaAt(const JsonValue& root, std::string_view pointer) {
  const JsonValue* at = &resolved(root, root);
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view token = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(token.size());
    const JsonValue* next = (*at)["properties"].find(unescapedToken(token));
    if (!next) next = at->find("items");
    if (next && next->isArray()) {  // one schema for each position
      std::size_t index = next->items().size();
      std::from_chars(token.data(), token.data() + token.size(), index);
      next = index < next->items().size() ? &next->items()[index] : nullptr;
    }
    if (!next) next = at->find("additionalProperties");
    static const JsonValue nothing;
    if (!next) return nothing;
    at = &resolved(root, *next);
  }
  return *at;
}

std::string numberText(const JsonValue& json) {
  if (!json.isNumber()) return "";
  std::string text = toText(json);
  text.pop_back();
  return text;
}

const JsonValue& either(const JsonValue& schema, const char* inclusive, const char* exclusive) {
  const JsonValue* bound = schema.find(inclusive);
  return bound ? *bound : schema[exclusive];
}

/// "'density'" out of valijson's sentence, without the quotes.
std::string quotedIn(const std::string& sentence) {
  const std::size_t end = sentence.rfind('\'');
  const std::size_t begin = end == std::string::npos || end == 0 ? end : sentence.rfind('\'', end - 1);
  if (begin == std::string::npos || end == 0) return "";
  return sentence.substr(begin + 1, end - begin - 1);
}

/// Valijson's sentence in the words of somebody who looks at the document.
std::string describe(const std::string& sentence, const JsonValue& schema) {
  const auto says = [&](const char* words) { return sentence.find(words) != std::string::npos; };
  if (says("Missing required property")) return "member \"" + quotedIn(sentence) + "\" is missing";
  if (says("'additionalProperties'")) {
    // The sentence ends "…constraints: 'NAME'."; the name is all that stands behind the colon.
    const std::size_t colon = sentence.find("constraints: '");
    if (colon != std::string::npos)
      return "member \"" + sentence.substr(colon + 14, sentence.size() - colon - 16) + "\" is unknown";
  }
  if (says("'type' constraint")) {
    std::string expected = schema["type"].text();
    for (const JsonValue& type : schema["type"].items())
      expected.append(expected.empty() ? "" : " or ").append(type.text());
    if (!expected.empty()) return "must be of type " + expected;
  }
  if (says("enum values") || says("'const'")) {
    std::string allowed;
    for (const JsonValue& value : schema["enum"].items())
      allowed.append(allowed.empty() ? "" : ", ").append(value.text());
    if (!allowed.empty()) return "must be one of: " + allowed;
  }
  return sentence;
}

Error violation(const valijson::ValidationResults& results, const JsonValue& json, const JsonValue& schema,
                const std::string& file) {
  // The innermost violation comes first; those that only say "a member failed" follow it.
  if (results.numErrors() == 0) return {Fault::SchemaMismatch, {file, {}, {}, {}}, {""}, {}};
  const valijson::ValidationResults::Error& first = *results.begin();
  const Place place{file, pointerOf(first.context), {}, {}};
  const JsonValue& part = schemaAt(schema, place.pointer);
  const JsonValue* value = valueAt(json, place.pointer);
  if (value && value->isNumber() && first.description.rfind("Expected number", 0) == 0)
    return {Fault::OutOfRange,
            place,
            {numberText(*value), numberText(either(part, "minimum", "exclusiveMinimum")),
             numberText(either(part, "maximum", "exclusiveMaximum"))},
            first.description};
  return {Fault::SchemaMismatch, place, {describe(first.description, part)}, first.description};
}

/// Asks for a yes or no, which stops at the first violation; only then for reasons, and of a document cut as
/// short as still shows a violation: valijson collects every one, and a list of a million wrong items would
/// fill the memory.
Result<Done> validateWith(const JsonValue& json, const JsonValue& schemaJson, const std::string& file) {
  valijson::Schema schema;
  const nlohmann::json schemaDocument = toLibrary(schemaJson, std::string::npos);
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(Adapter(schemaDocument), schema);
  valijson::Validator validator(valijson::Validator::kStrongTypes);

  nlohmann::json document = toLibrary(json, std::string::npos);
  if (validator.validate(schema, Adapter(document), nullptr)) return Done{};
  const std::size_t longest = longestArray(json);
  for (std::size_t itemsMax = 64; itemsMax < longest; itemsMax *= 4) {
    nlohmann::json shorter = toLibrary(json, itemsMax);
    if (validator.validate(schema, Adapter(shorter), nullptr)) continue;
    document = std::move(shorter);
    break;
  }
  valijson::ValidationResults results;
  validator.validate(schema, Adapter(document), &results);
  return violation(results, json, schemaJson, file);
}

}  // namespace

const char* schemaFileName(Schema schema) {
  return knownOf(schema).fileName;
}
std::string_view schemaText(Schema schema) {
  return knownOf(schema).text;
}
int schemaVersion(Schema schema) {
  return knownOf(schema).version;
}

Result<Done> validateAgainst(const JsonValue& json, std::string_view schemaText, const std::string& file) {
  const Result<JsonValue> schema = parseJson(schemaText, "schema");
  if (!schema) return Error{Fault::Internal, {file, {}, {}, {}}, {}, "schema: " + toLogLine(schema.error())};
  try {
    return validateWith(json, *schema, file);
  } catch (const std::exception& broken) {  // valijson's answer to a schema that is none
    return Error{Fault::Internal, {file, {}, {}, {}}, {}, broken.what()};
  }
}

Result<Done> checkVersion(const JsonValue& json, Schema schema, const std::string& file) {
  const JsonValue& found = json["schemaVersion"];
  const int known = schemaVersion(schema);
  if (found.isNumber() && found.number() > known)
    return Error{
        Fault::NewerSchema, {file, "/schemaVersion", {}, {}}, {numberText(found), std::to_string(known)}, {}};
  return Done{};
}

Result<Done> validate(const JsonValue& json, Schema schema, const std::string& file) {
  if (const auto known = checkVersion(json, schema, file); !known) return known;
  return validateAgainst(json, schemaText(schema), file);
}

Result<JsonValue> readDocument(const std::string& path, Schema schema) {
  Result<JsonValue> json = readJson(path, knownOf(schema).limits);
  if (!json) return json;
  if (const auto valid = validate(*json, schema, path); !valid) return valid.error();
  return json;
}

}  // namespace glenoid
