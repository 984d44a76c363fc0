// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "algorithms/attribute_surface/curves/piecewise_quintic.h"
#include "croquis/attribute_surface/face_surface.h"

namespace croquis {

/// A fence, read between its keys.
class FenceReader {
 public:
  explicit FenceReader(const NormalFence& fence);

  /// The normal at a fraction of the side, projected off the curve's tangent there.
  /// @param tangent unit
  Vec3 normal(double at, const Vec3& tangent) const;

 private:
  Vec3 between_keys(double at) const;

  NormalFence fence_;
  std::vector<double> angles_;  ///< between a key and the next, radians
};

/// One straight side of a domain and what lies along it: a curve, or half of one in a domain of two curves. Everything
/// along it is read by the fraction t = 0..1 in the loop's direction.
class Footprint {
 public:
  struct Extent {
    double begin = 0;  ///< fraction of the side's curve in the loop's direction
    double end = 1;
  };

  /// @param sigma model units per unit of the domain, for the conormals' length
  Footprint(const DomainPolygon& polygon, std::size_t index, const SurfaceSide& side, const Extent& extent);

  Vec2 from;
  Vec2 along;    ///< unit
  Vec2 inwards;  ///< unit
  double length = 0;

  Vec3 point(double t) const { return curve_->at(fraction(t)); }

  /// The derivative is by t.
  ArcLengthCurve::Place place(double t) const;

  const Vec3& start() const { return start_.point; }
  const Vec3& end() const { return end_.point; }
  const Vec3& start_derivative() const { return start_.derivative; }
  const Vec3& end_derivative() const { return end_.derivative; }

  bool has_fence() const { return conormals_ != nullptr; }

  /// Of the surface, into the face, as long as the fence's magnitude: the surface's derivative across the side in
  /// arc-length units.
  Vec3 conormal(double t) const { return conormals_->at(t); }
  PiecewiseQuintic::ValueAndSlope conormal_place(double t) const { return conormals_->evaluate(t); }

  std::size_t byte_size() const { return sizeof(*this) + (conormals_ ? conormals_->byte_size() : 0); }

 private:
  double fraction(double t) const { return first_ + t * step_; }

  std::shared_ptr<const ArcLengthCurve> curve_;
  double first_ = 0;  ///< the curve's own fraction where the footprint begins
  double step_ = 1;   ///< to its end: below 0 where the curve is walked along backwards
  ArcLengthCurve::Place start_;
  ArcLengthCurve::Place end_;
  std::shared_ptr<const PiecewiseQuintic> conormals_;  ///< null: no fence
};

}  // namespace croquis
