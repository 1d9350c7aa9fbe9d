// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/starter/Starter.h"

#include <cstdio>
#include <filesystem>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/SurfaceWrite.h"
#include "simcore/scene/MaterialLibrary.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

constexpr StarterKind kKinds[] = {{"elbow", elbowSurfaces}, {"knee", kneeSurfaces}};

/// Every `mark` of a text that all starters share as `word`.
std::string filled(std::string text, const std::string& mark, const std::string& word) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + word.size())) text.replace(at, mark.size(), word);
  return text;
}

/// Rows of the README's table, as the library of tissues has them.
std::string tissueRows(const std::vector<Material>& library) {
  const auto modulus = [](double pascals) {
    char out[32];
    std::snprintf(out, sizeof out, "%.3g", pascals);
    return std::string(out);
  };
  std::string rows;
  for (const Material& material : library) {
    const bool differs = material.literatureYoungsModulus && *material.literatureYoungsModulus != material.youngsModulus;
    rows += (rows.empty() ? "| " : "\n| ") + material.name + " | " + modulus(material.density) + " | " + modulus(material.youngsModulus) + " | " +
            modulus(material.poissonRatio) + " | " + (differs ? modulus(*material.literatureYoungsModulus) : std::string()) + " |";
  }
  return rows;
}

/// An empty folder: nothing of an author's is written over, and nothing half-made is taken for a whole.
Result<Done> makeEmptyFolder(const std::string& folder) {
  std::error_code failed;
  if (fs::exists(folder, failed)) {
    if (!fs::is_directory(folder, failed) || !fs::is_empty(folder, failed) || failed)
      return Error{Fault::FileUnwritable, {folder, {}, {}, {}}, {}, "something is there already"};
    return Done{};
  }
  if (!fs::create_directory(folder, failed) || failed) {
    const bool missing = failed == std::errc::no_such_file_or_directory;
    return Error{missing ? Fault::FileMissing : Fault::FileUnwritable, {folder, {}, {}, {}}, {}, failed.message()};
  }
  return Done{};
}

}  // namespace

std::span<const StarterKind> starterKinds() { return kKinds; }

const StarterKind* findStarter(const std::string& name) {
  for (const StarterKind& kind : kKinds)
    if (name == kind.name) return &kind;
  return nullptr;
}

Result<StarterFiles> saveStarter(const StarterKind& kind, const std::string& resources, const std::string& folder) {
  const std::string name = kind.name;
  const fs::path from = fs::path(resources) / "starters", to = folder;
  const StarterFiles files{(to / "recipe.json").string(), (to / "meshes").string(), (to / (name + ".joint")).string(),
                           (to / (name + ".scenario.json")).string()};
  const std::pair<fs::path, std::string> texts[] = {{from / (name + ".recipe.json"), files.recipe},
                                                    {from / (name + ".scenario.json"), files.scenario},
                                                    {from / "README.md", (to / "README.md").string()}};
  const std::string tissues = (fs::path(resources) / "materials" / "tissues.json").string();
  const auto libraryText = readWholeFile(tissues);
  if (!libraryText) return libraryText.error();
  const auto library = parseMaterialLibrary(*libraryText, tissues);
  if (!library) return library.error();
  std::vector<std::string> read;
  for (const auto& [text, target] : texts) {
    auto bytes = readWholeFile(text.string());
    if (!bytes) return bytes.error();
    read.push_back(filled(filled(std::move(*bytes), "@KIND@", name), "@TISSUES@", tissueRows(*library)));
  }
  if (const auto made = makeEmptyFolder(folder); !made) return made.error();
  for (std::size_t i = 0; i < read.size(); ++i)
    if (const auto written = writeWholeFile(texts[i].second, read[i]); !written) return written.error();
  if (const auto made = makeEmptyFolder(files.meshes); !made) return made.error();
  for (const StarterSurface& surface : kind.surfaces())
    if (const auto written = writeSurface((fs::path(files.meshes) / (surface.name + ".stl")).string(), surface.mesh); !written) return written.error();
  return files;
}

}  // namespace glenoid
