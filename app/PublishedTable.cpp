// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PublishedTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace glenoid {

const std::vector<PublishedRow>& publishedTable() {
  static const std::vector<PublishedRow> rows = {
      {1, "Scapula", 10224, 105, -1, {3, 4, 5, 6, 6, 7, 9}},
      {2, "Humerus", 5189, 112, -1, {3, 4, 5, 7, 8, 8, 11}},
      {3, "Supraspinatus", 1716, 86, 87, {1, 2}},
      {4, "Infraspinatus", 2136, 96, 129, {1, 2}},
      {5, "Subscapularis", 2424, 100, 158, {1, 2}},
      {6, "Coracoacromial", 1632, 146, 65, {1, 1}},
      {7, "Coracohumeral", 522, 60, 86, {1, 2}},
      {8, "Transversehumeral", 264, 28, -1, {2, 2}},
      {9, "Labrum", 636, 120, 96, {1, 10}},
      {10, "Labrum Tendon", 128, 128, 122, {9, 11}},
      {11, "Biceps Tendon", 264, 264, -1, {2, 10}},
  };
  return rows;
}

Comparison compare(const PartReport& part) {
  Comparison result;
  for (const PublishedRow& row : publishedTable())
    if (row.number == part.number) result.published = &row;
  if (!result.published) return result;
  const PublishedRow& row = *result.published;
  const auto within = [](int ours, int theirs, double share, double atLeast) {
    return std::abs(ours - theirs) <= std::max(share * theirs, atLeast);
  };
  result.kind = part.rigid == (row.tetrahedra < 0);
  result.render = within(part.renderTriangles, row.render, 0.05, 0);
  result.collision = within(part.collisionTriangles, row.collision, 0.05, 4);
  result.tetrahedra = part.rigid ? row.tetrahedra < 0 : row.tetrahedra >= 0 && within(part.tetrahedra, row.tetrahedra, 0.15, 0);
  std::vector<int> numbers;
  for (const PartCoupling& coupling : part.couplings) numbers.push_back(coupling.part);
  std::sort(numbers.begin(), numbers.end());
  result.couplings = numbers == row.couplings;
  return result;
}

std::string couplingText(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    const auto same = std::count(numbers.begin(), numbers.end(), numbers[i]);
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (same > 1) text += "(x" + std::to_string(same) + ")";
    i += static_cast<std::size_t>(same);
  }
  return text;
}

}  // namespace glenoid
