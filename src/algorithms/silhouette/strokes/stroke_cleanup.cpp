// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/stroke_cleanup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/strokes/doubled_strokes.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/exactness.h"
#include "algorithms/silhouette/strokes/stroke_chains.h"
#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// A drawing with more samples than this is a scribble: its outlines would be longer than 3000 times its diagonal.
constexpr double maximum_samples = 500'000;

// At most so many times finer than the sheet's own u, which bounds the number of samples.
constexpr double finest_unit = 8;

struct UsableStroke {
  Index stroke = 0;
  Points points;  ///< as drawn, repeated points dropped
  double length = 0;
  bool closed = false;
  bool hidden = false;
};

Finding unsupported_kind(const Drawing& drawing, Index stroke, const std::string& kind) {
  return make_error(Category::Geometry, "E_NOT_SUPPORTED",
                    "The stroke " + in_quotes(drawing, stroke) + " is marked as \"" + kind +
                        "\", which is no kind of stroke: write contour, part, hole, blob, detail, scribble, tube, "
                        "ignored, hidden or visible",
                    {stroke_subject(drawing, stroke)});
}

/// W_BEHIND for every id that a stroke is told to lie behind though it can't.
Findings wrong_behind(const Drawing& drawing) {
  Findings findings;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    for (const std::string_view id : behind_ids(stroke)) {
      const bool known = std::any_of(drawing.strokes.begin(), drawing.strokes.end(),
                                     [id](const Stroke& other) { return other.id == id; });
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
  return std::all_of(stroke.samples.begin(), stroke.samples.end(),
                     [](const StrokeSample& sample) { return are_usable_numbers(sample.position); });
}

double bounding_diagonal(const Drawing& drawing) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Stroke& stroke : drawing.strokes) {
    if (!is_usable(stroke)) continue;
    for (const StrokeSample& sample : stroke.samples) {
      low = low.cwiseMin(sample.position);
      high = high.cwiseMax(sample.position);
    }
  }
  return low.x() <= high.x() ? (high - low).norm() : 0;
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
  double unit = bounding_diagonal(drawing) / 1000;
  if (typical > 0) {
    // In steps of half an octave: else every change of one thing would sample all others anew.
    const double finer = std::clamp(least_typical_size * unit / typical, 1.0, finest_unit);
    unit /= std::exp2(std::floor(2 * std::log2(finer)) / 2);
  }
  return {unit,
          options.step * unit,
          options.tiny * unit,
          options.close * unit,
          options.gap * unit,
          options.snap * unit,
          options.close_share,
          options.aside_share,
          options.reach_share,
          0};
}

std::vector<UsableStroke> usable_strokes(const Drawing& drawing, const DrawingScale& scale, std::vector<Index>& dots,
                                         Findings& findings) {
  std::vector<UsableStroke> usable;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    const std::optional<StrokeKind> kind = stroke_kind(stroke);
    if (!kind) {
      findings.push_back(unsupported_kind(drawing, s, stroke.data.at(kind_key)));
      continue;
    }
    if (!is_usable(stroke)) {
      findings.push_back(make_error(Category::Malformed, "E_NOT_FINITE",
                                    "The stroke " + in_quotes(drawing, s) + " has a coordinate that " + unusable_words +
                                        ": correct it or remove the stroke",
                                    {stroke_subject(drawing, s)}));
      continue;
    }
    UsableStroke candidate{s, distinct_points(stroke), 0, stroke.closed, kind == StrokeKind::Hidden};
    candidate.length = croquis::length(candidate.points, candidate.closed);
    if (candidate.points.size() < 2 || candidate.length < scale.tiny) {
      dots.push_back(s);
      continue;
    }
    usable.push_back(std::move(candidate));
  }
  return usable;
}

/// Takes the strokes that are told to be hidden out of all.
std::vector<HiddenStroke> take_hidden(std::vector<UsableStroke>& usable) {
  std::vector<HiddenStroke> hidden;
  for (UsableStroke& stroke : usable) {
    if (stroke.hidden) hidden.push_back({stroke.stroke, std::move(stroke.points), stroke.closed});
  }
  std::erase_if(usable, [](const UsableStroke& stroke) { return stroke.hidden; });
  return hidden;
}

void check_extent(const Drawing& drawing, const std::vector<UsableStroke>& usable, double step, Findings& findings) {
  if (!has_errors(findings) && usable.empty()) {
    findings.push_back(make_error(Category::Geometry, "E_NO_STROKES",
                                  "The drawing has no stroke to work with: draw the outline of something"));
  }
  if (usable.empty()) throw Error(findings);
  double length = 0;
  const UsableStroke* longest = &usable.front();
  for (const UsableStroke& stroke : usable) {
    length += stroke.length;
    if (stroke.length > longest->length) longest = &stroke;
  }
  if (std::isfinite(length) && length <= maximum_samples * step) return;
  findings.push_back(make_error(Category::Limit, "E_LIMIT",
                                "The strokes are too long in all for their size, the longest being " +
                                    in_quotes(drawing, longest->stroke) + ": remove scribbles",
                                {stroke_subject(drawing, longest->stroke)}));
  throw Error(findings);
}

std::vector<SampledStroke> sample(const Drawing& drawing, const std::vector<UsableStroke>& usable, double spacing) {
  std::vector<SampledStroke> sampled;
  for (const UsableStroke& stroke : usable) {
    SampledStroke one;
    one.stroke = stroke.stroke;
    one.object = drawing.strokes[stroke.stroke].object;
    one.told = stroke_kind(drawing.strokes[stroke.stroke]).value_or(StrokeKind::Visible);
    one.closed = stroke.closed;
    one.length = stroke.length;
    one.size = size_of(stroke.points, stroke.closed);
    for (const double parameter : even_parameters(stroke.points, stroke.closed, spacing)) {
      one.points.push_back(point_at(stroke.points, parameter));
    }
    sampled.push_back(std::move(one));
  }
  return sampled;
}

}  // namespace

SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical) {
  SampledDrawing result;
  result.findings = wrong_behind(drawing);
  result.scale = scale_of(drawing, options, typical);
  std::vector<UsableStroke> usable = usable_strokes(drawing, result.scale, result.dots, result.findings);
  result.hidden = take_hidden(usable);
  if (usable.empty()) {
    for (const Index dot : result.dots) result.findings.push_back(too_short(drawing, dot));
  }
  check_extent(drawing, usable, result.scale.step, result.findings);
  result.strokes = sample(drawing, usable, result.scale.step / 2);
  cut_retraced_ends(result.strokes, result.scale);
  result.smoothing_passes = options.smoothing_passes;
  if (!options.adapts) return result;
  const StrokeOptions exact = Options::of(Preset::Clean).strokes;
  if (are_smooth(result.strokes, result.scale)) result.smoothing_passes = exact.smoothing_passes;
  if (are_ends_exact(result.strokes, result.scale)) {
    result.scale.snap = exact.snap * result.scale.unit;
    result.scale.close_share = exact.close_share;
    result.scale.aside_share = exact.aside_share;
    result.scale.reach_share = exact.reach_share;
  }
  return result;
}

}  // namespace croquis::silhouette
