// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <string>

#include "simcore/study/accuracy/AccuracyTrace.h"

namespace glenoid {

/// What is compared.
enum class AccuracyQuantity { Displacement, ContactForce, Penetration, HandForce };
inline constexpr int kAccuracyQuantities = 4;
/// "displacement", "contactForce", "penetration", "handForce".
const char* quantityKey(AccuracyQuantity quantity);

/// How far a setting lies from its reference. Each figure is a root mean square over windows and moments, for the object, pair or
/// tool for which it is largest, which is named: a mean over all would be diluted by what hardly moves.
struct AccuracyError {
  double value = 0;   ///< m or N
  double most = 0;    ///< the largest single one: of a place, a pair, a tool
  std::string where;  ///< id, or "id / id"
};

/// By quantity:
///   displacement   of each object, over its compared places: |x − x_ref|
///   contactForce   of each pair: |F − F_ref|, F the mean net force between two moments
///   penetration    of each pair: |d − d_ref| of the visual surfaces at the end of the window
///   handForce      of each tool: |F − F_ref|
struct AccuracyErrors {
  std::array<AccuracyError, kAccuracyQuantities> by;
  const AccuracyError& operator[](AccuracyQuantity quantity) const { return by[static_cast<std::size_t>(quantity)]; }
};

/// Both spans hold the same windows in the same order, at least one. `model` names objects.
AccuracyErrors errorsOf(const Model& model, std::span<const AccuracyTrace> traces, std::span<const AccuracyTrace> reference);

}  // namespace glenoid
