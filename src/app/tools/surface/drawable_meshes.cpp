// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/drawable_meshes.h"

#include <Eigen/Geometry>

#include "app/tools/surface/shown_surface.h"

namespace croquis::app {
namespace {

/// Newell's normal: of concave faces, too. Of no length for a face without area.
Vec3 face_normal(const PolyMesh& mesh, Index face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3& a = mesh.positions[corners[k]];
    const Vec3& b = mesh.positions[corners[(k + 1) % corners.size()]];
    sum += (a - mesh.positions[corners[0]]).cross(b - mesh.positions[corners[0]]);
  }
  return sum.normalized();
}

}  // namespace

MeshPicker& DrawableMeshes::picker_of(const WorkObject& object) {
  Kept& kept = kept_[object.node];
  if (kept.mesh != object.shown()) {
    kept.mesh = object.shown();
    kept.picker = std::make_unique<MeshPicker>(kept.mesh);
  }
  return *kept.picker;
}

std::optional<MeshHit> DrawableMeshes::under(const Ray& ray, NodeId except) {
  std::optional<MeshHit> nearest;
  for (const WorkObject& object : studio_.objects()) {
    const bool is_seen = object.visible && object.shown() && object.shown()->face_count() > 0;
    if (!is_seen || object.node == except) continue;
    const Affine3 to_model = object.placement.map();
    const Affine3 back = inverse_of(to_model);
    const auto hit = picker_of(object).face_under({back(ray.origin), (back.linear * ray.direction).normalized()});
    const Vec3 place = hit ? to_model(hit->place) : Vec3();
    const double distance = (place - ray.origin).norm();
    if (!hit || (nearest && distance >= nearest->distance)) continue;
    const Vec3 normal = back.linear.transpose() * face_normal(*object.shown(), hit->element);
    nearest = MeshHit{place, normal.normalized(), distance};
  }
  return nearest;
}

}  // namespace croquis::app
