// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The backdrop alone, where no surface is drawn.
uniform ivec2 viewport_origin;  // pixels of the target

layout(location = 0) out vec4 color;

vec3 backdrop(vec2 pixel);

void main() { color = vec4(backdrop(gl_FragCoord.xy - vec2(viewport_origin)), 1.0); }
