// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <cstdio>

#include "simcore/base/Utf8.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"

namespace glenoid {
namespace {

constexpr std::size_t kLineMax = 100;

void writeText(const std::string& bytes, std::string& out) {
  const std::string text = asUtf8(bytes);  // a path may be anything, a JSON text may not
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          char escaped[8];
          std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(c));
          out += escaped;
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

void writeNumber(double value, std::string& out) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  if (value == 0 && std::signbit(value)) {  // "-0" would come back as the integer 0
    out += "-0.0";
    return;
  }
  char digits[32];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, value).ptr;  // shortest that reads back the same
  out.append(digits, end);
}

bool isSimple(const JsonValue& json) {
  if (json.isObject()) return json.members().empty();
  for (const JsonValue& item : json.items())
    if (item.isObject() || item.isArray()) return false;
  return true;
}

/// One line without regard to its length.
void writeFlat(const JsonValue& json, std::string& out) {
  if (json.isNull()) out += "null";
  if (json.isBoolean()) out += json.boolean() ? "true" : "false";
  if (json.isInteger())
    out += std::to_string(json.integer());
  else if (json.isNumber())
    writeNumber(json.number(), out);
  if (json.isText()) writeText(json.text(), out);
  if (json.isArray()) {
    out += '[';
    const char* between = "";
    for (const JsonValue& item : json.items()) {
      out += between;
      writeFlat(item, out);
      between = ", ";
    }
    out += ']';
  }
  if (json.isObject()) {
    out += '{';
    const char* between = "";
    for (const auto& [key, value] : json.members()) {
      out += between;
      writeText(key, out);
      out += ": ";
      writeFlat(value, out);
      between = ", ";
    }
    out += '}';
  }
}

/// An object whose members are all simple may stand on one line, like the key of a track.
bool mayBeFlat(const JsonValue& json) {
  for (const auto& member : json.members())
    if (!isSimple(member.second)) return false;
  for (const JsonValue& item : json.items())
    if (item.isObject() || !isSimple(item)) return false;
  return true;
}

void write(const JsonValue& json, std::size_t indent, std::size_t column, std::string& out) {
  if (mayBeFlat(json)) {
    std::string flat;
    writeFlat(json, flat);
    if (column + flat.size() <= kLineMax || (isSimple(json) && !json.isArray())) {
      out += flat;
      return;
    }
  }
  const std::string margin(indent + 2, ' ');
  if (json.isObject()) {
    out += '{';
    const char* between = "\n";
    for (const auto& [key, value] : json.members()) {
      std::string head = margin;
      writeText(key, head);
      head += ": ";
      out += between;
      out += head;
      write(value, indent + 2, head.size() + 1, out);
      between = ",\n";
    }
    out.append("\n").append(indent, ' ').append("}");
    return;
  }
  // Arrays: numbers and short rows fill lines, anything larger gets its own.
  out += '[';
  std::size_t lineStart = 0;
  bool first = true;
  for (const JsonValue& item : json.items()) {
    const bool fills = !item.isObject() && isSimple(item);
    std::string flat;
    if (fills) writeFlat(item, flat);
    const bool sameLine = !first && fills && out.size() - lineStart + 2 + flat.size() <= kLineMax;
    if (!first) out += sameLine ? ", " : ",";
    if (!sameLine) {
      out += '\n';
      lineStart = out.size();
      out += margin;
    }
    if (fills)
      out += flat;
    else
      write(item, indent + 2, margin.size() + 1, out);
    first = false;
  }
  out.append("\n").append(indent, ' ').append("]");
}

/// Pointer of the first number that is not finite, or nothing.
bool findNotFinite(const JsonValue& json, const std::string& pointer, std::string& found) {
  if (json.isNumber() && !std::isfinite(json.number())) {
    found = pointer;
    return true;
  }
  for (std::size_t i = 0; i < json.items().size(); ++i)
    if (findNotFinite(json.items()[i], pointerTo(pointer, i), found)) return true;
  for (const auto& [key, value] : json.members())
    if (findNotFinite(value, pointerTo(pointer, key), found)) return true;
  return false;
}

}  // namespace

std::string toText(const JsonValue& json) {
  std::string text;
  write(json, 0, 0, text);
  text += '\n';
  return text;
}

std::optional<std::string> notFiniteIn(const JsonValue& json) {
  std::string pointer;
  if (findNotFinite(json, {}, pointer)) return pointer;
  return std::nullopt;
}

Result<Done> writeJson(const std::string& path, const JsonValue& json) {
  if (const auto pointer = notFiniteIn(json))
    return Error{Fault::NotFinite, {path, *pointer, {}, {}}, {}, {}};
  return writeWholeFile(path, toText(json));
}

}  // namespace glenoid
