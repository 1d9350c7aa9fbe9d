// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen in a pixel, as numbers.
in vec3 p_W;
uniform int object;
uniform int surface;
layout(location = 0) out ivec4 what;   // object + 1, surface, triangle
layout(location = 1) out vec4 where;   // world
layout(location = 2) out vec4 normal;  // world, of the flat triangle

void main() {
  what = ivec4(object + 1, surface, gl_PrimitiveID, 0);
  where = vec4(p_W, 1.0);
  vec3 n = cross(dFdx(p_W), dFdy(p_W));
  float scale = max(abs(n.x), max(abs(n.y), abs(n.z)));
  normal = vec4(scale > 0.0 ? normalize(n / scale) : vec3(0.0), 0.0);
}
