// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Geometry>

#include "algorithms/remeshing/surface_parts.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

using Link = TriangleFans::Link;

constexpr double box_differs = 2;        // × cell
constexpr double volume_differs = 0.05;  // × volume
constexpr double surface_differs = 0.1;  // × cell, all over
constexpr double hole_bulge = 0.5;       // × diameter, over a hole
constexpr double crossing_volume = 0.5;  // × volume: where a surface crosses itself parts count twice

/// V - E + F, with E = (3 F + rim edges) / 2, and with every rim closed by a disc.
std::int64_t euler_number(std::size_t vertices, std::size_t triangles, std::size_t rim_edges, std::size_t rims) {
  return static_cast<std::int64_t>(vertices + triangles + rims) -
         static_cast<std::int64_t>((3 * triangles + rim_edges) / 2);
}

/// The triangles of a piece joined across edges of two triangles alone.
/// @param count is given the number of sheets @return their Euler numbers added up
std::int64_t euler_of_sheets(const SurfaceView& view, const std::vector<Index>& triangles, std::size_t& count) {
  // Corners of the piece's triangles are numbered in their order.
  const auto given = [&](Index corner) { return 3 * triangles[corner / 3] + corner % 3; };
  const auto own = [&](Index corner) {
    const auto found = std::ranges::lower_bound(triangles, corner / 3) - triangles.begin();
    return 3 * static_cast<Index>(found) + corner % 3;
  };
  const auto corners = static_cast<Index>(3 * triangles.size());
  DisjointSets fans(corners);  // corners at one vertex of one sheet
  DisjointSets sheets(triangles.size());
  for (Index corner = 0; corner < corners; ++corner) {
    const Index opposite = view.opposite[given(corner)];
    if (!view.has_opposite(given(corner)) || opposite < given(corner)) continue;  // once per edge
    const Index across = own(opposite);
    sheets.unite(corner / 3, across / 3);
    for (const Index end : {corner, SurfaceView::next(corner)})
      for (const Index other : {across, SurfaceView::next(across)})
        if (view.origin(given(end)) == view.origin(given(other))) fans.unite(end, other);
  }
  std::size_t vertices = 0;
  for (Index corner = 0; corner < corners; ++corner) vertices += fans.root(corner) == corner ? 1U : 0U;
  std::vector<Index> rims;  // a corner of the rim for every rim edge
  for (Index corner = 0; corner < corners; ++corner) {
    if (view.has_opposite(given(corner))) continue;
    fans.unite(corner, SurfaceView::next(corner));  // rims lead from fan to fan
    rims.push_back(corner);
  }
  const std::size_t rim_edges = rims.size();
  for (Index& rim : rims) rim = fans.root(rim);
  std::ranges::sort(rims);
  rims.erase(std::unique(rims.begin(), rims.end()), rims.end());
  count = 0;
  for (Index t = 0; t < triangles.size(); ++t) count += sheets.root(t) == t ? 1U : 0U;
  return euler_number(vertices, triangles.size(), rim_edges, rims.size());
}

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

double volume_below(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& middle) {
  return (a - middle).dot((b - middle).cross(c - middle)) / 6;
}

}  // namespace

std::optional<ExpectedTopology> expected_topology(const HoleAnalysis& analysis, const RemeshPiece& piece,
                                                  std::span<const Link> links) {
  const bool is_clear =
      piece.views == 0 && std::ranges::none_of(piece.vertices, [&](Index v) { return links[v] == Link::Broken; });
  if (!is_clear && analysis.view.one_sided_components > 0) return std::nullopt;
  std::size_t sheets = 0;
  const std::int64_t euler = euler_of_sheets(analysis.view, piece.triangles, sheets);
  // Joining all sheets to one makes a ball of two balls, each handle takes two.
  const auto joints = static_cast<std::int64_t>(sheets) - 1;
  const auto handles = static_cast<std::int64_t>(handles_of_groups(analysis, piece));
  return ExpectedTopology{{1, euler - 2 * (joints + handles)}, is_clear};
}

std::size_t difference(const SurfaceTopology& a, const SurfaceTopology& b) {
  const auto handles = [](const SurfaceTopology& t) { return static_cast<std::int64_t>(2 * t.components) - t.euler; };
  const auto components = static_cast<std::int64_t>(a.components) - static_cast<std::int64_t>(b.components);
  return static_cast<std::size_t>(std::abs(components) + std::abs(handles(a) - handles(b)));
}

SurfaceTopology topology_of(const PolyMesh& mesh, int threads, Progress progress) {
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  const std::vector<Link> links = fans.links(threads, progress);
  const auto rim_edges = static_cast<std::size_t>(std::ranges::count(links, Link::Path));
  return {part_count(mesh),
          euler_number(mesh.vertex_count(), mesh.face_count(), rim_edges, open_loop_count(fans, links))};
}

Vec3 place_of_smallest_part(const PolyMesh& mesh) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::size_t> sizes(parts.size(), 0);
  for (const Index part : parts) ++sizes[part];
  return mesh.positions[*std::ranges::min_element(mesh.corners, {}, [&](Index v) { return sizes[parts[v]]; })];
}

PieceExtent extent_of_scan(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece) {
  PieceExtent extent;
  extent.box = {mesh.positions[piece.vertices.front()], mesh.positions[piece.vertices.front()]};
  for (const Index v : piece.vertices) {
    extent.box.low = extent.box.low.cwiseMin(mesh.positions[v]);
    extent.box.high = extent.box.high.cwiseMax(mesh.positions[v]);
  }
  const Vec3 middle = extent.box.middle();
  double volume = 0;
  for (const Index t : piece.triangles) {
    const auto& [a, b, c] = analysis.view.triangles[t];
    const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
    extent.area += 0.5 * (pb - pa).cross(pc - pa).norm();
    volume += volume_below(pa, pb, pc, middle);
  }
  const std::vector<Index> closed = piece.chosen_holes();
  for (const Hole& hole : analysis.holes) {
    if (!std::ranges::binary_search(piece.vertices, hole.vertices.front())) continue;
    if (!std::ranges::binary_search(closed, hole.id)) return extent;
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
      const Vec3& from = mesh.positions[hole.vertices[i]];
      const Vec3& to = mesh.positions[hole.vertices[(i + 1) % hole.vertices.size()]];
      volume += volume_below(hole.centre, to, from, middle);
    }
  }
  extent.volume = volume;
  return extent;
}

PieceExtent extent_of_surface(const PolyMesh& surface, bool is_closed) {
  PieceExtent extent{implicit::bounds(surface.positions), {}, 0};
  const Vec3 middle = extent.box.middle();
  double volume = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto [a, b, c] = places_of(surface.positions, surface.face(f));
    volume += volume_below(a, b, c, middle);
    extent.area += area_normal(surface, f).norm();
  }
  if (is_closed) extent.volume = volume;
  return extent;
}

ExtentChange change_of(const PieceExtent& given, const PieceExtent& made, const HoleAnalysis& analysis,
                       const RemeshPiece& piece, double cell) {
  ExtentChange change;
  double bulge = 0, enclosed = 0;
  for (const Index id : piece.chosen_holes()) {
    const Hole& hole = analysis.holes[id];
    bulge = std::max(bulge, hole_bulge * hole.diameter);
    enclosed += hole_bulge * hole.diameter * hole.area;
  }
  const double shrunk =
      std::max((made.box.low - given.box.low).maxCoeff(), (given.box.high - made.box.high).maxCoeff());
  const double grown = std::max((given.box.low - made.box.low).maxCoeff(), (made.box.high - given.box.high).maxCoeff());
  if (shrunk > box_differs * cell) change.shrunk = shrunk;
  if (grown > box_differs * cell + bulge && piece.seams.empty()) change.grown = grown;
  if (!given.volume || !made.volume) return change;
  const double most = volume_differs * std::abs(*given.volume) + surface_differs * cell * given.area + enclosed;
  if (std::abs(*made.volume - *given.volume) > most) {
    change.given = *given.volume;
    change.made = *made.volume;
  }
  return change;
}

ExtentChange change_of_solid(const std::vector<std::optional<double>>& volumes, const PolyMesh& solid, double cell) {
  ExtentChange change;
  double largest = 0, all = 0, cavities = 0;
  for (const std::optional<double>& volume : volumes) {
    if (!volume) return change;
    largest = std::max(largest, *volume);
    all += std::max(*volume, 0.0);
    cavities -= std::min(*volume, 0.0);
  }
  const PieceExtent made = extent_of_surface(solid, true);
  const double least = (volumes.size() == 1 ? crossing_volume : 1) * largest - cavities;
  const double allowed = volume_differs * all + surface_differs * cell * made.area;
  if (*made.volume >= least - allowed && *made.volume <= all + allowed) return change;
  change.given = *made.volume < least ? least : all;
  change.made = *made.volume;
  return change;
}

}  // namespace croquis::remeshing
