// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Makes icons, themes and translations known to Qt: they lie in static libraries, which the linker would
/// otherwise drop. Global namespace because of Q_INIT_RESOURCE. To be called once, before the first window.
void initGlenoidResources();
