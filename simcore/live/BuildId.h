// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// Which build this is: version and commit ("0.1.0+1a2b3c4", "-changed" when sources differ from the commit),
/// or the version alone where it was built without git. Made when the program is built, so it never lags behind.
const char* buildId();

/// The version alone, "0.1.0".
const char* versionId();

}  // namespace glenoid
