// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/attribute_surface/face_surface.h"

/// A face evaluated as its formulas are written, slowly: arc lengths by bisection over quadrature, normals turned along
/// great circles, no table, nothing precomputed. Shares no code with the library.
namespace croquis::test {

struct ReferencePoint {
  FanPlace fan;
  Vec3 point = Vec3::Zero();
  std::optional<double> radius;
  PointProfile profile = PointProfile::Smooth;
};

class ReferenceSurface {
 public:
  explicit ReferenceSurface(const SurfaceFrame& frame, std::vector<ReferencePoint> points = {});

  Vec3 base_at(const FanPlace& fan) const;
  Vec3 at(const FanPlace& fan) const;

  /// Corners of the domain in order, perimeter 1.
  const std::vector<Vec2>& corners() const { return corners_; }

 private:
  /// A side of the domain: a part of a side of the frame.
  struct Side {
    const SurfaceSide* source = nullptr;
    double from = 0;
    double to = 1;
    double length = 0;  ///< model units
  };

  Vec3 curve_place(const Side& side, double t) const;
  Vec3 curve_derivative(const Side& side, double t) const;
  Vec3 inward(const Side& side, double t) const;
  Vec3 continued(const Side& side, double t) const;
  Vec2 place_of(const FanPlace& fan) const;
  Vec3 base(const Vec2& q) const;
  Vec3 paper(const Vec2& q) const;
  double side_weights(const Vec2& q) const;
  double distance(std::size_t side, const Vec2& q) const;
  double parameter(std::size_t side, const Vec2& q) const;
  double half_height(const ReferencePoint& point) const;

  SurfaceFrame frame_;
  std::vector<Side> sides_;
  std::vector<Vec2> corners_;
  double sigma_ = 0;
  std::vector<ReferencePoint> points_;
};

}  // namespace croquis::test
