// SPDX-License-Identifier: GPL-3.0-or-later
in vec4 dotColor;
uniform float sizePx;
uniform float strength;
out vec4 shaded;

void main() {
  float size = sizePx + 1.0;
  vec2 offset = (gl_PointCoord - 0.5) * size;
  float radius = 0.5 * sizePx;
  float r = length(offset);
  float alpha = dotColor.a * strength * clamp(radius + 0.5 - r, 0.0, 1.0);
  // A little ball: lighter towards the upper left, darker at its edge.
  float ball = 1.0 - 0.45 * smoothstep(0.0, radius, length(offset + 0.25 * radius));
  shaded = vec4(dotColor.rgb * ball * alpha, alpha);
}
