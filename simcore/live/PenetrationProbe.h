// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simcore/collide/Penetration.h"
#include "simcore/live/Notice.h"
#include "simcore/reading/UnderSkin.h"
#include "simcore/scene/Part.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Measures how deep surfaces of a running model lie in each other, over all pairs that may collide, by the check
/// of collide/Penetration that shares nothing with the contact detector. Collision surfaces leave out what the
/// model's pairs leave out (coupled and perforated triangles); visual surfaces what lies nearest to that. These are as they are
/// shown, what a skin covers beneath it (reading/UnderSkin). Keeps the deepest of all looks. The model must outlive it.
class PenetrationProbe {
 public:
  PenetrationProbe(const Model& model, SurfaceKind kind);

  /// From now on counts what lies deeper than a depth (m; infinite: nothing), or, without one, than a third of the
  /// thickness of the thinner of the two objects. Thickness: twice the volume over the area, which is that of a sheet, the
  /// radius of a long shaft, a third of the diameter of a ball. Deeper, the far side is nearly as near as the side
  /// that was passed.
  void setLimit(std::optional<double> depth);

  /// The state vector of one moment and the dents of the step that led to it: a tip counts from the bottom of its dent.
  void look(const VecX& q, std::span<const DentView> dents = {}, double time = 0, long step = 0);

  /// One notice for each pair that went beyond its limit, of its deepest moment; first the one furthest beyond, as a share of
  /// its limit. Empty where all stayed within.
  std::vector<Notice> tooDeep() const;

  /// By pair of the model, of the last look alone; depth 0 where nothing is inside.
  std::span<const Penetration> lastLook() const { return m_found; }

  double deepest() const { return m_deepest; }        ///< m
  const std::string& where() const { return m_where; }  ///< "id of a / id of b", empty when nothing is inside

 private:
  const Model& m_model;
  SurfaceKind m_kind;
  std::vector<std::vector<Vec3>> m_positions;
  std::vector<std::span<const Vec3>> m_spans;
  PenetrationCheck m_check;
  UnderSkin m_underSkin;          ///< visual surfaces only
  std::vector<double> m_allowed;  ///< by pair, m
  std::vector<double> m_limits;   ///< by pair, m; empty: none
  std::vector<Penetration> m_found;
  std::vector<Notice> m_beyond;   ///< one for a pair, in the order they came
  double m_deepest = 0;
  std::string m_where;
};

}  // namespace glenoid
