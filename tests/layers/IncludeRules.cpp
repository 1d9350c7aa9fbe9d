// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/layers/IncludeRules.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace glenoid::layers {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Blanks comments and keeps line breaks, so that line numbers stay. String literals are passed over whole.
std::string withoutComments(const std::string& text) {
  std::string out = text;
  enum { Code, Line, Block, String } mode = Code;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const char c = out[i], next = i + 1 < out.size() ? out[i + 1] : '\0';
    if (mode == Code && c == '/' && next == '/') mode = Line;
    else if (mode == Code && c == '/' && next == '*') mode = Block;
    else if (mode == Code && c == '"') mode = String;
    else if (mode == String && c == '\\') ++i;
    else if (mode == String && (c == '"' || c == '\n')) mode = Code;
    else if (mode == Line && c == '\n') mode = Code;
    else if (mode == Block && c == '*' && next == '/') {
      out[i] = out[i + 1] = ' ';
      mode = Code;
    }
    if ((mode == Line || mode == Block) && out[i] != '\n') out[i] = ' ';
  }
  return out;
}

int indexOf(const std::vector<std::string>& order, const std::string& name) {
  const auto found = std::find(order.begin(), order.end(), name);
  return found == order.end() ? -1 : static_cast<int>(found - order.begin());
}

/// Part of a path between the first and the second slash.
std::string secondOf(const std::string& path) {
  const auto first = path.find('/');
  if (first == std::string::npos) return {};
  const auto second = path.find('/', first + 1);
  return second == std::string::npos ? std::string() : path.substr(first + 1, second - first - 1);
}

std::string topOf(const std::string& path) { return path.substr(0, path.find('/')); }

std::string at(const std::string& file, int line, const std::string& what) {
  return file + ":" + std::to_string(line) + ": " + what;
}

/// Class or file name of an include without module folder and ending, lower case: <QtWidgets/qlabel.h> → qlabel.
std::string qtName(const std::string& path) {
  std::string name = path.substr(path.rfind('/') == std::string::npos ? 0 : path.rfind('/') + 1);
  if (name.size() > 2 && name.substr(name.size() - 2) == ".h") name.resize(name.size() - 2);
  return lower(name);
}

/// Headers that the build makes; they lie beside their folder's objects.
bool isGenerated(const std::string& path) { return path == "simcore/file/SchemaTexts.h"; }

bool isQt(const Include& include) {
  static const std::regex pattern(R"(^(Qt[A-Z]\w*/.*|Q[A-Z]\w*|q[a-z]\w*\.h|QtGlobal|Qt[A-Z]\w*)$)");
  return include.angled && std::regex_match(include.path, pattern);
}

struct Library {
  std::string name;
  std::regex header;
  std::set<std::string> folders;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> list = {
      {"Bullet", std::regex("^(Bullet\\w*/|LinearMath/|bullet/|bt[A-Z]).*"), {"simcore/spatial"}},
      {"CGAL", std::regex("^CGAL/.*"), {"simcore/export", "simcore/repair"}},
      {"meshoptimizer", std::regex("^meshoptimizer.*"), {"simcore/mesh"}},
      {"SuiteSparse", std::regex("^(suitesparse/.*|cholmod\\w*\\.h|amd\\.h|SuiteSparse\\w*\\.h|.*CholmodSupport)$"),
       {"simcore/linear"}},
      {"assimp", std::regex("^assimp/.*"), {"simcore/import"}},
      {"valijson", std::regex("^valijson/.*"), {"simcore/file"}},
      {"nlohmann", std::regex("^nlohmann/.*"), {"simcore/file"}},
      {"xxHash", std::regex("^xxh.*"), {"simcore/base"}},
      {"pugixml", std::regex("^pugixml\\.hpp$"), {"simcore/import"}},
      {"libzip", std::regex("^zip(conf)?\\.h$"), {"simcore/file"}},
      {"zlib", std::regex("^z(lib|conf)\\.h$"), {"simcore/file", "simcore/import", "editor/render"}},
      {"libepoxy", std::regex("^(epoxy|GL|EGL|GLES\\w*)/.*"), {"editor/render"}},
      {"libwebsockets", std::regex("^libwebsockets\\.h$"), {"simcore/device"}},
      {"libspnav", std::regex("^spnav\\.h$"), {"simcore/device"}},
      {"OpenIGTLink", std::regex("^igtl\\w*\\.h$"), {"simcore/device"}},
      {"CLI11", std::regex("^CLI/.*"), {"app"}},
      {"QCustomPlot", std::regex("^qcustomplot\\.h$"), {"editor/ui"}},
  };
  return list;
}

}  // namespace

std::vector<Include> parseIncludes(const std::string& text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  std::istringstream lines(withoutComments(text));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) includes.push_back({number, match[2], match[1] == "<"});
  }
  return includes;
}

SourceTree readTree(const std::string& root) {
  namespace fs = std::filesystem;
  SourceTree tree;
  for (const char* top : {"simcore", "editor", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / top)) {
      const std::string ending = entry.path().extension().string();
      if (!entry.is_regular_file() || (ending != ".h" && ending != ".hpp" && ending != ".cpp" && ending != ".cc" &&
                                       ending != ".inc"))
        continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      tree[fs::relative(entry.path(), root).generic_string()] = parseIncludes(text);
    }
  }
  return tree;
}

std::string folderOf(const std::string& path) {
  const std::string top = topOf(path);
  if (top == "app") return top;
  if (top != "simcore" && top != "editor") return {};
  const std::string second = secondOf(path);
  return second.empty() ? std::string() : top + "/" + second;
}

const std::vector<std::string>& simcoreOrder() {
  static const std::vector<std::string> order = {"base", "linear", "mesh", "shape", "spatial", "file", "import", "repair", "embed",
                                                 "scene", "starter", "fem", "body", "tool", "coupling", "collide", "contact", "step",
                                                 "author", "check", "export", "reading", "train", "haptic", "device", "live", "study"};
  return order;
}

const std::vector<std::string>& editorOrder() {
  static const std::vector<std::string> order = {"render", "core", "lab", "ui"};
  return order;
}

Findings checkOrder(const SourceTree& tree) {
  static const std::vector<std::string> tops = {"simcore", "editor", "app"};
  Findings findings;
  for (const auto& [file, includes] : tree) {
    const std::string top = topOf(file), folder = secondOf(file);
    const std::vector<std::string>& order = top == "simcore" ? simcoreOrder() : editorOrder();
    if (top != "app" && indexOf(order, folder) < 0) findings.push_back(at(file, 1, "the folder has no place in the order"));
    for (const Include& include : includes) {
      if (include.angled) {
        if (indexOf(tops, topOf(include.path)) >= 0 && tree.count(include.path))
          findings.push_back(at(file, include.line, "our own header in angle brackets: " + include.path));
        continue;
      }
      if (include.path.size() > 4 && include.path.substr(include.path.size() - 4) == ".moc") continue;
      const std::string otherTop = topOf(include.path), otherFolder = secondOf(include.path);
      if (isGenerated(include.path) && folderOf(include.path) == folderOf(file)) continue;
      if (!tree.count(include.path)) {
        findings.push_back(at(file, include.line, "not a file from the repository's root: " + include.path));
      } else if (indexOf(tops, otherTop) > indexOf(tops, top)) {
        findings.push_back(at(file, include.line, top + " includes the layer above it: " + include.path));
      } else if (otherTop == top && top != "app" && indexOf(order, otherFolder) > indexOf(order, folder)) {
        findings.push_back(at(file, include.line, top + "/" + folder + " includes a folder after it: " + include.path));
      }
    }
  }
  return findings;
}

Findings checkQt(const SourceTree& tree, const std::set<std::string>& widgetHeaders) {
  Findings findings;
  for (const auto& [file, includes] : tree) {
    const std::string folder = folderOf(file);
    const bool withoutQt = topOf(file) == "simcore" || folder == "editor/render";
    for (const Include& include : includes) {
      if (!isQt(include)) continue;
      if (withoutQt) findings.push_back(at(file, include.line, "Qt has no place here: " + include.path));
      const bool widget = widgetHeaders.count(qtName(include.path)) || include.path.find("Widgets") != std::string::npos;
      if ((folder == "editor/core" || folder == "editor/lab") && widget)
        findings.push_back(at(file, include.line, "a widget in " + folder + ": " + include.path));
    }
  }
  return findings;
}

Findings checkLibraries(const SourceTree& tree) {
  // Which libraries each file sees: its own includes and those of every header it reaches. Repeated until nothing
  // is added, so the order of the files does not matter.
  std::map<std::string, std::map<std::string, int>> seen;  // file → library → line that brings it in
  for (const auto& [file, includes] : tree)
    for (const Include& include : includes)
      for (const Library& library : libraries())
        if (std::regex_match(include.path, library.header) && !tree.count(include.path))
          seen[file].emplace(library.name, include.line);
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [file, includes] : tree)
      for (const Include& include : includes) {
        const auto header = seen.find(include.path);
        if (header == seen.end() || header->first == file) continue;
        const auto brought = header->second;
        for (const auto& entry : brought) grew |= seen[file].emplace(entry.first, include.line).second;
      }
  }
  Findings findings;
  for (const auto& [file, brought] : seen)
    for (const Library& library : libraries()) {
      const auto line = brought.find(library.name);
      if (line != brought.end() && !library.folders.count(folderOf(file)))
        findings.push_back(at(file, line->second, "sees headers of " + library.name + ", which other folders wrap"));
    }
  return findings;
}

}  // namespace glenoid::layers
