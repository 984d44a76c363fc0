// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/attribute_network.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// Where a ray meets a patch.
struct SurfaceHit {
  std::string face;
  FanPlace fan;
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double distance = 0;          ///< along the ray
};

/// Where a ray meets another mesh that can be drawn on.
struct MeshHit {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double distance = 0;          ///< along the ray
};

/// How a patch goes on from a place of a curve in its loop.
struct SlopeFrame {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, of the patch
  Vec3 inward = Vec3::UnitX();  ///< unit, in the tangent plane, across the curve into the patch
  double length = 1;            ///< model units, > 0: how long a handle of magnitude 1 is
};

/// What the tool has to know of the surfaces as they are shown. A host implements it: it has them computed. Everything
/// in the network's own space. A network whose surfaces aren't computed yet has no hits.
class SurfaceSight {
 public:
  virtual ~SurfaceSight() = default;

  /// The patch that the ray meets first, from either side.
  virtual std::optional<SurfaceHit> patch_under(const Ray& ray) const = 0;

  /// What is met first of the meshes that can be drawn on; the patches of the network don't count.
  virtual std::optional<MeshHit> mesh_under(const Ray& ray) const = 0;

  /// The normal of its patch at a point attribute; unit.
  virtual std::optional<Vec3> normal_at(const std::string& point) const = 0;

  /// Radius of a point attribute as it is used, model units.
  virtual std::optional<double> radius_of(const std::string& point) const = 0;

  /// On the surface the circle of the domain that is so far from a point attribute; closed without repeating the first.
  virtual std::vector<Vec3> ring_of(const std::string& point, double radius) const = 0;

  /// @param at fraction of the curve's arc length from its start
  virtual std::optional<SlopeFrame> slope_at(const std::string& face, const std::string& curve, double at) const = 0;
};

}  // namespace croquis
