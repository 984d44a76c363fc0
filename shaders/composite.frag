// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Light, lines and background, averaged over the samples of a pixel.
uniform sampler2D colors;
uniform sampler2D normals;
uniform sampler2D depths;
uniform sampler2D overlay;        // polylines and wire, alpha is the strength
uniform sampler2D row_distances;  // of contour marks
uniform sampler2D openness;       // one texel per pixel

uniform int samples;              // per pixel and axis
uniform ivec2 viewport_origin;    // pixels of the target
uniform int border;               // pixels of the drawn frame outside the viewport
uniform bool perspective;
uniform vec2 view_extent;
uniform vec2 view_center;
uniform bool lit;
uniform bool occluded;
uniform bool contours;
uniform float contour_half_width;  // samples
uniform int contour_reach;         // samples
uniform vec4 contour_color;

layout(location = 0) out vec4 color;

vec3 backdrop(vec2 pixel);

vec3 to_linear(vec3 display) { return pow(display, vec3(2.2)); }
vec3 to_display(vec3 light) { return pow(light, vec3(1.0 / 2.2)); }

// The lights stand still relative to the camera: key upper left, fill right, sky above and ground below.
const vec3 key_direction = vec3(-0.447, 0.639, 0.626);
const vec3 fill_direction = vec3(0.864, 0.123, 0.488);
const vec3 key_light = vec3(0.97, 0.93, 0.87);
const vec3 fill_light = vec3(0.07, 0.09, 0.12);
const vec3 sky_light = vec3(0.31, 0.33, 0.37);
const vec3 ground_light = vec3(0.10, 0.09, 0.09);
const vec3 rim_light = vec3(0.22, 0.24, 0.27);

vec3 clay(vec3 albedo, vec3 normal, vec3 to_eye, float open_sky) {
  // The key wraps a little around the side: clay scatters light inside.
  float key = max((dot(normal, key_direction) + 0.18) / 1.18, 0.0);
  float fill = max(dot(normal, fill_direction), 0.0);
  vec3 ambient = mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
  vec3 light = albedo * (ambient * open_sky + (key_light * key + fill_light * fill) * mix(1.0, open_sky, 0.6));
  vec3 half_way = normalize(key_direction + to_eye);
  light += 0.05 * key_light * pow(max(dot(normal, half_way), 0.0), 22.0);
  float grazing = 1.0 - max(dot(normal, to_eye), 0.0);
  light += albedo * rim_light * pow(grazing, 3.0) * (0.6 + 0.4 * normal.y) * open_sky;
  // A soft shoulder keeps the lightest places from burning out.
  return light / (1.0 + 0.16 * light * light);
}

vec3 eye_direction(ivec2 place) {
  if (!perspective) return vec3(0.0, 0.0, 1.0);
  vec2 share = 2.0 * (vec2(place) + 0.5) / vec2(textureSize(depths, 0)) - 1.0;
  return normalize(vec3(-(view_center + share * view_extent), 1.0));
}

float contour_strength(ivec2 place) {
  float nearest = 1e9;
  int last = textureSize(row_distances, 0).y - 1;
  for (int dy = -contour_reach; dy <= contour_reach; ++dy) {
    float dx = 255.0 * texelFetch(row_distances, ivec2(place.x, clamp(place.y + dy, 0, last)), 0).x;
    nearest = min(nearest, dx * dx + float(dy * dy));
  }
  // The break lies half a sample from the marks on its two sides.
  return clamp(contour_half_width - sqrt(nearest), 0.0, 1.0);
}

// Every sample is smoothed with those of its pixel that belong to it, to take the spiral's grain away.
float open_sky_at(ivec2 pixel, vec2 here) {
  float sum = 0.0;
  float weight = 0.0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      ivec2 other = clamp(pixel + ivec2(dx, dy), ivec2(0), textureSize(openness, 0) - 1);
      if (texelFetch(depths, other * samples + samples / 2, 0).y != here.y) continue;
      sum += texelFetch(openness, other, 0).x;
      weight += 1.0;
    }
  }
  return weight > 0.0 ? sum / weight : 1.0;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport_origin;
  vec3 background = backdrop(vec2(pixel) + 0.5);
  pixel += border;
  vec2 middle = texelFetch(depths, pixel * samples + samples / 2, 0).xy;
  float open_sky = lit && occluded ? open_sky_at(pixel, middle) : 1.0;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < samples * samples; ++i) {
    ivec2 place = pixel * samples + ivec2(i % samples, i / samples);
    vec3 shade = background;
    if (texelFetch(depths, place, 0).y != 0.0) {
      shade = texelFetch(colors, place, 0).rgb;
      if (lit) {
        shade = to_display(clay(to_linear(shade), texelFetch(normals, place, 0).xyz, eye_direction(place), open_sky));
      }
    }
    vec4 line = texelFetch(overlay, place, 0);
    shade = mix(shade, line.rgb, line.a);
    if (contours) shade = mix(shade, contour_color.rgb, contour_color.a * contour_strength(place));
    sum += clamp(shade, 0.0, 1.0);
  }
  color = vec4(sum / float(samples * samples), 1.0);
}
