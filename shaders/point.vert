// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Points of constant size on screen. Hidden ones are left out here, once each, not at each of their pixels.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;

uniform mat4 to_view;
uniform mat4 to_clip;
uniform bool perspective;
uniform vec2 frame_size;   // pixels
uniform float nearest;     // perspective: points closer than this are left out, view units
uniform float size;        // whole pixels
uniform vec4 fixed_color;  // alpha 0: every point has its own

flat out vec4 point_color;

float seen_near(vec2 place, float measure, float slack);

const float slack = 2.5;  // pixels: what a fold may rise beside its bottom

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = size;
  point_color = fixed_color.a > 0.0 ? fixed_color : color;
  vec4 view = to_view * vec4(position, 1.0);
  if (perspective && -view.z < nearest) return;
  vec4 clip = to_clip * view;
  vec2 middle = (0.5 * clip.xy / clip.w + 0.5) * frame_size;
  if (any(lessThan(middle, vec2(-size))) || any(greaterThan(middle, frame_size + size))) return;
  if (seen_near(middle, perspective ? 1.0 / view.z : -view.z, slack) == 0.0) return;
  // Borders of squares fall between pixels: all look alike.
  float odd = mod(size, 2.0);
  middle = floor(middle + 0.5 * (1.0 - odd)) + 0.5 * odd;
  gl_Position = vec4(2.0 * middle / frame_size - 1.0, 0.0, 1.0);
}
