// SPDX-License-Identifier: GPL-3.0-or-later
// A line of any width in pixels as a quad with soft edges (core profiles promise a width of one only).
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in vec4 endColor[];
uniform vec2 viewport;     // pixels
uniform float widthPx;
uniform float lift;         // towards the viewer, in clip z (see LinePainter)
out vec4 lineColor;
noperspective out float across;  // pixels from the middle

void corner(vec4 at, vec2 offset, float side, vec4 color) {
  lineColor = color;
  across = side;
  gl_Position = vec4(at.xy + offset / viewport * 2.0 * at.w, at.z - lift, at.w);
  EmitVertex();
}

void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  vec4 colorA = endColor[0], colorB = endColor[1];
  // Cut at the near plane, so that dividing by w keeps its meaning.
  float da = a.z + a.w, db = b.z + b.w;
  if (da <= 0.0 && db <= 0.0) return;
  if (da <= 0.0) a = mix(b, a, 0.999 * db / (db - da));
  if (db <= 0.0) b = mix(a, b, 0.999 * da / (da - db));
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport * 0.5;
  float length2 = dot(along, along);
  vec2 unit = length2 > 1e-12 ? along * inversesqrt(length2) : vec2(1.0, 0.0);
  float reach = 0.5 * widthPx + 0.75;
  vec2 aside = vec2(-unit.y, unit.x) * reach;
  vec2 ahead = unit * 0.5;
  corner(a, aside - ahead, reach, colorA);
  corner(a, -aside - ahead, -reach, colorA);
  corner(b, aside + ahead, reach, colorB);
  corner(b, -aside + ahead, -reach, colorB);
  EndPrimitive();
}
