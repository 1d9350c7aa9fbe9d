// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Math.h"

/// Where names stand beside a picture, as in an atlas; no OpenGL here. Pixels from the upper left.
namespace glenoid {

/// What is to be named: a point of it that is seen, and the size of its name.
struct LabelWish {
  Vec2 anchor = Vec2::Zero();
  double width = 0, height = 0;
};

struct LabelPlace {
  bool placed = false;        ///< false: no room is left for it
  Vec2 corner = Vec2::Zero(); ///< upper left of the name
  Vec2 lineEnd = Vec2::Zero();///< of the line that begins at the anchor: the name's side that faces it
};

/// The picture, and what of it names keep clear of.
struct LabelArea {
  double width = 0, height = 0;
  double margin = 10, gap = 4;     ///< to the borders; between two names
  double taken = 0;                ///< height of the lower left corner that something else needs
  double takenRight = 0;           ///< of the lower right one
};

/// Two columns at the left and right border: a name goes to the nearer one while that has room, and stands as near to
/// its anchor's height as the others allow. Within a column names keep the order of their anchors, so that lines do not
/// cross. What finds no room, of many the last ones, is left out. By wish, in order.
std::vector<LabelPlace> layOutLabels(const std::vector<LabelWish>& wishes, const LabelArea& area);

}  // namespace glenoid
