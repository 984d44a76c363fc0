// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A segment as a rectangle of a width in samples, its ends half a width longer so that joints close.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

in vec4 end_color[];
out vec4 line_color;

uniform vec2 frame_size;  // samples
uniform float width;      // samples

void emit(vec4 clip, vec2 offset, vec4 color) {
  line_color = color;
  gl_Position = vec4(clip.xy + 2.0 * offset / frame_size * clip.w, clip.zw);
  EmitVertex();
}

void main() {
  vec4 a = gl_in[0].gl_Position;
  vec4 b = gl_in[1].gl_Position;
  // What lies before the near plane has no place on screen.
  float inside_a = a.z + a.w;
  float inside_b = b.z + b.w;
  if (inside_a <= 0.0 && inside_b <= 0.0) return;
  if (inside_a < 0.0) a = mix(a, b, inside_a / (inside_a - inside_b));
  if (inside_b < 0.0) b = mix(b, a, inside_b / (inside_b - inside_a));

  vec2 along = (b.xy / b.w - a.xy / a.w) * frame_size;
  float extent = length(along);
  along = extent > 1e-6 ? along / extent : vec2(1.0, 0.0);
  vec2 ahead = 0.5 * width * along;
  vec2 left = vec2(-ahead.y, ahead.x);
  emit(a, left - ahead, end_color[0]);
  emit(a, -left - ahead, end_color[0]);
  emit(b, left + ahead, end_color[1]);
  emit(b, -left + ahead, end_color[1]);
  EndPrimitive();
}
