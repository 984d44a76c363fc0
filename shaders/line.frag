// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
in vec4 line_color;

uniform bool on_surface;    // wire: belongs to the surface seen at this sample
uniform sampler2D normals;

layout(location = 0) out vec4 color;

void main() {
  color = line_color;
  // Where the surface turns away, edges of its far side would show past the outline, and near ones crowd: both fade.
  if (on_surface) color.a *= smoothstep(0.0, 0.2, texelFetch(normals, ivec2(gl_FragCoord.xy), 0).z);
}
