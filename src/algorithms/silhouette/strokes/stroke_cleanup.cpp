// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/tube_outline.h"
#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// A drawing with more samples than this is a scribble: its outlines would be longer than 3000 times its diagonal.
constexpr double maximum_samples = 500'000;
// At most so many times finer than the sheet's own u, which bounds the number of samples.
constexpr double finest_unit = 8;
// A program puts ends on lines and draws curves, a hand does neither. Programs round places to a pixel of a thousand;
// of hands that miss by 2 % one end in twenty is so near.
constexpr double exact_miss = 1;  // u
constexpr double most_exact = 0.9;
// The part of the own stroke that an end doesn't lie on.
constexpr double own_part = 40;  // u
// Curves have less jitter, in steps, but for so many of their samples, which lie beside corners. Polylines of few
// points have corners everywhere.
constexpr double smooth_jitter = 0.01;
constexpr double samples_at_corners = 0.2;
// Lines nearer than this (u) over the share of the shorter one look like one line.
constexpr double doubling_distance = 6;
constexpr double doubling_share = 0.6;
// An end runs along a line no farther from it than that (u), nor than hands miss by. Where it does so for less than
// some of these distances, or for more than a share of the line, it is by chance; what is left of it is longer, too.
constexpr double retracing_distance = 10;
constexpr double least_retraced = 4;
constexpr double most_retraced = 0.5;
// Lines run along one another up to 45 degrees.
constexpr double parallel_cosine = 0.7;
// Lines that keep to one side of one another, this far apart (u) or more, are two outlines: the sides of a thin tube.
constexpr double strand_distance = 2;
// They keep to one side when their mean distance is so many times its standard deviation.
constexpr double steadiness = 2;

/// W_BEHIND for every id that a stroke can't lie behind though its data says so.
void add_wrong_behind(const Drawing& drawing, Findings& findings) {
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    for (const std::string_view id : behind_ids(stroke)) {
      const bool known = std::ranges::count(drawing.strokes, id, &Stroke::id) > 0;
      if (id == behind_all || (known && id != stroke.id)) continue;
      const std::string why = known ? "itself" : "\"" + std::string(id) + "\", which isn't in the drawing";
      findings.push_back(make_warning(
          Category::Geometry, "W_BEHIND",
          "The stroke " + in_quotes(drawing, s) + " is set to lie behind " + why + ": write the id of another stroke",
          {stroke_subject(drawing, s)}));
    }
  }
}

bool is_usable(const Stroke& stroke) {
  return std::ranges::all_of(stroke.samples,
                             [](const StrokeSample& sample) { return are_usable_numbers(sample.position); });
}

Points distinct_points(const Stroke& stroke) {
  Points points;
  for (const StrokeSample& sample : stroke.samples) {
    if (points.empty() || sample.position != points.back()) points.push_back(sample.position);
  }
  while (stroke.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

/// Of lengths that go by how exact the hand was.
void set_tolerances(const StrokeOptions& options, DrawingScale& scale) {
  scale.snap = options.snap * scale.unit;
  scale.close_share = options.close_share;
  scale.aside_share = options.aside_share;
  scale.reach_share = options.reach_share;
}

DrawingScale scale_of(const Drawing& drawing, const StrokeOptions& options, double typical) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    if (!is_usable(stroke)) continue;
    const Vec2 around = Vec2::Constant(largest_radius(stroke));
    for (const StrokeSample& sample : stroke.samples) {
      box.extend(Vec2(sample.position - around));
      box.extend(Vec2(sample.position + around));
    }
  }
  double unit = box.isEmpty() ? 0 : box.diagonal().norm() / 1000;
  if (typical > 0) {
    // In steps of half an octave: else every change of one thing would sample all others anew.
    const double finer = std::clamp(least_typical_size * unit / typical, 1.0, finest_unit);
    unit /= std::exp2(std::floor(2 * std::log2(finer)) / 2);
  }
  DrawingScale scale{unit, options.step * unit, options.close * unit, options.gap * unit};
  set_tolerances(options, scale);
  return scale;
}

/// Adds the strokes that are long enough to be lines, with their points as drawn.
void add_usable_strokes(const Drawing& drawing, double tiny, SampledDrawing& sampled) {
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    const std::optional<StrokeKind> kind = stroke_kind(stroke);
    if (!kind) {
      sampled.findings.push_back(make_error(
          Category::Geometry, "E_NOT_SUPPORTED",
          "The stroke " + in_quotes(drawing, s) + " is marked as \"" + stroke.data.at(kind_key) +
              "\", which is no kind of stroke: write contour, part, hole, blob, detail, scribble, tube, ignored, "
              "hidden or visible",
          {stroke_subject(drawing, s)}));
    } else if (!is_usable(stroke)) {
      sampled.findings.push_back(make_error(Category::Malformed, "E_NOT_FINITE",
                                            "The stroke " + in_quotes(drawing, s) + " has a coordinate that " +
                                                unusable_words + ": correct it or remove the stroke",
                                            {stroke_subject(drawing, s)}));
    } else if (is_centre_line(stroke)) {
      add_centre_line(drawing, s, sampled);
    } else {
      SampledStroke drawn{distinct_points(stroke), s, stroke.object, *kind, stroke.closed};
      drawn.length = length(drawn.points, drawn.closed);
      if (drawn.points.size() < 2 || drawn.length < tiny) {
        sampled.dots.push_back(s);
      } else {
        sampled.strokes.push_back(std::move(drawn));
      }
    }
  }
}

bool is_hidden(const SampledStroke& stroke) { return stroke.given_kind == StrokeKind::Hidden; }

/// @throws Error when nothing is left to read, or too much to sample
void check_extent(const Drawing& drawing, const SampledDrawing& sampled) {
  Findings findings = sampled.findings;
  const std::vector<SampledStroke>& usable = sampled.strokes;
  if (std::ranges::all_of(usable, is_hidden)) {
    if (!sampled.tubes.empty()) return;
    for (const Index dot : sampled.dots) findings.push_back(too_short(drawing, dot));
    if (!has_errors(findings)) {
      findings.push_back(make_error(Category::Geometry, "E_NO_STROKES",
                                    "The drawing has no stroke to work with: draw the outline of something"));
    }
  } else {
    double length = 0;
    for (const SampledStroke& stroke : usable) length += stroke.length;
    if (std::isfinite(length) && length <= maximum_samples * sampled.scale.step) return;
    const Index longest = std::ranges::max_element(usable, {}, &SampledStroke::length)->stroke;
    findings.push_back(make_error(Category::Limit, "E_LIMIT",
                                  "The strokes are too long in all for their size, the longest being " +
                                      in_quotes(drawing, longest) + ": remove scribbles",
                                  {stroke_subject(drawing, longest)}));
  }
  throw Error(findings);
}

/// Whether nearly all ends of open strokes lie on another line, or on a part of their own far from them.
bool are_ends_exact(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const SegmentGrid grid(segments_of(strokes), scale.step);
  int ends = 0, exact = 0;
  for (Index s = 0; s < strokes.size(); ++s) {
    const Points& points = strokes[s].points;
    if (strokes[s].closed) continue;
    for (const bool at_start : {true, false}) {
      bool touches = false;
      const auto look = [&](const GridSegment& segment, const Vec2&) {
        const auto last = static_cast<double>(points.size() - 2);
        const double from_end = scale.step / 2 * (at_start ? segment.position : last - segment.position);
        touches = touches || segment.line != s || from_end >= own_part * scale.unit;
      };
      grid.near_place(end_of(points, at_start), exact_miss * scale.unit, look);
      ++ends;
      exact += touches ? 1 : 0;
    }
  }
  return ends > 0 && exact >= most_exact * ends;
}

/// Whether most samples lie on smooth curves: smoothing would only take from them.
bool are_smooth(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  std::vector<double> sizes;  // of the fourth differences of samples a step apart: cubic curves have none
  for (const SampledStroke& stroke : strokes) {
    const Points& p = stroke.points;
    for (std::size_t i = 8; i < p.size(); i += 2) {
      sizes.push_back((p[i - 8] - 4 * (p[i - 6] + p[i - 2]) + 6 * p[i - 4] + p[i]).norm() / 6);
    }
  }
  if (sizes.empty()) return true;
  const auto place = (1 - samples_at_corners) * static_cast<double>(sizes.size());
  const auto jitter = sizes.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(sizes, jitter);
  return *jitter < smooth_jitter * scale.step;
}

/// The samples that are left of a stroke while ends are cut off: from `begin` to before `end`.
struct KeptRun {
  Index begin = 0;
  Index end = 0;

  std::span<const Vec2> of(const Points& points) const { return std::span(points).subspan(begin, end - begin); }
};

/// An end of a stroke that may be cut off.
struct CutEnd {
  Index stroke = 0;
  bool at_start = false;
  double reach = 0;  ///< of what it runs along
};

/// Whether the step from one sample of a stroke to the next runs along what is left of another one, or along a part of
/// its own far from there.
bool runs_along_another(const SegmentGrid& grid, const std::vector<SampledStroke>& strokes,
                        const std::vector<KeptRun>& kept, const CutEnd& cut, Index from, Index to) {
  const Points& points = strokes[cut.stroke].points;
  const Vec2 direction = (points[to] - points[from]).normalized();
  bool found = false;
  grid.near_place(points[from], cut.reach, [&](const GridSegment& segment, const Vec2&) {
    const auto [begin, end] = kept[segment.line];
    const Index last = strokes[segment.line].closed ? end : end - 1;
    if (segment.position < begin || segment.position >= last) return;
    const Index apart = std::max(segment.position, from) - std::min(segment.position, from);
    if (segment.line == cut.stroke && apart <= points.size() / 2) return;
    const Vec2 along = segment.b - segment.a;
    found = found || std::abs(along.dot(direction)) > parallel_cosine * along.norm();
  });
  return found;
}

/// Whether another line, or the other end of the same one, ends where a stroke goes on alone, and in its direction:
/// lines that only come together don't.
/// @param onward the stroke's direction at that place
bool goes_on_from_end(const std::vector<SampledStroke>& strokes, const std::vector<KeptRun>& kept, const CutEnd& cut,
                      double length, const Vec2& place, const Vec2& onward) {
  for (Index other = 0; other < strokes.size(); ++other) {
    if (strokes[other].closed || length > most_retraced * strokes[other].length) continue;
    const std::span<const Vec2> points = kept[other].of(strokes[other].points);
    for (const bool at_start : {true, false}) {
      if (other == cut.stroke && at_start == cut.at_start) continue;
      const bool near = (end_of(points, at_start) - place).norm() <= 2 * cut.reach;
      if (near && end_chord(points, at_start, 2 * cut.reach).dot(onward) > parallel_cosine) return true;
    }
  }
  return false;
}

bool may_be_outline(StrokeKind kind) {
  return kind == StrokeKind::Visible || kind == StrokeKind::Contour || kind == StrokeKind::Part ||
         kind == StrokeKind::Blob || kind == StrokeKind::Hole;
}

/// Cuts off what open strokes draw once more of other ones.
void cut_retraced_ends(std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  if (scale.reach_share <= 0) return;
  const SegmentGrid grid(segments_of(strokes), scale.step);
  std::vector<KeptRun> kept;
  for (const SampledStroke& stroke : strokes) kept.push_back({0, static_cast<Index>(stroke.points.size())});
  for (auto s = static_cast<Index>(strokes.size()); s-- > 0;) {
    const SampledStroke& stroke = strokes[s];
    if (stroke.closed || !may_be_outline(stroke.given_kind)) continue;
    const double reach = std::min(retracing_distance * scale.unit, scale.reach_share * stroke.size);
    const double spacing = stroke.length / static_cast<double>(stroke.points.size() - 1);
    for (const bool at_start : {false, true}) {
      Index& begin = kept[s].begin;
      Index& end = kept[s].end;
      const CutEnd cut{s, at_start, reach};
      const auto sample = [&](Index steps) { return at_start ? begin + steps : end - 1 - steps; };
      Index steps = 0;  // from the end, along another line
      while (begin + steps + 1 < end &&
             runs_along_another(grid, strokes, kept, cut, sample(steps), sample(steps + 1))) {
        ++steps;
      }
      const double length = spacing * steps, rest = spacing * (end - begin - steps);
      if (std::min(length, rest) < least_retraced * reach) continue;
      const Vec2& place = stroke.points[sample(steps)];
      const auto back = static_cast<Index>(std::min(length, 2 * reach) / spacing);
      const Vec2 onward = (place - stroke.points[sample(steps - back)]).normalized();
      if (goes_on_from_end(strokes, kept, cut, length, place, onward)) (at_start ? begin += steps : end -= steps);
    }
  }
  for (Index s = 0; s < strokes.size(); ++s) {
    SampledStroke& stroke = strokes[s];
    if (kept[s].end - kept[s].begin == stroke.points.size()) continue;
    const std::span<const Vec2> left = kept[s].of(stroke.points);
    stroke.points = Points(left.begin(), left.end());
    stroke.length = length(stroke.points, false);
    stroke.size = size_of(stroke.points, false);
  }
}

/// Whether a line keeps to one side of another one.
/// @param distances signed, from samples of the one to the other
bool keeps_to_one_side(const std::vector<double>& distances, double unit) {
  double sum = 0, squares = 0;
  for (const double distance : distances) {
    sum += distance;
    squares += distance * distance;
  }
  const auto count = static_cast<double>(distances.size());
  const double mean = std::abs(sum) / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  return mean >= strand_distance * unit && mean >= steadiness * deviation;
}

}  // namespace

SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical) {
  SampledDrawing result;
  add_wrong_behind(drawing, result.findings);
  result.scale = scale_of(drawing, options, typical);
  add_usable_strokes(drawing, options.tiny * result.scale.unit, result);
  check_extent(drawing, result);
  for (SampledStroke& stroke : result.strokes) {
    stroke.size = size_of(stroke.points, stroke.closed);
    stroke.points = even_points(stroke.points, stroke.closed, result.scale.step / 2);
  }
  std::ranges::copy_if(result.strokes, std::back_inserter(result.hidden), is_hidden);
  std::erase_if(result.strokes, is_hidden);
  cut_retraced_ends(result.strokes, result.scale);
  result.smoothing_passes = options.smoothing_passes;
  if (!options.adapts) return result;
  const StrokeOptions exact = Options::of(Preset::Clean).strokes;
  if (are_smooth(result.strokes, result.scale)) result.smoothing_passes = exact.smoothing_passes;
  if (are_ends_exact(result.strokes, result.scale)) set_tolerances(exact, result.scale);
  return result;
}

std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(segments_of(strokes), scale.step);
  std::vector<Index> doubled(strokes.size(), no_index);
  for (Index s = 0; s < strokes.size(); ++s) {
    if (strokes[s].given_kind != StrokeKind::Visible) continue;
    std::map<Index, std::vector<double>> beside;  // per stroke the distances from it, on its left positive
    for (const Vec2& point : strokes[s].points) {
      std::map<Index, double> nearest;
      grid.near_place(point, reach, [&](const GridSegment& segment, const Vec2& at) {
        if (segment.line == s) return;
        const double distance = (point - at).norm();
        double& least = nearest.try_emplace(segment.line, std::numeric_limits<double>::infinity()).first->second;
        if (distance < std::abs(least)) least = cross(segment.b - segment.a, point - at) < 0 ? -distance : distance;
      });
      for (const auto& [other, distance] : nearest) beside[other].push_back(distance);
    }
    const auto size = strokes[s].points.size();
    for (const auto& [other, distances] : beside) {
      const auto other_size = strokes[other].points.size();
      if (size > other_size || (size == other_size && s < other)) continue;  // asked of the shorter one
      const bool long_enough = static_cast<double>(distances.size()) >= doubling_share * static_cast<double>(size);
      if (long_enough && !keeps_to_one_side(distances, scale.unit)) doubled[s] = other;
    }
  }
  return doubled;
}

}  // namespace croquis::silhouette
