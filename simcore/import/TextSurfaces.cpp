// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/TextSurfaces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace glenoid {
namespace {

constexpr std::string_view kObject = "glenoid-object-";  ///< and its number from 0

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view withoutBlanks(std::string_view line) {
  while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
  while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
  return line;
}

/// Takes a line with its end (LF, CR or both) off the front.
std::string_view nextLine(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  std::size_t after = end;
  if (after < text.size()) after += text[after] == '\r' && after + 1 < text.size() && text[after + 1] == '\n' ? 2 : 1;
  text.remove_prefix(after);
  return line;
}

/// Takes a word off the front, in lower case; what is left begins behind the blanks after it.
std::string nextWord(std::string_view& line) {
  std::size_t end = 0;
  while (end < line.size() && !isBlank(line[end])) ++end;
  std::string word(line.substr(0, end));
  for (char& c : word) c = lower(c);
  line = withoutBlanks(line.substr(end));
  return word;
}

/// Text that begins with “solid” and soon says “facet” or “endsolid”; binary files may begin with “solid” too.
bool isTextStl(std::string_view bytes) {
  std::string start(bytes.substr(0, 8192));
  for (char& c : start) c = lower(c);
  std::size_t at = start.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  while (at < start.size() && (isBlank(start[at]) || start[at] == '\r' || start[at] == '\n')) ++at;
  return start.compare(at, 5, "solid") == 0 && start.find('\0') == std::string::npos &&
         (start.find("facet", at) != std::string::npos || start.find("endsolid", at) != std::string::npos);
}

Result<TextSurfaces> textStl(std::string_view bytes, const std::string& path) {
  TextSurfaces out;
  std::string last;
  bool ended = false;
  out.bytes.reserve(bytes.size());
  if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3);
  while (!bytes.empty()) {
    std::string_view line = withoutBlanks(nextLine(bytes));
    if (line.empty()) continue;
    std::string word = nextWord(line);
    if (word == "solid") {
      out.names.emplace_back(line);
      line = {};
    } else if (word == "facet" || word == "outer") {
      const std::string second = nextWord(line);  // normal, loop
      word += " " + second;
    } else if (word == "endsolid") {
      line = {};
    }
    last = word;
    ended = word == "endsolid" || (ended && word != "solid");
    out.bytes += word;
    if (word == "solid") out.bytes += " surface";
    if (!line.empty()) out.bytes.append(" ").append(line);
    out.bytes += '\n';
  }
  // Some writers leave the last “endsolid” out; none stops within a triangle.
  if (!ended && last != "endfacet" && last != "solid") return Error{Fault::FileTruncated, {path, {}, {}, {}}, {}, "STL"};
  out.named = true;
  return out;
}

/// What writers call every solid of theirs (ITK, three, VTK …): no name.
bool saysNothing(std::string name) {
  for (char& c : name) c = lower(c);
  static constexpr std::array<std::string_view, 7> kWords{"ascii", "exported", "stl", "mesh", "default", "unnamed", "visualization toolkit generated sla file"};
  return std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

}  // namespace

Result<TextSurfaces> stlForReader(std::string_view bytes, const std::string& path) {
  if (isTextStl(bytes)) return textStl(bytes, path);
  const auto fail = [&](Fault fault, const char* what) { return Error{fault, {path, {}, {}, {}}, {what}, "STL"}; };
  if (bytes.size() < 84) return fail(Fault::BadMesh, "it is neither a text STL nor long enough for a binary one");
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  const std::uint64_t wanted = 84 + 50 * static_cast<std::uint64_t>(count);
  if (count == 0) return fail(Fault::BadMesh, "it holds no triangles");
  if (wanted > bytes.size()) {
    // Text of another format has letters where a binary file counts its triangles.
    const std::string_view number = bytes.substr(80, 4);
    if (std::all_of(number.begin(), number.end(), [](char c) { return c >= ' ' && c <= '~'; }) ||
        bytes.substr(0, std::min<std::size_t>(bytes.size(), 1024)).find('\0') == std::string_view::npos)
      return fail(Fault::BadMesh, "its content is not that of an STL file");
    return Error{Fault::FileTruncated, {path, {}, {}, {}}, {}, "STL"};
  }
  TextSurfaces out;
  // A header that begins with “solid” would be taken for text.
  if (wanted < bytes.size() || bytes.substr(0, 5) == "solid") {
    out.bytes = bytes.substr(0, wanted);
    out.bytes.replace(0, 5, "-----");
  }
  return out;
}

TextSurfaces objForReader(std::string_view bytes) {
  TextSurfaces out;
  bool changed = false;
  std::string text;
  text.reserve(bytes.size() + 1024);
  if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3), changed = true;
  while (!bytes.empty()) {
    const std::string_view whole = nextLine(bytes);
    const std::string_view line = withoutBlanks(whole);
    const bool object = line.size() > 2 && line[0] == 'o' && isBlank(line[1]);
    out.named = out.named || object || (line.size() > 2 && line[0] == 'g' && isBlank(line[1]));
    if (object) {
      text.append("o ").append(kObject).append(std::to_string(out.names.size()));
      out.names.emplace_back(withoutBlanks(line.substr(1)));
      changed = true;
    } else {
      text.append(whole);
    }
    text += '\n';
  }
  if (changed) out.bytes = std::move(text);
  return out;
}

void nameSurfaces(const TextSurfaces& text, bool objects, std::vector<ImportedSurface>& surfaces) {
  if (!objects) {
    if (text.names.size() == surfaces.size())
      for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i].name = saysNothing(text.names[i]) ? std::string() : text.names[i];
    return;
  }
  for (ImportedSurface& surface : surfaces) {
    if (!text.named) surface.name.clear();
    if (surface.name.compare(0, kObject.size(), kObject) != 0) continue;
    const std::size_t number = std::strtoul(surface.name.c_str() + kObject.size(), nullptr, 10);
    if (number < text.names.size()) surface.name = text.names[number];
  }
}

std::string notTheFile(std::string_view bytes) {
  std::string start(bytes.substr(0, 256));
  for (char& c : start) c = lower(c);
  if (start.starts_with("version https://git-lfs.github.com/spec/")) return "it is a pointer of Git LFS in place of the file: fetch the file itself with “git lfs pull”";
  const std::string_view page = withoutBlanks(start);
  if (page.starts_with("<!doctype html") || page.starts_with("<html")) return "it is a web page in place of the file: download the file itself";
  return {};
}

}  // namespace glenoid
