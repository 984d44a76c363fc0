// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <unordered_map>

#include "app/tools/surface/drawable_meshes.h"
#include "app/tools/surface/shown_surface.h"
#include "croquis/tools/surface/surface_sight.h"

namespace croquis::app {

/// The surfaces as they were computed last, for the tool that draws on them.
class NetworkSight final : public SurfaceSight {
 public:
  /// @param object whose surfaces these are. @param meshes outlive this
  NetworkSight(ShownSurface shown, NodeId object, DrawableMeshes& meshes)
      : shown_(std::move(shown)), object_(object), meshes_(meshes) {}

  std::optional<SurfaceHit> patch_under(const Ray& ray) const override;
  std::optional<MeshHit> mesh_under(const Ray& ray) const override;
  std::optional<Vec3> normal_at(const std::string& point) const override;
  std::optional<double> radius_of(const std::string& point) const override;
  std::vector<Vec3> ring_of(const std::string& point, double radius) const override;
  std::optional<SlopeFrame> slope_at(const std::string& face, const std::string& curve, double at) const override;

 private:
  /// A point attribute as its face has it.
  struct Placed {
    const FaceSurface* face = nullptr;
    std::size_t index = 0;

    const PlacedPoint& point() const { return face->points()[index]; }
  };
  std::optional<Placed> placed(const std::string& point) const;
  const FaceSurface* surface_of(Index face) const;
  MeshPicker& picker() const;
  std::optional<Vec2> domain_place(const SurfacePart& part, Index triangle, const Vec3& place) const;

  ShownSurface shown_;
  NodeId object_;
  DrawableMeshes& meshes_;
  mutable std::unique_ptr<MeshPicker> picker_;  ///< made when it is first needed
};

}  // namespace croquis::app
