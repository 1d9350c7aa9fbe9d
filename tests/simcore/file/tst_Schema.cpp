// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/file/Schema.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

constexpr Schema kAll[] = {Schema::Joint, Schema::Scenario, Schema::Recording, Schema::RunReport,
                           Schema::Recipe, Schema::RunState};

constexpr const char* kSmall = R"({
  "type": "object", "required": ["size"], "additionalProperties": false,
  "properties": {
    "size": {"type": "number", "exclusiveMinimum": 0, "maximum": 10},
    "kind": {"enum": ["rigid", "soft"]},
    "list": {"type": "array", "items": {"$ref": "#/definitions/item"}}
  },
  "definitions": {"item": {"type": "object", "required": ["n"],
                           "properties": {"n": {"type": "integer", "minimum": 1}, "a/b": {"type": "string"}}}}
})";

Error violation(const std::string& text) {
  const auto json = parseJson(text, "t");
  EXPECT_TRUE(json.ok());
  const auto valid = validateAgainst(*json, kSmall, "file.json");
  EXPECT_FALSE(valid.ok()) << text;
  return valid.ok() ? Error{} : valid.error();
}

TEST(Schema, shippedSchemasAreTheOnesInside) {
  for (const Schema schema : kAll) {
    const auto shipped =
        readJson(std::string(GLENOID_SOURCE_DIR) + "/resources/schemas/" + schemaFileName(schema));
    ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
    const auto inside = parseJson(schemaText(schema), schemaFileName(schema));
    ASSERT_TRUE(inside.ok());
    EXPECT_EQ(*shipped, *inside);
  }
}

/// A schema that means nothing lets everything pass; each of ours must refuse these, and not as broken
/// itself.
TEST(Schema, everySchemaIsSoundAndRefusesNonsense) {
  for (const Schema schema : kAll)
    for (const char* text :
         {"{}", "[]", "1", R"({"schemaVersion": 1})", R"({"schemaVersion": 1, "unknown": 2})"}) {
      const auto valid = validate(*parseJson(text, "t"), schema, "t");
      ASSERT_FALSE(valid.ok()) << schemaFileName(schema) << text;
      EXPECT_EQ(valid.error().fault, Fault::SchemaMismatch)
          << schemaFileName(schema) << toLogLine(valid.error());
    }
}

/// $ref that leads nowhere would be found only when a document comes that far.
void expectReferencesResolve(const JsonValue& root, const JsonValue& json, const char* file) {
  if (const JsonValue* reference = json.find("$ref")) {
    ASSERT_EQ(reference->text().rfind("#/", 0), 0u) << file;
    EXPECT_TRUE(valueAt(root, reference->text().substr(1))) << file << " " << reference->text();
  }
  for (const auto& member : json.members()) expectReferencesResolve(root, member.second, file);
  for (const JsonValue& item : json.items()) expectReferencesResolve(root, item, file);
}

TEST(Schema, referencesInsideResolveAndNoPatternMeetsForeignText) {
  for (const Schema schema : kAll) {
    const JsonValue root = *parseJson(schemaText(schema), "t");
    expectReferencesResolve(root, root, schemaFileName(schema));
    // std::regex recurses once for each character: a long string would end the program. (Reports are only
    // written.)
    if (schema == Schema::RunReport) continue;
    EXPECT_EQ(schemaText(schema).find("\"pattern"), std::string_view::npos) << schemaFileName(schema);
  }
}

TEST(Schema, aFittingDocumentPasses) {
  EXPECT_TRUE(
      validateAgainst(*parseJson(R"({"size": 10, "kind": "soft", "list": [{"n": 1}]})", "t"), kSmall, "f")
          .ok());
}

TEST(Schema, boundsAreNamed) {
  const Error above = violation(R"({"size": 10.5})");
  EXPECT_EQ(above.fault, Fault::OutOfRange);
  EXPECT_EQ(above.place.pointer, "/size");
  EXPECT_EQ(above.place.file, "file.json");
  EXPECT_EQ(above.arguments, (Arguments{"10.5", "0", "10"}));
  EXPECT_EQ(violation(R"({"size": 0})").fault, Fault::OutOfRange);
  const Error below = violation(R"({"size": 1, "list": [{"n": 3}, {"n": 0}]})");
  EXPECT_EQ(below.fault, Fault::OutOfRange);
  EXPECT_EQ(below.place.pointer, "/list/1/n");
  EXPECT_EQ(below.arguments, (Arguments{"0", "1", ""}));
}

TEST(Schema, otherViolationsSayWhatAndWhere) {
  struct Case {
    const char *text, *pointer, *what;
  };
  for (const Case& c :
       {Case{R"({"kind": "soft"})", "", "member \"size\" is missing"},
        Case{R"({"size": 1, "it's": 2})", "", "member \"it's\" is unknown"},
        Case{R"({"size": "1"})", "/size", "must be of type number"},
        Case{R"({"size": 1, "kind": "hard"})", "/kind", "must be one of: rigid, soft"},
        Case{R"({"size": 1, "list": [{"n": 1}, {}]})", "/list/1", "member \"n\" is missing"},
        Case{R"({"size": 1, "list": [{"n": 1.5}]})", "/list/0/n", "must be of type integer"},
        Case{R"({"size": 1, "list": [{"n": 1, "a/b": 1}]})", "/list/0/a~1b", "must be of type string"}}) {
    const Error error = violation(c.text);
    EXPECT_EQ(error.fault, Fault::SchemaMismatch) << c.text;
    EXPECT_EQ(error.place.pointer, c.pointer) << c.text;
    EXPECT_EQ(error.arguments, Arguments{c.what}) << c.text;
  }
}

TEST(Schema, theFirstOfManyWrongItemsIsFoundWithoutListingThemAll) {
  JsonValue list = JsonValue::array();
  for (int i = 0; i < 200000; ++i) list.append(i < 1000 ? *parseJson(R"({"n": 1})", "t") : JsonValue(1));
  JsonValue json = JsonValue::object();
  json.set("size", 1);
  json.set("list", list);
  const auto valid = validateAgainst(json, kSmall, "f");
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().place.pointer, "/list/1000");
}

TEST(Schema, newerVersionsAreNamedBeforeAnythingElse) {
  for (const Schema schema : kAll) {
    const auto valid = validate(*parseJson(R"({"schemaVersion": 7, "future": []})", "t"), schema, "f");
    ASSERT_FALSE(valid.ok());
    EXPECT_EQ(valid.error().fault, Fault::NewerSchema);
    EXPECT_EQ(valid.error().place.pointer, "/schemaVersion");
    EXPECT_EQ(valid.error().arguments, (Arguments{"7", std::to_string(schemaVersion(schema))}));
  }
  EXPECT_EQ(validate(*parseJson(R"({"schemaVersion": 1e300})", "t"), Schema::Joint, "f").error().fault,
            Fault::NewerSchema);
  EXPECT_EQ(validate(*parseJson(R"({"schemaVersion": "9"})", "t"), Schema::Joint, "f").error().fault,
            Fault::SchemaMismatch);
}

TEST(Schema, aBrokenSchemaIsABugOfOurs) {
  for (const char* schema : {"{", R"({"type": "no-such-type"})", R"({"properties": 3})"})
    EXPECT_EQ(validateAgainst(JsonValue::object(), schema, "f").error().fault, Fault::Internal) << schema;
}

}  // namespace
}  // namespace glenoid
