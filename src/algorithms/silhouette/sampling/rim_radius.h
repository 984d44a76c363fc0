// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Rows of points that run along every contour: without close ones the silhouette would be serrated, since thickness
/// grows like a square root at the rim.
///
/// On a tube they lie at 15, 35 and 60 degrees from the rim, seen from the axis; more of them gain nothing. On wider
/// bodies at distances along the surface that grow from two steps, where the plane's own points lie too far apart on
/// the steep surface.
class RimRows {
 public:
  static constexpr std::size_t most = 6;

  /// @param radius of the surface at the rim, @param step of the contour's points; sketch units
  RimRows(double radius, double step);

  std::size_t count() const { return count_; }

  /// Distance from the rim in the plane; ascending.
  double depth(std::size_t row) const { return depth_[row]; }

 private:
  std::size_t count_ = 0;
  std::array<double, most> depth_{};
};

/// Of the first row, and the most that it can be of the radius.
double first_row_depth(double radius, double step);
double greatest_first_row();

/// Per contour and position the radius of the surface there: that of the chords, filled in along the contour where none
/// ends and smoothed. A contour without any chord takes the skeleton's scale.
std::vector<std::vector<double>> rim_radii(const LabelledFigure& figure, const Skeleton& skeleton);

/// Objects that are thinner than wide, ascending.
/// @param thickness per object the factor of its depth; empty: 1 for all
std::vector<Index> thin_objects(std::span<const double> thickness);

/// The radii by which rows are laid out: those of the surface, but for parts that are thinner than wide, whose back may
/// be flat. There rows as close to the rim as a round side needs them would make slender triangles on the back, so that
/// rows lie as far apart as they ever do.
/// @param radii per contour and position, see rim_radii
/// @param thin  objects of the figure, see thin_objects
std::vector<std::vector<double>> row_radii(const LabelledFigure& figure, std::vector<std::vector<double>> radii,
                                           std::span<const Index> thin);

}  // namespace croquis::silhouette
