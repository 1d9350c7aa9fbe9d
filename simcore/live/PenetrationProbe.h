// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "simcore/collide/Penetration.h"
#include "simcore/scene/Part.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Measures how deep surfaces of a running model lie in each other, over all pairs that may collide, by the check
/// of collide/Penetration that shares nothing with the contact detector. Collision surfaces leave out what the
/// model's pairs leave out (coupled and perforated triangles); visual surfaces what lies nearest to that. Keeps the
/// deepest of all looks. The model must outlive it.
class PenetrationProbe {
 public:
  PenetrationProbe(const Model& model, SurfaceKind kind);

  /// The state vector of one moment and the dents of the step that led to it: a tip counts from the bottom of its dent.
  void look(const VecX& q, std::span<const DentView> dents = {});

  double deepest() const { return m_deepest; }        ///< m
  const std::string& where() const { return m_where; }  ///< "id of a / id of b", empty when nothing is inside

 private:
  const Model& m_model;
  SurfaceKind m_kind;
  std::vector<std::vector<Vec3>> m_positions;
  std::vector<std::span<const Vec3>> m_spans;
  PenetrationCheck m_check;
  std::vector<double> m_allowed;  ///< by pair, m
  double m_deepest = 0;
  std::string m_where;
};

}  // namespace glenoid
