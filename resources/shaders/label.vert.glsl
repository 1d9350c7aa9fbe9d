// SPDX-License-Identifier: GPL-3.0-or-later
// A plate of a name, in pixels from the lower left.
uniform vec2 corner;
uniform vec2 size;
uniform vec2 viewport;
out vec2 at;  // pixels from the plate's lower left

void main() {
  at = size * vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(2.0 * (corner + at) / viewport - 1.0, 0.0, 1.0);
}
