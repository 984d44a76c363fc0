// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/attribute_surface/blend/dual.h"
#include "algorithms/attribute_surface/blend/surface_base.h"
#include "croquis/attribute_surface/face_surface.h"

namespace croquis {

/// Points and inner curves of a face, as displacements of the surface of its sides.
/// Source: Kim and Park 2006, equations (2.4), (2.5). There a point's weight meets the point itself, and the surface
/// shrinks to a needle; the displacement that is blended here leaves a surface alone that meets the point already.
class SurfaceAttributes {
 public:
  /// Points' radii that are missing are filled in.
  SurfaceAttributes(const SurfaceBase& base, std::vector<PlacedPoint> points, std::vector<PlacedCurve> curves);

  const std::vector<PlacedPoint>& points() const { return points_; }
  const std::vector<PlacedCurve>& curves() const { return curves_; }

  /// The surface with them, from what the sides give there.
  template <class Numbers>
  typename Numbers::Vector blend(const SurfaceBase& base, const BaseBlend<Numbers>& sides, const Vec2& place) const;

  std::size_t byte_size() const;

 private:
  /// A point with what doesn't depend on the place that is evaluated.
  struct Displacement {
    Vec2 place;
    Vec3 offset;             ///< of the surface of the sides: it is moved this far there
    Vec3 du = Vec3::Zero();  ///< change of that offset by the domain's coordinates, for a normal
    Vec3 dv = Vec3::Zero();
    double reach = 0;     ///< rho, in the domain
    double strength = 0;  ///< weight of the sides there × reach^2, or × reach for cones
    bool cone = false;
  };

  /// A piece of an inner curve's footprint.
  struct Segment {
    Vec2 from;
    Vec2 along;   ///< unit
    Vec2 across;  ///< unit
    double length = 0;
    Vec3 offset;         ///< at its start
    Vec3 offset_change;  ///< to its end
    double strength = 0;
    bool sharp = false;
  };

  template <class Numbers>
  struct Sums;

  void prepare(const SurfaceBase& base, PlacedPoint& point);
  void prepare(const SurfaceBase& base, const PlacedCurve& curve);
  const Displacement* point_under(const Vec2& place) const;
  double scale_near_points(const Vec2& place) const;

  template <class Numbers>
  static typename Numbers::Vector offset_of(const Displacement& point, const typename Numbers::Number& x,
                                            const typename Numbers::Number& y);
  template <class Numbers>
  void add_points(Sums<Numbers>& sums, const Vec2& place) const;
  template <class Numbers>
  void add_segments(Sums<Numbers>& sums, const Vec2& place) const;
  template <class Numbers>
  typename Numbers::Vector blend_as_in_paper(const BaseBlend<Numbers>& sides, const Vec2& place) const;

  std::vector<PlacedPoint> points_;
  std::vector<PlacedCurve> curves_;
  std::vector<Displacement> displacements_;
  std::vector<Segment> segments_;
};

}  // namespace croquis
