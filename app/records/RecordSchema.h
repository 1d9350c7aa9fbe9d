// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QStringList>
#include <vector>

namespace glenoid {

/// The statements that bring a database from each version to the next, the first from nothing. Only added to, never changed:
/// databases out there have run them.
std::vector<QStringList> recordMigrations(bool postgres);

}  // namespace glenoid
