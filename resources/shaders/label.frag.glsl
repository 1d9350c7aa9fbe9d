// SPDX-License-Identifier: GPL-3.0-or-later
// Ink on a translucent plate with round corners. Colours are sRGB: this goes over a finished picture.
in vec2 at;
uniform sampler2D text;  // rows from the top
uniform vec2 size;
uniform vec2 pad;
uniform vec3 ink, paper;
uniform float plateOpacity;
out vec4 result;

void main() {
  float radius = min(4.0, 0.4 * size.y);
  vec2 beyond = max(abs(at - 0.5 * size) - (0.5 * size - radius), 0.0);
  float plate = plateOpacity * clamp(radius + 0.5 - length(beyond), 0.0, 1.0);
  ivec2 texel = ivec2(floor(at - pad)), extent = textureSize(text, 0);
  texel.y = extent.y - 1 - texel.y;
  bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, extent));
  float cover = inside ? texelFetch(text, texel, 0).r : 0.0;
  float alpha = max(plate, cover);
  result = vec4(mix(paper, ink, cover) * alpha, alpha);
}
