// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "editor/core/Document.h"

namespace glenoid {

/// A scene put aside for undo. What is the same as in a scene put aside before is shared with it, so that a thousand
/// steps cost what they changed: parts (with regions of many runs) and cages each stand alone.
class FrozenScene {
 public:
  /// `near`: one put aside before, or null.
  static std::shared_ptr<const FrozenScene> of(const Scene& scene, const FrozenScene* near);
  Scene thaw() const;

  const std::vector<std::shared_ptr<const Part>>& parts() const { return m_parts; }
  const std::vector<std::shared_ptr<const Cage>>& cages() const { return m_cages; }

 private:
  std::vector<std::shared_ptr<const Part>> m_parts;
  std::vector<std::shared_ptr<const Cage>> m_cages;
  Scene m_rest;  ///< without the above
};

}  // namespace glenoid
