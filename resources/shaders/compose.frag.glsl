// SPDX-License-Identifier: GPL-3.0-or-later
// From what was drawn to what is seen: averages the supersamples, compresses bright light, lays the
// scene over the background, draws outlines of what is selected and writes sRGB.
// Built with WITH_OUTLINE or without: a processor that draws would run both sides of a branch.
// Tone curve: Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002, equation
// 4.
uniform sampler2D scene;      // premultiplied, linear
uniform sampler2D mask;
uniform int factor;           // scene texels per pixel
uniform ivec2 size;           // pixels
uniform int outlinePx;
uniform vec3 outlineColor;    // linear
uniform vec3 top, bottom;     // background, square roots of linear colours: nearly even steps to the eye
uniform bool background;
out vec4 result;
#ifdef SCOPE
uniform vec4 field;    // middle of the round field and its radius, pixels from the lower left; distortion
uniform vec3 notch;    // where its mark stands (unit, y up); whether there is one
uniform float blood;   // 0...1
uniform float haze;    // 0...1

// What was drawn at a place in pixels, between texels.
vec4 sceneAt(vec2 place) {
  vec2 at = place * float(factor) - 0.5;
  ivec2 low = ivec2(floor(at)), most = size * factor - 1;
  vec2 f = at - vec2(low);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec4 s = texelFetch(scene, clamp(low + corner, ivec2(0), most), 0);
    vec2 w = mix(1.0 - f, f, vec2(corner));
    sum += w.x * w.y * s;
  }
  return sum;
}

// Slow clouds over the field, 0...1, each with a width of its own.
float clouds(vec2 at) {
  float sum = 0.0, share = 0.55;
  for (int i = 0; i < 4; ++i) {
    at = mat2(0.8, 0.6, -0.6, 0.8) * at * 1.9 + 3.7;
    sum += share * (0.5 + 0.5 * sin(at.x + 1.3 * sin(at.y)) * sin(at.y + 1.1 * sin(at.x)));
    share *= 0.5;
  }
  return clamp(sum, 0.0, 1.0);
}
#endif

vec3 compressed(vec3 c) {
  float light = dot(c, vec3(0.2126, 0.7152, 0.0722));
  float white = 3.2;
  float mapped = 0.9 * light * (1.0 + light / (white * white)) / (1.0 + 0.6 * light);
  return light > 0.0 ? c * (mapped / light) : c;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0.0);
  float alpha = 0.0;
#ifdef SCOPE
  vec2 from = (gl_FragCoord.xy - field.xy) / field.z;
  float r = length(from);
  for (int y = 0; y < factor; ++y)
    for (int x = 0; x < factor; ++x) {
      vec2 sub = from + (vec2(x, y) + 0.5 - 0.5 * float(factor)) / (float(factor) * field.z);
      vec4 s = sceneAt(field.xy + field.z * sub * (1.0 + field.w) / (1.0 + field.w * dot(sub, sub)));
      if (s.a > 0.0) color += compressed(s.rgb / s.a) * s.a;
      alpha += s.a;
    }
  color /= float(factor * factor);
  alpha /= float(factor * factor);
  color += (1.0 - alpha) * mix(vec3(0.010, 0.008, 0.008), vec3(0.20, 0.17, 0.16), haze);  // fluid without an end
  float drift = clouds(2.6 * from);
  float bled = clamp(blood * 1.7 - 0.7 * (1.0 - drift), 0.0, 1.0) * smoothstep(0.0, 0.1, blood);
  color = mix(color, vec3(0.26, 0.015, 0.012) * (0.6 + 0.6 * drift), 0.92 * bled);
  color *= 1.0 - 0.38 * r * r * r * r;
  // A wedge on the rim, its point inwards.
  if (notch.z > 0.5) {
    float inwards = 1.0 - dot(from, notch.xy), aside = abs(from.x * notch.y - from.y * notch.x);
    float wedge = clamp((0.075 - inwards - 1.6 * aside) * field.z * 0.5 + 0.5, 0.0, 1.0);
    color *= 1.0 - wedge * step(0.0, dot(from, notch.xy));
  }
  color *= clamp((1.0 - r) * field.z + 0.5, 0.0, 1.0);
  result = vec4(toSrgb(color), 1.0);
  return;
#endif
  for (int y = 0; y < factor; ++y)
    for (int x = 0; x < factor; ++x) {
      vec4 s = texelFetch(scene, pixel * factor + ivec2(x, y), 0);
      if (s.a > 0.0) color += compressed(s.rgb / s.a) * s.a;
      alpha += s.a;
    }
  color /= float(factor * factor);
  alpha /= float(factor * factor);

  if (background) {
    float height = (gl_FragCoord.y) / float(size.y);
    vec2 middle = (gl_FragCoord.xy / vec2(size) - 0.5);
    vec3 back = mix(bottom, top, smoothstep(0.0, 1.0, height));
    color += (1.0 - alpha) * (1.0 - 0.28 * dot(middle, middle)) * back * back;
    alpha = 1.0;
  }

#ifdef WITH_OUTLINE
  float here = texelFetch(mask, pixel, 0).r, strongest = 0.0;
  for (int y = -outlinePx; y <= outlinePx; ++y)
    for (int x = -outlinePx; x <= outlinePx; ++x) {
      float nearness = clamp(float(outlinePx) + 0.5 - length(vec2(x, y)), 0.0, 1.0);
      ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), size - 1);
      strongest = max(strongest, nearness * texelFetch(mask, at, 0).r);
    }
  float line = clamp(strongest - here, 0.0, 1.0);
  color = mix(color, outlineColor, line);
  alpha = max(alpha, line);
#endif

  vec3 encoded = toSrgb(alpha > 0.0 ? color / alpha : color);
  // Half a step of an ordered 2x2 pattern keeps a wide gradient from banding; the same in every run.
  float pattern = float((pixel.x & 1) * 2 + ((pixel.x ^ pixel.y) & 1)) / 4.0 - 0.375;
  result = vec4(encoded + (background ? pattern / 255.0 : 0.0), 1.0) * vec4(vec3(alpha), alpha);
}
