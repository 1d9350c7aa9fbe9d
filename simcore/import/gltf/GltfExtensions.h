// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace glenoid {

/// Extensions that a glTF (or, `binary`, a GLB) file requires and that what reads it does not understand, where they may change the
/// surface: a file must not be read without them (glTF 2.0, section 3.12), yet assimp 5.2.5 does not look. Those of materials,
/// textures and lights change no surface. Empty too for what is no glTF at all.
std::vector<std::string> extensionsNotUnderstood(std::string_view bytes, bool binary);

}  // namespace glenoid
