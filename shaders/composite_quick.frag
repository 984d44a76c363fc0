// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Light and lines of one sample per pixel, over the backdrop: little work, for while something moves.
uniform sampler2D colors;
uniform sampler2D normals;
uniform sampler2D depths;       // (measure of depth, patch)
uniform sampler2D overlay;      // polylines and wire, alpha is the strength
uniform sampler2D veil;         // translucent surfaces, lit, times their strength

uniform ivec2 viewport_origin;  // pixels of the target
uniform int border;             // pixels of the drawn frame outside the viewport
uniform bool perspective;
uniform vec2 view_extent;
uniform vec2 view_center;
uniform bool lit;
uniform bool veiled;            // there are such
uniform int contour_reach;      // pixels; 0: no contours
uniform vec4 contour_color;
uniform float contour_break;    // jump of depth that is a contour, view units

layout(location = 0) out vec4 color;

vec3 lit_clay(vec3 surface, vec3 normal, vec3 to_eye, float open_sky);

vec3 eye_direction(ivec2 place) {
  if (!perspective) return vec3(0.0, 0.0, 1.0);
  vec2 share = 2.0 * (vec2(place) + 0.5) / vec2(textureSize(depths, 0)) - 1.0;
  return normalize(vec3(-(view_center + share * view_extent), 1.0));
}

vec2 depth_at(ivec2 place) {
  return texelFetch(depths, clamp(place, ivec2(0), textureSize(depths, 0) - 1), 0).xy;
}

// Is there a break between two places on either side? On one surface depths grow evenly.
bool breaks(vec2 here, ivec2 place, ivec2 step_) {
  vec2 before = depth_at(place - step_);
  vec2 behind = depth_at(place + step_);
  if (before.y != here.y || behind.y != here.y) return true;
  float jump = abs(before.x + behind.x - 2.0 * here.x);
  return jump > contour_break * (perspective ? here.x * here.x : 1.0);
}

bool on_contour(vec2 here, ivec2 place) {
  if (contour_reach == 0) return false;
  return breaks(here, place, ivec2(contour_reach, 0)) || breaks(here, place, ivec2(0, contour_reach));
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy) - viewport_origin + border;
  vec2 here = texelFetch(depths, place, 0).xy;
  vec4 drawn = vec4(0.0);
  vec4 filled = texelFetch(colors, place, 0);
  if (filled.a != 0.0) {
    vec3 surface = filled.rgb;
    if (lit) surface = lit_clay(surface, texelFetch(normals, place, 0).xyz, eye_direction(place), 1.0);
    drawn = vec4(surface, 1.0);
  }
  if (veiled) {
    vec4 over = texelFetch(veil, place, 0);
    drawn = over + (1.0 - over.a) * drawn;
  }
  vec4 line = texelFetch(overlay, place, 0);
  drawn = vec4(line.rgb * line.a, line.a) + (1.0 - line.a) * drawn;
  if (on_contour(here, place)) {
    drawn = vec4(contour_color.rgb * contour_color.a, contour_color.a) + (1.0 - contour_color.a) * drawn;
  }
  color = drawn;
}
