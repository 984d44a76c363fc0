// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The finished picture into its place in the host's framebuffer.
uniform sampler2D canvas;
uniform ivec2 viewport_origin;  // pixels of the target

layout(location = 0) out vec4 color;

void main() { color = vec4(texelFetch(canvas, ivec2(gl_FragCoord.xy) - viewport_origin, 0).rgb, 1.0); }
