// SPDX-License-Identifier: GPL-3.0-or-later
// Where a selected (1) or hovered (0.5) object is, seen or hidden: its outline is found from this.
uniform float amount;
out vec4 mask;

void main() {
  mask = vec4(amount);
}
