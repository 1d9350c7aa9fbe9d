// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <span>
#include <string>

namespace glenoid {

/// The name of a part, region, landmark, material or joint in the user's language. A name that the shipped joints do
/// not use stays as its author wrote it.
QString anatomyName(const std::string& name);

/// Every name that has translations, in the language of the joints' files.
std::span<const char* const> anatomyNames();

}  // namespace glenoid
