// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A parallelogram, in view space; needs no buffer.
uniform mat4 to_clip;
uniform vec3 corner;   // lower left
uniform vec3 right;    // along its lower border
uniform vec3 upwards;  // along its left border

out vec2 place;  // in the picture, from its upper left corner

void main() {
  vec2 share = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec4 clip = to_clip * vec4(corner + share.x * right + share.y * upwards, 1.0);
  place = vec2(share.x, 1.0 - share.y);
  gl_Position = vec4(clip.xy, 0.0, clip.w);  // whatever lies between the planes near and far
}
