// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/LabelLayout.h"

#include <algorithm>

namespace glenoid {
namespace {

/// Heights in a column: each as near to its wish as the ones above allow; what runs out below pushes back up.
void stack(std::vector<double>& tops, const std::vector<double>& heights, double low, double high, double gap) {
  double least = low;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    tops[i] = std::max(tops[i], least);
    least = tops[i] + heights[i] + gap;
  }
  double most = high;
  for (std::size_t i = tops.size(); i-- > 0;) {
    tops[i] = std::min(tops[i], most - heights[i]);
    most = tops[i] - gap;
  }
}

}  // namespace

std::vector<LabelPlace> layOutLabels(const std::vector<LabelWish>& wishes, const LabelArea& area) {
  const auto& [width, height, margin, gap, taken, takenRight] = area;
  std::vector<LabelPlace> places(wishes.size());
  std::vector<int> columns[2];
  double used[2] = {0, 0};
  const double room[2] = {height - 2 * margin - taken, height - 2 * margin - takenRight};
  for (int i = 0; i < static_cast<int>(wishes.size()); ++i) {
    const LabelWish& wish = wishes[i];
    if (!(wish.width > 0) || wish.width > width - 2 * margin) continue;
    const double need = wish.height + gap;
    int side = wish.anchor.x() < width / 2 ? 0 : 1;
    // The other column where this one is half full and the other is emptier by three: lines grow long, names are read.
    if (used[side] > room[side] / 2 && used[1 - side] + 3 * need < used[side]) side = 1 - side;
    if (used[side] + need > room[side]) side = 1 - side;
    if (used[side] + need > room[side]) continue;
    used[side] += need;
    columns[side].push_back(i);
  }
  for (int side = 0; side < 2; ++side) {
    std::vector<int>& column = columns[side];
    std::stable_sort(column.begin(), column.end(), [&](int a, int b) { return wishes[a].anchor.y() < wishes[b].anchor.y(); });
    std::vector<double> tops, heights;
    for (const int i : column) {
      heights.push_back(wishes[i].height);
      tops.push_back(wishes[i].anchor.y() - wishes[i].height / 2);
    }
    stack(tops, heights, margin, margin + room[side], gap);
    for (std::size_t k = 0; k < column.size(); ++k) {
      const LabelWish& wish = wishes[column[k]];
      LabelPlace& place = places[column[k]];
      place.placed = true;
      place.corner = {side == 0 ? margin : width - margin - wish.width, tops[k]};
      place.lineEnd = {side == 0 ? place.corner.x() + wish.width : place.corner.x(), tops[k] + wish.height / 2};
    }
  }
  return places;
}

}  // namespace glenoid
