// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/drawing_reading.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/figure/drawing_parts.h"
#include "algorithms/silhouette/figure/nested_outlines.h"
#include "algorithms/silhouette/strokes/told_hidden.h"

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

/// Marks the overlaps of objects whose outlines cross in full view.
void mark_whole_outlines(LabelledDrawing& labelled) {
  for (LabelledFigure& figure : labelled.figures) {
    for (FigureOverlap& overlap : figure.overlaps) {
      const auto bounds = [&](Index object, Index stroke) {
        const std::vector<Index>& strokes = figure.objects[object].strokes;
        return std::find(strokes.begin(), strokes.end(), stroke) != strokes.end();
      };
      overlap.whole_outlines =
          std::any_of(labelled.crossings.begin(), labelled.crossings.end(), [&](const CrossingInView& pair) {
            return pair.whole && bounds(overlap.upper, pair.front) && bounds(overlap.lower, pair.behind);
          });
    }
  }
}

}  // namespace

ReadStrokes read_strokes(const Drawing& drawing, const Options& options, const StrokeReading& reading,
                         Progress& progress) {
  ReadStrokes read;
  read.clean = clean_strokes(drawing, options.strokes, reading, progress.step("cleaning strokes", 0.5));
  std::vector<CleanLine>& lines = read.clean.lines;
  const DrawingScale& scale = read.clean.scale;
  const Progress finding = progress.step("finding junctions", 0.5);
  const std::vector<std::array<bool, 2>> loose = meet_bars(lines, reading, scale, finding);
  if (options.strokes.crossings == Crossings::Front) {
    read.crossed = cut_visible_crossings(drawing, lines, loose, scale, finding);
  }
  ToldHidden told = told_hidden(drawing, read.clean.hidden, lines, scale);
  std::vector<HiddenPiece>& pieces = read.crossed.pieces;
  pieces.insert(pieces.end(), told.pieces.begin(), told.pieces.end());
  read.junctions = find_junctions(drawing, lines, reading, std::move(pieces), scale, finding);
  std::move(told.findings.begin(), told.findings.end(), std::back_inserter(read.junctions.findings));
  extend_behind_bars(lines, read.junctions.ends, scale);
  bring_into_general_position(lines, scale.step);
  return read;
}

LabelledDrawing label_strokes(const Drawing& drawing, const Options& options, const ReadStrokes& read,
                              Progress& progress) {
  const std::vector<CleanLine>& lines = read.clean.lines;
  const FigureContext context{drawing, options,        read.clean.scale,
                              lines,   read.junctions, completion_reference(lines, read.junctions)};
  LabelledDrawing result = label_parts(context, read.junctions.findings, progress);
  result.crossings = read.crossed.pairs;
  mark_whole_outlines(result);
  Findings findings = read.clean.findings;
  findings.insert(findings.end(), read.crossed.findings.begin(), read.crossed.findings.end());
  for (const LineFinding& found : read.junctions.findings) findings.push_back(found.finding);
  std::move(result.findings.begin(), result.findings.end(), std::back_inserter(findings));
  for (const LabelledFigure& figure : result.figures) {
    Findings notes = nested_findings(drawing, figure);
    std::move(notes.begin(), notes.end(), std::back_inserter(findings));
  }
  result.findings = std::move(findings);
  return result;
}

}  // namespace croquis::silhouette
