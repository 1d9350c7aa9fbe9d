// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/fem/Bands.h"

#include <Eigen/Cholesky>

namespace glenoid::test {

double BandBeam::ratio() const {
  const auto node = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  const int nodes = (nx + 1) * (ny + 1) * (nz + 1);
  MatX K = MatX::Zero(3 * nodes, 3 * nodes);
  VecX f = VecX::Zero(3 * nodes);
  const double thickness = top - bottom, load = 1e-6;
  const double volume = cell * cell * cell;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const double low = std::max(-1.0, 2 * (bottom - k * cell) / cell - 1), high = std::min(1.0, 2 * (top - k * cell) / cell - 1);
        if (high <= low) continue;
        const CellTissue tissue{momentsOfPart(Vec3(-1, -1, low), Vec3(1, 1, high), volume), lameFrom(young, nu)};
        CellBox box;
        box.origin = cell * Vec3(i, j, k);
        box.edges.setConstant(cell);
        const CorotCell element = makeCorotCell(box, {&tissue, 1}).value();
        for (int a = 0; a < 8; ++a)
          for (int b = 0; b < 8; ++b)
            K.block<3, 3>(3 * node(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2)), 3 * node(i + (b & 1), j + (b >> 1 & 1), k + (b >> 2))) +=
                element.K_E.block<3, 3>(3 * a, 3 * b);
        if (i + 1 < nx) continue;
        // The end face: its share of the force by the shape functions' means over the tissue in it.
        for (int a = 0; a < 8; ++a) {
          if (!(a & 1)) continue;
          const double up = 0.5 * (high - low) + (a >> 2 ? 1 : -1) * 0.25 * (high * high - low * low);  // ∫ (1 ± ζ)/2 dζ
          f[3 * node(nx, j + (a >> 1 & 1), k + (a >> 2)) + 2] += load * 0.5 * cell * 0.5 * cell * up / (thickness * ny * cell);
        }
      }
  // Held at x = 0 as beam theory has it: the section stays in its plane and may widen and curl in it, so of the rest only
  // its mean and its turn about X are held. Nodes that no cell holds are held too.
  const double stiff = 1e3 * K.diagonal().maxCoeff();
  VecX across = VecX::Zero(3 * nodes), up = across, turn = across;
  for (int n = 0; n < nodes; ++n) {
    const bool loose = K.block<3, 3>(3 * n, 3 * n).isZero(0), root = n % (nx + 1) == 0 && !loose;
    const double y = n / (nx + 1) % (ny + 1) - 0.5 * ny, z = n / (nx + 1) / (ny + 1) - 0.5 * nz;
    if (root && !glued) {
      across[3 * n + 1] = up[3 * n + 2] = 1;
      turn.segment<3>(3 * n) = Vec3(0, -z, y);
    }
    for (int r = 0; r < (loose || (root && glued) ? 3 : root ? 1 : 0); ++r) {
      K.row(3 * n + r).setZero();
      K.col(3 * n + r).setZero();
      K(3 * n + r, 3 * n + r) = stiff;
      f[3 * n + r] = 0;
    }
  }
  for (const VecX* held : {&across, &up, &turn}) K += stiff * *held * held->transpose();
  const VecX u = K.ldlt().solve(f);
  const double width = ny * cell, length = nx * cell, area = width * thickness, inertia = area * thickness * thickness / 12;
  const double shear = young / (2 * (1 + nu)), kappa = 10 * (1 + nu) / (12 + 11 * nu);
  return u.dot(f) / load / (load * (std::pow(length, 3) / (3 * young * inertia) + length / (kappa * shear * area)));
}

}  // namespace glenoid::test
