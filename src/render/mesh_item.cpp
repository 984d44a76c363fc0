// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/mesh_item.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "render/item_colors.h"
#include "render/polygon_triangulation.h"
#include "render/smooth_surface.h"

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

std::vector<glm::dvec3> own_positions(const PolyMesh& mesh, const MeshItem& item) {
  std::vector<glm::dvec3> positions;
  positions.reserve(mesh.vertex_count());
  for (const Vec3& position : mesh.positions) positions.push_back((to_glm(position) - item.origin) / item.scale);
  return positions;
}

/// Makes as few vertices as possible: corners share one when group, patch and colour agree.
class VertexCollector {
 public:
  VertexCollector(MeshItem& item, std::size_t corner_count) : item_(item), first_(corner_count, no_index) {}

  Index vertex(Index group, const SurfaceVertex& vertex, const SurfacePaint& paint) {
    Index found = first_[group];
    while (found != no_index && paint_[found] != paint) found = next_[found];
    if (found != no_index) return found;
    found = static_cast<Index>(item_.vertices.size());
    item_.vertices.push_back(vertex);
    paint_.push_back(paint);
    next_.push_back(std::exchange(first_[group], found));
    return found;
  }

  std::vector<SurfacePaint> take_paint() { return std::move(paint_); }

 private:
  MeshItem& item_;
  std::vector<SurfacePaint> paint_;
  std::vector<Index> first_;  // newest vertex of each group
  std::vector<Index> next_;   // the one made before, per vertex
};

void add_surface(const PolyMesh& mesh, std::span<const glm::dvec3> positions, const MeshItemOptions& options,
                 MeshItem& item) {
  const std::vector<Index> welded = weld(positions);
  const std::vector<Index> parts = face_parts(mesh, welded);
  const std::vector<Color> colors = corner_colors(mesh, parts);
  const SmoothSurface surface = find_smooth_surface(mesh, positions, welded, parts, options.crease_angle);
  item.patch_count = surface.patch_count;

  std::vector<Index> corner_vertices(mesh.corners.size());
  VertexCollector collector(item, mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) {
      const Index group = surface.corner_groups[c];
      corner_vertices[c] = collector.vertex(
          group, {positions[mesh.corners[c]], surface.normals[group]}, {colors[c], surface.face_patches[f]});
    }
  }
  item.paint = collector.take_paint();
  std::vector<std::uint32_t> edges;
  for (const auto& [a, b] : surface.edges) edges.insert(edges.end(), {corner_vertices[a], corner_vertices[b]});
  item.edges = std::move(edges);

  std::vector<std::uint32_t> triangles;
  std::vector<glm::dvec3> polygon;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3) continue;
    polygon.clear();
    for (const Index vertex : face) polygon.push_back(positions[vertex]);
    for (const auto& triangle : triangulate_polygon(polygon)) {
      for (const Index corner : triangle) triangles.push_back(corner_vertices[mesh.face_offsets[f] + corner]);
    }
  }
  item.triangles = std::move(triangles);
}

void add_lines(const PolyMesh& mesh, std::span<const glm::dvec3> positions, const MeshItemOptions& options,
               MeshItem& item) {
  const std::vector<Color> colors = line_colors(mesh, options.line_color);
  for (std::size_t i = 0; i < mesh.line_vertices.size(); ++i) {
    item.line_vertices.push_back({positions[mesh.line_vertices[i]], colors[i]});
  }
  std::vector<std::uint32_t> segments;
  for (std::size_t l = 0; l < mesh.line_count(); ++l) {
    for (Index i = mesh.line_offsets[l]; i + 1 < mesh.line_offsets[l + 1]; ++i) {
      segments.insert(segments.end(), {i, i + 1});
    }
  }
  item.segments = std::move(segments);
}

}  // namespace

MeshItemPtr make_mesh_item(const PolyMesh& mesh, const MeshItemOptions& options) {
  require_drawable(mesh);
  auto item = std::make_shared<MeshItem>();
  item->bounds = bounds_of_drawn(mesh);
  if (!item->bounds.empty()) item->origin = item->bounds.center();
  if (item->bounds.radius() > 0 && !item->bounds.empty()) item->scale = item->bounds.radius();
  const std::vector<glm::dvec3> positions = own_positions(mesh, *item);
  add_surface(mesh, positions, options, *item);
  add_lines(mesh, positions, options, *item);
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
