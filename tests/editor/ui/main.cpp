// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "editor/ui/GlProbe.h"
#include "editor/ui/Resources.h"

#include "tests/editor/ui/KilledEditor.h"

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == glenoid::kKilledEditor) return glenoid::editUntilKilled(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  glenoid::prepareGraphics();
  QApplication application(argc, argv);
  initGlenoidResources();
  return RUN_ALL_TESTS();
}
