// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/figure/drawing_parts.h"
#include "algorithms/silhouette/figure/nested_outlines.h"
#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {
namespace {

// Drawings with symmetries put samples exactly on other lines. So small a displacement (of a step) can't be seen and
// leaves no three points on a line.
constexpr double displacement = 1e-7;

/// A number in [-1,1) from a counter (splitmix64, Steele, Lea and Flood 2014).
double scattered(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

/// A start for a line's counter that no other line shares, and that stays the same while other lines change: then the
/// parts of the drawing made of those don't.
std::uint64_t seed_of(const CleanLine& line) {
  std::uint64_t seed = line.points.size();
  for (const Vec2& point : {line.points.front(), line.points[line.points.size() / 2], line.points.back()}) {
    for (const double coordinate : {point.x(), point.y()}) {
      seed = seed * 0x100000001b3U + std::bit_cast<std::uint64_t>(coordinate);
      seed = (seed ^ (seed >> 29)) * 0xbf58476d1ce4e5b9U;
    }
  }
  return seed;
}

void bring_into_general_position(std::vector<CleanLine>& lines, double step) {
  for (CleanLine& line : lines) {
    std::uint64_t counter = seed_of(line);
    for (Vec2& point : line.points) {
      point.x() += displacement * step * scattered(counter++);
      point.y() += displacement * step * scattered(counter++);
    }
  }
}

LabelledDrawing label_anew(const Drawing& drawing, const Options& options, Progress& progress) {
  CleanDrawing clean = clean_strokes(drawing, options.strokes, progress.step("cleaning strokes", 0.2));
  Progress finding = progress.step("finding junctions", 0.2);
  const std::vector<std::array<bool, 2>> loose = meet_bars(clean.lines, clean.scale, finding);
  VisibleCrossings crossed;
  if (options.strokes.crossings == Crossings::Front) {
    crossed = cut_visible_crossings(drawing, clean.lines, loose, clean.scale, finding);
  }
  Junctions junctions = find_junctions(drawing, clean.lines, std::move(crossed.pieces), clean.scale, finding);
  extend_behind_bars(clean.lines, junctions.ends, clean.scale);
  bring_into_general_position(clean.lines, clean.scale.step);

  Progress labelling = progress.step("labelling contours", 0.6);
  const FigureContext context{drawing,     options,   clean.scale,
                              clean.lines, junctions, completion_reference(clean.lines, junctions)};
  LabelledDrawing result = label_parts(context, junctions.findings, labelling);

  result.crossings = std::move(crossed.pairs);
  Findings findings = std::move(clean.findings);
  std::move(crossed.findings.begin(), crossed.findings.end(), std::back_inserter(findings));
  for (LineFinding& found : junctions.findings) findings.push_back(std::move(found.finding));
  std::move(result.findings.begin(), result.findings.end(), std::back_inserter(findings));
  for (const LabelledFigure& figure : result.figures) {
    Findings notes = nested_findings(drawing, figure);
    std::move(notes.begin(), notes.end(), std::back_inserter(findings));
  }
  result.findings = std::move(findings);
  if (result.figures.empty()) throw Error(result.findings);
  return result;
}

}  // namespace

LabelledDrawing label(const Drawing& drawing, const Options& options, Progress& progress) {
  StageKey key;
  if (options.cache != nullptr) {
    add_drawing(drawing, key);
    key.add(options.strokes).add(options.completion);
  }
  const auto labelled = cached<LabelledDrawing>(
      options.cache, "silhouette labels", key, [&] { return label_anew(drawing, options, progress); },
      [](const LabelledDrawing& result) { return bytes_of(result); });
  progress.report(1);
  return *labelled;
}

}  // namespace croquis::silhouette
