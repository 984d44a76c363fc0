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

// How a place (pixels) is seen: 1 where no surface there or a pixel beside it is nearer than the measure by more than
// slack (pixels), for in a slope, however steep, one of these lies further away than the place; 0.5 where only places
// without any surface speak for it; 0 where it is hidden.
float seen_near(vec2 place, float measure, float slack) {
  if (!depth_tested) return 1.0;
  float nearest = limit_for(measure, slack);
  ivec2 middle = ivec2(floor((place + float(border)) * float(samples)));
  ivec2 last = textureSize(depths, 0) - 1;
  const ivec2 around[5] = ivec2[5](ivec2(0, 0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  float seen = 0.0;
  for (int i = 0; i < 5; ++i) {
    vec2 surface = texelFetch(depths, clamp(middle + samples * around[i], ivec2(0), last), 0).xy;
    if (surface.y == 0.0) {
      seen = 0.5;
    } else {
      if (surface.x >= nearest) return 1.0;
      if (i == 0 && surface.x < limit_for(measure, sure_cover)) return 0.0;
    }
  }
  return seen;
}
