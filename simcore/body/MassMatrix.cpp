// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/MassMatrix.h"

#include <algorithm>

namespace glenoid {

MassMatrix::MassMatrix(int nodeCount, std::vector<MassPair> loose) : m_nodeCount(nodeCount) {
  const auto key = [](const MassPair& pair) { return std::array{pair.row != pair.col ? 1 : 0, pair.row, pair.col}; };
  for (int node = 0; node < nodeCount; ++node) loose.push_back({node, node, 0, 0});
  std::stable_sort(loose.begin(), loose.end(), [&](const MassPair& a, const MassPair& b) { return key(a) < key(b); });
  for (const MassPair& pair : loose) {
    if (m_pairs.empty() || key(m_pairs.back()) != key(pair)) {
      m_pairs.push_back(pair);
    } else {
      m_pairs.back().mass += pair.mass;
      m_pairs.back().drag += pair.drag;
    }
  }
}

double MassMatrix::total() const {
  double sum = 0;
  for (const MassPair& pair : m_pairs) sum += pair.row == pair.col ? pair.mass : 2 * pair.mass;
  return sum;
}

void MassMatrix::addProduct(const Eigen::Ref<const VecX>& v, const Vec3& w, Eigen::Ref<VecX> out) const {
  for (int node = 0; node < m_nodeCount; ++node) out.segment<3>(3 * node) += m_pairs[node].mass * (v.segment<3>(3 * node) + w);
  for (std::size_t k = m_nodeCount; k < m_pairs.size(); ++k) {
    const MassPair& pair = m_pairs[k];
    out.segment<3>(3 * pair.row) += pair.mass * (v.segment<3>(3 * pair.col) + w);
    out.segment<3>(3 * pair.col) += pair.mass * (v.segment<3>(3 * pair.row) + w);
  }
}

}  // namespace glenoid
