// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
flat in vec4 point_color;

uniform float size;          // pixels
uniform bool disc;
uniform vec4 outline;        // alpha 0: none
uniform float outline_width; // pixels

layout(location = 0) out vec4 color;

void main() {
  vec2 offset = (gl_PointCoord - 0.5) * size;
  vec2 across = abs(offset);
  float inside = disc ? 0.5 * size - length(offset) : 0.5 * size - max(across.x, across.y);
  float coverage = clamp(inside + 0.5, 0.0, 1.0);
  vec4 ink = outline.a > 0.0 && inside < outline_width ? outline : point_color;
  ink.a *= coverage;
  if (ink.a <= 0.0) discard;
  color = vec4(ink.rgb * ink.a, ink.a);
}
