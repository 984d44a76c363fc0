// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// What stands behind everything: a vertical gradient and squared paper.
uniform vec2 picture_rows;     // (first row, number of rows) of the whole picture
uniform vec3 background_top;
uniform vec3 background_bottom;
uniform int grid_kind;         // 0 none, 1 dots, 2 lines
uniform vec4 grid_color;
uniform float grid_step;       // pixels; every fifth line is a strong one
uniform vec2 grid_origin;      // of a strong crossing, pixels of the viewport
uniform float grid_fine;       // strength of the other lines
uniform float grid_width;      // of lines, pixels

vec2 distance_to_lattice(vec2 place, float step_) {
  vec2 offset = mod(place + 0.5 * step_, step_) - 0.5 * step_;
  return abs(offset);
}

float lattice(vec2 place, float step_) {
  vec2 away = distance_to_lattice(place, step_);
  if (grid_kind == 1) return clamp(grid_width + 0.5 - length(away), 0.0, 1.0);
  return clamp(0.5 * grid_width + 0.5 - min(away.x, away.y), 0.0, 1.0);
}

// pixel: middle of a pixel, from the viewport's lower left corner
vec3 backdrop(vec2 pixel) {
  float height = (picture_rows.x + pixel.y) / picture_rows.y;
  vec3 paper = mix(background_bottom, background_top, smoothstep(0.0, 1.0, height));
  if (grid_kind == 0) return paper;
  vec2 place = pixel - grid_origin;
  float strength = max(lattice(place, 5.0 * grid_step), grid_fine * lattice(place, grid_step));
  return mix(paper, grid_color.rgb, grid_color.a * strength);
}
