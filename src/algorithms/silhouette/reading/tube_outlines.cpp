// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/tube_outlines.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/strokes/covered_runs.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// Limbs of one line are as wide as this share of the drawing's diagonal, and no wider than that of their own length.
constexpr double width_share = 0.035;
constexpr double slenderness = 0.3;
// So far (in widths) they go on within what they grow out of; an end that misses it by less than that is led there.
constexpr double depth_within = 1;
constexpr double farthest_miss = 1.5;
// Points of a circle in the round ends.
constexpr int circle_points = 24;

/// A stretch of a stroke that becomes a limb.
struct Limb {
  Points line;
  Index stroke = 0;  ///< index into Drawing::strokes
  double width = 1;
};

bool is_inside(const Vec2& place, const std::vector<CleanLine>& contours) {
  return std::ranges::any_of(contours, [&](const CleanLine& line) { return line.closed && encloses(line, place); });
}

/// The nearest place on any contour.
Vec2 nearest_on(const std::vector<CleanLine>& contours, const Vec2& place) {
  Vec2 found = place;
  double least = std::numeric_limits<double>::infinity();
  for (const CleanLine& line : contours) {
    for (const Vec2& point : line.points) {
      if ((point - place).norm() >= least) continue;
      least = (point - place).norm();
      found = point;
    }
  }
  return found;
}

class LimbSearch {
 public:
  LimbSearch(const SampledDrawing& sampled, const std::vector<CleanLine>& contours) : contours_(contours) {
    Eigen::AlignedBox2d box;
    for (const SampledStroke& stroke : sampled.strokes) {
      for (const Vec2& point : stroke.points) box.extend(point);
    }
    usual_width_ = width_share * box.diagonal().norm();
  }

  void add(const SampledStroke& stroke) {
    const double width = std::min(usual_width_, slenderness * stroke.length);
    const Points& points = stroke.points;
    std::vector<bool> inside;
    for (const Vec2& point : points) inside.push_back(is_inside(point, contours_));
    const double spacing = stroke.length / static_cast<double>(points.size() - 1);
    const auto more = static_cast<std::size_t>(depth_within * width / spacing) + 1;
    for (std::size_t begin = 0; begin < points.size();) {
      std::size_t end = begin;
      while (end < points.size() && inside[end] == inside[begin]) ++end;
      const bool is_limb = !inside[begin] && static_cast<double>(end - begin) * spacing > width / 2;
      if (is_limb) {
        const std::size_t first = begin - std::min(begin, more), last = std::min(points.size(), end + more);
        Limb limb{Points(points.begin() + static_cast<std::ptrdiff_t>(first),
                         points.begin() + static_cast<std::ptrdiff_t>(last)),
                  stroke.stroke, width};
        lead_in(limb, first<begin, last> end);
        limbs_.push_back(std::move(limb));
      }
      begin = end;
    }
  }

  std::vector<Limb> take() { return std::move(limbs_); }

 private:
  /// Ends that nearly reach something are led into it.
  void lead_in(Limb& limb, bool starts_within, bool ends_within) const {
    const auto led = [&](const Vec2& end) {
      const Vec2 place = nearest_on(contours_, end);
      const double miss = (place - end).norm();
      if (miss == 0 || miss > farthest_miss * limb.width) return end;
      return Vec2(place + depth_within * limb.width / miss * (place - end));
    };
    if (!starts_within) limb.line.insert(limb.line.begin(), led(limb.line.front()));
    if (!ends_within) limb.line.push_back(led(limb.line.back()));
  }

  const std::vector<CleanLine>& contours_;
  double usual_width_ = 1;
  std::vector<Limb> limbs_;
};

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using Polygons = bg::model::multi_polygon<bg::model::polygon<BoostPoint>>;

Polygons around(const Limb& limb) {
  bg::model::linestring<BoostPoint> line;
  for (const Vec2& point : limb.line) line.emplace_back(point.x(), point.y());
  bg::model::linestring<BoostPoint> simple;
  bg::simplify(line, simple, limb.width / 50);
  Polygons polygons;
  bg::buffer(simple, polygons, bg::strategy::buffer::distance_symmetric<double>(limb.width / 2),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_round(circle_points),
             bg::strategy::buffer::end_round(circle_points), bg::strategy::buffer::point_circle(circle_points));
  return polygons;
}

CleanLine line_of(const Points& ring, const std::vector<Limb>& limbs, double step) {
  CleanLine line;
  line.closed = true;
  for (const double parameter : even_parameters(ring, true, step)) line.points.push_back(point_at(ring, parameter));
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
  LimbSearch search(sampled, contours);
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    if (reading.kinds[s] == LineKind::Tube) search.add(sampled.strokes[s]);
  }
  const std::vector<Limb> limbs = search.take();
  Polygons all;
  for (const Limb& limb : limbs) {
    Polygons joined;
    bg::union_(all, around(limb), joined);
    all = std::move(joined);
  }
  std::vector<CleanLine> lines;
  for (const auto& polygon : all) {
    Points ring;
    for (const BoostPoint& point : polygon.outer()) ring.emplace_back(point.x(), point.y());
    ring.pop_back();  // the first one again
    if (signed_area(ring) < 0) std::ranges::reverse(ring);
    lines.push_back(line_of(ring, limbs, sampled.scale.step));
  }
  return lines;
}

}  // namespace croquis::silhouette
