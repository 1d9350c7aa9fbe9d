// SPDX-License-Identifier: GPL-3.0-or-later
// A translucent plate with a bar of colours on it, low below. Colours are sRGB: this goes over a finished picture.
in vec2 at;  // pixels from the plate's lower left
uniform sampler1D scale;
uniform vec2 size;
uniform vec2 barFrom, barTo;  // of the bar, the same pixels
uniform vec3 ink, paper;
uniform float frame;          // pixels around the bar
out vec4 result;

void main() {
  float radius = min(5.0, 0.4 * size.y);
  vec2 beyond = max(abs(at - 0.5 * size) - (0.5 * size - radius), 0.0);
  float alpha = 0.86 * clamp(radius + 0.5 - length(beyond), 0.0, 1.0);
  vec3 color = paper;
  if (all(greaterThan(at, barFrom - frame)) && all(lessThan(at, barTo + frame))) {
    alpha = 1.0;
    color = ink;
    if (all(greaterThan(at, barFrom)) && all(lessThan(at, barTo))) {
      float entries = float(textureSize(scale, 0)), share = (at.y - barFrom.y) / (barTo.y - barFrom.y);
      color = texture(scale, (share * (entries - 1.0) + 0.5) / entries).rgb;
    }
  }
  result = vec4(color * alpha, alpha);
}
