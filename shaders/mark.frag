// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Symbols by their distance functions: fill, outline around it, halo around that.
flat in vec2 middle;
flat in float measure;
flat in vec3 mark_lengths;  // size, outline, halo in pixels
flat in vec2 mark_angles;
flat in vec4 fill_color;
flat in vec4 outline_color;
flat in vec4 halo_color;
flat in uint mark_shape;

uniform float strength;  // of everything

layout(location = 0) out vec4 color;

float visible_share(ivec2 pixel, float measure_, float slack);

// In the order of MarkShape.
const uint disc = 0u, ring = 1u, square = 2u, cross_ = 3u, warning = 4u, over_under = 5u;

vec2 turned(vec2 place, float angle) {
  return vec2(cos(angle) * place.x + sin(angle) * place.y, cos(angle) * place.y - sin(angle) * place.x);
}

// All distances are negative inside. A bar of that half length along x with round ends.
float bar(vec2 place, float half_length, float radius) {
  place.x -= clamp(place.x, radius - half_length, half_length - radius);
  return length(place) - radius;
}

float box(vec2 place, float half_side) {
  vec2 beyond = abs(place) - half_side;
  return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
}

// An upright triangle of equal sides with rounded corners that fills the mark's circle.
float triangle(vec2 place, float radius) {
  float rounding = 0.16 * radius;
  float inner = 0.5 * (radius - rounding) - 0.04 * radius;
  vec2 p = vec2(abs(place.x), place.y + 0.12 * radius);
  float side = dot(p, vec2(0.8660254, 0.5)) - inner;
  return max(side, -p.y - inner) - rounding;
}

float exclamation(vec2 place, float radius) {
  float stem = bar(turned(place - vec2(0.0, 0.08 * radius), 1.5707963), 0.32 * radius, 0.1 * radius);
  return min(stem, length(place + vec2(0.0, 0.42 * radius)) - 0.12 * radius);
}

float crossing_bars(vec2 place, float radius) {
  float thickness = 0.17 * radius;
  float upper = bar(turned(place, mark_angles.x), radius, thickness);
  float lower = bar(turned(place, mark_angles.y), radius, thickness);
  return min(upper, max(lower, max(0.22 * radius, 1.5) - upper));
}

float distance_to_shape(vec2 place, float radius) {
  if (mark_shape == over_under) return crossing_bars(place, radius);
  place = turned(place, mark_angles.x);
  if (mark_shape == square) return box(place, 0.886 * radius);
  if (mark_shape == warning) return triangle(place, radius);
  if (mark_shape == cross_) {
    vec2 diagonal = turned(place, 0.78539816);
    float thickness = max(0.17 * radius, 0.75);
    return min(bar(diagonal, radius, thickness), bar(diagonal.yx, radius, thickness));
  }
  if (mark_shape == ring) {
    float thickness = max(0.15 * radius, 0.75);
    return abs(length(place) - radius + thickness) - thickness;
  }
  return length(place) - radius;
}

float covered(float outside) { return clamp(0.5 - outside, 0.0, 1.0); }

// Premultiplied: top over bottom.
vec4 over(vec4 top, float share, vec4 bottom) {
  float alpha = top.a * share;
  return vec4(top.rgb * alpha, alpha) + (1.0 - alpha) * bottom;
}

void main() {
  vec2 place = gl_FragCoord.xy - middle;
  float radius = 0.5 * mark_lengths.x;
  float outside = distance_to_shape(place, radius);
  vec4 drawn = over(halo_color, mark_lengths.z > 0.0 ? covered(outside - mark_lengths.y - mark_lengths.z) : 0.0, vec4(0.0));
  drawn = over(outline_color, mark_lengths.y > 0.0 ? covered(outside - mark_lengths.y) : 0.0, drawn);
  drawn = over(fill_color, covered(outside), drawn);
  if (mark_shape == warning) {
    vec4 sign_color = outline_color.a > 0.0 ? outline_color : vec4(1.0);
    drawn = over(sign_color, covered(exclamation(turned(place, mark_angles.x), radius)), drawn);
  }
  drawn *= strength * visible_share(ivec2(middle), measure, radius + 2.0);
  if (drawn.a <= 0.0) discard;
  color = drawn;
}
