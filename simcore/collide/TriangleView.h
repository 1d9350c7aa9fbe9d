// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "simcore/collide/MovingSurface.h"

/// Two triangles seen in single precision, to throw away pairs that are far apart.
namespace glenoid {

/// How the corners of a triangle lie over the plane of another one, a bit for each lane.
struct PlaneView {
  int high, low;      ///< above `high`, below −`low`
  int near;           ///< no further than `high` on either side
  int above, below;   ///< certainly on one side
  bool beyond() const { return high == 15 || low == 15; }
  bool crosses() const { return above != 15 && below != 15; }
};

inline PlaneView viewOver(const MovingSurface::Lanes& corners, const MovingSurface::Lanes& plane, float high, float low, float slack) {
#ifdef __SSE2__
  const __m128 x = _mm_mul_ps(_mm_load_ps(corners.x.data()), _mm_set1_ps(plane.normal[0]));
  const __m128 y = _mm_mul_ps(_mm_load_ps(corners.y.data()), _mm_set1_ps(plane.normal[1]));
  const __m128 z = _mm_mul_ps(_mm_load_ps(corners.z.data()), _mm_set1_ps(plane.normal[2]));
  const __m128 height = _mm_sub_ps(_mm_add_ps(_mm_add_ps(x, y), z), _mm_set1_ps(plane.offset));
  const auto over = [&](float limit) { return _mm_movemask_ps(_mm_cmpgt_ps(height, _mm_set1_ps(limit))); };
  const auto under = [&](float limit) { return _mm_movemask_ps(_mm_cmplt_ps(height, _mm_set1_ps(limit))); };
  const int beyond = over(high);
  return {beyond, under(-low), 15 & ~(beyond | under(-high)), over(slack), under(-slack)};
#else
  PlaneView view{0, 0, 0, 0, 0};
  for (int lane = 0; lane < 4; ++lane) {
    const float height = corners.x[lane] * plane.normal[0] + corners.y[lane] * plane.normal[1] +
                         corners.z[lane] * plane.normal[2] - plane.offset;
    view.high |= (height > high) << lane;
    view.low |= (height < -low) << lane;
    view.near |= (height <= high && height >= -high) << lane;
    view.above |= (height > slack) << lane;
    view.below |= (height < -slack) << lane;
  }
  return view;
#endif
}

/// Whether two triangles' own boxes lie apart; the nodes' boxes are wider by margins that add up to `reach`.
inline bool boxesApart(const BoxTree::Node& a, const BoxTree::Node& b, float reach) {
#ifdef __SSE2__
  // The fourth lane holds child numbers and is not looked at.
  const __m128 wide = _mm_set1_ps(reach);
  const __m128 left = _mm_cmpgt_ps(_mm_add_ps(_mm_load_ps(a.low.data()), wide), _mm_load_ps(b.high.data()));
  const __m128 right = _mm_cmpgt_ps(_mm_add_ps(_mm_load_ps(b.low.data()), wide), _mm_load_ps(a.high.data()));
  return (_mm_movemask_ps(_mm_or_ps(left, right)) & 7) != 0;
#else
  bool apart = false;
  for (int k = 0; k < 3; ++k) apart |= (a.low[k] + reach > b.high[k]) | (b.low[k] + reach > a.high[k]);
  return apart;
#endif
}

}  // namespace glenoid
