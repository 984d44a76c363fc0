// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/picture_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "io/tracing/dots.h"
#include "io/tracing/ink.h"
#include "io/tracing/skeleton.h"
#include "io/tracing/thinning.h"
#include "io/tracing/traced_curve.h"

namespace croquis {
namespace tracing {
namespace {

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
