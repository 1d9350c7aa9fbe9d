// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

namespace glenoid::layers {

/// One #include line as written.
struct Include {
  int line = 0;        ///< from 1
  std::string path;    ///< between the brackets or quotes
  bool angled = false; ///< <…> rather than "…"
};

/// Sources by their path from the repository's root, sorted, so that the findings come in one order.
using SourceTree = std::map<std::string, std::vector<Include>>;

/// What is wrong, as "file:line: sentence".
using Findings = std::vector<std::string>;

/// The #include lines of one source; those inside comments do not count.
std::vector<Include> parseIncludes(const std::string& text);

/// All .h, .hpp, .cpp, .cc and .inc below simcore/, editor/ and app/.
SourceTree readTree(const std::string& root);

/// "simcore/mesh" of "simcore/mesh/TriMesh.h", "app" of "app/commands/RunCommand.cpp"; "" of anything else.
std::string folderOf(const std::string& path);

/// Folders of simcore and of editor, each allowed to include itself and those before it.
const std::vector<std::string>& simcoreOrder();
const std::vector<std::string>& editorOrder();

/// app → editor → simcore, the order inside simcore and editor, and that a quoted include names a file of the tree.
Findings checkOrder(const SourceTree& tree);

/// No Qt in simcore and editor/render; no widget in editor/core. `widgetHeaders`: names of Qt's widget classes
/// as in `#include <QPushButton>`, in lower case without ".h".
Findings checkQt(const SourceTree& tree, const std::set<std::string>& widgetHeaders);

/// A wrapped library's headers are seen, directly or through other headers, only in the folders that wrap it.
Findings checkLibraries(const SourceTree& tree);

}  // namespace glenoid::layers
