// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/stroke_cleanup.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/doubled_strokes.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/segment_grid.h"
#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// A drawing with more samples than this is a scribble: its outlines would be longer than 3000 times its diagonal.
constexpr double maximum_samples = 500'000;
// At most so many times finer than the sheet's own u, which bounds the number of samples.
constexpr double finest_unit = 8;

// A program puts ends on lines, a hand doesn't. Programs round places to a pixel of a thousand;
// of hands that miss by 2 % one end in twenty is so near.
constexpr double exact_miss = 1;  // u
constexpr double most_exact = 0.9;
// The part of the own stroke that an end doesn't lie on.
constexpr double own_part = 40;  // u

/// W_BEHIND for every id that a stroke is told to lie behind though it can't.
Findings wrong_behind(const Drawing& drawing) {
  Findings findings;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    for (const std::string_view id : behind_ids(stroke)) {
      const bool known = std::ranges::count(drawing.strokes, id, &Stroke::id) > 0;
      if (id == behind_all || (known && id != stroke.id)) continue;
      const std::string why = known ? "itself" : "\"" + std::string(id) + "\", which isn't in the drawing";
      findings.push_back(make_warning(
          Category::Geometry, "W_BEHIND",
          "The stroke " + in_quotes(drawing, s) + " is told to lie behind " + why + ": write the id of another stroke",
          {stroke_subject(drawing, s)}));
    }
  }
  return findings;
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

DrawingScale scale_of(const Drawing& drawing, const StrokeOptions& options, double typical) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    if (!is_usable(stroke)) continue;
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  }
  double unit = box.isEmpty() ? 0 : box.diagonal().norm() / 1000;
  if (typical > 0) {
    // In steps of half an octave: else every change of one thing would sample all others anew.
    const double finer = std::clamp(least_typical_size * unit / typical, 1.0, finest_unit);
    unit /= std::exp2(std::floor(2 * std::log2(finer)) / 2);
  }
  DrawingScale scale{unit, options.step, options.tiny, options.close, options.gap, options.snap};
  for (double* length : {&scale.step, &scale.tiny, &scale.close, &scale.gap, &scale.snap}) *length *= unit;
  scale.close_share = options.close_share;
  scale.aside_share = options.aside_share;
  scale.reach_share = options.reach_share;
  return scale;
}

/// The strokes that are long enough to be lines, with their points as drawn.
std::vector<SampledStroke> usable_strokes(const Drawing& drawing, double tiny, std::vector<Index>& dots,
                                          Findings& findings) {
  std::vector<SampledStroke> usable;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    const std::optional<StrokeKind> kind = stroke_kind(stroke);
    if (!kind) {
      findings.push_back(make_error(
          Category::Geometry, "E_NOT_SUPPORTED",
          "The stroke " + in_quotes(drawing, s) + " is marked as \"" + stroke.data.at(kind_key) +
              "\", which is no kind of stroke: write contour, part, hole, blob, detail, scribble, tube, ignored, "
              "hidden or visible",
          {stroke_subject(drawing, s)}));
    } else if (!is_usable(stroke)) {
      findings.push_back(make_error(Category::Malformed, "E_NOT_FINITE",
                                    "The stroke " + in_quotes(drawing, s) + " has a coordinate that " + unusable_words +
                                        ": correct it or remove the stroke",
                                    {stroke_subject(drawing, s)}));
    } else {
      SampledStroke drawn{distinct_points(stroke), s, stroke.object, *kind, stroke.closed};
      drawn.length = length(drawn.points, drawn.closed);
      if (drawn.points.size() < 2 || drawn.length < tiny) {
        dots.push_back(s);
      } else {
        usable.push_back(std::move(drawn));
      }
    }
  }
  return usable;
}

bool is_hidden(const SampledStroke& stroke) { return stroke.told == StrokeKind::Hidden; }

/// @throws Error when nothing is left to read, or too much to sample
void check_extent(const Drawing& drawing, const SampledDrawing& sampled) {
  Findings findings = sampled.findings;
  const std::vector<SampledStroke>& usable = sampled.strokes;
  if (std::ranges::all_of(usable, is_hidden)) {
    for (const Index dot : sampled.dots) findings.push_back(too_short(drawing, dot));
    if (!has_errors(findings)) {
      findings.push_back(make_error(Category::Geometry, "E_NO_STROKES",
                                    "The drawing has no stroke to work with: draw the outline of something"));
    }
    throw Error(findings);
  }
  double length = 0;
  for (const SampledStroke& stroke : usable) length += stroke.length;
  if (std::isfinite(length) && length <= maximum_samples * sampled.scale.step) return;
  const Index longest = std::ranges::max_element(usable, {}, &SampledStroke::length)->stroke;
  findings.push_back(make_error(Category::Limit, "E_LIMIT",
                                "The strokes are too long in all for their size, the longest being " +
                                    in_quotes(drawing, longest) + ": remove scribbles",
                                {stroke_subject(drawing, longest)}));
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
      grid.near_place(at_start ? points.front() : points.back(), exact_miss * scale.unit, look);
      ++ends;
      exact += touches ? 1 : 0;
    }
  }
  return ends > 0 && exact >= most_exact * ends;
}

}  // namespace

SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical) {
  SampledDrawing result;
  result.findings = wrong_behind(drawing);
  result.scale = scale_of(drawing, options, typical);
  result.strokes = usable_strokes(drawing, result.scale.tiny, result.dots, result.findings);
  check_extent(drawing, result);
  for (SampledStroke& stroke : result.strokes) {
    stroke.size = size_of(stroke.points, stroke.closed);
    stroke.points = even_points(stroke.points, stroke.closed, result.scale.step / 2);
  }
  std::ranges::copy_if(result.strokes, std::back_inserter(result.hidden), is_hidden);
  std::erase_if(result.strokes, is_hidden);
  cut_retraced_ends(result.strokes, result.scale);
  if (options.adapts && are_ends_exact(result.strokes, result.scale)) {
    const StrokeOptions exact = Options::of(Preset::Clean).strokes;
    result.scale.snap = exact.snap * result.scale.unit;
    result.scale.close_share = exact.close_share;
    result.scale.aside_share = exact.aside_share;
    result.scale.reach_share = exact.reach_share;
  }
  return result;
}

}  // namespace croquis::silhouette
