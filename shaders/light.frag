// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The look of clay in a room whose lights stand still relative to the camera.

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

vec3 lit_clay(vec3 surface, vec3 normal, vec3 to_eye, float open_sky) {
  return to_display(clay(to_linear(surface), normal, to_eye, open_sky));
}
