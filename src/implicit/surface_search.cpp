// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/surface_search.h"

#include <algorithm>
#include <cmath>

#include "implicit/cube_loops.h"
#include "implicit/parallel.h"

namespace croquis::implicit {
namespace {

// Of an edge: vertices keep at least this distance of its ends, so that triangles have an area.
constexpr double least_fraction = 1e-4;

// Of the search: how many fronts there will be isn't known.
constexpr double share_of_front = 0.02;

constexpr std::size_t grain = 256;  // corners or vertices per call of the field

bool inside(double value) { return value < 0; }

bool has_surface(const CornerValues& values) {
  return std::any_of(values.begin() + 1, values.end(), [&](double v) { return inside(v) != inside(values[0]); });
}

bool defined(const CornerValues& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// The four edges of every face.
constexpr std::array<std::array<unsigned, 4>, 6> edges_of_faces = [] {
  std::array<std::array<unsigned, 4>, 6> edges = {};
  for (unsigned face = 0; face < 6; ++face) {
    std::size_t count = 0;
    for (unsigned edge = 0; edge < 12; ++edge)
      if ((faces_of_edge(edge) >> face & 1U) != 0) edges[face][count++] = edge;
  }
  return edges;
}();

bool crosses(const CornerValues& values, unsigned edge) {
  const auto [axis, corner] = cube_edge(edge);
  return inside(values[corner]) != inside(values[corner | 1U << axis]);
}

}  // namespace

CornerValues corner_values(SparseLattice& lattice, const LatticePlace& cube) {
  CornerValues values;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const LatticePlace place = lattice.upper(cube, corner);
    values[corner] = place.block->values[place.local];
  }
  return values;
}

Vec3 crossing(SparseLattice& lattice, const LatticePlace& edge, int axis) {
  const LatticePlace end = lattice.upper(edge, 1U << axis);
  const double a = edge.block->values[edge.local];
  const double b = end.block->values[end.local];
  const double t = std::clamp(a / (a - b), least_fraction, 1 - least_fraction);
  const Vec3 from = lattice.position(edge);
  Vec3 place = from;
  place[axis] = from[axis] + t * (lattice.position(end)[axis] - from[axis]);
  return place;
}

SurfaceSearch::SurfaceSearch(SparseLattice& lattice, const Field& field, const PolygonizerOptions& options,
                             Polygonized& result)
    : lattice_(lattice), field_(field), options_(options), result_(result) {}

void SurfaceSearch::run(std::span<const Vec3> seeds, Progress& progress) {
  std::vector<LatticePlace> front = first_front(seeds);
  while (!front.empty()) {
    ++result_.rounds;
    Progress evaluating = progress.step("search", share_of_front);
    evaluate_corners(front, evaluating);
    const std::vector<LatticePlace> cubes = active_cubes(front);
    Progress covering = progress.step("search", 0);
    mark_crossings(cubes, covering);
    if (result_.cells > options_.max_cells) {
      result_.reached_max_cells = true;
      return;
    }
    front = next_front(cubes);
  }
}

std::vector<LatticePlace> SurfaceSearch::first_front(std::span<const Vec3> seeds) {
  std::vector<LatticePlace> front;
  const int reach = options_.seed_reach;
  for (const Vec3& seed : seeds) {
    const auto middle = lattice_.cube_at(seed);
    for (int z = -reach; z <= reach; ++z)
      for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) visit({middle[0] + x, middle[1] + y, middle[2] + z}, front);
  }
  return front;
}

void SurfaceSearch::visit(const std::array<std::int64_t, 3>& cube, std::vector<LatticePlace>& front) {
  if (!lattice_.has_cube(cube)) return;
  const LatticePlace place = lattice_.place(cube);
  if (!place.block->visited.insert(place.local)) return;
  ++result_.visited_cells;
  front.push_back(place);
}

void SurfaceSearch::evaluate_corners(const std::vector<LatticePlace>& front, Progress& progress) {
  std::vector<LatticePlace> corners;
  for (const LatticePlace& cube : front) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const LatticePlace place = lattice_.upper(cube, corner);
      if (place.block->known.insert(place.local)) corners.push_back(place);
    }
  }
  result_.evaluations += corners.size();
  for_each_part(corners.size(), grain, options_.threads, progress, [&](std::size_t begin, std::size_t end) {
    std::array<Vec3, grain> places;
    std::array<double, grain> values;
    for (std::size_t i = begin; i < end; ++i) places[i - begin] = lattice_.position(corners[i]);
    field_({places.data(), end - begin}, {values.data(), end - begin}, {});
    for (std::size_t i = begin; i < end; ++i) corners[i].block->values[corners[i].local] = values[i - begin];
  });
}

std::vector<LatticePlace> SurfaceSearch::active_cubes(const std::vector<LatticePlace>& front) {
  std::vector<LatticePlace> cubes;
  for (const LatticePlace& cube : front) {
    const CornerValues values = corner_values(lattice_, cube);
    if (!defined(values)) {
      // Seeds may lie anywhere; but a front came here along the surface.
      if (result_.rounds > 1) result_.reached_undefined = true;
      continue;
    }
    if (!has_surface(values)) continue;
    cube.block->active.set(cube.local);
    cubes.push_back(cube);
  }
  result_.cells += cubes.size();
  return cubes;
}

void SurfaceSearch::mark_crossings(const std::vector<LatticePlace>& cubes, Progress& progress) {
  std::vector<Edge> edges;
  for (const LatticePlace& cube : cubes) {
    const CornerValues values = corner_values(lattice_, cube);
    for (unsigned edge = 0; edge < 12; ++edge) {
      if (!crosses(values, edge)) continue;
      const auto [axis, corner] = cube_edge(edge);
      const LatticePlace place = lattice_.upper(cube, corner);
      const bool found = place.block->crossed[static_cast<std::size_t>(axis)].insert(place.local);
      if (found && options_.covered) edges.push_back({place, axis});
    }
  }
  if (options_.covered) ask_covered(edges, progress);
}

void SurfaceSearch::ask_covered(const std::vector<Edge>& edges, Progress& progress) {
  std::vector<std::uint8_t> covered(edges.size(), 0);
  std::vector<Vec3> places;
  for (const Edge& edge : edges) places.push_back(crossing(lattice_, edge.place, edge.axis));
  for_each_part(edges.size(), grain, options_.threads, progress, [&](std::size_t begin, std::size_t end) {
    options_.covered(std::span(places).subspan(begin, end - begin), std::span(covered).subspan(begin, end - begin));
  });
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (covered[i] != 0)
      edges[i].place.block->covered[static_cast<std::size_t>(edges[i].axis)].set(edges[i].place.local);
}

std::vector<LatticePlace> SurfaceSearch::next_front(const std::vector<LatticePlace>& cubes) {
  std::vector<LatticePlace> front;
  for (const LatticePlace& cube : cubes) {
    const CornerValues values = corner_values(lattice_, cube);
    const auto here = cube.coordinates();
    for (unsigned face = 0; face < 6; ++face) {
      if (!leads_on(cube, values, face)) continue;
      std::array<std::int64_t, 3> neighbour = {here[0], here[1], here[2]};
      neighbour[face / 2] += (face & 1U) != 0 ? 1 : -1;
      if (!lattice_.has_cube(neighbour)) result_.reached_bounds = true;
      visit(neighbour, front);
    }
  }
  return front;
}

bool SurfaceSearch::leads_on(const LatticePlace& cube, const CornerValues& values, unsigned face) {
  for (const unsigned edge : edges_of_faces[face]) {
    if (!crosses(values, edge)) continue;
    const auto [axis, corner] = cube_edge(edge);
    const LatticePlace place = lattice_.upper(cube, corner);
    if (!place.block->covered[static_cast<std::size_t>(axis)].test(place.local)) return true;
  }
  return false;
}

}  // namespace croquis::implicit
