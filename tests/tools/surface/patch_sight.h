// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/tools/surface/surface_sight.h"

namespace croquis::test {

/// What lies under rays of an evaluated network, by its triangles: as a host would give it to the tool.
class PatchSight final : public SurfaceSight {
 public:
  /// Finds what a ray meets of other meshes; empty: nothing.
  using FindMesh = std::function<std::optional<MeshHit>(const Ray&)>;

  /// O(#triangles).
  /// @param surface, tessellation of that network
  PatchSight(std::shared_ptr<const AttributeNetwork> network, std::shared_ptr<const AttributeSurface> surface,
             std::shared_ptr<const SurfaceTessellation> tessellation, FindMesh find_mesh = {});
  ~PatchSight() override;

  /// The place of the domain is that of the triangles, the point the surface's own there.
  std::optional<SurfaceHit> patch_under(const Ray& ray) const override;
  std::optional<MeshHit> mesh_under(const Ray& ray) const override;
  std::optional<Vec3> normal_at(const std::string& point) const override;
  std::optional<double> radius_of(const std::string& point) const override;
  /// What of the circle lies outside the domain is brought to its border.
  std::vector<Vec3> ring_of(const std::string& point, double radius) const override;
  std::optional<SlopeFrame> slope_at(const std::string& face, const std::string& curve, double at) const override;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace croquis::test
