// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The distance to the nearest mark in the same row, in samples / 255; 1 for none within reach.
uniform sampler2D marks;
uniform int reach;

layout(location = 0) out float row_distance;

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  int last = textureSize(marks, 0).x - 1;
  row_distance = 1.0;
  for (int distance_ = 0; distance_ <= reach; ++distance_) {
    float left = texelFetch(marks, ivec2(max(place.x - distance_, 0), place.y), 0).x;
    float right = texelFetch(marks, ivec2(min(place.x + distance_, last), place.y), 0).x;
    if (max(left, right) > 0.5) {
      row_distance = float(distance_) / 255.0;
      return;
    }
  }
}
