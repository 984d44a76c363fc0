// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/tube_outlines.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// Limbs of one line are as wide as this share of the drawing's diagonal, and no wider than that of their own length.
constexpr double width_share = 0.035;
constexpr double slenderness = 0.3;
// So far (in widths) they go on within what they grow out of; an end that misses it by less than that is led there.
constexpr double depth_within = 1;
constexpr double farthest_miss = 1.5;
// Where they run beside a contour, more than so many widths from where they grow out of it, they are thin enough to
// keep that share of their distance from it, but not thinner than that share of their width.
constexpr double root_length = 1.5;
constexpr double distance_share = 0.7;
constexpr double thinnest = 0.3;
// Places along a limb are this share of its width apart; its round ends have so many corners.
constexpr double place_share = 0.4;
constexpr int circle_points = 20;

/// A stretch of a stroke that becomes a limb.
struct Limb {
  Points line;
  std::vector<double> radius;  ///< per point
  Index stroke = 0;            ///< index into Drawing::strokes
};

bool is_inside(const Vec2& place, const std::vector<CleanLine>& contours) {
  return std::ranges::any_of(contours, [&](const CleanLine& line) { return line.closed && encloses(line.points, place); });
}

/// The nearest place on any contour, infinitely far where there is none.
Vec2 nearest_on(const std::vector<CleanLine>& contours, const Vec2& place) {
  double least = std::numeric_limits<double>::infinity();
  Vec2 found = Vec2::Constant(least);
  for (const CleanLine& line : contours) {
    for (const Vec2& point : line.points) {
      if ((point - place).norm() >= least) continue;
      least = (point - place).norm();
      found = point;
    }
  }
  return found;
}

/// @param line outside everything but for a bit at the ends that start or end within
Limb limb_along(Points line, bool starts_within, bool ends_within, double width,
                const std::vector<CleanLine>& contours) {
  // Ends that nearly reach something are led into it.
  const auto led = [&](const Vec2& end, bool& within) {
    const Vec2 place = nearest_on(contours, end);
    const double miss = (place - end).norm();
    if (miss == 0 || miss > farthest_miss * width) return end;
    within = true;
    return Vec2(place + depth_within * width / miss * (place - end));
  };
  if (!starts_within) line.insert(line.begin(), led(line.front(), starts_within));
  if (!ends_within) line.push_back(led(line.back(), ends_within));
  const std::vector<double> arcs = arc_lengths(line, false);
  Limb limb{std::move(line), {}, 0};
  for (std::size_t i = 0; i < limb.line.size(); ++i) {
    const double root = (depth_within + root_length) * width;
    const bool at_root = (starts_within && arcs[i] < root) || (ends_within && arcs.back() - arcs[i] < root);
    const double distance = (nearest_on(contours, limb.line[i]) - limb.line[i]).norm();
    limb.radius.push_back(at_root ? width / 2 : std::clamp(distance_share * distance, thinnest * width / 2, width / 2));
  }
  return limb;
}

/// Adds the stretches of a stroke outside everything, and a bit of it within at both ends.
void add_limbs(const SampledStroke& stroke, double usual_width, const std::vector<CleanLine>& contours,
               std::vector<Limb>& limbs) {
  const double width = std::min(usual_width, slenderness * stroke.length);
  const Points points = even_points(stroke.points, stroke.closed, place_share * width);
  std::vector<bool> inside;
  for (const Vec2& point : points) inside.push_back(is_inside(point, contours));
  const auto more = static_cast<std::size_t>(depth_within / place_share) + 1;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && inside[end] == inside[begin]) ++end;
    if (inside[begin] || end - begin < 2) continue;
    const std::size_t first = begin - std::min(begin, more), last = std::min(points.size(), end + more);
    limbs.push_back(limb_along(
        Points(points.begin() + static_cast<std::ptrdiff_t>(first), points.begin() + static_cast<std::ptrdiff_t>(last)),
        first<begin, last> end, width, contours));
    limbs.back().stroke = stroke.stroke;
  }
}

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using Polygons = bg::model::multi_polygon<bg::model::polygon<BoostPoint>>;

/// Coordinates in which a drawing of any size is small: Boost counts in whole numbers.
struct SmallFrame {
  Vec2 origin = Vec2::Zero();
  double unit = 1;

  BoostPoint to(const Vec2& place) const {
    const Vec2 at = (place - origin) / unit;
    return {at.x(), at.y()};
  }
  Vec2 from(const BoostPoint& point) const { return origin + unit * Vec2(point.x(), point.y()); }
};

/// Everything within the radius of a limb: the hulls of neighbouring circles.
Polygons around(const Limb& limb, const SmallFrame& frame) {
  using Polygon = Polygons::value_type;
  Polygons all;
  for (std::size_t i = 0; i + 1 < limb.line.size(); ++i) {
    bg::model::multi_point<BoostPoint> circles;
    for (const std::size_t k : {i, i + 1}) {
      for (int corner = 0; corner < circle_points; ++corner) {
        const double angle = corner * 2 * std::numbers::pi / circle_points;
        circles.push_back(frame.to(limb.line[k] + limb.radius[k] * Vec2(std::cos(angle), std::sin(angle))));
      }
    }
    Polygon hull;
    bg::convex_hull(circles, hull);
    Polygons joined;
    bg::union_(all, hull, joined);
    all = std::move(joined);
  }
  return all;
}

CleanLine line_of(const Points& ring, const std::vector<Limb>& limbs, double step) {
  CleanLine line;
  line.closed = true;
  line.points = even_points(ring, true, step);
  line.raw = line.points;
  for (const Vec2& point : line.points) {
    double least = std::numeric_limits<double>::infinity();
    line.stroke.push_back(limbs.front().stroke);
    for (const Limb& limb : limbs) {
      for (const Vec2& place : limb.line) {
        if ((place - point).squaredNorm() >= least) continue;
        least = (place - point).squaredNorm();
        line.stroke.back() = limb.stroke;
      }
    }
  }
  line.strokes = line.stroke;
  std::ranges::sort(line.strokes);
  line.strokes.erase(std::unique(line.strokes.begin(), line.strokes.end()), line.strokes.end());
  line.size = size_of(line.points, true);
  line.tube = true;
  return line;
}

}  // namespace

std::vector<CleanLine> tube_outlines(const SampledDrawing& sampled, const Reading& reading,
                                     const std::vector<CleanLine>& contours) {
  Eigen::AlignedBox2d box;
  for (const SampledStroke& stroke : sampled.strokes) {
    for (const Vec2& point : stroke.points) box.extend(point);
  }
  std::vector<Limb> limbs;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    if (reading.kinds[s] == LineKind::Tube)
      add_limbs(sampled.strokes[s], width_share * box.diagonal().norm(), contours, limbs);
  }
  if (limbs.empty()) return {};
  const SmallFrame frame{limbs.front().line.front(), sampled.scale.unit};
  Polygons all;
  for (const Limb& limb : limbs) {
    Polygons joined;
    bg::union_(all, around(limb, frame), joined);
    all = std::move(joined);
  }
  std::vector<CleanLine> lines;
  for (const auto& polygon : all) {
    Points ring;
    for (const BoostPoint& point : polygon.outer()) ring.push_back(frame.from(point));
    ring.pop_back();  // the first one again
    if (signed_area(ring) < 0) std::ranges::reverse(ring);
    lines.push_back(line_of(ring, limbs, sampled.scale.step));
  }
  return lines;
}

}  // namespace croquis::silhouette
