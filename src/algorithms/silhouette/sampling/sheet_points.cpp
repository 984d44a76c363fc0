// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/sampling/proximity_grid.h"
#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/sampling/sheet_sampling.h"

namespace croquis::silhouette {
namespace {

constexpr double least_cut_sine = 0.5;  // flatter crossings would send the cuts far along the other contour
constexpr double end_clearance = 0.2;   // of the cut's distance or a step: keeps the pieces from becoming slivers

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

/// A figure's contour by its positions, which run on cyclically in both directions.
struct CyclicContour {
  const LabelledFigure& figure;
  const FigureContour& contour;

  CyclicContour(const LabelledFigure& f, Index c) : figure(f), contour(f.contours[c]) {}

  Index wrapped(int position) const {
    const auto count = static_cast<int>(contour.vertices.size());
    return static_cast<Index>((position % count + count) % count);
  }
  const Vec2& point(int position) const { return figure.points[contour.vertices[wrapped(position)]]; }
};

/// Walks a distance along a contour and cuts the segment that it ends in.
/// @param cuts of the contour's segments, by their positions
void cut_at_distance(const CyclicContour& contour, Index position, int direction, double distance,
                     std::vector<std::vector<double>>& cuts) {
  const auto start = static_cast<int>(position);
  const double clearance = end_clearance * std::min(distance, contour.figure.step);
  double left = distance;
  for (int k = 0; k < static_cast<int>(cuts.size()); ++k) {
    const int from = start + direction * k;
    const double length = (contour.point(from + direction) - contour.point(from)).norm();
    if (left > length) {
      left -= length;
      continue;
    }
    if (left < clearance || length - left < clearance) return;
    const double fraction = direction > 0 ? left / length : 1 - left / length;
    std::vector<double>& own = cuts[contour.wrapped(direction > 0 ? from : from - 1)];
    const auto is_near = [&](double other) { return std::abs(other - fraction) < clearance / length; };
    if (std::none_of(own.begin(), own.end(), is_near)) own.push_back(fraction);
    return;
  }
}

class SheetPointCollector {
 public:
  SheetPointCollector(const LabelledFigure& figure, const SheetSampling& sheets, const RimRows& rim_rows,
                      double hexagon_spacing)
      : figure_(figure),
        rim_rows_(rim_rows),
        step_(figure.step),
        spacing_(hexagon_spacing * figure.step),
        walk_(figure.points, figure.triangulation),
        segments_(std::max(deep_row_clearance * step_, hexagon_contour_clearance * spacing_)),
        spaced_(hexagon_point_clearance * spacing_),
        rows_(row_row_clearance * step_) {
    for (const RimPiece& piece : sheets.pieces) {
      segments_.add(sheets.points[piece.begin], sheets.points[piece.end]);
      spaced_.add(sheets.points[piece.begin]);
    }
  }

  void add_row(Index contour, std::size_t row) {
    Vec2 last(1e300, 1e300);
    const std::vector<Index>& vertices = figure_.contours[contour].vertices;
    for (Index i = 0; i < vertices.size(); ++i) {
      const std::vector<double>& depths = rim_rows_[contour][i];
      if (row >= depths.size()) continue;
      const Vec2 place = figure_.points[vertices[i]] + depths[row] * inward(contour, i);
      const double gap = (place - last).norm();
      if (gap < row_spacing * step_ || !fits_row(place, depths, row)) continue;
      // Beside the middle of a row's edge, a point of another row would make a sliver of any slope.
      const bool passes_point =
          row > 0 && gap < 2 * step_ &&
          rows_.any_within((last + place) / 2, std::min(passing_clearance * gap, row_row_clearance * step_));
      last = place;
      if (!passes_point) keep(place);
    }
  }

  /// Rim points that were cut in need row points of their own: else edges run from there past the row.
  void add_row_at_cut(const RimPiece& piece, const SheetSampling& sheets, std::size_t row) {
    const std::vector<double>& depths = rim_rows_[piece.contour][piece.position];
    if (row >= depths.size()) return;
    const Vec2& begin = sheets.points[piece.begin];
    const Vec2 place = begin + depths[row] * (piece.side * left_of((sheets.points[piece.end] - begin).normalized()));
    if (fits_row(place, depths, row)) keep(place);
  }

  /// Where the first two rows of two contours cross, inside both: each rim is steep there, and the rows' own points
  /// meet the other rim at any depth.
  void add_crossing(const FigureCrossing& crossing) {
    const Vec2 a = inward(crossing.over_contour, crossing.over_position);
    const Vec2 b = inward(crossing.under_contour, crossing.under_position);
    const double sine = cross(a, b);
    if (std::abs(sine) < least_crossing_sine) return;
    const std::vector<double>& over_rows = rim_rows_[crossing.over_contour][crossing.over_position];
    const std::vector<double>& under_rows = rim_rows_[crossing.under_contour][crossing.under_position];
    for (std::size_t i = 0; i < std::min<std::size_t>(2, over_rows.size()); ++i) {
      for (std::size_t j = 0; j < std::min<std::size_t>(2, under_rows.size()); ++j) {
        const Vec2 offset = (over_rows[i] * Vec2(b.y(), -b.x()) + under_rows[j] * Vec2(-a.y(), a.x())) / sine;
        const Vec2 place = figure_.points[crossing.vertex] + offset;
        const double depth = std::min(over_rows[i], under_rows[j]);
        if (is_free(place, std::min(0.7 * depth, deep_row_clearance * step_), rows_,
                    std::min(0.6 * depth, row_row_clearance * step_))) {
          keep(place);
        }
      }
    }
  }

  /// A node of the skeleton or a point of the hexagonal grid.
  void add_between_rows(const Vec2& place) {
    if (is_free(place, hexagon_contour_clearance * spacing_, spaced_, hexagon_point_clearance * spacing_)) keep(place);
  }

  void add_hexagons() {
    const double height = spacing_ * std::sqrt(0.75);
    // Counted from the middle, so that a shifted or mirrored drawing gets the shifted or mirrored points.
    Eigen::AlignedBox2d box;
    for (const Vec2& point : figure_.points) box.extend(point);
    const Vec2 middle = box.center();
    const Vec2 half = box.sizes() / 2;
    const auto rows = static_cast<int>(half.y() / height);
    const auto columns = static_cast<int>(half.x() / spacing_) + 1;
    for (int j = -rows; j <= rows; ++j) {
      for (int i = -columns; i <= columns; ++i) {
        add_between_rows(middle + Vec2((i + (j % 2 != 0 ? 0.5 : 0.0)) * spacing_, j * height));
      }
    }
  }

  std::vector<Vec2> take() { return std::move(points_); }

 private:
  Vec2 inward(Index contour, Index position) const {
    const CyclicContour around(figure_, contour);
    const auto i = static_cast<int>(position);
    const Vec2 tangent =
        (around.point(i) - around.point(i - 1)).normalized() + (around.point(i + 1) - around.point(i)).normalized();
    return around.contour.side * left_of(tangent.normalized());
  }

  bool fits_row(const Vec2& place, const std::vector<double>& depths, std::size_t row) {
    const double gap = row > 0 ? depths[row] - depths[row - 1] : depths[row];
    const double clearance = row > 0 ? deep_row_clearance : first_row_clearance;
    return is_free(place, std::min(0.9 * depths[row], clearance * step_), rows_,
                   std::min(0.6 * gap, row_row_clearance * step_));
  }

  /// Whether a place lies in the drawn region, away from contours and from other points.
  bool is_free(const Vec2& place, double from_contours, const ProximityGrid& others, double from_others) {
    if (segments_.any_within(place, from_contours) || others.any_within(place, from_others)) return false;
    const Index triangle = walk_.locate(place);
    return triangle != no_index && figure_.layers[triangle] > 0;
  }

  void keep(const Vec2& place) {
    spaced_.add(place);
    rows_.add(place);
    points_.push_back(place);
  }

  const LabelledFigure& figure_;
  const RimRows& rim_rows_;
  double step_;
  double spacing_;  ///< of the hexagons
  PlanarWalk walk_;
  ProximityGrid segments_;
  ProximityGrid spaced_;  ///< all points so far
  ProximityGrid rows_;    ///< the same, to be asked within a smaller reach
  std::vector<Vec2> points_;
};

}  // namespace

std::vector<std::vector<double>> crossing_splits(const LabelledFigure& figure, const RimRows& rows) {
  std::vector<std::vector<std::vector<double>>> cuts;  // per contour and position
  for (const FigureContour& contour : figure.contours) cuts.emplace_back(contour.vertices.size());
  const auto split = [&](Index contour, Index position, Index rim, Index rim_position) {
    const CyclicContour crossed(figure, rim), cut(figure, contour);
    const auto i = static_cast<int>(rim_position), k = static_cast<int>(position);
    const Vec2 inward = crossed.contour.side * left_of(crossed.point(i + 1) - crossed.point(i - 1)).normalized();
    for (const int direction : {1, -1}) {
      const double slope = (cut.point(k + direction) - cut.point(k)).normalized().dot(inward);
      if (slope <= 0) continue;
      for (const double depth : rows[rim][rim_position]) {
        cut_at_distance(cut, position, direction, depth / std::max(slope, least_cut_sine), cuts[contour]);
      }
    }
  };
  for (const FigureCrossing& crossing : figure.crossings) {
    const auto& [vertex, over, over_position, under, under_position, seen] = crossing;
    split(under, under_position, over, over_position);
    split(over, over_position, under, under_position);
  }
  std::vector<std::vector<double>> of_segments;
  for (std::vector<std::vector<double>>& contour : cuts) {
    for (std::vector<double>& own : contour) {
      std::sort(own.begin(), own.end());
      of_segments.push_back(std::move(own));
    }
  }
  return of_segments;
}

std::vector<Vec2> sheet_points(const LabelledFigure& figure, const Skeleton& skeleton, const SheetSampling& sheets,
                               const RimRows& rows, Quality quality) {
  // A draft has one row along every contour, and wider spaces between; in contour steps.
  const bool is_draft = quality == Quality::Draft;
  SheetPointCollector collector(figure, sheets, rows, is_draft ? 3 : 1.5);
  for (const FigureCrossing& crossing : figure.crossings) collector.add_crossing(crossing);
  for (std::size_t row = 0; row < (is_draft ? 1 : most_rows); ++row) {
    for (const RimPiece& piece : sheets.pieces) {
      const bool begins_at_cut = piece.begin >= figure.points.size();
      if (begins_at_cut) collector.add_row_at_cut(piece, sheets, row);
    }
    for (Index c = 0; c < figure.contours.size(); ++c) collector.add_row(c, row);
  }
  for (const SkeletonNode& node : skeleton.nodes) collector.add_between_rows(node.position);
  collector.add_hexagons();
  return collector.take();
}

}  // namespace croquis::silhouette
