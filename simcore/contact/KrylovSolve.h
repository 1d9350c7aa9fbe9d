// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// Scratch of solveShifted; only grows.
struct KrylovWork {
  static constexpr int kDirections = 40;
  MatX basis;
  VecX next;
};

/// δ of δ − T δ = e by restart-free GMRES over at most KrylovWork::kDirections directions, to a relative residual of
/// `tolerance`; `apply` writes T δ. e in, δ out. Right where T is near a contraction and known by its products alone.
/// Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986).
void solveShifted(const std::function<void(const VecX& x, VecX& Tx)>& apply, int size, double tolerance, VecX& e,
                  KrylovWork& work);

}  // namespace glenoid
