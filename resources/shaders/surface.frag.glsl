// SPDX-License-Identifier: GPL-3.0-or-later
// Tissue as in an atlas: three soft lights that stand with the camera, a sky and a ground, a moist
// highlight and a thin bright rim; where the surface turns away it darkens, which draws its contour. The
// inside of a surface is matt and dark, so that a mesh wound inside out shows at once.
// With DETAIL muscle shows bundles of fibres that pass into their tendon in streaks, a ligament its strands, bone is
// mottled, skin finely lined and flushed, a cut through fat lobed; the same grain is a relief that breaks the
// highlights. All fade before they grow finer than a pixel.
// Highlight: Trowbridge-Reitz distribution, Schlick's Fresnel term and the visibility term after
// Lagarde and de Rousiers, "Moving Frostbite to Physically Based Rendering", SIGGRAPH 2014 course notes.
// Relief from screen derivatives: Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010.
in vec3 p_V;
in vec3 n_V;
in vec4 share;    // tendon, cartilage, depth into the fat, nail
in vec3 grainAt;  // m
in float sky;     // share of it that other tissue and tools leave open
in float flush;   // of skin, -0.5...0.5
uniform vec3 color;        // linear
uniform float opacity;
uniform bool faceted;      // one normal for each triangle
uniform float roughness;
uniform int grain;         // 0 none, 1 muscle, 2 bone, 3 collagen, 4 skin, 5 a finger
uniform float wet;         // 0...1, film of fluid
uniform float occluded;    // 0...1, how much hollows darken
uniform vec4 tint;         // linear colour and strength: selected, hovered
uniform vec3 up_V;         // the world's vertical in camera axes
#ifdef SCOPE
uniform float reach;       // m: where the lamp at the eye lights as the camera expects
uniform float fog;         // 1/m: how fast fluid veils
#endif
#ifdef FIELD
in float shownValue;
uniform sampler1D scale;   // sRGB, from low to high
uniform vec2 ends;         // values at its ends
uniform bool valued;       // or `color` alone
#endif
out vec4 shaded;

#ifdef DETAIL
float lattice(ivec3 p) {
  uint h = uint(p.x) * 0x8da6b343u + uint(p.y) * 0xd8163841u + uint(p.z) * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h ^= h >> 13;
  return float(h & 0xffffu) / 65535.0;
}

// Smooth noise 0...1 with a feature size of one; its mean where `pixel`, its change over a pixel, comes
// near that size.
float noise(vec3 p, float pixel) {
  ivec3 cell = ivec3(floor(p));
  vec3 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 w = mix(1.0 - f, f, vec3(corner));
    sum += w.x * w.y * w.z * lattice(cell + corner);
  }
  return mix(sum, 0.5, smoothstep(0.35, 1.0, pixel));
}

float grainOf(vec3 at, vec3 coarse, vec3 fine) {
  vec3 step = max(abs(dFdx(at)), abs(dFdy(at)));
  vec3 a = step / coarse, b = step / fine;
  float rough = noise(at / coarse, max(a.x, max(a.y, a.z)));
  return 0.62 * rough + 0.38 * noise(at / fine + 17.0, max(b.x, max(b.y, b.z)));
}

// Turned as a relief of this height (m) turns it.
vec3 embossed(vec3 n, float height) {
  vec3 dx = dFdx(p_V), dy = dFdy(p_V), a = cross(dy, n), b = cross(n, dx);
  float area = dot(dx, a);
  vec3 slope = sign(area) * (dFdx(height) * a + dFdy(height) * b);
  float most = 0.5 * abs(area);  // a step between two pixels is no cliff
  float length2 = dot(slope, slope);
  if (length2 > most * most) slope *= most * inversesqrt(length2);
  return normalize(abs(area) * n - slope);
}

// Where a muscle's flesh ends in tendon, by the share that falls from 1 to 0 over some way: its bundles reach
// into the tendon by different lengths, and so do its finer fibres.
float streaked(float tendon) {
  if (tendon <= 0.0 || tendon >= 1.0) return tendon;
  float streaks = grainOf(grainAt + 3.1, vec3(0.0060, 0.0120, 0.090), vec3(0.0017, 0.0030, 0.040));
  return smoothstep(0.27, 0.73, tendon + 1.4 * (streaks - 0.5) * min(4.0 * tendon * (1.0 - tendon), 1.0));
}
#endif

vec3 litBy(vec3 light, vec3 radiance, float wrap, float rough, vec3 n, vec3 v, vec3 albedo) {
  float nl = dot(n, light);
  float soft = clamp((nl + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 diffuse = albedo * soft * soft;
  float lit = max(nl, 0.0);
  vec3 h = normalize(light + v);
  float nh = max(dot(n, h), 0.0), nv = max(dot(n, v), 1e-3), vh = max(dot(v, h), 0.0);
  float a = rough * rough;
  float d = nh * nh * (a * a - 1.0) + 1.0;
  float spread = a * a / (3.14159265 * d * d);
  float visible = 0.5 / max(mix(2.0 * lit * nv, lit + nv, a), 1e-3);
  float f = (1.0 - vh) * (1.0 - vh);
  float fresnel = 0.04 + 0.96 * f * f * (1.0 - vh);
  return radiance * (diffuse + spread * visible * fresnel * lit);
}

#ifdef FIELD
// What the tone curve of compose.frag turns into c.
vec3 beforeTone(vec3 c) {
  float m = dot(c, vec3(0.2126, 0.7152, 0.0722)), a = 0.9 / (3.2 * 3.2), b = 0.9 - 0.6 * m;
  float light = (sqrt(b * b + 4.0 * a * m) - b) / (2.0 * a);
  return m > 1e-6 ? c * (light / m) : c;
}

vec3 fromSrgb(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}

// Colours that are to be read: those of the scale where the surface faces the viewer, darker where it turns away and in
// hollows, no light of any colour and no highlight.
vec3 readable(float nv, bool outside) {
  vec3 base = color;
  if (valued) {
    float entries = float(textureSize(scale, 0));
    float share = clamp((shownValue - ends.x) / (ends.y - ends.x), 0.0, 1.0);
    base = fromSrgb(texture(scale, (share * (entries - 1.0) + 0.5) / entries).rgb);
  }
  float shade = mix(0.42, 1.0, smoothstep(0.0, 0.85, nv));
  shade *= 1.0 - occluded * 0.45 * (1.0 - (outside ? sky : 1.0));
  return beforeTone(outside ? base * shade : vec3(0.12) * shade);
}
#endif

void main() {
  vec3 face = normalize(cross(dFdx(p_V), dFdy(p_V)));  // towards the viewer
  vec3 v = normalize(-p_V);
  bool outside = gl_FrontFacing;
  vec3 n = faceted || dot(n_V, n_V) < 1e-12 ? face : normalize(n_V) * (outside ? 1.0 : -1.0);
  // An interpolated normal may lean away from the viewer at a contour: it is turned back until it just
  // grazes.
  float nv = dot(n, v);
  if (nv < 0.02) n = normalize(n + (0.02 - nv) * v);
  nv = clamp(dot(n, v), 0.0, 1.0);
#ifdef FIELD
  float covers = opacity >= 1.0 ? 1.0 : clamp(opacity, 0.0, 1.0);
  shaded = vec4(readable(nv, outside) * covers, covers);
  return;
#endif

  // Tendon: pearly, silky. Cartilage: bluish white, smooth. Fat: yellow, moist.
  float tendon = smoothstep(0.15, 0.85, share.x), fat = 0.0;
#ifdef DETAIL
  if (grain == 1) tendon = streaked(share.x);
#endif
  vec3 tissueColor = mix(color, vec3(0.86, 0.80, 0.67), 0.92 * tendon);
  tissueColor = mix(tissueColor, vec3(0.66, 0.75, 0.80), 0.75 * smoothstep(0.15, 0.85, share.y));
  float rough = mix(mix(roughness, 0.36, tendon), 0.30, share.y);
  float film = wet * mix(1.0, 1.5, share.y);
#ifdef DETAIL
  if (grain != 0) {
    vec3 coarse = vec3(0.011), fine = vec3(0.0032);
    float depth = mix(0.16, 0.03, share.y), relief = 1.2e-4 * (1.0 - share.y);
    if (grain == 1) {
      coarse = mix(vec3(0.0026, 0.0090, 0.045), vec3(0.0014, 0.0030, 0.060), step(0.5, tendon));
      fine = mix(vec3(0.0009, 0.0040, 0.018), vec3(0.0005, 0.0010, 0.020), step(0.5, tendon));
      depth = mix(0.75, 0.30, tendon);
      relief = mix(4.0e-4, 1.2e-4, tendon);
    } else if (grain == 3) {
      coarse = vec3(0.0016, 0.0020, 0.030);
      fine = vec3(0.0005, 0.0010, 0.012);
      depth = 0.34;
      relief = 0.9e-4;
    } else if (grain >= 4) {
      // The skin is a fifth of what lies over the flesh; its border in a cut is not quite even.
      coarse = vec3(0.006);
      fine = vec3(0.0011);
      depth = 0.16;
      relief = 1.0e-4;
    }
    float g = grainOf(grainAt, coarse, fine) - 0.5;
    vec3 hue = vec3(0.9, 1.05, 1.1);  // a darker strand is a little warmer
    if (grain == 5) {
      hue = vec3(0.35, 1.0, 1.0);
      float nail = smoothstep(0.42, 0.58, share.w), rim = nail * (1.0 - smoothstep(0.58, 0.80, share.w));
      tissueColor = mix(tissueColor, vec3(0.80, 0.50, 0.43) + 0.12 * rim, nail);
      rough = mix(rough, 0.24, nail);
      film = 0.5 * nail;
      depth *= 1.0 - nail;
      relief *= 1.0 - nail;
    }
    if (grain == 4) {
      fat = smoothstep(0.17, 0.21, share.z + 0.08 * g);
      hue = vec3(0.35, 1.0, 1.0);  // skin flushes where it is thin
      tissueColor *= 1.0 + flush * vec3(0.03, 0.13, 0.17);
      tissueColor = mix(tissueColor, vec3(0.92, 0.66, 0.25) * (1.0 + 0.6 * g), fat);
      tissueColor = mix(tissueColor, vec3(0.86, 0.64, 0.54), (1.0 - fat) * smoothstep(0.02, 0.05, share.z));
      rough = mix(rough, 0.40, fat);
      film = mix(film, 0.5, fat);
      relief *= 1.0 + 4.0 * fat;
    }
    tissueColor *= 1.0 + depth * g * hue;
    rough = clamp(rough - 0.25 * depth * g, 0.2, 0.9);
    film *= clamp(1.0 + 1.6 * g, 0.2, 1.8);
    if (!faceted) n = embossed(n, (outside ? relief : 0.0) * g);
    nv = clamp(dot(n, v), 0.0, 1.0);
  }
#endif
  vec3 albedo = outside ? tissueColor : mix(color, vec3(dot(color, vec3(0.21, 0.72, 0.07))), 0.6) * 0.30;
#ifdef SCOPE
  // One lamp, at the eye: by the inverse square, bounded near, and what tissue throws back into the joint.
  float away = length(p_V), lamp = min(1.0 / (away * away / (reach * reach) + 0.12), 3.2);
  vec3 lampColor = lamp * vec3(1.05, 1.02, 0.98);
  vec3 result = albedo * (0.10 * lamp + 0.004) + litBy(v, lampColor, 0.12, rough, n, v, albedo);
  if (outside && film > 0.0) {
    float a = 0.03, d = nv * nv * (a - 1.0) + 1.0;
    result += film * 0.16 * lampColor * min(a / (3.14159265 * d * d), 8.0) * nv;
  }
  float open = 1.0 - occluded * 0.5 * (1.0 - (outside ? sky : 1.0));
  result *= open * vec3(sqrt(sqrt(open)), 1.0, 1.0);
  result *= 1.0 - 0.35 * smoothstep(0.75, 1.0, 1.0 - nv);
  result = mix(result, tint.rgb * (0.35 + 0.65 * nv), 0.5 * tint.a);
  float clear = exp(-fog * away);
  result = mix(vec3(0.42, 0.36, 0.33) * min(lamp, 1.0), result, clear);
  shaded = vec4(result * (opacity >= 1.0 ? 1.0 : clamp(opacity, 0.0, 1.0)), opacity >= 1.0 ? 1.0 : clamp(opacity, 0.0, 1.0));
#else
  float height = dot(n, normalize(up_V + vec3(0.0, 0.6, 0.0))) * 0.5 + 0.5;
  vec3 ambient = mix(vec3(0.30, 0.25, 0.23), vec3(0.52, 0.56, 0.62), height);
  vec3 result = albedo * ambient;
  result += litBy(normalize(vec3(-0.45, 0.60, 0.75)), vec3(1.14, 1.09, 1.01), 0.20, rough, n, v, albedo);
  result += litBy(normalize(vec3(0.80, 0.05, 0.55)), vec3(0.34, 0.39, 0.47), 0.35, rough, n, v, albedo);
  result += litBy(normalize(vec3(0.25, 0.55, -0.80)), vec3(0.50, 0.52, 0.55), 0.10, rough, n, v, albedo);

  if (outside && film > 0.0) {
    // Water on tissue: a second, narrow highlight of the key light, with water's reflectance.
    vec3 key = normalize(vec3(-0.45, 0.60, 0.75)), h = normalize(key + v);
    float nh = max(dot(n, h), 0.0), a = 0.045, d = nh * nh * (a - 1.0) + 1.0;
    result += film * 0.10 * vec3(1.14, 1.09, 1.01) * min(a / (3.14159265 * d * d), 6.0) * max(dot(n, key), 0.0);
  }

  float open = 1.0 - occluded * 0.9 * (1.0 - (outside ? sky : 1.0));
  float root = sqrt(open);
  result *= open * vec3(sqrt(root), root, root);  // hollows of tissue stay warm

  float graze = 1.0 - nv;
  float contour = smoothstep(0.70, 1.0, graze);
  if (outside && !faceted) {
    result *= 1.0 - 0.45 * contour;
    result += mix(vec3(0.8), albedo, 0.5) * 0.10 * graze * graze * graze * height;
  }
  result = mix(result, tint.rgb * (0.35 + 0.65 * nv), tint.a * (0.45 + 0.55 * graze));

  // A film is denser where one looks along it.
  float denser = (1.0 - opacity) * 0.55 * graze * graze * sqrt(graze);
  float alpha = opacity >= 1.0 ? 1.0 : clamp(opacity + denser, 0.0, 1.0);
  shaded = vec4(result * alpha, alpha);
#endif
}
