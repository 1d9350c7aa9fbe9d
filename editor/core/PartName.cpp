// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/PartName.h"

#include "editor/core/AnatomyNames.h"

namespace glenoid {

QString partName(const Joint& joint, const std::string& id) {
  const int index = findPart(joint, id);
  return index < 0 || joint.parts[index].name.empty() ? QString::fromStdString(id) : anatomyName(joint.parts[index].name);
}

}  // namespace glenoid
