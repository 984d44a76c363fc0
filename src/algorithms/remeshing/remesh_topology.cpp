// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_topology.h"

#include <algorithm>
#include <cstdlib>

#include "algorithms/remeshing/remesh_trimming.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

using Link = TriangleFans::Link;

/// V - E + F, with E = (3 F + rim edges) / 2.
std::int64_t euler_number(std::size_t vertices, std::size_t triangles, std::size_t rim_edges) {
  return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>((3 * triangles + rim_edges) / 2) +
         static_cast<std::int64_t>(triangles);
}

}  // namespace

std::size_t difference(const SurfaceTopology& a, const SurfaceTopology& b) {
  const auto handles = [](const SurfaceTopology& t) { return static_cast<std::int64_t>(2 * t.components) - t.euler; };
  const auto components = static_cast<std::int64_t>(a.components) - static_cast<std::int64_t>(b.components);
  return static_cast<std::size_t>(std::abs(components) + std::abs(handles(a) - handles(b)));
}

std::optional<SurfaceTopology> wanted_topology(const HoleAnalysis& analysis, const RemeshPiece& piece,
                                               std::span<const TriangleFans::Link> links) {
  if (piece.views > 0) return std::nullopt;
  if (std::any_of(piece.vertices.begin(), piece.vertices.end(), [&](Index v) { return links[v] == Link::Broken; }))
    return std::nullopt;
  // At sound vertices there are as many edges of rims as vertices on them.
  const auto rim_edges = static_cast<std::size_t>(
      std::count_if(piece.vertices.begin(), piece.vertices.end(), [&](Index v) { return links[v] == Link::Path; }));
  SurfaceTopology wanted{1, euler_number(piece.vertices.size(), piece.triangles.size(), rim_edges)};
  const auto is_here = [&](const Hole& hole) {
    return std::binary_search(piece.vertices.begin(), piece.vertices.end(), hole.vertices.front());
  };
  for (const Hole& hole : analysis.holes) wanted.euler += is_here(hole) ? 1 : 0;
  // A sheet with several rims is a ball less so many discs: each rim beyond the first takes two.
  for (const std::vector<Index>& group : piece.groups)
    wanted.euler -= 2 * (static_cast<std::int64_t>(group.size()) - 1);
  return wanted;
}

SurfaceTopology topology_of(const PolyMesh& mesh, int threads, Progress& progress) {
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  const std::vector<Link> links = fans.links(threads, progress);
  const auto rim_edges = static_cast<std::size_t>(std::count(links.begin(), links.end(), Link::Path));
  const std::size_t loops = open_loop_count(fans, links);
  return {part_count(mesh),
          euler_number(mesh.vertex_count(), mesh.face_count(), rim_edges) + static_cast<std::int64_t>(loops)};
}

Vec3 place_of_smallest_part(const PolyMesh& mesh) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::size_t> sizes(parts.size(), 0);
  for (const Index part : parts) ++sizes[part];
  const auto is_smaller = [&](Index a, Index b) { return sizes[parts[a]] < sizes[parts[b]]; };
  return mesh.positions[*std::min_element(mesh.corners.begin(), mesh.corners.end(), is_smaller)];
}

}  // namespace croquis::remeshing
