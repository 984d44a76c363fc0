// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/attribute_surface/blend/dual.h"
#include "algorithms/attribute_surface/blend/footprint.h"
#include "croquis/attribute_surface/face_surface.h"

namespace croquis {

/// Distances below this, of domains of perimeter 1, are none.
inline constexpr double on_a_side = 1e-14;

/// What the sides of a face give at a place of its domain.
template <class Numbers>
struct BaseBlend {
  using Number = typename Numbers::Number;

  typename Numbers::Vector point;
  Number nearness = 0.0;     ///< the least distance to a side
  Number side_weight = 0.0;  ///< W_b nearness^2: weight of all sides together against points and inner curves
};

/// The surface of the curves of a loop alone.
/// Source: Kim and Park 2006, equations (1.2), (2.1), (2.2), (2.3), in the form of the project's documentation: feet on
/// the lines of the sides, weights length / distance, ribbons.
class SurfaceBase {
 public:
  explicit SurfaceBase(const SurfaceFrame& frame);

  const SurfaceFrame& frame() const { return frame_; }
  const DomainPolygon& polygon() const { return polygon_; }
  const std::vector<Footprint>& footprints() const { return footprints_; }

  /// Of the sides of the loop, which have them in mode Smooth.
  const std::vector<FenceReader>& fences() const { return fences_; }
  double sigma() const { return sigma_; }
  bool is_paper() const { return frame_.mode == AttributeMode::Paper; }

  /// The footprint that a place lies on, or their number; the corner's first one in a corner.
  std::size_t footprint_under(const Vec2& place) const;

  /// The place of the curve under a footprint.
  Vec3 on_footprint(std::size_t footprint, const Vec2& place) const;

  /// @pre in the domain; not in a corner. On a side the limit from inside
  template <class Numbers>
  BaseBlend<Numbers> blend(const Vec2& place) const;

  /// Weight of all sides together: sum (L_i / h_i)^2.
  double boundary_weight(const Vec2& place) const;

  /// Least distance to the sides' lines.
  double depth(const Vec2& place) const;

  std::size_t byte_size() const;

 private:
  template <class Numbers>
  BaseBlend<Numbers> blend_by_lines(const Vec2& place) const;
  template <class Numbers>
  BaseBlend<Numbers> blend_as_in_paper(const Vec2& place) const;

  SurfaceFrame frame_;
  DomainPolygon polygon_;
  std::vector<Footprint> footprints_;
  std::vector<FenceReader> fences_;
  double sigma_ = 0;
  double middle_bubble_ = 1;  ///< 1 / boundary weight at the area's centroid
};

}  // namespace croquis
