// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A segment of a line of constant width on screen: a rectangle around it with all that the fragments need.
layout(location = 0) in vec3 a_position;
layout(location = 1) in float a_width;  // negative where no segment starts
layout(location = 2) in vec4 a_color;
layout(location = 3) in vec3 b_position;
layout(location = 4) in float b_width;
layout(location = 5) in vec4 b_color;
layout(location = 6) in float dash_start;  // length of the line on screen up to a, pixels

uniform mat4 to_view;
uniform mat4 to_clip;
uniform bool perspective;
uniform vec2 frame_size;       // pixels
uniform float pixel_ratio;
uniform float grow;            // pixels added on either side
uniform vec4 fixed_color;      // alpha 0: every corner has its own
uniform float nearest;         // perspective: lines are cut off here, view units

flat out vec4 ends;            // a and b, pixels
flat out vec2 radii;
flat out vec2 measures;        // of depth
flat out vec4 start_color;
flat out vec4 end_color;
flat out float dash_offset;

vec2 on_screen(vec4 view) {
  vec4 clip = to_clip * view;
  return (0.5 * clip.xy / clip.w + 0.5) * frame_size;
}

float radius_of(float width) { return 0.5 * pixel_ratio * width + grow; }
vec4 color_of(vec4 color) { return fixed_color.a > 0.0 ? fixed_color : color; }

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  float far_width = b_width < 0.0 ? -1.0 - b_width : b_width;
  vec4 a = to_view * vec4(a_position, 1.0);
  vec4 b = to_view * vec4(b_position, 1.0);
  float inside_a = -a.z - nearest;
  float inside_b = -b.z - nearest;
  if (a_width < 0.0 || (perspective && max(inside_a, inside_b) <= 0.0)) return;
  if (perspective && inside_a < 0.0) a = mix(a, b, inside_a / (inside_a - inside_b));
  if (perspective && inside_b < 0.0) b = mix(b, a, inside_b / (inside_b - inside_a));

  ends = vec4(on_screen(a), on_screen(b));
  radii = vec2(radius_of(a_width), radius_of(far_width));
  measures = perspective ? 1.0 / vec2(a.z, b.z) : -vec2(a.z, b.z);
  start_color = color_of(a_color);
  end_color = color_of(b_color);
  dash_offset = dash_start;

  vec2 along = ends.zw - ends.xy;
  float extent = length(along);
  along = extent > 1e-6 ? along / extent : vec2(1.0, 0.0);
  float reach = max(max(radii.x, radii.y), 0.5) + 0.6;  // no pixel further away is touched
  vec2 sideways = (gl_VertexID & 2) == 0 ? vec2(-along.y, along.x) : vec2(along.y, -along.x);
  vec2 corner = (gl_VertexID & 1) == 0 ? ends.xy - reach * along : ends.zw + reach * along;
  gl_Position = vec4(2.0 * (corner + reach * sideways) / frame_size - 1.0, 0.0, 1.0);
}
