// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A room of black and white stripes as a surface mirrors it. The room stands still relative to the camera; its stripes
// lie level, evenly by their angle from straight above to straight below.

/// @param surface tints the light stripes a little, so that parts stay distinct
vec3 zebra(vec3 surface, vec3 normal, vec3 to_eye, float dark_stripes) {
  vec3 mirrored = reflect(-to_eye, normal);
  float phase = dark_stripes * acos(clamp(mirrored.y, -1.0, 1.0)) / 3.14159265;
  // From 0 in the middle of a dark stripe to 1 in the middle of a light one; both are equally wide.
  float wave = 2.0 * abs(fract(phase) - 0.5);
  float step_size = fwidth(phase);
  float light = clamp((wave - 0.5) / max(2.0 * step_size, 1e-6) + 0.5, 0.0, 1.0);
  // Where a sample spans a stripe there are none to be seen.
  light = mix(light, 0.5, smoothstep(0.35, 0.9, step_size));
  // A little shape remains for the eye to hold on to.
  float facing = max(dot(normal, to_eye), 0.0);
  vec3 bright = mix(vec3(0.97), surface, 0.3) * (0.72 + 0.28 * facing);
  vec3 dark = mix(vec3(0.03), 0.25 * surface, 0.3) + 0.05 * (1.0 - facing);
  return mix(dark, bright, light);
}
