// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/surface_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "croquis/base/parallel.h"
#include "implicit/cube_loops.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

constexpr double most_cubes = 4194304;  // per axis: block numbers of three axes fit one key
constexpr double most_steps = 1e15;     // from the origin: lattice coordinates stay whole in a double
constexpr double farthest_seed = 1e9;   // in cubes; seeds beyond are out of every box

std::array<std::int32_t, 3> first_of_upper(const LatticeBlock& block, unsigned bits) {
  std::array<std::int32_t, 3> first = block.first;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((bits >> axis & 1U) != 0) first[axis] += LatticeBlock::side;
  return first;
}

// Of an edge: vertices keep at least this distance of its ends, so that triangles have an area.
constexpr double least_fraction = 1e-4;

// Of the search: how many fronts there will be isn't known.
constexpr double share_of_front = 0.02;

constexpr std::size_t places_per_call = 256;  // corners or vertices per call of the field

constexpr unsigned all_inside = 255;

/// Seeds and fronts wander about. Corners of one block lie near each other in memory, and near what the field needs.
bool comes_before(const LatticePlace& a, const LatticePlace& b) {
  return a.block != b.block ? a.block->first < b.block->first : a.local < b.local;
}

/// For every pattern of signs the edges that it crosses, one bit per edge.
constexpr std::array<std::uint16_t, 256> crossed_edges = [] {
  std::array<std::uint16_t, 256> crossed = {};
  for (unsigned signs = 0; signs < 256; ++signs) {
    for (unsigned edge = 0; edge < 12; ++edge) {
      const auto [axis, corner] = cube_edge(edge);
      if ((signs >> corner & 1U) != (signs >> (corner | 1U << axis) & 1U))
        crossed[signs] = static_cast<std::uint16_t>(crossed[signs] | 1U << edge);
    }
  }
  return crossed;
}();

/// The four edges of every face, one bit per edge.
constexpr std::array<std::uint16_t, 6> edges_of_faces = [] {
  std::array<std::uint16_t, 6> edges = {};
  for (unsigned face = 0; face < 6; ++face)
    for (unsigned edge = 0; edge < 12; ++edge)
      if ((faces_of_edge(edge) >> face & 1U) != 0) edges[face] = static_cast<std::uint16_t>(edges[face] | 1U << edge);
  return edges;
}();

}  // namespace

SparseLattice::SparseLattice(const Vec3& origin, double cell, const Box& bounds, int layer_axis)
    : origin_(origin), cell_(cell), axis_(static_cast<std::size_t>(layer_axis)) {
  require_parameter(std::isfinite(cell) && cell > 0, "cell", "the cubes' edge length must be positive");
  require_parameter(origin.allFinite() && bounds.low.allFinite() && bounds.high.allFinite() &&
                        (bounds.low.array() <= bounds.high.array()).all(),
                    "bounds", "origin and box must be finite, and the box not inside out");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    base_[axis] = std::ceil((bounds.low[i] - origin[i]) / cell);
    const double count = std::floor((bounds.high[i] - origin[i]) / cell) - base_[axis];
    require_parameter(std::abs(base_[axis]) < most_steps && count <= most_cubes, "cell",
                      "the box holds more than 4194304 cubes along one axis; choose larger ones");
    counts_[axis] = static_cast<std::int64_t>(std::max(count, 0.0));
  }
}

Vec3 SparseLattice::position(const std::array<std::int32_t, 3>& corner) const {
  return {origin_.x() + cell_ * (base_[0] + corner[0]), origin_.y() + cell_ * (base_[1] + corner[1]),
          origin_.z() + cell_ * (base_[2] + corner[2])};
}

std::array<std::int64_t, 3> SparseLattice::cube_at(const Vec3& place) const {
  std::array<std::int64_t, 3> cube;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double steps = std::floor((place[i] - origin_[i]) / cell_) - base_[axis];
    cube[axis] = static_cast<std::int64_t>(std::isfinite(steps) ? std::clamp(steps, -farthest_seed, farthest_seed)
                                                                : -farthest_seed);
  }
  return cube;
}

bool SparseLattice::has_cube(const std::array<std::int64_t, 3>& cube) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cube[axis] < 0 || cube[axis] >= counts_[axis]) return false;
  return true;
}

LatticePlace SparseLattice::place(const std::array<std::int64_t, 3>& corner) {
  std::array<std::int32_t, 3> first;
  unsigned local = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::int32_t>(corner[axis] & ~std::int64_t{7});
    local |= static_cast<unsigned>(corner[axis] & 7) << (3 * axis);
  }
  return {&block(first), static_cast<std::uint16_t>(local)};
}

LatticePlace SparseLattice::upper(const LatticePlace& place, unsigned bits) {
  unsigned local = place.local;
  unsigned over = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if ((bits >> axis & 1U) == 0) continue;
    const unsigned shift = 3 * axis;
    if ((local >> shift & 7U) == 7U) {
      local &= ~(7U << shift);
      over |= 1U << axis;
    } else {
      local += 1U << shift;
    }
  }
  if (over == 0) return {place.block, static_cast<std::uint16_t>(local)};
  LatticeBlock*& neighbour = place.block->upper[over];
  if (neighbour == nullptr) neighbour = &block(first_of_upper(*place.block, over));
  return {neighbour, static_cast<std::uint16_t>(local)};
}

std::optional<LatticePlace> SparseLattice::neighbour(const LatticePlace& cube, unsigned face) {
  const unsigned axis = face / 2;
  const bool up = (face & 1U) != 0;
  const auto here = cube.coordinates();
  std::array<std::int64_t, 3> there = {here[0], here[1], here[2]};
  there[axis] += up ? 1 : -1;
  if (!has_cube(there)) return std::nullopt;
  const unsigned step = 1U << (3 * axis);
  if ((cube.local >> (3 * axis) & 7) == (up ? 7 : 0)) return place(there);
  return LatticePlace{cube.block, static_cast<std::uint16_t>(up ? cube.local + step : cube.local - step)};
}

CornerValues SparseLattice::values(const LatticePlace& cube) {
  CornerValues values;
  const bool at_rim = (cube.local & 7) == 7 || (cube.local >> 3 & 7) == 7 || cube.local >> 6 == 7;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const unsigned step = (corner & 1U) + 8 * (corner >> 1 & 1U) + 64 * (corner >> 2);
    const LatticePlace place =
        at_rim ? upper(cube, corner) : LatticePlace{cube.block, static_cast<std::uint16_t>(cube.local + step)};
    values[corner] = place.block->values[place.local];
  }
  return values;
}

double SparseLattice::bottom(int layer) const {
  std::array<std::int32_t, 3> corner = {};
  corner[axis_] = layer * LatticeBlock::side;
  return position(corner)[static_cast<Eigen::Index>(axis_)];
}

void SparseLattice::link(int layer) {
  const auto here = layers_.find(layer);
  if (here == layers_.end()) return;
  for (LatticeBlock& block : here->second) {
    for (unsigned bits = 1; bits < 8; ++bits) {
      const auto found = by_key_.find(key_of(first_of_upper(block, bits)));
      block.upper[bits] = found == by_key_.end() ? nullptr : found->second;
    }
  }
}

void SparseLattice::drop(int layer) {
  const auto here = layers_.find(layer);
  if (here == layers_.end()) return;
  for (const LatticeBlock& block : here->second) by_key_.erase(key_of(block.first));
  layers_.erase(here);
}

std::uint64_t SparseLattice::key_of(const std::array<std::int32_t, 3>& first) {
  std::uint64_t key = 0;
  for (const std::int32_t coordinate : first)
    key = key << 20 | static_cast<std::uint64_t>(coordinate / LatticeBlock::side);
  return key;
}

LatticeBlock& SparseLattice::block(const std::array<std::int32_t, 3>& first) {
  LatticeBlock*& found = by_key_[key_of(first)];
  if (found == nullptr) {
    found = &layers_[first[axis_] / LatticeBlock::side].emplace_back();
    found->first = first;
  }
  return *found;
}

std::size_t SparseLattice::bytes() const {
  constexpr std::size_t entry = 48;  // of the table: key, pointer, link and bucket, about
  std::size_t count = 0;
  for (const auto& [layer, blocks] : layers_) count += blocks.size();
  return count * (sizeof(LatticeBlock) + entry);
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

void SurfaceSearch::run_slab(std::span<const Vec3> seeds, std::span<const std::array<std::int64_t, 3>> cubes, int begin,
                             int end, Progress& progress) {
  begin_ = begin;
  end_ = end;
  from_seeds_ = true;
  Progress sowing = progress.step("search", 0.5);
  go_on(first_front(seeds), sowing);
  std::vector<LatticePlace> front;
  const std::vector<LatticePlace> ahead = std::exchange(ahead_, {});
  for (const LatticePlace& cube : ahead) (lattice_.layer_of(*cube.block) < end ? front : ahead_).push_back(cube);
  for (const auto& cube : cubes)
    if (lattice_.has_cube(cube)) visit(lattice_.place(cube), front);
  from_seeds_ = false;
  std::sort(front.begin(), front.end(), comes_before);
  Progress joining = progress.step("search", 0.5);
  go_on(std::move(front), joining);
}

void SurfaceSearch::go_on(std::vector<LatticePlace> front, Progress& progress) {
  while (!front.empty()) {
    ++result_.rounds;
    Progress evaluating = progress.step("search", share_of_front);
    evaluate_corners(front, evaluating);
    const std::vector<ActiveCube> cubes = active_cubes(front);
    Progress covering = progress.step("search", 0);
    mark_crossings(cubes, covering);
    if (result_.cells > options_.max_cells) {
      result_.reached_max_cells = true;
      return;
    }
    from_seeds_ = false;
    front = next_front(cubes);
    if (options_.only_complete && !result_.complete()) return;
  }
}

std::vector<LatticePlace> SurfaceSearch::first_front(std::span<const Vec3> seeds) {
  std::vector<LatticePlace> front;
  const int reach = options_.seed_reach;
  for (const Vec3& seed : seeds) {
    const auto middle = lattice_.cube_at(seed);
    for (int z = -reach; z <= reach; ++z) {
      for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
          const std::array<std::int64_t, 3> cube = {middle[0] + x, middle[1] + y, middle[2] + z};
          if (lattice_.has_cube(cube)) visit(lattice_.place(cube), front);
        }
      }
    }
  }
  std::sort(front.begin(), front.end(), comes_before);
  return front;
}

void SurfaceSearch::visit(const LatticePlace& cube, std::vector<LatticePlace>& front) {
  if (!cube.block->visited.insert(cube.local)) return;
  const int layer = lattice_.layer_of(*cube.block);
  if (layer < begin_) {
    const auto place = cube.coordinates();
    missed_.push_back({place[0], place[1], place[2]});
    return;
  }
  ++result_.visited_cells;
  (layer < end_ ? front : ahead_).push_back(cube);
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
  for_each_part(corners.size(), places_per_call, options_.threads, progress, [&](std::size_t begin, std::size_t end) {
    std::array<Vec3, places_per_call> places;
    std::array<double, places_per_call> values;
    for (std::size_t i = begin; i < end; ++i) places[i - begin] = lattice_.position(corners[i]);
    field_({places.data(), end - begin}, {values.data(), end - begin}, {});
    for (std::size_t i = begin; i < end; ++i) corners[i].block->values[corners[i].local] = values[i - begin];
  });
}

std::vector<SurfaceSearch::ActiveCube> SurfaceSearch::active_cubes(const std::vector<LatticePlace>& front) {
  std::vector<ActiveCube> cubes;
  for (const LatticePlace& cube : front) {
    const CornerValues values = lattice_.values(cube);
    unsigned signs = 0;
    bool defined = true;
    for (unsigned corner = 0; corner < 8; ++corner) {
      signs |= (values[corner] < 0 ? 1U : 0U) << corner;
      defined = defined && std::isfinite(values[corner]);
    }
    // Seeds may lie anywhere; but a later front came here along the surface.
    if (!defined && !from_seeds_) result_.reached_undefined = true;
    if (!defined || signs == 0 || signs == all_inside) continue;
    cube.block->active.set(cube.local);
    cubes.push_back({cube, static_cast<std::uint8_t>(signs)});
  }
  result_.cells += cubes.size();
  return cubes;
}

void SurfaceSearch::mark_crossings(const std::vector<ActiveCube>& cubes, Progress& progress) {
  std::vector<Edge> edges;
  for (const ActiveCube& cube : cubes) {
    for (unsigned left = crossed_edges[cube.signs]; left != 0; left &= left - 1) {
      const auto [axis, corner] = cube_edge(static_cast<unsigned>(std::countr_zero(left)));
      const LatticePlace place = lattice_.upper(cube.place, corner);
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
  for_each_part(edges.size(), places_per_call, options_.threads, progress, [&](std::size_t begin, std::size_t end) {
    options_.covered(std::span(places).subspan(begin, end - begin), std::span(covered).subspan(begin, end - begin));
  });
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (covered[i] != 0)
      edges[i].place.block->covered[static_cast<std::size_t>(edges[i].axis)].set(edges[i].place.local);
}

std::vector<LatticePlace> SurfaceSearch::next_front(const std::vector<ActiveCube>& cubes) {
  std::vector<LatticePlace> front;
  for (const ActiveCube& cube : cubes) {
    for (unsigned face = 0; face < 6; ++face) {
      if (!leads_on(cube, face)) continue;
      if (const auto neighbour = lattice_.neighbour(cube.place, face)) {
        visit(*neighbour, front);
      } else {
        result_.reached_bounds = true;
      }
    }
  }
  return front;
}

bool SurfaceSearch::leads_on(const ActiveCube& cube, unsigned face) {
  unsigned left = crossed_edges[cube.signs] & edges_of_faces[face];
  if (!options_.covered) return left != 0;
  for (; left != 0; left &= left - 1) {
    const auto [axis, corner] = cube_edge(static_cast<unsigned>(std::countr_zero(left)));
    const LatticePlace place = lattice_.upper(cube.place, corner);
    if (!place.block->covered[static_cast<std::size_t>(axis)].test(place.local)) return true;
  }
  return false;
}

}  // namespace croquis::implicit
