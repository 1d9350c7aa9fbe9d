// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "tests/layers/IncludeRules.h"

namespace glenoid::layers {
namespace {

std::string joined(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

/// Names of the headers in these modules of the Qt that this build uses, lower case, without ending.
std::set<std::string> headersOf(const std::set<std::string>& modules) {
  std::set<std::string> names;
  const std::string folders = GLENOID_QT_HEADERS;  // separated by '|'
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find('|', begin), folders.size());
    const std::filesystem::path folder = folders.substr(begin, end - begin);
    begin = end + 1;
    if (!modules.count(folder.filename().string())) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::string name = entry.path().stem().string();
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
      names.insert(name);
    }
  }
  return names;
}

/// What only the widget modules have: some classes moved down to QtGui and left a forwarding header behind.
std::set<std::string> widgetHeaders() {
  std::set<std::string> names = headersOf({"QtWidgets", "QtOpenGLWidgets", "QtSvgWidgets"});
  for (const std::string& lower : headersOf({"QtCore", "QtGui"})) names.erase(lower);
  return names;
}

SourceTree tree(std::initializer_list<std::pair<std::string, std::string>> sources) {
  SourceTree made;
  for (const auto& [path, text] : sources) made[path] = parseIncludes(text);
  return made;
}

TEST(Layers, sourcesAreFoundAtAll) {
  const SourceTree sources = readTree(GLENOID_SOURCE_DIR);
  EXPECT_TRUE(sources.count("simcore/base/Error.h"));
  EXPECT_TRUE(sources.count("simcore/step/Stepper.h"));
  EXPECT_TRUE(sources.count("app/main.cpp"));
  EXPECT_FALSE(sources.at("simcore/step/Stepper.h").empty());
}

TEST(Layers, foldersIncludeOnlyWhatStandsBeforeThem) {
  const Findings findings = checkOrder(readTree(GLENOID_SOURCE_DIR));
  EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Layers, qtStaysOutOfSimcoreAndRenderAndWidgetsOutOfCore) {
  const Findings findings = checkQt(readTree(GLENOID_SOURCE_DIR), widgetHeaders());
  EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Layers, wrappedLibrariesStayWhereTheyAreWrapped) {
  const Findings findings = checkLibraries(readTree(GLENOID_SOURCE_DIR));
  EXPECT_TRUE(findings.empty()) << joined(findings);
}

// The rules themselves: each breach is found, in the right line, and nothing else is.

TEST(LayerRules, commentsAreNoIncludes) {
  const auto includes = parseIncludes("// #include \"a.h\"\n/* x\n#include <b>\n*/ #include <c>\n  #  include \"d/e.h\"  // f\n");
  ASSERT_EQ(includes.size(), 2u);
  EXPECT_EQ(includes[0].path, "c");
  EXPECT_EQ(includes[0].line, 4);
  EXPECT_TRUE(includes[0].angled);
  EXPECT_EQ(includes[1].path, "d/e.h");
  EXPECT_EQ(includes[1].line, 5);
  EXPECT_FALSE(includes[1].angled);
}

TEST(LayerRules, aFolderThatIncludesALaterOneIsFound) {
  const Findings findings = checkOrder(tree({{"simcore/fem/A.h", ""},
                                             {"simcore/mesh/B.h", "\n#include \"simcore/fem/A.h\"\n"},
                                             {"simcore/step/C.h", "#include \"simcore/fem/A.h\"\n"}}));
  EXPECT_EQ(findings, Findings{"simcore/mesh/B.h:2: simcore/mesh includes a folder after it: simcore/fem/A.h"});
}

TEST(LayerRules, aLayerThatIncludesTheOneAboveIsFound) {
  const Findings findings = checkOrder(tree({{"simcore/base/A.h", "#include \"editor/core/B.h\"\n"},
                                             {"editor/core/B.h", "#include \"app/C.h\"\n#include \"editor/ui/D.h\"\n"},
                                             {"editor/ui/D.h", "#include \"editor/core/B.h\"\n#include \"simcore/base/A.h\"\n"},
                                             {"app/C.h", "#include \"editor/ui/D.h\"\n"}}));
  EXPECT_EQ(findings, (Findings{"editor/core/B.h:1: editor includes the layer above it: app/C.h",
                                "editor/core/B.h:2: editor/core includes a folder after it: editor/ui/D.h",
                                "simcore/base/A.h:1: simcore includes the layer above it: editor/core/B.h"}));
}

TEST(LayerRules, pathsThatAreNotFromTheRootAndUnknownFoldersAreFound) {
  const Findings findings = checkOrder(tree({{"simcore/base/A.h", ""},
                                             {"simcore/base/B.cpp", "#include \"A.h\"\n#include <simcore/base/A.h>\n"},
                                             {"simcore/spare/C.h", ""}}));
  EXPECT_EQ(findings, (Findings{"simcore/base/B.cpp:1: not a file from the repository's root: A.h",
                                "simcore/base/B.cpp:2: our own header in angle brackets: simcore/base/A.h",
                                "simcore/spare/C.h:1: the folder has no place in the order"}));
}

TEST(LayerRules, qtAndWidgetsAreFoundWhereTheyMayNotBe) {
  const Findings findings = checkQt(tree({{"simcore/base/A.h", "#include <vector>\n#include <QString>\n"},
                                          {"editor/render/B.h", "#include <QtGui/qimage.h>\n"},
                                          {"editor/core/C.h", "#include <QUndoStack>\n#include <QPushButton>\n#include <QtWidgets>\n"},
                                          {"editor/ui/D.h", "#include <QPushButton>\n"}}),
                                    widgetHeaders());
  EXPECT_EQ(findings, (Findings{"editor/core/C.h:2: a widget in editor/core: QPushButton",
                                "editor/core/C.h:3: a widget in editor/core: QtWidgets",
                                "editor/render/B.h:1: Qt has no place here: QtGui/qimage.h",
                                "simcore/base/A.h:2: Qt has no place here: QString"}));
}

TEST(LayerRules, aLibraryThatLeaksThroughAHeaderIsFound) {
  const Findings findings = checkLibraries(tree({{"simcore/mesh/Simplify.cpp", "#include <meshoptimizer.h>\n"},
                                                 {"simcore/spatial/Inside.h", "#include <btBulletCollisionCommon.h>\n"},
                                                 {"simcore/spatial/Trees.h", "#include \"simcore/spatial/Inside.h\"\n"},
                                                 {"simcore/collide/Pairs.cpp", "#include <array>\n#include \"simcore/spatial/Trees.h\"\n"},
                                                 {"editor/ui/View.cpp", "#include <GL/gl.h>\n"}}));
  EXPECT_EQ(findings, (Findings{"editor/ui/View.cpp:1: sees headers of libepoxy, which other folders wrap",
                                "simcore/collide/Pairs.cpp:2: sees headers of Bullet, which other folders wrap"}));
}

}  // namespace
}  // namespace glenoid::layers
