// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include "croquis/geometry/vector.h"

/// The shapes of SVG files: texts of attributes, paths, outlines and transforms.
namespace croquis {

/// A piece of a subpath, from the end of the piece before it. All three kinds stay what they are under an affine map.
struct SvgSegment {
  enum class Kind { Line, Cubic, Arc };

  Kind kind = Kind::Line;
  Vec2 end = Vec2::Zero();
  Vec2 a = Vec2::Zero();       ///< cubic: first handle; arc: first half axis
  Vec2 b = Vec2::Zero();       ///< cubic: second handle; arc: second half axis
  Vec2 centre = Vec2::Zero();  ///< arc: centre + cos(angle) a + sin(angle) b
  double angle = 0;            ///< arc: where it begins
  double sweep = 0;            ///< arc: by how much the angle grows
};

struct SvgSubpath {
  Vec2 start = Vec2::Zero();
  std::vector<SvgSegment> segments;
  bool closed = false;

  Vec2 last() const { return segments.empty() ? start : segments.back().end; }
};

struct SvgArcShape {
  double radius_x = 0;
  double radius_y = 0;
  double rotation = 0;  ///< degrees
  bool large = false;
  bool positive = false;
};

SvgSegment svg_line(const Vec2& end);
SvgSegment svg_cubic(const Vec2& a, const Vec2& b, const Vec2& end);

/// The elliptical arc of path data; a line when a radius is 0, radii enlarged when they are too short to reach.
/// SVG 1.1, F.6.5 and F.6.6.
SvgSegment svg_arc(const Vec2& from, const SvgArcShape& shape, const Vec2& to);

/// A full turn that begins and ends at centre + (radius_x, 0).
SvgSubpath svg_ellipse(const Vec2& centre, double radius_x, double radius_y);

void transform(SvgSubpath& subpath, const Eigen::Affine2d& map);

/// The point of a segment at t in [0,1]. @param from where it begins
Vec2 point_on(const SvgSegment& segment, const Vec2& from, double t);

/// Into how many straight pieces a segment must be cut to stay within a distance of it; bounded.
int pieces_within(const SvgSegment& segment, const Vec2& from, double tolerance);

/// What is wrong in an attribute's text, and at which byte of it.
struct SvgTextError {
  std::string message;
  std::size_t position = 0;
  bool limit = false;  ///< nothing wrong, but too much of it
};

/// Walks over the numbers, flags and words of an SVG attribute.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  void skip_blanks();
  void skip_separators();  ///< blanks with at most one comma among them

  bool at_end() const { return position_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  char take() { return text_[position_++]; }
  std::size_t position() const { return position_; }

  /// The next number as SVG writes them ("1.5.5" are two, "1-2" are two). Too large ones are infinite; the words NaN
  /// and Infinity are read too, so that they can be refused by their own name.
  /// Nothing, and nothing consumed, when there is none.
  std::optional<double> number();

  /// So many numbers, each behind separators or not.
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers() {
    std::array<double, N> result;
    for (double& value : result) {
      skip_separators();
      const std::optional<double> next = number();
      if (!next) return std::nullopt;
      value = *next;
    }
    return result;
  }

  /// A single 0 or 1, which needs no separator after it.
  std::optional<bool> flag();

  /// Letters, for names of transforms and units.
  std::string_view word();

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

struct SvgOutline {
  std::vector<SvgSubpath> subpaths;
  std::optional<SvgTextError> error;  ///< the subpaths are those before it
};

/// Path data: every command, absolute and relative (SVG 1.1, 8.3).
SvgOutline parse_svg_path(std::string_view data);

/// The points of a polyline or polygon. @param closed for a polygon
SvgOutline parse_svg_points(std::string_view points, bool closed);

bool is_svg_shape(std::string_view element);

/// The outline of a path, polyline, polygon, line, rect, circle or ellipse in its own coordinates. Empty for shapes
/// that SVG does not draw (no data, no width).
/// @param viewport see SvgLengths
SvgOutline svg_shape(std::string_view element, const pugi::xml_node& node, const Vec2& viewport);

/// Reads length attributes of one element. They may be in px, mm, cm, in, pt, pc (96 px to the inch) or percent of the
/// viewport's width, height or, for radii of circles, root mean square of both (SVG 1.1, 7.10).
class SvgLengths {
 public:
  /// @param viewport size of the viewBox of the svg element or symbol around, user units; 0 where nothing says so
  SvgLengths(const pugi::xml_node& element, const Vec2& viewport) : element_(element), viewport_(viewport) {}

  /// `fallback` when it is not there or no length.
  double at(const char* name, double fallback = 0);

  /// The first that is no length.
  const std::optional<SvgTextError>& error() const { return error_; }

 private:
  std::optional<double> factor_of(std::string_view unit, std::string_view name) const;

  pugi::xml_node element_;
  Vec2 viewport_;
  std::optional<SvgTextError> error_;
};

struct SvgTransform {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  std::optional<SvgTextError> error;
};

/// A list of matrix, translate, scale, rotate, skewX and skewY, the last one applied first (SVG 1.1, 7.6); also as
/// style sheets write it, with units and for one axis (CSS Transforms 1, section 12).
SvgTransform parse_svg_transform(std::string_view text);

}  // namespace croquis
