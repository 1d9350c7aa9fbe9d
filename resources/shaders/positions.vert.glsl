// SPDX-License-Identifier: GPL-3.0-or-later
// One point entity from the state vector, captured by transform feedback.
// Rigid (node.y < 0): p = c + R r, q = (c, quaternion x y z w) at node.x, r in `weight`.
// Soft: p = sum of w_i q_i, node = offset of each node's x in q.
layout(location = 0) in ivec4 node;
layout(location = 1) in vec4 weight;
layout(location = 2) in vec3 shift;  // W, m; zero where none are sent
uniform samplerBuffer q;
// Dents: the vertices [range.x, range.y) of a visual surface sink by `way`, less with the distance r from `place` as
// exp(-r²/(2 place.w²)).
uniform int dentCount;
uniform ivec2 dentRange[4];
uniform vec4 dentPlace[4];
uniform vec3 dentWay[4];
out vec4 position;

vec3 three(int at) {
  return vec3(texelFetch(q, at).r, texelFetch(q, at + 1).r, texelFetch(q, at + 2).r);
}

void main() {
  if (node.y < 0) {
    vec3 u = three(node.x + 3);
    float w = texelFetch(q, node.x + 6).r;
    vec3 t = 2.0 * cross(u, weight.xyz);
    position = vec4(three(node.x) + weight.xyz + w * t + cross(u, t), 1.0);
  } else {
    vec3 p = weight.x * three(node.x);
    p += weight.y * three(node.y);
    p += weight.z * three(node.z);
    p += weight.w * three(node.w);
    for (int i = 0; i < dentCount; ++i) {
      if (gl_VertexID < dentRange[i].x || gl_VertexID >= dentRange[i].y) continue;
      vec3 off = (p - dentPlace[i].xyz) / dentPlace[i].w;
      p += exp(-0.5 * dot(off, off)) * dentWay[i];
    }
    position = vec4(p, 1.0);
  }
  position.xyz += shift;
}
