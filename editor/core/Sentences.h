// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/base/Error.h"

namespace glenoid {

/// The user's sentences for everything that can be wrong with what came from outside: what is wrong, where,
/// and what to do about it. The one table Fault → text of the project; the command line and the window both
/// ask here. Works with no QCoreApplication (English then); thread-safe like QCoreApplication::translate.
/// Missing arguments are shown as "?", never as "%1".
QString sentenceOf(const Error& error);

/// Only the place, e.g. "shoulder.joint/joint.json, at /parts/3, part “humerus”"; empty when unknown.
QString placeOf(const Place& place);

/// What the word of an effect plan means ("asked-on", "auto-present" …), for people; unknown words as they are.
QString effectReason(const std::string& reason);

/// The name of an effect ("gravity", "couplings" …), for people; unknown names as they are.
QString effectName(const std::string& name);

}  // namespace glenoid
