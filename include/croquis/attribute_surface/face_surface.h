// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/domain_polygon.h"
#include "croquis/geometry/attribute_network.h"

/// The surface of one face, evaluated at places of its domain.
/// Source: Kim and Park 2006, sections 2 and 3. The paper's formulas (mode Paper) miss the curves and shrink to a
/// needle at points; docs/algorithms/attribute_surface.md lists what stands in their place.
namespace croquis {

/// Unit normals of the surface along a side, which give its tangent planes there.
struct NormalFence {
  std::vector<double> at;     ///< fractions of the side, ascending, the first 0, the last 1
  std::vector<Vec3> normals;  ///< unit, one for each; between them they turn evenly
  double magnitude = 1;       ///< of the slope across the side

  bool empty() const { return normals.empty(); }
};

/// A curve as a loop walks along it.
struct SurfaceSide {
  std::shared_ptr<const ArcLengthCurve> curve;
  bool reversed = false;
  NormalFence fence;  ///< along the loop's direction; read in mode Smooth alone
};

/// A point that the surface passes through, at its place of the domain.
struct PlacedPoint {
  Vec3 point = Vec3::Zero();
  Vec2 place = Vec2::Zero();     ///< inside the domain
  std::optional<double> radius;  ///< model units, > 0; none: half of the place's distance to the sides
  PointProfile profile = PointProfile::Smooth;
  std::optional<Vec3> normal;  ///< unit
};

/// A curve that the surface passes through: places of the domain and of space, at least 2.
struct PlacedCurve {
  std::vector<Vec2> places;
  std::vector<Vec3> points;
  std::optional<double> radius;  ///< model units, > 0; none: everywhere half of the distance to the sides
  InnerProfile profile = InnerProfile::Smooth;
};

/// All that a face is made from but points and inner curves.
struct SurfaceFrame {
  std::vector<SurfaceSide> sides;  ///< at least 2, in the loop's order; ends meet
  AttributeMode mode = AttributeMode::Smooth;
  AttributeDomain domain = AttributeDomain::Chordlength;
  double fullness = 0.7;  ///< -1..2
};

/// A place of the surface with its derivatives by the domain's coordinates, model units per part of the perimeter.
struct SurfacePlace {
  Vec3 point = Vec3::Zero();
  Vec3 du = Vec3::Zero();
  Vec3 dv = Vec3::Zero();
};

class SurfaceBase;
class SurfaceAttributes;

/// The map from a face's domain to space. Immutable and cheap to copy; reading is thread safe and allocates nothing.
class FaceSurface {
 public:
  /// The surface of the curves alone. Costs some microseconds per side.
  explicit FaceSurface(const SurfaceFrame& frame);

  /// The same curves with points and inner curves on them, all of them met. Costs one evaluation for each.
  FaceSurface with(std::vector<PlacedPoint> points, std::vector<PlacedCurve> curves) const;

  const DomainPolygon& domain() const;
  const SurfaceFrame& frame() const;
  double sigma() const;                            ///< model units per unit of the domain: the loop's length
  const std::vector<PlacedPoint>& points() const;  ///< as given
  const std::vector<PlacedCurve>& curves() const;  ///< as given

  /// The place in space of a place of the domain, its sides included.
  Vec3 at(const Vec2& place) const;

  /// What it would be without points and inner curves.
  Vec3 base_at(const Vec2& place) const;

  /// At a side: of the surface just inside.
  SurfacePlace evaluate(const Vec2& place) const;
  SurfacePlace evaluate_base(const Vec2& place) const;

  /// Unit normal; at a side of mode Smooth the fence's. Zero where the surface has none.
  Vec3 normal(const Vec2& place) const;

  /// The unit normal of the fence at a fraction of a side of the loop, which may be a position's own where it has no
  /// fence.
  Vec3 side_normal(std::size_t side, double fraction) const;

  /// Where a fraction 0..1 of a side of the loop lies in the domain. The two sides of a face of two are two footprints
  /// each.
  Vec2 side_place(std::size_t side, double fraction) const;

  std::size_t byte_size() const;

 private:
  FaceSurface(std::shared_ptr<const SurfaceBase> base, std::shared_ptr<const SurfaceAttributes> attributes);

  std::shared_ptr<const SurfaceBase> base_;
  std::shared_ptr<const SurfaceAttributes> attributes_;  ///< null: none
};

/// A place of the domain and how near the surface is there.
struct NearestPlace {
  Vec2 place = Vec2::Zero();
  double distance = 0;    ///< model units
  bool at_limit = false;  ///< the nearest place would be a side or beyond: moved inwards to 1e-3 / N of the perimeter
};

/// The place of the surface nearest to a point: footprints of points are found by it, since a plane projection puts
/// bumps elsewhere.
/// @param guess where to begin; none: the best of a coarse grid
NearestPlace nearest_place(const FaceSurface& surface, const Vec3& point, const std::optional<Vec2>& guess = {});

/// The same for the surface without its points and inner curves.
NearestPlace nearest_base_place(const FaceSurface& surface, const Vec3& point, const std::optional<Vec2>& guess = {});

}  // namespace croquis
