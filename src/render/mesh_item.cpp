// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/mesh_item.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "render/item_frame.h"
#include "render/mesh_plan.h"

namespace croquis::render {
namespace {

glm::dvec3 to_glm(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void require_drawable(const PolyMesh& mesh) {
  Findings findings = validate(mesh);
  // A face without area or with a vertex twice shows nothing, which is what it is.
  std::erase_if(findings, [](const Finding& finding) { return finding.code == "E_FACE_DEGENERATE"; });
  if (has_errors(findings)) throw Error(std::move(findings));
}

Bounds bounds_of_drawn(const PolyMesh& mesh) {
  Bounds bounds;
  for (const Index vertex : mesh.corners) bounds.add(to_glm(mesh.positions[vertex]));
  for (const Index vertex : mesh.line_vertices) bounds.add(to_glm(mesh.positions[vertex]));
  return bounds;
}

/// An item's frame, and the mesh's vertices in it.
std::vector<glm::dvec3> take_frame(const PolyMesh& mesh, MeshItem& item) {
  item.bounds = bounds_of_drawn(mesh);
  set_own_frame(item);
  std::vector<glm::dvec3> positions;
  positions.reserve(mesh.vertex_count());
  for (const Vec3& position : mesh.positions) positions.push_back((to_glm(position) - item.origin) / item.scale);
  return positions;
}

bool all_finite(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& v) { return v.allFinite(); });
}

}  // namespace

MeshItemPtr make_mesh_item(const PolyMesh& mesh, const MeshItemOptions& options) {
  require_drawable(mesh);
  auto item = std::make_shared<MeshItem>();
  const std::vector<glm::dvec3> positions = take_frame(mesh, *item);
  item->plan = std::make_shared<MeshPlan>(mesh, positions, options);
  item->plan->fill(mesh, positions, *item);
  return item;
}

MeshItemPtr update_mesh_item(const MeshItemPtr& previous, const PolyMesh& mesh, const MeshItemOptions& options) {
  if (!previous || !previous->plan) return make_mesh_item(mesh, options);
  const MeshPlan& plan = *previous->plan;
  // Connectivity that fits has been checked before: only positions can be wrong.
  if (!all_finite(mesh) || !plan.fits(mesh)) return make_mesh_item(mesh, plan.options());
  auto item = std::make_shared<MeshItem>();
  item->plan = previous->plan;
  plan.fill(mesh, take_frame(mesh, *item), *item);
  return item;
}

Bounds bounds_of(const std::vector<MeshItemPtr>& items) {
  Bounds bounds;
  for (const MeshItemPtr& item : items) bounds.add(item->bounds);
  return bounds;
}

std::vector<glm::dvec3> points_of(const std::vector<MeshItemPtr>& items) {
  std::vector<glm::dvec3> points;
  for (const MeshItemPtr& item : items) {
    const auto add = [&](const glm::vec3& own) { points.push_back(item->origin + item->scale * glm::dvec3(own)); };
    for (const SurfaceVertex& vertex : item->vertices) add(vertex.position);
    for (const LineVertex& vertex : item->line_vertices) add(vertex.position);
  }
  return points;
}

}  // namespace croquis::render
