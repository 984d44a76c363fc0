// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/picture_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/bezier_fit.h"
#include "croquis/geometry/polyline.h"
#include "io/tracing/tracing.h"

namespace croquis {
namespace tracing {
namespace {

constexpr double spacing = 2;      // pixels between points that are fitted, and points of the result
constexpr double tolerance = 0.6;  // pixels, of a curve from the middle of a line
constexpr double corner_turn = 55 * std::numbers::pi / 180;
constexpr double least_reach = 5;   // pixels on both sides over which the turn of a corner is measured, or
constexpr double corner_reach = 4;  // half widths, if that is more

/// Adds points along the curves through a row that has no corner inside; the row's last point isn't added.
void add_curves(const std::vector<Vec3>& row, BezierFitOptions options, std::vector<Vec2>& result) {
  options.tolerance = tolerance;
  for (const FittedBezier& curve : fit_beziers(row, options)) {
    const std::size_t count = curve.last - curve.first;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count);
      std::vector<Vec3> p = curve.control;
      for (std::size_t left = p.size() - 1; left > 0; --left) {
        for (std::size_t j = 0; j < left; ++j) p[j] += t * (p[j + 1] - p[j]);
      }
      result.push_back(p.front().head<2>());
    }
  }
}

Vec3 in_space(const Vec2& point) { return {point.x(), point.y(), 0}; }

/// The smooth curve along the pixels of a line, with its corners, as points at even distances.
/// @param half_width pixels, the usual one of a line: corners are found over about two widths
TracedLine smooth_curve(const TracedLine& line, double half_width) {
  const double apart = std::min(spacing, length(line.points, line.closed) / 3);
  std::vector<Vec2> points = even_points(line.points, line.closed, apart);
  const double reach = std::max(least_reach, corner_reach * half_width);
  const std::vector<Index> corners = corners_of(points, line.closed, reach, corner_turn);
  TaubinOptions fairing;
  fairing.fixed.assign(points.size(), false);
  for (const Index corner : corners) fairing.fixed[corner] = true;
  points = taubin_smooth(points, line.closed, fairing);
  TracedLine result{{}, line.closed};
  const std::size_t n = points.size();
  std::vector<std::size_t> ends;
  if (!line.closed) ends.push_back(0);
  ends.insert(ends.end(), corners.begin(), corners.end());
  const bool is_smooth_ring = ends.empty();
  if (is_smooth_ring) ends.push_back(0);
  ends.push_back(line.closed ? ends.front() + n : n - 1);
  BezierFitOptions options;
  if (is_smooth_ring) {
    std::vector<Vec3> ring;
    std::ranges::transform(points, std::back_inserter(ring), in_space);
    options.start_direction = options.end_direction = row_direction(ring, 0, 3 * spacing, true);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    std::vector<Vec3> row;
    for (std::size_t k = ends[i]; k <= ends[i + 1]; ++k) row.push_back(in_space(points[k % n]));
    add_curves(row, options, result.points);
  }
  if (!line.closed) result.points.push_back(points.back());
  return result;
}

constexpr double faintest_line = 0.45;  // × the usual darkness along lines
constexpr std::size_t branches_per_stroke = 20;
constexpr std::string_view png_beginning = "\x89PNG";

[[noreturn]] void refuse_tracing(const std::string& file, Category category, const char* code,
                                 const std::string& reason) {
  throw Error(make_error(category, code, "The picture \"" + file + "\" " + reason,
                         {{SubjectKind::File, file, std::nullopt, std::nullopt, {}}}));
}

[[noreturn]] void refuse_crowd(const std::string& file) {
  refuse_tracing(file, Category::Geometry, "E_NO_LINE_DRAWING",
                 "shows more than a line drawing does: take a picture of the drawing alone, or draw over it in the "
                 "studio");
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Pixels, half of the usual width of a line: over all middle lines.
double usual_half_width(const Mask& thin, const PixelGrid<int>& distances) {
  std::vector<double> widths;
  for (std::size_t i = 0; i < thin.values.size(); ++i) {
    if (thin.values[i] != 0) widths.push_back(static_cast<double>(distances.values[i]) / pixel_step);
  }
  return median(std::move(widths));
}

/// The mean darkness of the picture along a line.
double darkness_along(const TracedLine& line, const PixelGrid<float>& darkness) {
  double sum = 0;
  for (const Vec2& point : line.points)
    sum += darkness.at_or_empty(static_cast<int>(std::lround(point.x())), static_cast<int>(std::lround(point.y())));
  return sum / static_cast<double>(line.points.size());
}

/// Half as large about its middle: inside a compact shape.
TracedLine halved(TracedLine dot) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& point : dot.points) middle += point / static_cast<double>(dot.points.size());
  for (Vec2& point : dot.points) point = (point + middle) / 2;
  return dot;
}

/// Leaves out lines that are too short, and what is far fainter than most of the lines: creases, and corners between
/// shadows.
void drop_specks(std::vector<TracedLine>& lines, std::vector<TracedLine>& dots, const PixelGrid<float>& darkness,
                 double shortest) {
  std::erase_if(lines, [&](const TracedLine& line) { return length(line.points, line.closed) < shortest; });
  std::vector<double> along;
  for (const TracedLine& line : lines) along.insert(along.end(), line.points.size(), darkness_along(line, darkness));
  const double faintest = faintest_line * median(std::move(along));
  std::erase_if(lines, [&](const TracedLine& line) { return darkness_along(line, darkness) < faintest; });
  std::erase_if(dots, [&](const TracedLine& dot) { return darkness_along(halved(dot), darkness) < faintest; });
}

/// All lines and the borders of dots; pixels.
std::vector<TracedLine> lines_of(Ink& ink, const TraceOptions& options, const std::string& file, Progress& progress) {
  PixelGrid<int> distances = distances_to_outside(ink.mask);
  Mask thin = thinned(ink.mask, distances);
  const double half_width = usual_half_width(thin, distances);
  progress.check();
  std::vector<TracedLine> dots = take_dots(ink.mask, distances, half_width);
  thin = thinned(ink.mask, distances);
  progress.check();
  const Skeleton skeleton = simplified(skeleton_of(thin, distances));
  if (skeleton.branches.size() > branches_per_stroke * options.most_strokes) refuse_crowd(file);
  std::vector<TracedLine> lines = joined_lines(skeleton, half_width);
  drop_specks(lines, dots, ink.darkness, options.shortest_stroke * 2 * half_width);
  lines.insert(lines.end(), dots.begin(), dots.end());
  if (lines.size() > options.most_strokes) refuse_crowd(file);
  for (TracedLine& line : lines) line = smooth_curve(line, half_width);
  return lines;
}

/// Pixel centres lie half a pixel from the corner.
Stroke stroke_of(const TracedLine& line, double unit) {
  Stroke stroke;
  stroke.closed = line.closed;
  for (const Vec2& point : line.points) stroke.samples.push_back({unit * Vec2(point.x() + 0.5, -point.y() - 0.5)});
  return stroke;
}

}  // namespace
}  // namespace tracing

Drawing trace_picture(const Picture& picture, const std::string& file_name, Progress& progress,
                      const TraceOptions& options) {
  Progress finding = progress.step("find lines", 0.6);
  tracing::Ink ink = tracing::find_ink(picture, options, finding);
  Progress following = progress.step("trace lines", 0.4);
  std::vector<tracing::TracedLine> lines = tracing::lines_of(ink, options, file_name, following);
  if (lines.empty()) {
    tracing::refuse_tracing(file_name, Category::Malformed, "E_NO_STROKES",
                            "has no line in it: draw with a darker pen, or take the picture nearer and in more light");
  }
  std::ranges::stable_sort(lines, std::greater(),
                           [](const tracing::TracedLine& line) { return length(line.points, line.closed); });
  const double unit = traced_side / std::max(ink.mask.width, ink.mask.height);
  Drawing drawing;
  drawing.file = file_name;
  for (const tracing::TracedLine& line : lines) {
    drawing.strokes.push_back(tracing::stroke_of(line, unit));
    drawing.strokes.back().id = "stroke-" + std::to_string(drawing.strokes.size());
  }
  return drawing;
}

bool is_picture(std::string_view bytes) {
  constexpr std::array<std::string_view, 6> beginnings{
      tracing::png_beginning, "\xFF\xD8\xFF", "GIF8", "RIFF", "BM", "II*"};
  const bool is_heif = bytes.size() > 8 && bytes.substr(4, 4) == "ftyp";
  return is_heif ||
         std::ranges::any_of(beginnings, [&](std::string_view beginning) { return bytes.starts_with(beginning); });
}

Drawing read_picture_drawing(std::string_view bytes, const std::string& file_name, Progress& progress) {
  if (!bytes.starts_with(tracing::png_beginning)) {
    tracing::refuse_tracing(
        file_name, Category::Malformed, "E_PICTURE_FILE",
        "isn't a PNG file, the only pictures that are read here: save it as PNG, or open it in the studio");
  }
  const Picture picture = decode_png(bytes, file_name);
  return trace_picture(picture, file_name, progress);
}

}  // namespace croquis
