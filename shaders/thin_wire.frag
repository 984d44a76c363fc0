// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Wire one sample wide, as OpenGL draws lines by itself: far quicker than rectangles.
uniform vec4 fixed_color;
uniform bool on_surface;    // belongs to the surface seen at this sample
uniform sampler2D normals;

layout(location = 0) out vec4 color;

float share_facing(vec3 normal);

void main() {
  color = fixed_color;
  if (on_surface) color.a *= share_facing(texelFetch(normals, ivec2(gl_FragCoord.xy), 0).xyz);
}
