// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/file/Json.h"

namespace glenoid {

/// The formats we define. Their JSON Schemas (draft 7) are in resources/schemas and inside the program.
enum class Schema { Joint, Scenario, Recording, RunReport, Recipe, RunState };
inline constexpr int kSchemaCount = 6;

/// File name in resources/schemas and its text.
const char* schemaFileName(Schema schema);
std::string_view schemaText(Schema schema);

/// Newest `schemaVersion` that this program reads.
int schemaVersion(Schema schema);

/// NewerSchema (arguments: found, known) when the document says it was written by a newer program.
Result<Done> checkVersion(const JsonValue& json, Schema schema, const std::string& file);

/// First checkVersion, then the whole schema: OutOfRange (arguments: value, low, high; "" where there is no bound) for
/// a number outside its bounds, SchemaMismatch (argument: what, English) for anything else. The place holds the JSON
/// pointer of the first violation.
Result<Done> validate(const JsonValue& json, Schema schema, const std::string& file);

/// The same against any schema, without the version. Fails with Internal when the schema itself is broken.
Result<Done> validateAgainst(const JsonValue& json, std::string_view schemaText, const std::string& file);

/// readJson and validate.
Result<JsonValue> readDocument(const std::string& path, Schema schema);

}  // namespace glenoid
