// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// Four corotational tetrahedra side by side, lane by lane, for the processor's vector registers. The same
/// element as CorotTet; tests compare the two. Raw arrays, since this crosses into code built for one
/// instruction set. Unused lanes repeat an element with zero volume and write nowhere.
struct alignas(32) ElementPack {
  double gradients[4][3][4];   ///< [node][axis][lane], 1/m
  double lambda[4], mu[4];     ///< volume × Lamé constant, J
  double stiffnessDamping[4];  ///< Rayleigh β, s
  int node[4][4];              ///< [lane][node], of the object
  int count;                   ///< lanes in use
};

/// Where and how the stiffness of four elements goes. Ten blocks, kPackPairs names their local nodes.
struct PackTarget {
  double* slot[4][10];  ///< [lane][block]: 12 doubles on 32 bytes, columns of four; null in unused lanes
  bool turned[4][10];   ///< the transpose is stored
  double tension = 1;   ///< 0: without tension's part
};
inline constexpr int kPackPairs[10][2] = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 0}, {2, 0}, {3, 0}, {2, 1}, {3, 1}, {3, 2}};

struct alignas(32) PackResult {
  double force[4][3][4];    ///< [node][axis][lane], N
  double quaternion[4][4];  ///< [lane][x y z w]
  bool settled[4];          ///< the rotation converged; where not, the caller must find it another way
  bool strained[4];         ///< |S − I|² above 0.04: a principal stretch may have left the linear range (StretchLaw)
};

/// Rotations (from the guesses), forces, and (dt² + dt β) K + dt² (tension's part) added to the targets, of four elements.
/// `nodes`: the object's node positions, xyz after xyz, m. `quaternions`: guesses of the four lanes.
/// `damping` 0 or 1 scales β. A lane that has not settled adds nothing to its targets.
using PackKernel = void (*)(const ElementPack& pack, const double* nodes, const double* const quaternions[4], double dt,
                            double damping, const PackTarget& target, PackResult& result);

/// The best kernel of this processor, or the portable one. Both do the same operations in the same order, without
/// fused multiply-add, so their results agree to the last bit.
PackKernel packKernel(bool portable);

void elementPackPortable(const ElementPack&, const double*, const double* const[4], double, double, const PackTarget&, PackResult&);
void elementPackAvx2(const ElementPack&, const double*, const double* const[4], double, double, const PackTarget&, PackResult&);

}  // namespace glenoid
