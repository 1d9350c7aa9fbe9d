// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Layers.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

Result<Layers> layersFromWords(std::string_view words) {
  struct Word {
    std::string_view name;
    bool Layers::*member;
  };
  static constexpr Word kWords[] = {{"visual", &Layers::visual},     {"collision", &Layers::collision},
                                    {"dynamics", &Layers::dynamics}, {"couplings", &Layers::couplings},
                                    {"contacts", &Layers::contacts}, {"tools", &Layers::tools},
                                    {"regions", &Layers::regions},   {"labels", &Layers::labels}};
  Layers layers;
  layers.visual = false;
  while (!words.empty()) {
    const std::size_t comma = words.find(',');
    const std::string_view name = words.substr(0, comma);
    words = comma == std::string_view::npos ? std::string_view() : words.substr(comma + 1);
    bool known = name == "all" || name == "none";  // neither writes names: they are no layer of the scene
    for (const Word& word : kWords) {
      if (name == "none") layers.*word.member = false;
      if (name != word.name && (name != "all" || word.member == &Layers::labels)) continue;
      layers.*word.member = true;
      known = true;
    }
    if (!known) return Error{Fault::BadUsage, {}, {std::string(name)}, "unknown layer"};
  }
  return layers;
}

ColorMap mapOf(const FieldLook& field) { return field.low < 0 && field.high > 0 ? ColorMap::Diverging : ColorMap::Sequential; }

std::array<float, 3> colorOf(const FieldLook& field, double value) {
  if (!std::isfinite(value)) return kNeutralColor;
  const double inside = std::clamp(value, field.low, field.high);
  if (mapOf(field) == ColorMap::Diverging) return colorAt(ColorMap::Diverging, 0.5 + 0.5 * inside / std::max(field.high, -field.low));
  const double share = (inside - field.low) / (field.high - field.low);
  std::array<float, 3> color = colorAt(ColorMap::Sequential, share);
  constexpr double kFade = 0.06;  // share of the scale over which nothing becomes something
  if (field.zeroIsNone && share < kFade)
    for (int i = 0; i < 3; ++i) color[i] = static_cast<float>(kNeutralColor[i] + share / kFade * (color[i] - kNeutralColor[i]));
  return color;
}

}  // namespace glenoid
