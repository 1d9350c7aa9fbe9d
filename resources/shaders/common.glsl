// SPDX-License-Identifier: GPL-3.0-or-later
// Put in front of every shader after its #version line. Colours inside are linear; sRGB only on the way out.

// Encoding curve of IEC 61966-2-1. Above its straight beginning a fit in roots (minimax over 4000 encoded
// values, error below 0.012 of an 8-bit step): roots are cheap where a processor draws, powers are not.
vec3 toSrgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 r2 = sqrt(c), r4 = sqrt(r2), r8 = sqrt(r4);
  vec3 curve = 0.642374 * r2 + 0.712101 * r4 - 0.336866 * r8 - 0.017565 * c;
  return mix(12.92 * c, curve, step(0.0031308, c));
}
