// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of lines, handed to the stage that makes quads of them. Colour: linear, or constant for a whole draw.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
uniform mat4 toClip;
out vec4 endColor;

void main() {
  endColor = color;
  gl_Position = toClip * vec4(position, 1.0);
}
