// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/Resources.h"

#include <QResource>

void initGlenoidResources() {
  Q_INIT_RESOURCE(glenoid);
  Q_INIT_RESOURCE(glenoid_translations);
}
