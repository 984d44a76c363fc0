// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Translucent surfaces, lit at once: what lies behind them has to stay as it is.
in vec3 view_position;
in vec3 view_normal;
in vec4 surface_color;
flat in float patch_number;

uniform bool perspective;
uniform bool front;  // draws the faces that look to the eye, else the others
uniform bool lit;
uniform float zebra_stripes;  // 0: none
uniform float opacity;
uniform vec4 tint;  // alpha is the strength
uniform vec4 fade;  // likewise, over the tint

layout(location = 0) out vec4 color;

vec3 lit_clay(vec3 surface, vec3 normal, vec3 to_eye, float open_sky);
vec3 zebra(vec3 surface, vec3 normal, vec3 to_eye, float dark_stripes);

void main() {
  vec3 to_eye = perspective ? normalize(-view_position) : vec3(0.0, 0.0, 1.0);
  float length_of_normal = length(view_normal);
  vec3 n = length_of_normal > 1e-6 ? view_normal / length_of_normal : vec3(0.0, 0.0, 1.0);
  if (!gl_FrontFacing) n = -n;
  vec3 shade = mix(mix(surface_color.rgb, tint.rgb, tint.a), fade.rgb, fade.a);
  if (zebra_stripes > 0.0) {
    shade = zebra(shade, n, to_eye, zebra_stripes);
  } else if (lit) {
    shade = lit_clay(shade, n, to_eye, 1.0);
  }
  // Seen aslant there is more of it in the way; so its outline shows without a line.
  float facing = abs(dot(n, to_eye));
  float covers = 1.0 - pow(1.0 - opacity, 1.0 / max(facing, 0.25));
  // Only now: what is thrown away has no slopes.
  if (gl_FrontFacing != front) discard;
  color = vec4(clamp(shade, 0.0, 1.0) * covers, covers);
}
