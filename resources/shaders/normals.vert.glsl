// SPDX-License-Identifier: GPL-3.0-or-later
// Area-weighted vertex normal: the sum of the cross products of the incident triangles, each given by its
// other two vertices in order. Zero where a vertex has no triangle or all of them are flat.
layout(location = 0) in ivec2 ring;  // first entry and count in `neighbours`
uniform samplerBuffer positions;
uniform isamplerBuffer neighbours;
out vec4 normal;

void main() {
  vec3 p = texelFetch(positions, gl_VertexID).xyz;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < ring.y; ++i) {
    ivec2 other = texelFetch(neighbours, ring.x + i).xy;
    sum += cross(texelFetch(positions, other.x).xyz - p, texelFetch(positions, other.y).xyz - p);
  }
  // Metres squared of small triangles are tiny numbers: scaled before they are squared again.
  float scale = max(abs(sum.x), max(abs(sum.y), abs(sum.z)));
  normal = vec4(scale > 0.0 ? normalize(sum / scale) : vec3(0.0), 0.0);
}
