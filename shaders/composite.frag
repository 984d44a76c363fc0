// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Light and lines over the backdrop, averaged over the samples of a pixel.
uniform sampler2D colors;
uniform sampler2D normals;
uniform sampler2D depths;
uniform sampler2D overlay;        // polylines and wire, alpha is the strength
uniform sampler2D row_distances;  // of contour marks
uniform sampler2D openness;       // one texel per pixel
uniform sampler2D veil;           // translucent surfaces, lit, times their strength

uniform int samples;              // per pixel and axis
uniform ivec2 viewport_origin;    // pixels of the target
uniform int border;               // pixels of the drawn frame outside the viewport
uniform bool perspective;
uniform vec2 view_extent;
uniform vec2 view_center;
uniform bool lit;
uniform bool occluded;
uniform bool veiled;              // there are such
uniform bool contours;
uniform float contour_half_width;  // samples
uniform int contour_reach;         // samples
uniform vec4 contour_color;

layout(location = 0) out vec4 color;

// The colour on screen of a surface of that colour.
vec3 lit_clay(vec3 surface, vec3 normal, vec3 to_eye, float open_sky);

vec3 eye_direction(ivec2 place) {
  if (!perspective) return vec3(0.0, 0.0, 1.0);
  vec2 share = 2.0 * (vec2(place) + 0.5) / vec2(textureSize(depths, 0)) - 1.0;
  return normalize(vec3(-(view_center + share * view_extent), 1.0));
}

float contour_strength(ivec2 place) {
  float nearest = 1e9;
  int last = textureSize(row_distances, 0).y - 1;
  for (int dy = -contour_reach; dy <= contour_reach; ++dy) {
    float dx = 255.0 * texelFetch(row_distances, ivec2(place.x, clamp(place.y + dy, 0, last)), 0).x;
    nearest = min(nearest, dx * dx + float(dy * dy));
  }
  // The break lies half a sample from the marks on its two sides.
  return clamp(contour_half_width - sqrt(nearest), 0.0, 1.0);
}

// Every sample is smoothed with those of its pixel that belong to it, to take the spiral's grain away.
float open_sky_at(ivec2 pixel, vec2 here) {
  float sum = 0.0;
  float weight = 0.0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      ivec2 other = clamp(pixel + ivec2(dx, dy), ivec2(0), textureSize(openness, 0) - 1);
      if (texelFetch(depths, other * samples + samples / 2, 0).y != here.y) continue;
      sum += texelFetch(openness, other, 0).x;
      weight += 1.0;
    }
  }
  return weight > 0.0 ? sum / weight : 1.0;
}

// One colour times its strength over another.
vec4 over(vec4 upper, vec4 lower) { return upper + (1.0 - upper.a) * lower; }

vec4 ink(vec4 line) { return vec4(line.rgb * line.a, line.a); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport_origin + border;
  vec2 middle = texelFetch(depths, pixel * samples + samples / 2, 0).xy;
  float open_sky = lit && occluded ? open_sky_at(pixel, middle) : 1.0;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < samples * samples; ++i) {
    ivec2 place = pixel * samples + ivec2(i % samples, i / samples);
    vec4 drawn = vec4(0.0);
    vec4 surface = texelFetch(colors, place, 0);
    if (surface.a != 0.0) {
      drawn = vec4(surface.rgb, 1.0);
      if (lit) {
        drawn.rgb = lit_clay(surface.rgb, texelFetch(normals, place, 0).xyz, eye_direction(place), open_sky);
      }
    }
    if (veiled) drawn = over(texelFetch(veil, place, 0), drawn);
    drawn = over(ink(texelFetch(overlay, place, 0)), drawn);
    if (contours) drawn = over(ink(vec4(contour_color.rgb, contour_color.a * contour_strength(place))), drawn);
    sum += clamp(drawn, 0.0, 1.0);
  }
  color = sum / float(samples * samples);
}
