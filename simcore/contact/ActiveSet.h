// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/contact/Lcp.h"

namespace glenoid {

/// Primal active set for the linear complementarity problem as the minimum of ½ λᵀWλ + dᵀλ over λ ≥ 0: it begins with λ = 0, takes in
/// the row that is violated most, and puts out rows that would pull. Every point on the way is feasible and lower than the last, so
/// unlike pivoting it cannot cycle, however dependent the rows are: one that depends on what has been taken in takes the place of another,
/// or contradicts them and is left out. The factor of the rows taken in is updated, so a step costs n k operations for n rows of which k carry: what many
/// dependent rows come down to is few.
/// work.scaled and work.d hold the problem, of unit diagonal; work.lambda the answer. At most `most` steps, added to `steps`. False: it
/// did not end, or a row left out is violated by more than `tolerance`.
/// Source: Lawson and Hanson, "Solving Least Squares Problems", 1974, ch. 23 (NNLS).
bool activeSet(LcpWork& work, int n, double tolerance, int most, int& steps);

}  // namespace glenoid
