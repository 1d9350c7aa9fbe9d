// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/FileAxes.h"

#include <algorithm>

#include "simcore/import/LengthUnit.h"

namespace glenoid {
namespace {

constexpr std::size_t kHead = 1u << 16;  ///< bytes in which headers and comments are looked for

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
  return text;
}

/// Calls `take` with what follows the mark on each line of the head that begins with it.
template <class Take>
void eachComment(std::string_view bytes, std::string_view mark, std::string_view end, Take&& take) {
  std::string_view head = bytes.substr(0, kHead);
  while (!head.empty()) {
    const std::size_t length = std::min(head.find_first_of("\r\n"), head.size());
    const std::string_view line = trimmed(head.substr(0, length));
    head.remove_prefix(std::min(length + 1, head.size()));
    if (!end.empty() && line == end) return;
    if (line.substr(0, mark.size()) == mark) take(trimmed(line.substr(mark.size())));
  }
}

FileAxes spaceInComments(std::string_view bytes, std::string_view mark, std::string_view end) {
  FileAxes axes = FileAxes::Unsaid;
  eachComment(bytes, mark, end, [&](std::string_view comment) {
    if (axes == FileAxes::Unsaid) axes = spaceIn(comment);
  });
  return axes;
}

FileAxes spaceOfVtk(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, kHead);
  const std::size_t first = head.find('\n');
  if (first == std::string_view::npos) return FileAxes::Unsaid;
  const std::size_t second = std::min(head.find('\n', first + 1), head.size());
  if (const FileAxes title = spaceIn(head.substr(first + 1, second - first - 1)); title != FileAxes::Unsaid) return title;
  constexpr std::string_view kField = "\nSPACE 1 1 string";  // a field keeps its value on the line after
  const std::size_t at = head.find(kField);
  if (at == std::string_view::npos) return FileAxes::Unsaid;
  const std::string_view after = trimmed(head.substr(at + kField.size(), 16));
  return spaceNamed(after.substr(0, 3));
}

FileAxes upOfDae(std::string_view bytes) {
  constexpr std::string_view kTag = "<up_axis>";
  const std::size_t at = bytes.substr(0, 1u << 20).find(kTag);
  if (at == std::string_view::npos) return FileAxes::YUp;  // the format's default
  const std::string_view word = trimmed(bytes.substr(at + kTag.size(), 16));
  return word.starts_with("X_UP") ? FileAxes::XUp : word.starts_with("Z_UP") ? FileAxes::ZUp : FileAxes::YUp;
}

/// The property "UpAxis" of the global settings: 0, 1 or 2. Text: P: "UpAxis", "int", "Integer", "",1. Binary: strings with their
/// length before them, then 'I' and four bytes.
FileAxes upOfFbx(std::string_view bytes) {
  const auto axis = [](int value) { return value == 0 ? FileAxes::XUp : value == 1 ? FileAxes::YUp : value == 2 ? FileAxes::ZUp : FileAxes::Unsaid; };
  if (const std::size_t at = bytes.find("\"UpAxis\""); at != std::string_view::npos) {
    const std::string_view line = bytes.substr(at, std::min(bytes.find_first_of("\r\n", at), bytes.size()) - at);
    const std::string_view value = trimmed(line.substr(line.rfind(',') + 1));
    return value.size() == 1 ? axis(value[0] - '0') : FileAxes::Unsaid;
  }
  static constexpr char kName[] = "S\6\0\0\0UpAxisS\3\0\0\0intS\7\0\0\0IntegerS\0\0\0\0I";
  const std::string_view name(kName, sizeof kName - 1);
  const std::size_t at = bytes.find(name);
  if (at == std::string_view::npos || at + name.size() >= bytes.size()) return FileAxes::Unsaid;
  return axis(bytes[at + name.size()]);
}

}  // namespace

FileAxes spaceNamed(std::string_view word) {
  const std::string name = upper(word);
  return name == "LPS" ? FileAxes::Lps : name == "RAS" ? FileAxes::Ras : FileAxes::Unsaid;
}

FileAxes spaceIn(std::string_view text) {
  const std::string words = upper(text);
  const std::size_t at = words.find("SPACE=");
  return at == std::string::npos ? FileAxes::Unsaid : spaceNamed(std::string_view(words).substr(at + 6, 3));
}

FileAxes axesSaidIn(std::string_view bytes, MeshFormat format) {
  switch (format) {
    case MeshFormat::Stl: return spaceIn(bytes.substr(0, std::min<std::size_t>(80, bytes.find_first_of("\r\n"))));
    case MeshFormat::Obj: return spaceInComments(bytes, "#", {});
    case MeshFormat::Ply: return spaceInComments(bytes, "comment", "end_header");
    case MeshFormat::VtkLegacy: return spaceOfVtk(bytes);
    case MeshFormat::Dae: return upOfDae(bytes);
    case MeshFormat::Fbx: return upOfFbx(bytes);
    case MeshFormat::Gltf:
    case MeshFormat::Glb: return FileAxes::YUp;  // the format's own
    default: return FileAxes::Unsaid;
  }
}

ObjComments objComments(std::string_view bytes) {
  ObjComments out;
  eachComment(bytes, "#", {}, [&](std::string_view comment) {
    const std::size_t colon = comment.find(':');
    if (colon == std::string_view::npos) return;
    const std::string key = upper(trimmed(comment.substr(0, colon)));
    const std::string_view value = trimmed(comment.substr(colon + 1));
    if (key == "ENGLISH NAME" && out.name.empty()) out.name = value;
    // "Bounds(mm)": the unit stands in brackets
    if (key.starts_with("BOUNDS(") && key.back() == ')') {
      const std::string_view written = trimmed(comment.substr(0, colon));
      out.metresPerUnit = metresIn(written.substr(7, written.size() - 8));
    }
  });
  return out;
}

}  // namespace glenoid
