// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_topology.h"

#include <algorithm>
#include <cstdlib>

#include "algorithms/remeshing/remesh_trimming.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

using Link = TriangleFans::Link;

/// V - E + F, with E = (3 F + rim edges) / 2.
std::int64_t euler_number(std::size_t vertices, std::size_t triangles, std::size_t rim_edges) {
  return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>((3 * triangles + rim_edges) / 2) +
         static_cast<std::int64_t>(triangles);
}

/// The triangles of a piece joined across edges of two triangles alone.
class Sheets {
 public:
  Sheets(const SurfaceView& view, const RemeshPiece& piece)
      : view_(view), piece_(piece), fans_(3 * piece.triangles.size()), parts_(piece.triangles.size()) {
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
      for (Index i = 0; i < 3; ++i) join(static_cast<Index>(3 * t) + i);
  }

  /// V - E + F of all, as if every rim were closed.
  std::int64_t euler() {
    std::size_t vertices = 0, rims = 0, loops = 0;
    for (Index corner = 0; corner < 3 * piece_.triangles.size(); ++corner)
      vertices += fans_.root(corner) == corner ? 1U : 0U;
    DisjointSets along = fans_;  // rims lead from fan to fan
    std::vector<Index> starts;
    for (Index corner = 0; corner < 3 * piece_.triangles.size(); ++corner) {
      if (view_.has_opposite(given(corner))) continue;
      ++rims;
      along.unite(corner, SurfaceView::next(corner));
      starts.push_back(corner);
    }
    for (Index& start : starts) start = along.root(start);
    std::ranges::sort(starts);
    loops = starts.size() - std::ranges::unique(starts).size();
    return euler_number(vertices, piece_.triangles.size(), rims) + static_cast<std::int64_t>(loops);
  }

  std::size_t count() {
    std::size_t parts = 0;
    for (Index t = 0; t < piece_.triangles.size(); ++t) parts += parts_.root(t) == t ? 1U : 0U;
    return parts;
  }

 private:
  /// Corners of the piece's triangles are numbered in their order.
  Index given(Index corner) const { return 3 * piece_.triangles[corner / 3] + corner % 3; }
  Index own(Index corner) const {
    const auto found = std::ranges::lower_bound(piece_.triangles, corner / 3);
    return static_cast<Index>(3 * (found - piece_.triangles.begin())) + corner % 3;
  }

  void join(Index corner) {
    if (!view_.has_opposite(given(corner))) return;
    const Index across = own(view_.opposite[given(corner)]);
    parts_.unite(corner / 3, across / 3);
    for (const Index end : {corner, SurfaceView::next(corner)})
      for (const Index other : {across, SurfaceView::next(across)})
        if (view_.origin(given(end)) == view_.origin(given(other))) fans_.unite(end, other);
  }

  const SurfaceView& view_;
  const RemeshPiece& piece_;
  DisjointSets fans_;   // corners at one vertex of one sheet
  DisjointSets parts_;  // triangles
};

/// How many handles holes that one sheet closes add: one for each rim more, unless it joins components.
std::size_t handles_of_groups(const HoleAnalysis& analysis, const RemeshPiece& piece) {
  DisjointSets joined(analysis.component_area.size());
  std::size_t handles = 0;
  for (const std::vector<Index>& group : piece.groups) {
    const Index first = analysis.holes[group.front()].component;
    for (std::size_t i = 1; i < group.size(); ++i) {
      const Index other = analysis.holes[group[i]].component;
      handles += joined.root(first) == joined.root(other) ? 1U : 0U;
      joined.unite(first, other);
    }
  }
  return handles;
}

}  // namespace

std::optional<SurfaceTopology> implied_topology(const HoleAnalysis& analysis, const RemeshPiece& piece) {
  if (analysis.view.one_sided_components > 0) return std::nullopt;
  Sheets sheets(analysis.view, piece);
  const auto twice = 2 * static_cast<std::int64_t>(sheets.count()) - sheets.euler();
  return SurfaceTopology{1, 2 - twice - 2 * static_cast<std::int64_t>(handles_of_groups(analysis, piece))};
}

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
