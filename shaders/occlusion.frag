// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// How much of the sky each pixel misses because of its surroundings: samples on a spiral around it, weighed by how far
// they rise above its tangent plane.
uniform sampler2D normals;
uniform sampler2D depths;
uniform bool perspective;
uniform vec2 view_extent;   // half size of the drawn frame at distance 1 (perspective) or everywhere, view units
uniform vec2 view_center;   // of the drawn frame, likewise
uniform int samples;        // per pixel and axis
uniform float radius;       // samples
uniform float view_radius;  // view units at the target
uniform ivec2 origin;       // of the drawn frame in the whole picture, pixels

layout(location = 0) out float openness;

const int count = 16;
const float turns = 7.0;

vec3 position_at(vec2 place, float measure) {
  vec2 share = 2.0 * place / vec2(textureSize(depths, 0)) - 1.0;
  vec2 sideways = view_center + share * view_extent;
  return perspective ? vec3(sideways, -1.0) / -measure : vec3(sideways, -measure);
}

// A pattern without visible grain, fixed to the picture.
float turn_at(ivec2 pixel) {
  return 6.2831853 * fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 place = pixel * samples + samples / 2;
  vec2 here = texelFetch(depths, place, 0).xy;
  openness = 1.0;
  if (here.y == 0.0) return;
  vec3 normal = texelFetch(normals, place, 0).xyz;
  vec3 position = position_at(vec2(place) + 0.5, here.x);
  float start = turn_at(pixel + origin);
  float hidden = 0.0;
  for (int i = 0; i < count; ++i) {
    float share = (float(i) + 0.5) / float(count);
    float angle = start + 6.2831853 * turns * share;
    ivec2 other = place + ivec2(round(radius * share * vec2(cos(angle), sin(angle))));
    other = clamp(other, ivec2(0), textureSize(depths, 0) - 1);
    vec2 there = texelFetch(depths, other, 0).xy;
    if (there.y == 0.0) continue;
    vec3 offset = position_at(vec2(other) + 0.5, there.x) - position;
    float distance_squared = dot(offset, offset);
    float rise = max(dot(offset, normal) - 0.03 * view_radius, 0.0);
    float fade = max(view_radius * view_radius * 2.0 - distance_squared, 0.0) / (view_radius * view_radius * 2.0);
    hidden += fade * rise / (distance_squared + 0.02 * view_radius * view_radius) * view_radius;
  }
  openness = clamp(1.0 - 0.34 * hidden / float(count), 0.0, 1.0);
}
