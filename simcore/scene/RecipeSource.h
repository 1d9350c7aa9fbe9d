// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "simcore/file/JsonValue.h"
#include "simcore/repair/PrepareSurface.h"

namespace glenoid {

/// What became of a file that a recipe names: for the report, because nothing is changed silently.
struct SourceReport {
  std::string part;  ///< id
  std::string file;  ///< as the recipe names it
  std::string format;
  double metresPerUnit = 1;
  std::vector<NoteCount> notes;
  std::vector<RepairChange> changes;
  long trianglesBefore = 0, trianglesAfter = 0;
};

/// Loads the surfaces of one recipe, each once. A PLY file without any "source" is taken as it is: metres, frame W. All
/// others go through importSurfaces and prepareSurface, with the wishes of the recipe's own "source" and, entry by
/// entry before them, of the part's.
class RecipeSurfaces {
 public:
  RecipeSurfaces(std::string folder, const JsonValue& general) : m_folder(std::move(folder)), m_general(general) {}

  /// `own`: the part's "source" or null; `place`: of the file's name in the recipe; `visual`: whether simplifyVisual
  /// counts. Fails with BadReference (a name that leaves the folder), SchemaMismatch (a repair that is none), and as
  /// readPly, importSurfaces and prepareSurface do.
  Result<std::shared_ptr<const TriMesh>> load(const std::string& name, const JsonValue& own, const Place& place, bool visual);

  const std::vector<SourceReport>& reports() const { return m_reports; }

 private:
  std::string m_folder;
  const JsonValue& m_general;
  std::map<std::string, std::shared_ptr<const TriMesh>> m_known;
  std::map<std::string, ImportedFile> m_files;
  std::vector<SourceReport> m_reports;
};

}  // namespace glenoid
