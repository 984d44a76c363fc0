// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/svg_drawing.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/geometry/drawing.h"
#include "io/svg/svg_shapes.h"
#include "io/svg/svg_walk.h"
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

class SketchReader : public SvgVisitor {
 public:
  SketchReader(std::string_view bytes, const std::string& file, Progress& progress)
      : walk_(bytes, file, progress), progress_(progress) {
    result_.drawing.file = file;
  }

  DrawingReadResult read() {
    const pugi::xml_node root = walk_.parse();
    read_plane(root);
    walk_.visit(root, *this);
    if (shapes_.empty() && !walk_.limit_reached()) {
      walk_.findings().file_error(
          Category::Malformed, "E_NO_STROKES",
          "The drawing has no visible path, line or other shape: there is nothing to make a solid of");
    }
    leave_out_background();
    walk_.findings().stop_on_errors();
    flatten();
    result_.warnings = walk_.findings().take();
    return std::move(result_);
  }

  void enter(const pugi::xml_node& group) override {
    const std::string object = group.attribute("data-object").value();
    if (!object.empty()) result_.drawing.object_data[object].merge(data_attributes(group));
  }

  void add(SvgShownShape shape) override {
    Stroke stroke;
    stroke.line = shape.line;
    stroke.object = object();
    stroke.data = data_attributes(shape.node);
    const Paint paint = has_line()                                   ? Paint::Line
                        : walk_.inherited_property("fill") == "none" ? Paint::Nothing
                                                                     : Paint::Filling;
    std::size_t number = 0;
    for (SvgSubpath& subpath : shape.subpaths) {
      if (subpath.segments.empty() && !subpath.closed) continue;  // a moveto alone draws nothing
      ++number;
      stroke.id = number == 1 ? shape.id : walk_.unique_name(shape.id + '/' + std::to_string(number), *stroke.line);
      if (!add(stroke, std::move(subpath), shape.map, paint)) return;
    }
  }

 private:
  void read_plane(const pugi::xml_node& root) {
    const pugi::xml_attribute attribute = root.attribute("data-plane");
    if (!attribute) return;
    SvgScanner scanner(attribute.value());
    DrawingPlane plane;
    bool complete = true;
    for (Vec3* vector : {&plane.origin, &plane.u, &plane.v}) {
      for (double& value : *vector) {
        scanner.skip_separators();
        const std::optional<double> number = scanner.number();
        complete = complete && number;
        value = number.value_or(0);
      }
    }
    scanner.skip_blanks();
    if (complete && scanner.at_end() && plane.is_orthonormal()) {
      result_.drawing.plane = plane;
      return;
    }
    walk_.refuse(
        "E_SYNTAX",
        "The drawing's data-plane is no plane: it takes nine numbers, an origin and two directions of length 1 "
        "at a right angle",
        walk_.line_of(root));
  }

  /// The object that a shape belongs to: its own or that of the nearest group with one.
  std::string object() const {
    const std::vector<pugi::xml_node>& path = walk_.path();
    for (auto node = path.rbegin(); node != path.rend(); ++node) {
      const std::string name = node->attribute("data-object").value();
      if (!name.empty()) return name;
    }
    return {};
  }

  /// How a shape is painted.
  enum class Paint { Line, Filling, Nothing };

  bool has_line() const {
    const std::string stroke = walk_.inherited_property("stroke");
    return !stroke.empty() && stroke != "none" && stroke != "transparent";
  }

  /// False when the rest of the element must not be read.
  bool add(const Stroke& stroke, SvgSubpath subpath, const Eigen::Affine2d& map, Paint paint) {
    if (subpath.segments.empty()) {
      walk_.findings().stroke_warning("W_TINY", "Stroke " + in_quotes(stroke.id) + " is a single point and was ignored",
                                      stroke.id, *stroke.line);
      return true;
    }
    transform(subpath, Eigen::Affine2d(Eigen::Scaling(1.0, -1.0)) * map);
    if (!is_usable(subpath)) {
      walk_.findings().stroke_error(Category::Malformed, "E_NOT_FINITE",
                                    "Stroke " + in_quotes(stroke.id) + " on line " + std::to_string(*stroke.line) +
                                        " has a coordinate that " + unusable_words,
                                    stroke.id, *stroke.line);
      return true;
    }
    std::size_t bytes = stroke.id.size() + stroke.object.size();
    for (const auto& [name, value] : stroke.data) bytes += name.size() + value.size();
    if (!walk_.count_pieces(subpath.segments.size(), bytes, *stroke.line)) return false;
    shapes_.push_back({stroke, std::move(subpath), paint});
    return true;
  }

  /// Drawing programs lay a rectangle without a line under the drawing: as large as the page, or around everything
  /// else.
  void leave_out_background() {
    Eigen::AlignedBox2d page = walk_.page();
    if (!page.isEmpty())
      page = Eigen::AlignedBox2d(Vec2(page.min().x(), -page.max().y()), Vec2(page.max().x(), -page.min().y()));
    // Where nothing has a line, files simply don't say how to paint it.
    const bool lines_are_painted =
        std::any_of(shapes_.begin(), shapes_.end(), [](const SvgShape& shape) { return shape.paint == Paint::Line; });
    const auto is_background = [&](std::size_t i) {
      const Paint paint = shapes_[i].paint;
      if (paint == Paint::Line || !is_upright_box(shapes_[i].outline)) return false;
      if (paint == Paint::Nothing && !lines_are_painted) return false;
      Eigen::AlignedBox2d box;
      extend(box, shapes_[i].outline);
      const Vec2 slack = background_slack * box.sizes();
      box = Eigen::AlignedBox2d(box.min() - slack, box.max() + slack);
      if (!page.isEmpty() && box.contains(page)) return true;
      Eigen::AlignedBox2d others;
      for (std::size_t k = 0; k < shapes_.size(); ++k) {
        if (k != i) extend(others, shapes_[k].outline);
      }
      return i == 0 && !others.isEmpty() && box.contains(others);
    };
    for (std::size_t i = 0; i < shapes_.size() && shapes_.size() > 1;) {
      if (!is_background(i)) {
        ++i;
        continue;
      }
      const Stroke& stroke = shapes_[i].stroke;
      walk_.findings().stroke_warning(
          "W_IGNORED", "The rectangle " + in_quotes(stroke.id) + " behind the drawing has no line and was ignored",
          stroke.id, *stroke.line);
      shapes_.erase(shapes_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void flatten() {
    FlatteningLimits limits;
    for (const SvgShape& shape : shapes_) extend(limits.bounds, shape.outline);
    limits.tolerance = svg_flattening_tolerance * limits.bounds.diagonal().norm();
    for (SvgShape& shape : shapes_) {
      progress_.check();
      if (!flatten_into(shape.stroke, shape.outline, limits)) {
        walk_.limit("The drawing has more than 4 million samples: simplify it", *shape.stroke.line);
        walk_.throw_findings();
      }
      result_.drawing.strokes.push_back(std::move(shape.stroke));
    }
  }

  struct SvgShape {
    Stroke stroke;  ///< without samples yet
    SvgSubpath outline;
    Paint paint = Paint::Line;
  };

  SvgWalk walk_;
  Progress& progress_;
  DrawingReadResult result_;
  std::vector<SvgShape> shapes_;
};

}  // namespace

DrawingReadResult read_svg_drawing(std::string_view bytes, const std::string& file_name, Progress& progress) {
  return SketchReader(bytes, file_name, progress).read();
}

}  // namespace croquis
