// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// What surfaces leave of a line or mark.
uniform bool depth_tested;
uniform sampler2D depths;  // (measure of depth, patch) of the surfaces
uniform int samples;       // of depths per pixel and axis
uniform int border;        // pixels of depths outside the viewport
uniform bool perspective;
uniform float pixel_size;  // view units at distance 1 (perspective) or everywhere

float limit_for(float measure, float slack) {
  return measure - slack * pixel_size * (perspective ? abs(measure) : 1.0);
}

// The share of a pixel's samples where no surface is nearer than the measure by more than slack (pixels).
float visible_share(ivec2 pixel, float measure, float slack) {
  if (!depth_tested) return 1.0;
  float nearest = limit_for(measure, slack);
  ivec2 first = clamp((pixel + border) * samples, ivec2(0), textureSize(depths, 0) - samples);
  int seen = 0;
  for (int i = 0; i < samples * samples; ++i) {
    vec2 surface = texelFetch(depths, first + ivec2(i % samples, i / samples), 0).xy;
    if (surface.y == 0.0 || surface.x >= nearest) ++seen;
  }
  return float(seen) / float(samples * samples);
}

// A surface so many pixels nearer than a place, right before it, hides the place even at the surface's rim.
const float sure_cover = 10.0;

// Whether a place (pixels) is seen: there or a pixel beside it no surface is nearer than the measure by more than slack
// (pixels). In a slope, however steep, one of these lies further away than the place.
bool seen_near(vec2 place, float measure, float slack) {
  if (!depth_tested) return true;
  float nearest = limit_for(measure, slack);
  ivec2 middle = ivec2(floor((place + float(border)) * float(samples)));
  ivec2 last = textureSize(depths, 0) - 1;
  const ivec2 around[5] = ivec2[5](ivec2(0, 0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  for (int i = 0; i < 5; ++i) {
    vec2 surface = texelFetch(depths, clamp(middle + samples * around[i], ivec2(0), last), 0).xy;
    if (surface.y == 0.0 || surface.x >= nearest) return true;
    if (i == 0 && surface.x < limit_for(measure, sure_cover)) return false;
  }
  return false;
}
