// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
in vec3 view_position;
in vec3 view_normal;
in vec4 surface_color;
flat in float patch_number;

uniform bool perspective;
uniform bool filled;       // else it covers without being seen
uniform float zebra_stripes;  // 0: none
uniform vec4 fixed_color;  // of a highlight; alpha 0: none
uniform vec4 tint;  // alpha is the strength
uniform vec4 fade;  // likewise, over the tint
uniform bool outlined;  // what is seen of it gets a line around it

layout(location = 0) out vec4 color;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec2 depth_and_patch;

vec3 zebra(vec3 surface, vec3 normal, vec3 to_eye, float dark_stripes);

void main() {
  vec3 n = view_normal;
  float length_of_normal = length(n);
  if (length_of_normal > 1e-6) {
    n /= length_of_normal;
    if (!gl_FrontFacing) n = -n;
  } else {
    n = vec3(0.0, 0.0, 1.0);
  }
  color = vec4(mix(mix(surface_color.rgb, tint.rgb, tint.a), fade.rgb, fade.a), filled ? 1.0 : 0.0);
  if (zebra_stripes > 0.0) {
    vec3 to_eye = perspective ? normalize(-view_position) : vec3(0.0, 0.0, 1.0);
    color.rgb = zebra(color.rgb, n, to_eye, zebra_stripes);
    // Through a hole one sees the inside: its stripes mustn't be taken for those of a patch.
    if (!gl_FrontFacing) color.rgb = mix(color.rgb, vec3(0.45), 0.6);
  }
  if (fixed_color.a > 0.0) color = fixed_color;
  normal = vec4(n, outlined ? 1.0 : 0.0);
  // A measure of depth that is linear over the picture on a plane, and grows away from the eye.
  float measure = perspective ? 1.0 / view_position.z : -view_position.z;
  depth_and_patch = vec2(measure, patch_number);
}
