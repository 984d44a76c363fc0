// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Surfaces of an item, into view space in units of the camera's reference length.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in uint patch_index;

uniform mat4 to_view;
uniform mat4 to_clip;
uniform mat3 normal_to_view;
uniform uint first_patch;
uniform uint patch_step;  // 0: all is one patch

out vec3 view_position;
out vec3 view_normal;
out vec4 surface_color;
flat out float patch_number;

void main() {
  vec4 in_view = to_view * vec4(position, 1.0);
  view_position = in_view.xyz;
  view_normal = normal_to_view * normal;
  surface_color = color;
  // 0 is the background; numbers stay exact in a float.
  patch_number = float((first_patch + patch_step * patch_index) % 16777213u + 1u);
  gl_Position = to_clip * in_view;
}
