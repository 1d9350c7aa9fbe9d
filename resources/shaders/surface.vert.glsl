// SPDX-License-Identifier: GPL-3.0-or-later
// Places a surface whose positions and normals the evaluation passes have left in buffers.
layout(location = 0) in vec3 position_W;
layout(location = 1) in vec3 normal_W;
layout(location = 2) in vec3 tissue;  // shares of tendon and cartilage; depth into the fat
layout(location = 3) in vec3 grain;   // across, through and along the fibres, or rest position; m
layout(location = 4) in float open;   // share of open sky, cast once
uniform mat4 worldToView;
uniform mat4 viewToClip;
out vec3 p_W;
out vec3 p_V;
out vec3 n_V;
out vec3 share;
out vec3 grainAt;
out float sky;

void main() {
  p_W = position_W;
  share = tissue;
  grainAt = grain;
  sky = open;
  p_V = (worldToView * vec4(position_W, 1.0)).xyz;
  n_V = mat3(worldToView) * normal_W;
  gl_Position = viewToClip * vec4(p_V, 1.0);
}
