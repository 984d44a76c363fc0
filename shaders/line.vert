// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 color;

uniform mat4 to_view;
uniform mat4 to_clip;
uniform vec4 fixed_color;  // alpha 0: every vertex has its own

out vec4 end_color;

void main() {
  end_color = fixed_color.a > 0.0 ? fixed_color : color;
  gl_Position = to_clip * to_view * vec4(position, 1.0);
}
