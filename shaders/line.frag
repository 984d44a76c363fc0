// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
in vec4 line_color;

uniform bool on_surface;    // wire: belongs to the surface seen at this sample
uniform sampler2D normals;

layout(location = 0) out vec4 color;

float share_facing(vec3 normal);

void main() {
  color = line_color;
  if (on_surface) color.a *= share_facing(texelFetch(normals, ivec2(gl_FragCoord.xy), 0).xyz);
}
