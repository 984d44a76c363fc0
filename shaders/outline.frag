// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A line around what is seen of outlined surfaces, with a dark border of its own.
uniform sampler2D normals;  // the fourth part marks outlined surfaces
uniform int samples;        // per pixel and axis
uniform ivec2 viewport_origin;  // pixels of the target
uniform int border;             // pixels of the drawn frame outside the viewport
uniform float width;            // pixels
uniform float casing;           // pixels, beyond the line
uniform vec3 line_color;
uniform vec3 casing_color;

layout(location = 0) out vec4 color;

bool is_outlined(ivec2 pixel) {
  ivec2 place = clamp(pixel * samples + samples / 2, ivec2(0), textureSize(normals, 0) - 1);
  return texelFetch(normals, place, 0).w > 0.5;
}

// Few pixels are near enough: a look into eight directions spares the others the search.
bool may_be_near(ivec2 pixel, int reach) {
  int half_way = (reach + 1) / 2;
  for (int k = 0; k < 8; ++k) {
    ivec2 direction = ivec2[8](ivec2(1, 0), ivec2(1, 1), ivec2(0, 1), ivec2(-1, 1), ivec2(-1, 0), ivec2(-1, -1),
                               ivec2(0, -1), ivec2(1, -1))[k];
    if (is_outlined(pixel + ((k & 1) == 0 ? reach : half_way) * direction)) return true;
    if ((k & 1) == 0 && is_outlined(pixel + half_way * direction)) return true;
  }
  return false;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport_origin + border;
  int reach = int(ceil(width + casing));
  if (is_outlined(pixel) || !may_be_near(pixel, reach)) discard;
  float nearest = 1e9;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      float away = float(dx * dx + dy * dy);
      if (away < nearest && is_outlined(pixel + ivec2(dx, dy))) nearest = away;
    }
  }
  // The surface's border lies half a pixel before the middle of its last one.
  float away = sqrt(nearest) - 0.5;
  float in_line = clamp(width + 0.5 - away, 0.0, 1.0);
  color = vec4(mix(casing_color, line_color, in_line), clamp(width + casing + 0.5 - away, 0.0, 1.0));
}
