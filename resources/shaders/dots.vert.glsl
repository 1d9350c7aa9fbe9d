// SPDX-License-Identifier: GPL-3.0-or-later
// Round dots of a size in pixels.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
uniform mat4 toClip;
uniform float sizePx;
uniform float lift;
out vec4 dotColor;

void main() {
  dotColor = color;
  gl_Position = toClip * vec4(position, 1.0);
  gl_Position.z -= lift;
  gl_PointSize = sizePx + 1.0;
}
