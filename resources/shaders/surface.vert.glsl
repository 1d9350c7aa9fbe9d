// SPDX-License-Identifier: GPL-3.0-or-later
// Places a surface whose positions and normals the evaluation passes have left in buffers.
layout(location = 0) in vec3 position_W;
layout(location = 1) in vec3 normal_W;
layout(location = 2) in vec4 tissue;  // shares of tendon and cartilage; depth into the fat; nail
layout(location = 3) in vec3 grain;   // across, through and along the fibres, or rest position; m
layout(location = 4) in float open;   // share of open sky, cast once
#ifdef FIELD
layout(location = 5) in float value;
out float shownValue;
#endif
uniform mat4 worldToView;
uniform mat4 viewToClip;
uniform int shafts;         // tools near which tissue darkens
uniform vec4 shaftFrom[4];  // camera axes, m; w: radius
uniform vec3 shaftTo[4];
out vec3 p_W;
out vec3 p_V;
out vec3 n_V;
out vec4 share;
out vec3 grainAt;
out float sky;
out float flush;

// What tools leave open: each as the ball on its axis that is nearest, whose share of a hemisphere is
// (radius / distance)^2 cos(angle to the normal).
float besideTools(vec3 p, vec3 n) {
  float open = 1.0;
  for (int i = 0; i < shafts; ++i) {
    vec3 along = shaftTo[i] - shaftFrom[i].xyz, from = p - shaftFrom[i].xyz;
    vec3 d = clamp(dot(from, along) / max(dot(along, along), 1e-12), 0.0, 1.0) * along - from;
    float l2 = max(dot(d, d), 1e-12), r = shaftFrom[i].w;
    open *= 1.0 - clamp(0.35 + 0.65 * dot(n, d) * inversesqrt(l2), 0.0, 1.0) * min(r * r / l2, 1.0);
  }
  return open;
}

// Where skin is redder or paler, in patches of some centimetres: warped waves over the rest shape.
float patches(vec3 at) {
  vec3 w = at * vec3(70.0, 62.0, 66.0) + 1.3 * sin(at.yzx * vec3(130.0, 110.0, 150.0));
  return 0.5 * sin(w.x + w.y) * sin(w.y - w.z) + 0.1 * sin(3.1 * w.x - 2.3 * w.z);
}

void main() {
  p_W = position_W;
#ifdef FIELD
  shownValue = value;
#endif
  share = tissue;
  grainAt = grain;
  p_V = (worldToView * vec4(position_W, 1.0)).xyz;
  n_V = mat3(worldToView) * normal_W;
  sky = open * (shafts > 0 ? besideTools(p_V, n_V) : 1.0);
  flush = patches(grain);
  gl_Position = viewToClip * vec4(p_V, 1.0);
}
