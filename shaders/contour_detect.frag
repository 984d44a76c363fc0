// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Marks the samples on both sides of every place where the visible surface breaks off.
uniform sampler2D normals;
uniform sampler2D depths;    // (measure of depth, patch)
uniform bool perspective;
uniform float frame_height;  // of the picture at the target, view units
uniform float sample_size;   // view units at the target

layout(location = 0) out float mark;

// Breaks smaller than this share of the picture's height are no contours wherever normals agree …
const float sure_break = 0.035;
// … and this one suffices where they do not.
const float possible_break = 0.004;
const float agreeing_normals = 0.9;   // cosine, about 26 degrees
const float creased_normals = 0.64;   // cosine, about 50 degrees

vec2 depth_at(ivec2 place) {
  return texelFetch(depths, clamp(place, ivec2(0), textureSize(depths, 0) - 1), 0).xy;
}

vec3 normal_at(ivec2 place) {
  return texelFetch(normals, clamp(place, ivec2(0), textureSize(normals, 0) - 1), 0).xyz;
}

// Depth measure to view units, near the depth of the nearer of both.
float to_view_units(float difference, float measure) {
  return perspective ? difference / max(measure * measure, 1e-12) : difference;
}

// before - here - next - behind stand in a row; is there a break between here and next?
bool breaks(ivec2 place, ivec2 step_, vec2 before, vec2 here, vec2 next, vec2 behind) {
  if (here.y != next.y) return true;
  if (here.y == 0.0) return false;
  float cosine = dot(normal_at(place), normal_at(place + step_));
  if (cosine < creased_normals) return true;
  // What the slope on either side explains is no break: the last sample before a round outline is far away, too.
  float jump = abs(next.x - here.x);
  float rest = jump;
  if (before.y == here.y) rest = min(rest, abs(next.x - 2.0 * here.x + before.x));
  if (behind.y == next.y) rest = min(rest, abs(here.x - 2.0 * next.x + behind.x));
  float nearer = min(here.x, next.x);
  rest = abs(to_view_units(rest, nearer));
  float least = cosine < agreeing_normals ? max(possible_break * frame_height, 4.0 * sample_size)
                                          : max(sure_break * frame_height, 30.0 * sample_size);
  return rest > least;
}

bool breaks_along(ivec2 place, ivec2 step_, vec2 here) {
  vec2 next = depth_at(place + step_);
  vec2 last = depth_at(place - step_);
  return breaks(place, step_, last, here, next, depth_at(place + 2 * step_)) ||
         breaks(place, -step_, next, here, last, depth_at(place - 2 * step_));
}

// Neither patch nor depth changes along the row: a quick answer for nearly all samples.
bool even_along(ivec2 place, ivec2 step_, vec2 here) {
  vec2 next = depth_at(place + step_);
  vec2 last = depth_at(place - step_);
  if (next.y != here.y || last.y != here.y) return false;
  float farthest = max(here.x, max(next.x, last.x));
  float rest = abs(to_view_units(next.x + last.x - 2.0 * here.x, farthest));
  return rest <= max(possible_break * frame_height, 4.0 * sample_size);
}

bool normals_agree(ivec2 place) {
  vec3 normal = normal_at(place);
  return dot(normal, normal_at(place + ivec2(1, 0))) >= creased_normals &&
         dot(normal, normal_at(place - ivec2(1, 0))) >= creased_normals &&
         dot(normal, normal_at(place + ivec2(0, 1))) >= creased_normals &&
         dot(normal, normal_at(place - ivec2(0, 1))) >= creased_normals;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  vec2 here = depth_at(place);
  mark = 0.0;
  if (even_along(place, ivec2(1, 0), here) && even_along(place, ivec2(0, 1), here) &&
      (here.y == 0.0 || normals_agree(place))) {
    return;
  }
  mark = breaks_along(place, ivec2(1, 0), here) || breaks_along(place, ivec2(0, 1), here) ? 1.0 : 0.0;
}
