// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "editor/core/Document.h"

namespace glenoid {

/// How a part takes part in a run: fixed in the room, free but pulled back to its rest pose by a spring (rigid parts
/// only), or free.
enum class Movement { Fixed, Held, Free };

Movement movementOf(const Scenario& scenario, const std::string& part);

/// One undo step, which changes the scenario. False where the part is unknown, moves so already, or is soft and should
/// be held. A part that is held anew gets the spring of a default Hold; what pushes a part that becomes fixed goes,
/// and so does the prescribed motion of one that becomes free.
bool setMovement(Document& document, const std::string& part, Movement movement);

/// Whether the scenario names the part among those that may fold onto themselves.
bool foldsOntoItself(const Scenario& scenario, const std::string& part);

/// One undo step, which changes the scenario. False where the part is unknown, rigid or fixed, or where it is so already.
bool setFoldsOntoItself(Document& document, const std::string& part, bool folds);

/// A joint without parts and a scenario around it, for beginning anew.
Scene emptyScene(const QString& name);

}  // namespace glenoid
