// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/mesh_item.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "render/items/item_frame.h"
#include "render/items/mesh_plan.h"

namespace croquis::render {
namespace {

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

/// Takes the frame that fits the item's bounds, and the positions in it.
std::vector<Vec3> take_frame(std::span<const Vec3> positions, MeshItem& item) {
  set_own_frame(item);
  const Vec3 origin(item.origin.x, item.origin.y, item.origin.z);
  std::vector<Vec3> own;
  own.reserve(positions.size());
  for (const Vec3& position : positions) own.push_back((position - origin) / item.scale);
  return own;
}

bool all_finite(std::span<const Vec3> positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Vec3& v) { return v.allFinite(); });
}

void require_positions(std::span<const Vec3> positions, std::size_t count) {
  Findings findings;
  if (positions.size() != count) {
    findings.push_back(make_error(Category::Usage, "E_COUNT",
                                  "A mesh of " + std::to_string(count) + " vertices can't take " +
                                      std::to_string(positions.size()) + " positions; give one for each vertex.",
                                  {}));
  } else if (!all_finite(positions)) {
    for (std::size_t v = 0; v < count; ++v) {
      if (!positions[v].allFinite()) findings.push_back(not_finite(SubjectKind::Vertex, "vertex", v));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

/// @param normals see MeshPlan::fill
MeshItemPtr place(const std::shared_ptr<const MeshPlan>& plan, std::span<const Vec3> positions,
                  const AttributeChannel* normals) {
  auto item = std::make_shared<MeshItem>();
  item->plan = plan;
  item->bounds = plan->bounds_of_drawn(positions);
  plan->fill(positions, take_frame(positions, *item), normals, *item);
  return item;
}

void require_faces(std::span<const Index> faces, std::size_t count) {
  Findings findings;
  for (const Index face : faces) {
    if (face >= count) findings.push_back(not_there(SubjectKind::Face, "face", face, count));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace

MeshItemPtr make_mesh_item(const PolyMesh& mesh, const MeshItemOptions& options) {
  require_drawable(mesh);
  auto item = std::make_shared<MeshItem>();
  item->bounds = bounds_of_drawn(mesh);
  const std::vector<Vec3> positions = take_frame(mesh.positions, *item);
  const auto plan = std::make_shared<MeshPlan>(mesh, positions, options);
  plan->fill(mesh.positions, positions, plan->normals_of(mesh), *item);
  plan->reduce(*item);
  if (plan->reduced()) item->reduced = plan->reduced()->of(*item);
  item->plan = plan;
  return item;
}

MeshItemPtr update_mesh_item(const MeshItemPtr& previous, const PolyMesh& mesh, const MeshItemOptions& options) {
  if (!previous || !previous->plan) return make_mesh_item(mesh, options);
  const MeshPlan& plan = *previous->plan;
  // Connectivity that fits has been checked before: only positions can be wrong.
  if (!all_finite(mesh.positions) || !plan.fits(mesh)) return make_mesh_item(mesh, plan.options());
  return place(previous->plan, mesh.positions, plan.normals_of(mesh));
}

MeshItemPtr update_mesh_item(const MeshItemPtr& previous, std::span<const Vec3> positions) {
  require_positions(positions, previous->plan->vertex_count());
  return place(previous->plan, positions, nullptr);
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

FaceHighlightPtr make_face_highlight(const MeshItemPtr& mesh, std::span<const Index> faces, const Color& color) {
  if (!mesh || !mesh->plan) return nullptr;
  require_faces(faces, mesh->plan->face_count());
  const auto of_faces = [&](std::span<const std::uint32_t> all) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(6 * faces.size());
    for (const Index face : faces) {
      const auto [first, last] = mesh->plan->triangle_indices(face);
      triangles.insert(triangles.end(), all.begin() + first, all.begin() + last);
    }
    return triangles;
  };
  FaceHighlightPtr reduced;
  if (mesh->reduced) {
    // The reduced surface keeps the cut of faces that it was made with.
    reduced = std::make_shared<FaceHighlight>(
        FaceHighlight{mesh->reduced, mesh->plan->reduced()->reduced(of_faces(mesh->plan->triangles())), color});
  }
  return std::make_shared<FaceHighlight>(FaceHighlight{mesh, of_faces(mesh->triangles), color, std::move(reduced)});
}

}  // namespace croquis::render
