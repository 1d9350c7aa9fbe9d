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
