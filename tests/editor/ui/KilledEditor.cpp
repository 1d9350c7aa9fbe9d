// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/ui/KilledEditor.h"

#include <QCoreApplication>
#include <cstdio>

#include "editor/core/Autosave.h"
#include "editor/core/PartEdits.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {

int editUntilKilled(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  Document document;
  document.open(blockScene(), QStringLiteral("/somewhere/block.scenario.json"));
  Autosave autosave(document, QString::fromLocal8Bit(argv[2]));
  QObject::connect(&autosave, &Autosave::safe, [] {
    std::puts("safe");
    std::fflush(stdout);
  });
  renamePart(document, "block", QStringLiteral("Saved from the crash"));
  return application.exec();
}

}  // namespace glenoid
