// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/sheet_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "algorithms/silhouette/sampling/figure_segments.h"
#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/sampling/proximity_grid.h"
#include "algorithms/silhouette/sampling/rim_radius.h"

namespace croquis::silhouette {
namespace {

// Clearances are parts of the contour step, as the density of everything follows it.
constexpr double first_row_clearance = 0.3;  // from contours, and at most 0.9 of the row's own depth
// Deeper rows stay out of the steep strip along another sheet's rim: an edge from there to the rim would cut a notch
// between the points of that rim's first row.
constexpr double deep_row_clearance = 0.8;
constexpr double row_row_clearance = 0.37;  // and at most 0.6 of the distance between the rows
constexpr double row_spacing = 0.33;        // from a row's last point
constexpr double passing_clearance = 0.35;  // from the middle of a row's edge, in parts of its length
// In parts of the hexagons' spacing.
constexpr double hexagon_point_clearance = 0.55;
constexpr double hexagon_contour_clearance = 0.4;
constexpr double least_crossing_sine = 0.3;  // flatter crossings have no corner to sample

class SheetPointCollector {
 public:
  SheetPointCollector(const LabelledFigure& figure, const SheetRims& rims, double hexagon_spacing)
      : figure_(figure),
        step_(figure.step),
        spacing_(hexagon_spacing * figure.step),
        bounds_(bounds_of(figure.points)),
        walk_(figure.points, figure.triangulation),
        segments_(bounds_[0], bounds_[1], deep_row_clearance * step_),
        spaced_(bounds_[0], bounds_[1], hexagon_point_clearance * spacing_),
        rows_(bounds_[0], bounds_[1], row_row_clearance * step_) {
    for (const RimPiece& piece : rims.pieces) {
      segments_.add(piece.begin, piece.end);
      spaced_.add(piece.begin);
    }
    for (const std::vector<double>& radii : rims.radii) {
      std::vector<RimRows>& rows = rim_rows_.emplace_back();
      rows.reserve(radii.size());
      for (const double radius : radii) rows.emplace_back(radius, step_);
    }
  }

  void add_row(Index contour, std::size_t row) {
    Vec2 last(1e300, 1e300);
    const std::vector<Index>& vertices = figure_.contours[contour].vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const RimRows& rows = rim_rows_[contour][i];
      if (row >= rows.count()) continue;
      const Vec2 place = figure_.points[vertices[i]] + rows.depth(row) * inward(contour, i);
      const double gap = (place - last).norm();
      if (gap < row_spacing * step_ || !fits_row(place, rows, row)) continue;
      // Beside the middle of a row's edge, a point of another row would make a sliver of any slope.
      const bool passes_point =
          row > 0 && gap < 2 * step_ &&
          rows_.any_within((last + place) / 2, std::min(passing_clearance * gap, row_row_clearance * step_));
      last = place;
      if (!passes_point) keep(place);
    }
  }

  /// Rim points that were cut in need row points of their own: else edges run from there past the row.
  void add_row_at_cut(const RimPiece& piece, std::size_t row) {
    const RimRows& rows = rim_rows_[piece.contour][piece.position];
    if (row >= rows.count()) return;
    const Vec2 inside = figure_.contours[piece.contour].side * left_of((piece.end - piece.begin).normalized());
    const Vec2 place = piece.begin + rows.depth(row) * inside;
    if (fits_row(place, rows, row)) keep(place);
  }

  /// Where the first two rows of two contours cross, inside both: each rim is steep there, and the rows' own points
  /// meet the other rim at any depth.
  void add_crossing(const FigureCrossing& crossing) {
    const Vec2 a = inward(crossing.over_contour, crossing.over_position);
    const Vec2 b = inward(crossing.under_contour, crossing.under_position);
    const double sine = cross(a, b);
    if (std::abs(sine) < least_crossing_sine) return;
    const RimRows& over_rows = rim_rows_[crossing.over_contour][crossing.over_position];
    const RimRows& under_rows = rim_rows_[crossing.under_contour][crossing.under_position];
    for (std::size_t i = 0; i < std::min<std::size_t>(2, over_rows.count()); ++i) {
      for (std::size_t j = 0; j < std::min<std::size_t>(2, under_rows.count()); ++j) {
        const double over = over_rows.depth(i);
        const double under = under_rows.depth(j);
        const Vec2 offset = (over * Vec2(b.y(), -b.x()) + under * Vec2(-a.y(), a.x())) / sine;
        const Vec2 place = figure_.points[crossing.vertex] + offset;
        const double depth = std::min(over, under);
        if (segments_.any_within(place, std::min(0.7 * depth, deep_row_clearance * step_)) ||
            rows_.any_within(place, std::min(0.6 * depth, row_row_clearance * step_)))
          continue;
        if (layers_at(place) > 0) keep(place);
      }
    }
  }

  void add_node(const Vec2& place) {
    if (segments_.any_within(place, hexagon_contour_clearance * spacing_)) return;
    if (spaced_.any_within(place, hexagon_point_clearance * spacing_) || layers_at(place) <= 0) return;
    keep(place);
  }

  void add_hexagons() {
    const double height = spacing_ * std::sqrt(0.75);
    // Counted from the middle, so that a shifted or mirrored drawing gets the shifted or mirrored points.
    const Vec2 middle = (bounds_[0] + bounds_[1]) / 2;
    const Vec2 half = (bounds_[1] - bounds_[0]) / 2;
    const auto rows = static_cast<int>(half.y() / height);
    const auto columns = static_cast<int>(half.x() / spacing_) + 1;
    std::vector<Vec2> chosen;
    for (int j = -rows; j <= rows; ++j) {
      for (int i = -columns; i <= columns; ++i) {
        const Vec2 place = middle + Vec2((i + (j % 2 != 0 ? 0.5 : 0.0)) * spacing_, j * height);
        if (segments_.any_within(place, hexagon_contour_clearance * spacing_)) continue;
        if (!spaced_.any_within(place, hexagon_point_clearance * spacing_) && layers_at(place) > 0)
          chosen.push_back(place);
      }
    }
    points_.insert(points_.end(), chosen.begin(), chosen.end());
  }

  std::vector<Vec2> take() { return std::move(points_); }

 private:
  Vec2 inward(Index contour, std::size_t i) const {
    const std::vector<Index>& vertices = figure_.contours[contour].vertices;
    const std::size_t count = vertices.size();
    const Vec2& before = figure_.points[vertices[(i + count - 1) % count]];
    const Vec2& at = figure_.points[vertices[i]];
    const Vec2& after = figure_.points[vertices[(i + 1) % count]];
    const Vec2 tangent = (at - before).normalized() + (after - at).normalized();
    return figure_.contours[contour].side * left_of(tangent.normalized());
  }

  bool fits_row(const Vec2& place, const RimRows& rows, std::size_t row) {
    const double depth = rows.depth(row);
    const double gap = row > 0 ? depth - rows.depth(row - 1) : depth;
    const double clearance = row > 0 ? deep_row_clearance : first_row_clearance;
    return !segments_.any_within(place, std::min(0.9 * depth, clearance * step_)) &&
           !rows_.any_within(place, std::min(0.6 * gap, row_row_clearance * step_)) && layers_at(place) > 0;
  }

  int layers_at(const Vec2& place) {
    const Index triangle = walk_.locate(place);
    return triangle == no_index ? 0 : figure_.layers[triangle];
  }

  void keep(const Vec2& place) {
    spaced_.add(place);
    rows_.add(place);
    points_.push_back(place);
  }

  const LabelledFigure& figure_;
  double step_;
  double spacing_;  ///< of the hexagons
  std::array<Vec2, 2> bounds_;
  PlanarWalk walk_;
  ProximityGrid segments_;
  ProximityGrid spaced_;  ///< all points so far
  ProximityGrid rows_;
  std::vector<std::vector<RimRows>> rim_rows_;  ///< per contour and position
  std::vector<Vec2> points_;
};

}  // namespace

std::vector<Vec2> sheet_points(const LabelledFigure& figure, const Skeleton& skeleton, const SheetRims& rims,
                               const SheetDensity& density) {
  SheetPointCollector collector(figure, rims, density.hexagon_spacing);
  for (const FigureCrossing& crossing : figure.crossings) collector.add_crossing(crossing);
  for (std::size_t row = 0; row < std::min(density.rows, RimRows::most); ++row) {
    for (const RimPiece& piece : rims.pieces) {
      if (piece.cut) collector.add_row_at_cut(piece, row);
    }
    for (Index c = 0; c < figure.contours.size(); ++c) collector.add_row(c, row);
  }
  for (const SkeletonNode& node : skeleton.nodes) collector.add_node(node.position);
  collector.add_hexagons();
  return collector.take();
}

}  // namespace croquis::silhouette
