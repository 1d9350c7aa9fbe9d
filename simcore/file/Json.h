// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"

namespace glenoid {

/// What a document from outside may cost.
struct JsonLimits {
  int depth = 64;                       ///< brackets inside brackets
  std::uint64_t bytes = 64ull << 20;    ///< size of the file
};

/// Parses RFC 8259 JSON; `file` only names it in errors. Fails with
/// FileEmpty (nothing but white space), FileTruncated (ends before its brackets close), TooDeep (argument: limit),
/// NotFinite (NaN, Infinity or a number beyond double), DuplicateId (a key twice in one object; argument: key) or
/// NotJson (arguments: line, column, both from 1). The place holds the JSON pointer reached and, as its
/// element, the line.
Result<JsonValue> parseJson(std::string_view text, const std::string& file, const JsonLimits& limits = {});

/// The same from a file; also fails as readWholeFile does.
Result<JsonValue> readJson(const std::string& path, const JsonLimits& limits = {});

/// Indented text that ends with a line break; short arrays stay on one line. Numbers come back bit for bit. A
/// number that is not finite becomes null: use writeJson, which refuses it.
std::string toText(const JsonValue& json);

/// Pointer of the first number that is not finite; nothing when there is none.
std::optional<std::string> notFiniteIn(const JsonValue& json);

/// Atomic. Fails with NotFinite, naming the pointer, and as writeWholeFile does.
Result<Done> writeJson(const std::string& path, const JsonValue& json);

}  // namespace glenoid
