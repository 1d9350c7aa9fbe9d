// SPDX-License-Identifier: GPL-3.0-or-later
in vec4 lineColor;
noperspective in float across;
uniform float widthPx;
uniform float strength;  // of the whole draw: less for what is hidden
out vec4 shaded;

void main() {
  float alpha = lineColor.a * strength * clamp(0.5 * widthPx + 0.5 - abs(across), 0.0, 1.0);
  shaded = vec4(lineColor.rgb * alpha, alpha);
}
