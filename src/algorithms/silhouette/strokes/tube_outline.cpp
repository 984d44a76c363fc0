// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/tube_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
namespace {

// Samples of a centre line are this share of the least radius apart.
constexpr double spacing_share = 0.2;
// Waves shorter than about twice the radius are half gone after so many passes over samples that far apart.
constexpr int tube_smoothing_passes = 60;
// A tube is at least so many u thick: else its outline has too few samples.
constexpr double least_radius = 4;
// Ends within the radii of both that head for one another by 60 degrees are one place.
constexpr double closing_cosine = 0.5;
// Radii change at most so much along a centre line, per length.
constexpr double steepest = 0.9;
constexpr double tube_displacement = 1e-7;

std::string tube_named(const Drawing& drawing, Index stroke) { return "The tube " + in_quotes(drawing, stroke); }

/// The numbers of a list; none where one of them isn't above 0, or there are none.
std::vector<double> radii_of(const Stroke& stroke) {
  std::vector<double> radii;
  const auto found = stroke.data.find(radius_key);
  if (found == stroke.data.end()) return radii;
  for (const std::string_view word : text_parts(found->second, ", ")) {
    double radius = 0;
    if (!read_number(word, radius) || !(radius > 0) || !is_usable_number(radius)) return {};
    radii.push_back(radius);
  }
  return radii;
}

/// What a stroke can't be a tube for; empty when it can.
std::string fault_of(const Drawing& drawing, Index s, double unit) {
  const Stroke& stroke = drawing.strokes[s];
  const std::vector<double> radii = radii_of(stroke);
  if (radii.empty()) {
    return " has the radius \"" + stroke.data.at(radius_key) +
           "\": write one number above 0, in units of the drawing, or several separated by commas";
  }
  if (radii.size() > std::max<std::size_t>(stroke.samples.size(), 2)) {
    return " has " + std::to_string(radii.size()) + " radii for " + std::to_string(stroke.samples.size()) +
           " points: write one radius, or no more than there are points";
  }
  const auto ends = stroke.data.find(ends_key);
  if (ends != stroke.data.end() && !tube_ends(ends->second)) {
    return " has the ends \"" + ends->second + "\": write round, flat or pointed";
  }
  for (const std::string_view word : over_words(stroke)) {
    if (word != over_word && word != under_word && word != auto_word)
      return " has the word \"" + std::string(word) + "\" for a crossing: write over, under or auto";
  }
  Points points;
  for (const StrokeSample& sample : stroke.samples) points.push_back(sample.position);
  const auto [least, most] = std::ranges::minmax(radii);
  if (length(points, stroke.closed) < most) {
    return " is shorter than its radius " + number_text(most, 4) + ": draw a longer line, or give it a smaller radius";
  }
  if (least < least_radius * unit)
    return " has the radius " + number_text(least, 4) +
           ", which is less than 0.4 % of the drawing: give it a larger one";
  return {};
}

/// The radius at a sample of a stroke, where pressure or one number a sample says it. Pens say at their last sample
/// that they press no more: what they did before counts there.
double radius_at(const Stroke& stroke, const std::vector<double>& radii, std::size_t sample) {
  const std::vector<StrokeSample>& samples = stroke.samples;
  if (radii.size() == samples.size()) return radii[sample];
  const auto differs = [&](const StrokeSample& other) { return other.pressure != samples.front().pressure; };
  if (std::ranges::none_of(samples, differs)) return radii.front();
  while (sample > 0 && samples[sample].pressure <= 0) --sample;
  return radii.front() * (0.4 + 1.2 * std::clamp(samples[sample].pressure, 0.0, 1.0));
}

/// Closes a line whose end comes back to where it began; what goes on beyond that is cut off.
void close_where_ends_meet(CentreLine& line, double close) {
  const double reach = line.radius.front() + line.radius.back();
  const Vec2 onward = end_chord(line.points, false, reach);
  if ((line.points.back() - line.points.front()).norm() > std::max(reach, close) ||
      onward.dot(-end_chord(line.points, true, reach)) < closing_cosine || line.points.size() < 4 ||
      length(line.points, false) < tube_loop_reach * reach)
    return;
  line.closed = true;
  while (line.points.size() > 4 && (line.points.front() - line.points.back()).dot(onward) <= 0) {
    line.points.pop_back();
    line.radius.pop_back();
  }
}

/// Puts places between those of a line until they lie close enough, on a smooth curve through them (the four-point
/// scheme of Dyn, Gregory and Levin 1987). Bends of more than 45 degrees stay corners.
void refine(CentreLine& line, double spacing) {
  constexpr int most_rounds = 5;
  constexpr double sharpest_cosine = 0.707;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t count = line.points.size(), segments = line.closed ? count : count - 1;
    if (length(line.points, line.closed) < 1.5 * spacing * static_cast<double>(segments)) return;
    const auto at = [&](std::size_t i) -> const Vec2& { return line.points[i % count]; };
    // What goes on from b, coming from a: as long as the way between the two, straight on at ends and corners.
    const auto beyond = [&](const Vec2& a, const Vec2& b, std::size_t next, bool is_end) -> Vec2 {
      const Vec2 way = b - a, on = at(next) - b;
      const bool straight = is_end || way.dot(on) < sharpest_cosine * way.norm() * on.norm();
      return b + way.norm() * (straight ? way : on).normalized();
    };
    Points points;
    std::vector<double> radius;
    for (std::size_t i = 0; i < segments; ++i) {
      const Vec2 &a = at(i), &b = at(i + 1);
      const Vec2 before = beyond(b, a, i + count - 1, !line.closed && i == 0);
      const Vec2 after = beyond(a, b, i + 2, !line.closed && i + 1 == segments);
      points.insert(points.end(), {a, (9 * (a + b) - before - after) / 16});
      radius.insert(radius.end(), {line.radius[i], (line.radius[i] + line.radius[(i + 1) % count]) / 2});
    }
    if (!line.closed) points.push_back(line.points.back());
    if (!line.closed) radius.push_back(line.radius.back());
    std::tie(line.points, line.radius) = std::pair(std::move(points), std::move(radius));
  }
}

/// An open line is smoothed as if it went on beyond its ends: as it came, seen in a mirror across the end, so that it
/// stays as curved there.
/// @param reach over which the direction of an end is taken; 0: no mirror, but turned by half a turn, for numbers
Points smoothed(const Points& line, bool closed, double reach) {
  TaubinOptions smoothing;
  smoothing.passes = tube_smoothing_passes;
  if (closed) return taubin_smooth(line, true, smoothing);
  const std::size_t more = std::min<std::size_t>(line.size() - 1, 2 * std::size_t{tube_smoothing_passes});
  const auto beyond = [&](bool at_start, std::size_t k) -> Vec2 {
    const Vec2& end = end_of(line, at_start);
    const Vec2 back = (at_start ? line[k] : line[line.size() - 1 - k]) - end;
    if (reach <= 0) return end - back;
    const Vec2 outward = end_tangent(line, at_start, reach);
    return end + back - 2 * back.dot(outward) * outward;
  };
  Points led_on;
  for (std::size_t k = more; k > 0; --k) led_on.push_back(beyond(true, k));
  led_on.insert(led_on.end(), line.begin(), line.end());
  for (std::size_t k = 1; k <= more; ++k) led_on.push_back(beyond(false, k));
  led_on = taubin_smooth(led_on, false, smoothing);
  const auto first = led_on.begin() + static_cast<std::ptrdiff_t>(more);
  return Points(first, first + static_cast<std::ptrdiff_t>(line.size()));
}

/// A place of an outline before it is sampled evenly.
struct OutlinePoint {
  Vec2 at = Vec2::Zero();
  double along = 0;
  bool corner = false;
  bool back = false;  ///< from here on it runs backwards along the centre line
};

using OutlinePoints = std::vector<OutlinePoint>;

/// The envelope of the circles around the centre line, on its left (+1) or right (-1).
OutlinePoints side_of(const CentreLine& line, int side) {
  const auto count = static_cast<Index>(line.points.size());
  const std::vector<double> arcs = arc_lengths(line.points, line.closed);
  OutlinePoints points;
  for (Index i = 0; i < count; ++i) {
    const Index before = line.closed ? (i + count - 1) % count : std::max<Index>(i, 1) - 1;
    const Index after = line.closed ? (i + 1) % count : std::min(i + 1, count - 1);
    const Vec2 step = line.points[after] - line.points[before];
    const Vec2 ahead = step.normalized();
    const double slope = std::clamp((line.radius[after] - line.radius[before]) / step.norm(), -steepest, steepest);
    const Vec2 out = side * std::sqrt(1 - slope * slope) * left_of(ahead) - slope * ahead;
    points.push_back({line.points[i] + line.radius[i] * out, arcs[i]});
  }
  for (Index i = 0; i < (line.closed ? count : count - 1); ++i) {
    const Index next = (i + 1) % count;
    points[i].back = (points[next].at - points[i].at).dot(line.points[next] - line.points[i]) < 0;
  }
  return points;
}

/// Cuts off the loops of a closed outline that run backwards, within bends narrower than the tube.
OutlinePoints without_loops(OutlinePoints outline, const CentreLine& line) {
  const std::size_t count = outline.size();
  if (std::ranges::none_of(outline, &OutlinePoint::back)) return outline;
  std::size_t start = 0;  // in the middle of the longest run ahead, where no loop is
  for (std::size_t i = 0, run = 0, longest = 0; i < 2 * count; ++i) {
    run = outline[i % count].back ? 0 : run + 1;
    if (run > longest) std::tie(longest, start) = std::pair(run, (i + 1 + count - std::min(run, count) / 2) % count);
  }
  std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(start), outline.end());
  const double spacing = length(line.points, line.closed) / static_cast<double>(line.points.size());
  const auto most = static_cast<std::size_t>(tube_loop_reach * std::ranges::max(line.radius) / spacing);
  OutlinePoints kept;
  for (std::size_t i = 0; i < count; ++i) {
    kept.push_back(outline[i]);
    for (std::size_t k = std::min(count - 1, i + most); k-- > i + 2;) {
      const Vec2 &a = outline[i].at, &b = outline[i + 1].at, &c = outline[k].at, &d = outline[k + 1].at;
      const auto between = std::span(outline).subspan(i, k - i + 1);
      if (!segments_cross(a, b, c, d) || std::ranges::none_of(between, &OutlinePoint::back)) continue;
      kept.push_back({a + crossing_fraction(a, b, c, d) * (b - a), outline[i].along, true});
      i = k;
      break;
    }
  }
  return kept;
}

/// The end of a tube, from one of its sides counter-clockwise to the other.
void add_end(const CentreLine& line, bool at_start, double spacing, OutlinePoints& outline, const Vec2& to) {
  const Vec2& centre = end_of(line.points, at_start);
  const Vec2 outward = end_chord(line.points, at_start, 2 * spacing);
  const double radius = at_start ? line.radius.front() : line.radius.back();
  const double along = at_start ? 0 : length(line.points, false);
  const auto add = [&](const Vec2& offset, bool corner) {
    const double beyond = offset.dot(outward);
    outline.push_back({centre + offset, at_start ? -beyond : along + beyond, corner});
  };
  const auto angle_of = [&](const Vec2& place) {
    return std::atan2(cross(outward, place - centre), outward.dot(place - centre));
  };
  if (line.ends != TubeEnds::Round) outline.back().corner = true;
  if (line.ends == TubeEnds::Pointed) add(tube_tip * radius * outward, true);
  if (line.ends != TubeEnds::Round) return;
  const double from = angle_of(outline.back().at), whole = angle_of(to) - from;
  const int pieces = std::max(4, static_cast<int>(std::ceil(whole * radius / spacing)));
  for (int k = 1; k < pieces; ++k) {
    const double angle = from + whole * k / pieces;
    add(radius * (std::cos(angle) * outward + std::sin(angle) * left_of(outward)), false);
  }
}

CleanLine sampled_line(const OutlinePoints& outline, const CentreLine& tube, Index number, int side, double step) {
  CleanLine line;
  line.closed = true;
  line.centre_line = number;
  line.side = side;
  line.object = tube.object;
  line.strokes = {tube.stroke};
  Points points;
  std::vector<Index> corners;
  for (const OutlinePoint& point : outline) {
    if (point.corner) corners.push_back(static_cast<Index>(points.size()));
    points.push_back(point.at);
  }
  const double period = length(tube.points, tube.closed);
  for (const double parameter : even_parameters(points, true, step, corners)) {
    const auto at = static_cast<std::size_t>(parameter);
    const OutlinePoint &from = outline[at], &to = outline[(at + 1) % outline.size()];
    double change = to.along - from.along;
    if (tube.closed) change -= period * std::round(change / period);
    line.points.push_back(point_at(points, parameter));
    line.along.push_back(from.along + (parameter - std::floor(parameter)) * change);
  }
  line.raw = line.points;
  line.stroke.assign(line.points.size(), tube.stroke);
  line.size = size_of(line.points, true);
  return line;
}

}  // namespace

double largest_radius(const Stroke& stroke) {
  const std::vector<double> radii = is_centre_line(stroke) ? radii_of(stroke) : std::vector<double>{};
  return radii.empty() ? 0 : std::ranges::max(radii);
}

void add_centre_line(const Drawing& drawing, Index s, SampledDrawing& sampled) {
  const Stroke& stroke = drawing.strokes[s];
  if (const std::string fault = fault_of(drawing, s, sampled.scale.unit); !fault.empty()) {
    sampled.findings.push_back(
        make_error(Category::Geometry, "E_TUBE", tube_named(drawing, s) + fault, {stroke_subject(drawing, s)}));
    return;
  }
  const std::vector<double> radii = radii_of(stroke);
  CentreLine line{{}, {}, s, stroke.object, stroke.closed, TubeEnds::Round};
  if (stroke.data.contains(ends_key)) line.ends = *tube_ends(stroke.data.at(ends_key));
  const bool spread = radii.size() > 1 && radii.size() != stroke.samples.size();  // evenly over the length
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const Vec2& place = stroke.samples[i].position;
    if (!line.points.empty() && place == line.points.back()) continue;
    line.points.push_back(place);
    line.radius.push_back(spread ? radii.front() : radius_at(stroke, radii, i));
  }
  if (line.closed && line.points.size() > 1 && line.points.back() == line.points.front()) {
    line.points.pop_back();
    line.radius.pop_back();
  }
  if (!line.closed) close_where_ends_meet(line, sampled.scale.close);
  const double spacing = std::min(spacing_share * std::ranges::min(radii), length(line.points, line.closed) / 16);
  Points points, thickness;  // radii as points, to be smoothed alike
  refine(line, spacing);
  const std::vector<double> parameters = even_parameters(line.points, line.closed, spacing);
  for (const double parameter : parameters) {
    const auto at = std::min(static_cast<std::size_t>(parameter), line.points.size() - 1);
    const double share = parameter - static_cast<double>(at);
    double radius = (1 - share) * line.radius[at] + share * line.radius[(at + 1) % line.radius.size()];
    if (spread) {
      const double part = static_cast<double>(points.size()) / static_cast<double>(parameters.size() - 1);
      const double place = part * static_cast<double>(radii.size() - 1);
      const auto first = std::min(static_cast<std::size_t>(place), radii.size() - 2);
      radius = std::lerp(radii[first], radii[first + 1], place - static_cast<double>(first));
    }
    points.push_back(point_at(line.points, parameter));
    thickness.emplace_back(radius, 0);
  }
  line.points = smoothed(points, line.closed, std::ranges::min(line.radius));
  line.radius.clear();
  for (const Vec2& radius : smoothed(thickness, line.closed, 0)) line.radius.push_back(radius.x());
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    line.points[i] += tube_displacement * spacing * Vec2(scattered(2 * i), scattered(2 * i + 1));
  }
  sampled.tubes.push_back(std::move(line));
}

std::vector<CleanLine> outlines_of_tubes(const std::vector<CentreLine>& tubes, const DrawingScale& scale) {
  std::vector<CleanLine> lines;
  for (Index number = 0; number < tubes.size(); ++number) {
    const CentreLine& tube = tubes[number];
    OutlinePoints right = side_of(tube, -1), left = side_of(tube, 1);
    if (tube.closed) {
      lines.push_back(sampled_line(without_loops(std::move(right), tube), tube, number, 1, scale.step));
      lines.push_back(sampled_line(without_loops(std::move(left), tube), tube, number, -1, scale.step));
      continue;
    }
    const double spacing = length(tube.points, false) / static_cast<double>(tube.points.size());
    add_end(tube, false, spacing, right, left.back().at);
    for (std::size_t i = left.size(); i-- > 1;) left[i].back = left[i - 1].back;  // they run the other way there
    std::ranges::reverse(left);
    left.back().back = false;
    if (tube.ends != TubeEnds::Round) left.front().corner = right.front().corner = true;
    const Vec2 start = right.front().at;
    right.insert(right.end(), left.begin(), left.end());
    add_end(tube, true, spacing, right, start);
    lines.push_back(sampled_line(without_loops(std::move(right), tube), tube, number, 1, scale.step));
  }
  return lines;
}

}  // namespace croquis::silhouette
