// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/scene/SceneWords.h"
#include "simcore/scene/training/Training.h"

namespace glenoid::scene_words {

inline constexpr std::array<Word<TaskKind>, 7> kTaskKinds{{{TaskKind::Touch, "touch"},
                                                           {TaskKind::Press, "press"},
                                                           {TaskKind::Look, "look"},
                                                           {TaskKind::Trace, "trace"},
                                                           {TaskKind::Follow, "follow"},
                                                           {TaskKind::Find, "find"},
                                                           {TaskKind::Pass, "pass"}}};

}  // namespace glenoid::scene_words
