// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/crossing_splits.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/sampling/rim_radius.h"

namespace croquis::silhouette {
namespace {

constexpr double least_cut_sine = 0.5;  // flatter crossings would send the cuts far along the other contour
constexpr double end_clearance = 0.2;   // of the cut's distance or a step: keeps the pieces from becoming slivers

/// One contour at a crossing.
struct Strand {
  Index contour = 0;
  Index position = 0;
};

class CrossingSplitter {
 public:
  CrossingSplitter(const LabelledFigure& figure, const std::vector<DirectedSegment>& segments,
                   const std::vector<std::vector<double>>& radii)
      : figure_(figure), radii_(radii), of_contour_(segments_of_contours(figure, segments)), cuts_(segments.size()) {}

  void split_at(const Strand& rim, const Strand& foreign) {
    const Vec2 tangent = point(rim, 1) - point(rim, -1);
    const Vec2 inward = figure_.contours[rim.contour].side * left_of(tangent).normalized();
    for (const int direction : {1, -1}) {
      const Vec2 along = (point(foreign, direction) - point(foreign, 0)).normalized();
      if (along.dot(inward) <= 0) continue;
      const double slope = std::max(along.dot(inward), least_cut_sine);
      const RimRows rows(radii_[rim.contour][rim.position], figure_.step);
      for (std::size_t row = 0; row < rows.count(); ++row) cut(foreign, direction, rows.depth(row) / slope);
    }
  }

  std::vector<std::vector<double>> take() {
    for (std::vector<double>& cuts : cuts_) std::sort(cuts.begin(), cuts.end());
    return std::move(cuts_);
  }

 private:
  Index position(const Strand& strand, int offset) const {
    const auto count = static_cast<int>(figure_.contours[strand.contour].vertices.size());
    return static_cast<Index>(((static_cast<int>(strand.position) + offset) % count + count) % count);
  }

  const Vec2& point(const Strand& strand, int offset) const {
    return figure_.points[figure_.contours[strand.contour].vertices[position(strand, offset)]];
  }

  /// Walks the distance along the other contour and cuts the segment that it ends in.
  void cut(const Strand& strand, int direction, double distance) {
    const auto count = static_cast<int>(figure_.contours[strand.contour].vertices.size());
    const double clearance = end_clearance * std::min(distance, figure_.step);
    double left = distance;
    for (int k = 0; k < count; ++k) {
      const double length = (point(strand, direction * (k + 1)) - point(strand, direction * k)).norm();
      if (left > length) {
        left -= length;
        continue;
      }
      if (left < clearance || length - left < clearance) return;
      const Index segment = of_contour_[strand.contour][position(strand, direction > 0 ? k : -k - 1)];
      add(segment, direction > 0 ? left / length : 1 - left / length, clearance / length);
      return;
    }
  }

  void add(Index segment, double fraction, double clearance) {
    for (const double other : cuts_[segment]) {
      if (std::abs(other - fraction) < clearance) return;
    }
    cuts_[segment].push_back(fraction);
  }

  const LabelledFigure& figure_;
  const std::vector<std::vector<double>>& radii_;
  std::vector<std::vector<Index>> of_contour_;
  std::vector<std::vector<double>> cuts_;
};

}  // namespace

std::vector<std::vector<double>> crossing_splits(const LabelledFigure& figure,
                                                 const std::vector<DirectedSegment>& segments,
                                                 const std::vector<std::vector<double>>& radii) {
  CrossingSplitter splitter(figure, segments, radii);
  for (const FigureCrossing& crossing : figure.crossings) {
    const Strand over{crossing.over_contour, crossing.over_position};
    const Strand under{crossing.under_contour, crossing.under_position};
    splitter.split_at(over, under);
    splitter.split_at(under, over);
  }
  return splitter.take();
}

}  // namespace croquis::silhouette
