// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "editor/ui/GlProbe.h"
#include "editor/ui/Resources.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  glenoid::prepareGraphics();
  QApplication application(argc, argv);
  initGlenoidResources();
  return RUN_ALL_TESTS();
}
