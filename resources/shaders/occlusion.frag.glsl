// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the sky above each visible point is hidden by what is near it, from the depth alone.
// Directions turn by pixel in a 4x4 pattern, which the composing pass averages out. Idea: Mittring,
// "Finding Next Gen: CryEngine 2", SIGGRAPH 2007 course; hemisphere about the surface's own normal as is
// now usual.
uniform sampler2D depth;
uniform vec2 tanHalf;       // of the field of view, x and y
uniform vec2 depthToZ;      // distance = 1 / (d * x + y) from depth d in [0, 1]
uniform int factor;         // depth texels per pixel here
uniform ivec2 size;         // of this pass, pixels
uniform float radius;       // m
uniform int directions;
out vec4 open;  // share of open sky, distance in m: the composing pass averages along one surface only

float distanceAt(ivec2 pixel) {
  ivec2 at = clamp(pixel, ivec2(0), size - 1) * factor + factor / 2;
  return 1.0 / (texelFetch(depth, at, 0).r * depthToZ.x + depthToZ.y);
}

vec3 pointAt(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  float d = distanceAt(pixel);
  return vec3(ndc * tanHalf * d, -d);
}

// Of the two differences the one that stays on the same surface.
vec3 slope(ivec2 pixel, ivec2 step, vec3 p) {
  vec3 ahead = pointAt(pixel + step) - p, behind = p - pointAt(pixel - step);
  return abs(ahead.z) < abs(behind.z) ? ahead : behind;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (texelFetch(depth, clamp(pixel * factor + factor / 2, ivec2(0), size * factor - 1), 0).r >= 1.0) {
    open = vec4(1.0, 1e4, 0.0, 0.0);
    return;
  }
  vec3 p = pointAt(pixel);
  vec3 n = normalize(cross(slope(pixel, ivec2(1, 0), p), slope(pixel, ivec2(0, 1), p)));
  vec3 side = normalize(abs(n.x) < 0.8 ? cross(n, vec3(1, 0, 0)) : cross(n, vec3(0, 1, 0)));
  vec3 third = cross(n, side);
  int turn = (pixel.x & 3) * 4 + (pixel.y & 3);
  float start = float((turn * 7) & 15) / 16.0;
  float hidden = 0.0;
  for (int i = 0; i < directions; ++i) {
    float share = (float(i) + 0.5) / float(directions);
    float angle = 6.2831853 * (float(i) * 0.618034 + start);
    float up = sqrt(1.0 - share * 0.95);
    float flat_ = sqrt(1.0 - up * up);
    vec3 direction = up * n + flat_ * (cos(angle) * side + sin(angle) * third);
    float reach = radius * (0.12 + 0.88 * fract(float(i) * 0.754878 + start));
    vec3 s = p + direction * reach;
    if (s.z > -1e-6) continue;
    vec2 ndc = s.xy / (-s.z * tanHalf);
    ivec2 at = ivec2((ndc * 0.5 + 0.5) * vec2(size));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
    float before = -s.z - distanceAt(at);  // > 0: something stands before the sample
    float bias = 0.02 * radius - 0.0005 * p.z;
    if (before > bias) hidden += smoothstep(0.0, 1.0, radius / max(before, 1e-6));
  }
  open = vec4(1.0 - hidden / float(directions), -p.z, 0.0, 0.0);
}
