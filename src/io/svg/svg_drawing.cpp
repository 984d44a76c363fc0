// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/svg_drawing.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/geometry/drawing.h"
#include "io/svg/svg_color.h"
#include "io/svg/svg_file.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr int places_per_curve = 8;  // enough to know a curve's size
constexpr double same_place = 1e-9;  // × diagonal: what relative commands lose by rounding

struct FlatteningLimits {
  Eigen::AlignedBox2d bounds;  ///< of the whole drawing
  double tolerance = 0;        ///< greatest distance of samples' chords from the curve
  std::size_t samples_left = most_curve_pieces;
};

/// Whether all its numbers are usable (limits.h).
bool is_usable(const SvgSubpath& subpath) {
  return are_usable_numbers(subpath.start) && std::ranges::all_of(subpath.segments, [](const SvgSegment& s) {
           const std::array points = {s.end, s.a, s.b, s.centre, Vec2(s.angle, s.sweep)};
           return std::ranges::all_of(points, are_usable_numbers<Vec2>);
         });
}

/// Makes the box hold the subpath, to within a fraction of each curve's own size.
void extend(Eigen::AlignedBox2d& box, const SvgSubpath& subpath) {
  Vec2 from = subpath.start;
  box.extend(from);
  for (const SvgSegment& segment : subpath.segments) {
    if (segment.kind != SvgSegment::Kind::Line) {
      for (int i = 1; i < places_per_curve; ++i) {
        box.extend(point_on(segment, from, static_cast<double>(i) / places_per_curve));
      }
    }
    box.extend(segment.end);
    from = segment.end;
  }
}

/// Gives the stroke its samples. A closed one does not repeat its first.
/// @returns false when there would be more samples than are left
bool flatten_into(Stroke& stroke, const SvgSubpath& subpath, FlatteningLimits& limits) {
  const auto append = [&](const Vec2& place) {
    StrokeSample sample;
    sample.position = place;
    stroke.samples.push_back(sample);
  };
  Vec2 from = subpath.start;
  append(from);
  for (const SvgSegment& segment : subpath.segments) {
    const int pieces = pieces_within(segment, from, limits.tolerance);
    if (static_cast<std::size_t>(pieces) >= limits.samples_left) return false;
    limits.samples_left -= static_cast<std::size_t>(pieces);
    for (int i = 1; i <= pieces; ++i) append(point_on(segment, from, static_cast<double>(i) / pieces));
    from = segment.end;
  }
  stroke.closed = subpath.closed;
  const bool returns = (from - subpath.start).norm() <= same_place * limits.bounds.diagonal().norm();
  if (stroke.closed && returns && stroke.samples.size() > 1) stroke.samples.pop_back();
  return true;
}

std::map<std::string, std::string> data_attributes(const pugi::xml_node& node) {
  std::map<std::string, std::string> data;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name.substr(0, 5) == "data-" && name != "data-object") data.emplace(name.substr(5), attribute.value());
  }
  return data;
}

// A background is no smaller than the page by more than this share.
constexpr double background_slack = 0.01;

/// A closed outline of straight sides along its bounding box.
bool is_upright_box(const SvgSubpath& outline) {
  if (outline.segments.size() < 3 || outline.segments.size() > 4) return false;
  Eigen::AlignedBox2d box;
  extend(box, outline);
  const double slack = 1e-6 * box.diagonal().norm();
  Vec2 from = outline.start;
  for (const SvgSegment& segment : outline.segments) {
    const Vec2 step = (segment.end - from).cwiseAbs();
    if (segment.kind != SvgSegment::Kind::Line || step.minCoeff() > slack) return false;
    from = segment.end;
  }
  return (from - outline.start).cwiseAbs().minCoeff() <= slack;
}

/// What an element or the nearest one around it says, also where a `use` shows it.
std::string inherited(const SvgFile& file, const std::vector<pugi::xml_node>& path, std::string_view name) {
  for (auto node = path.rbegin(); node != path.rend(); ++node) {
    std::string value = file.property(*node, name);
    if (!value.empty() && value != "inherit") return value;
  }
  return {};
}

/// The colour of a filled shape as text; empty for none, and for black, which files have that don't mean a colour.
std::string fill_of(const SvgFile& file, const std::vector<pugi::xml_node>& path) {
  const auto color = svg_color(inherited(file, path, "fill"));
  return !color || *color == SvgColor{} ? std::string() : hexadecimal_text(*color);
}

/// How a shape is painted.
enum class Paint { Line, Filling, Nothing };

/// Of a file in which nothing says so, a shape is filled.
Paint paint_of(const SvgFile& file, const std::vector<pugi::xml_node>& path) {
  const std::string stroke = inherited(file, path, "stroke");
  if (!stroke.empty() && stroke != "none" && stroke != "transparent") return Paint::Line;
  return inherited(file, path, "fill") == "none" ? Paint::Nothing : Paint::Filling;
}

/// The object that a shape belongs to: its own or that of the nearest group with one.
std::string object_of(const std::vector<pugi::xml_node>& path) {
  for (auto node = path.rbegin(); node != path.rend(); ++node) {
    const std::string name = node->attribute("data-object").value();
    if (!name.empty()) return name;
  }
  return {};
}

DrawingPlane read_plane(SvgFile& file) {
  const pugi::xml_attribute attribute = file.root().attribute("data-plane");
  if (!attribute) return {};
  SvgScanner scanner(attribute.value());
  DrawingPlane plane;
  const auto numbers = scanner.numbers<9>();
  scanner.skip_blanks();
  if (numbers) {
    const Eigen::Map<const Eigen::Matrix3d> columns(numbers->data());
    plane = {columns.col(0), columns.col(1), columns.col(2)};
    if (scanner.at_end() && plane.is_orthonormal()) return plane;
  }
  file.refuse("E_SYNTAX",
              "The drawing's data-plane is no plane: it takes nine numbers, an origin and two directions of length 1 "
              "at a right angle",
              file.line_of(file.root()));
}

/// A subpath that becomes a stroke.
struct SvgShape {
  Stroke stroke;  ///< without samples yet
  SvgSubpath outline;
  Paint paint = Paint::Line;
};

/// False when the rest of the element must not be read.
bool add_subpath(SvgFile& file, const Eigen::Affine2d& map, SvgShape shape, std::vector<SvgShape>& shapes) {
  const Stroke& stroke = shape.stroke;
  if (shape.outline.segments.empty()) {
    file.add(make_warning(Category::Malformed, "W_TINY",
                          "Stroke " + in_quotes(stroke.id) + " is a single point and was ignored"),
             stroke.line, stroke.id);
    return true;
  }
  transform(shape.outline, Eigen::Affine2d(Eigen::Scaling(1.0, -1.0)) * map);
  if (!is_usable(shape.outline)) {
    file.add(make_error(Category::Malformed, "E_NOT_FINITE",
                        "Stroke " + in_quotes(stroke.id) + " on line " + std::to_string(*stroke.line) +
                            " has a coordinate that " + unusable_words),
             stroke.line, stroke.id);
    return true;
  }
  std::size_t bytes = stroke.id.size() + stroke.object.size();
  for (const auto& [name, value] : stroke.data) bytes += name.size() + value.size();
  if (!file.count_pieces(shape.outline.segments.size(), bytes, *stroke.line)) return false;
  shapes.push_back(std::move(shape));
  return true;
}

void add_shape(SvgFile& file, SvgShownShape shown, std::vector<SvgShape>& shapes) {
  SvgShape shape;
  shape.stroke.line = shown.line;
  shape.stroke.object = object_of(shown.path);
  shape.stroke.data = data_attributes(shown.node);
  shape.paint = paint_of(file, shown.path);
  const std::string fill = fill_of(file, shown.path);
  std::size_t number = 0;
  for (SvgSubpath& subpath : shown.subpaths) {
    if (subpath.segments.empty() && !subpath.closed) continue;  // a moveto alone draws nothing
    ++number;
    shape.stroke.id = number == 1 ? shown.id : file.unique_name(shown.id + '/' + std::to_string(number), shown.line);
    shape.outline = std::move(subpath);
    if (shape.outline.closed && !fill.empty()) shape.stroke.data.try_emplace("fill", fill);
    if (!add_subpath(file, shown.map, shape, shapes)) return;
  }
}

/// Drawing programs lay a rectangle without a line under the drawing: as large as the page, or around everything else.
void leave_out_background(SvgFile& file, std::vector<SvgShape>& shapes) {
  Eigen::AlignedBox2d page = svg_page(file.root());
  if (!page.isEmpty())
    page = Eigen::AlignedBox2d(Vec2(page.min().x(), -page.max().y()), Vec2(page.max().x(), -page.min().y()));
  // Where nothing has a line, files simply don't say how to paint it.
  const bool lines_are_painted = std::ranges::find(shapes, Paint::Line, &SvgShape::paint) != shapes.end();
  const auto is_background = [&](std::size_t i) {
    const Paint paint = shapes[i].paint;
    if (paint == Paint::Line || !is_upright_box(shapes[i].outline)) return false;
    if (paint == Paint::Nothing && !lines_are_painted) return false;
    Eigen::AlignedBox2d box;
    extend(box, shapes[i].outline);
    const Vec2 slack = background_slack * box.sizes();
    box = Eigen::AlignedBox2d(box.min() - slack, box.max() + slack);
    if (!page.isEmpty() && box.contains(page)) return true;
    Eigen::AlignedBox2d others;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (k != i) extend(others, shapes[k].outline);
    }
    return i == 0 && !others.isEmpty() && box.contains(others);
  };
  for (std::size_t i = 0; i < shapes.size() && shapes.size() > 1;) {
    if (!is_background(i)) {
      ++i;
      continue;
    }
    const Stroke& stroke = shapes[i].stroke;
    file.add(make_warning(Category::Malformed, "W_IGNORED",
                          "The rectangle " + in_quotes(stroke.id) + " behind the drawing has no line and was ignored"),
             stroke.line, stroke.id);
    shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

DrawingReadResult read_svg_drawing(std::string_view bytes, const std::string& file_name, Progress& progress) {
  SvgFile file(bytes, file_name);
  DrawingReadResult result;
  Drawing& drawing = result.drawing;
  drawing.file = file_name;
  drawing.plane = read_plane(file);
  std::vector<SvgShape> shapes;
  const auto enter = [&](const pugi::xml_node& group) {
    const std::string object = group.attribute("data-object").value();
    if (!object.empty()) drawing.object_data[object].merge(data_attributes(group));
  };
  visit_svg(file, {enter, [&](SvgShownShape shape) { add_shape(file, std::move(shape), shapes); }}, progress);
  if (shapes.empty() && !file.limit_reached()) file.add(no_svg_strokes(), std::nullopt);
  leave_out_background(file, shapes);
  file.stop_on_errors();
  FlatteningLimits limits;
  for (const SvgShape& shape : shapes) extend(limits.bounds, shape.outline);
  limits.tolerance = svg_flattening_tolerance * limits.bounds.diagonal().norm();
  for (SvgShape& shape : shapes) {
    progress.check();
    if (!flatten_into(shape.stroke, shape.outline, limits)) {
      file.limit("The drawing has more than 4 million samples: simplify it", *shape.stroke.line);
      file.stop_on_errors();
    }
    drawing.strokes.push_back(std::move(shape.stroke));
  }
  result.warnings = file.take();
  return result;
}

}  // namespace croquis
