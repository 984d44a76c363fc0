// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square on screen around a mark's place.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 lengths;  // size, outline, halo
layout(location = 2) in vec2 angles;   // of the shape, of the lower bar
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 outline;
layout(location = 5) in vec4 halo;
layout(location = 6) in uint shape;

uniform mat4 to_view;
uniform mat4 to_clip;
uniform bool perspective;
uniform vec2 frame_size;   // pixels
uniform float pixel_ratio;
uniform float nearest;     // perspective: marks closer than this are left out, view units
uniform vec4 glow_color;   // alpha 0: every mark has its own halo
uniform float glow_width;  // pixels

flat out vec2 middle;      // pixels
flat out float measure;    // of depth
flat out vec3 mark_lengths;
flat out vec2 mark_angles;
flat out vec4 fill_color;
flat out vec4 outline_color;
flat out vec4 halo_color;
flat out uint mark_shape;

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vec4 view = to_view * vec4(position, 1.0);
  if (perspective && -view.z < nearest) return;
  vec4 clip = to_clip * view;
  middle = (0.5 * clip.xy / clip.w + 0.5) * frame_size;
  measure = perspective ? 1.0 / view.z : -view.z;
  mark_lengths = pixel_ratio * lengths;
  if (glow_color.a > 0.0) mark_lengths.z = glow_width;
  mark_angles = angles;
  fill_color = color;
  outline_color = outline;
  halo_color = glow_color.a > 0.0 ? glow_color : halo;
  mark_shape = shape;

  float reach = 0.5 * mark_lengths.x + mark_lengths.y + mark_lengths.z + 1.0;
  vec2 side = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  gl_Position = vec4(2.0 * (middle + reach * side) / frame_size - 1.0, 0.0, 1.0);
}
