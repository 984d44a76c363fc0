// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// How much of a pixel a segment with round ends covers. Of all segments of a line the one that reaches deepest into
// the pixel wins by depth, so that none is drawn twice.
flat in vec4 ends;
flat in vec2 radii;
flat in vec2 measures;
flat in vec4 start_color;
flat in vec4 end_color;
flat in float dash_offset;

uniform bool dashed;
uniform vec4 dashes;  // on, off, on, off in pixels
uniform float strength;
uniform float layer;  // the line's own interval of depth …
uniform float layer_depth;

layout(location = 0) out vec4 color;

uniform bool seen_at_middle;  // of the line, not at each pixel

float visible_share(ivec2 pixel, float measure, float slack);
float seen_near(vec2 place, float measure, float slack);

const float middle_slack = 2.0;  // pixels: what a fold may rise beside its bottom

// To the nearest dash centred at middle: a rounded box, negative inside. Short ones are dots of the line's width.
float distance_to_dash(vec2 place, float middle, float on, float radius) {
  float period = dot(dashes, vec4(1.0));
  vec2 from_middle = vec2(abs(mod(place.x - middle + 0.5 * period, period) - 0.5 * period), abs(place.y));
  return length(vec2(max(from_middle.x - max(0.5 * on - radius, 0.0), 0.0), from_middle.y)) - radius;
}

void main() {
  vec2 place = gl_FragCoord.xy;
  vec2 along = ends.zw - ends.xy;
  float extent = length(along);
  vec2 direction = extent > 1e-6 ? along / extent : vec2(1.0, 0.0);
  vec2 offset = place - ends.xy;
  float way = dot(offset, direction);
  float share = extent > 1e-6 ? clamp(way / extent, 0.0, 1.0) : 0.0;
  float true_radius = mix(radii.x, radii.y, share);
  float radius = max(true_radius, 0.5);  // a line thinner than a pixel keeps its width and loses strength instead
  float outside = length(offset - share * along) - radius;
  if (dashed) {
    vec2 on_line = vec2(dash_offset + way, dot(offset, vec2(-direction.y, direction.x)));
    float gap = distance_to_dash(on_line, 0.5 * dashes.x, dashes.x, radius);
    if (dashes.z > 0.0) gap = min(gap, distance_to_dash(on_line, dashes.x + dashes.y + 0.5 * dashes.z, dashes.z, radius));
    outside = max(outside, gap);
  }
  float coverage = clamp(0.5 - outside, 0.0, 1.0);
  if (coverage <= 0.0) discard;
  float measure = mix(measures.x, measures.y, share);
  float rank = outside;
  float seen;
  if (seen_at_middle) {
    seen = seen_near(ends.xy + share * along, measure, middle_slack);
    // Right behind a rim a hidden line can't be distinguished from the rim's own, which comes first; but not its thin border.
    if (seen == 0.5 || outside > -0.5) rank += 64.0;
    seen = ceil(seen);
  } else {
    seen = visible_share(ivec2(place), measure, radius + 2.0);
  }
  float share_of_ink = coverage * min(2.0 * true_radius, 1.0) * strength * seen;
  if (share_of_ink <= 0.0) discard;
  gl_FragDepth = layer + layer_depth * clamp((rank + 64.0) / 130.0, 0.0, 0.999);
  vec4 ink = mix(start_color, end_color, share);
  ink.a *= share_of_ink;
  color = vec4(ink.rgb * ink.a, ink.a);
}
