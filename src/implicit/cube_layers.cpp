// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/cube_layers.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "croquis/base/parallel.h"
#include "implicit/cube_loops.h"
#include "implicit/surface_search.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t blocks_per_part = 16;  // blocks per part

// Corners of triangles until their layers' numbers are known.
constexpr Index of_next_layer = Index{1} << 30;
constexpr Index of_middles = Index{1} << 31;
constexpr Index number_bits = of_next_layer - 1;

std::array<std::int32_t, 3> reversed(const LatticeBlock& block) {
  return {block.first[2], block.first[1], block.first[0]};
}

}  // namespace

Index CubeLayers::NumberedBlock::vertex(std::size_t axis, unsigned local) const {
  const unsigned w = local / 64;
  const std::uint64_t below = block->crossed[axis].word(w) & ((std::uint64_t{1} << (local % 64)) - 1);
  return first[axis * BlockBits::word_count + w] + static_cast<Index>(std::popcount(below));
}

CubeLayers::CubeLayers(SparseLattice& lattice, const PolygonizerOptions& options, LayeredMesh& made)
    : lattice_(lattice), options_(options), made_(made) {}

CubeLayers::Layer CubeLayers::numbered(int number) {
  Layer layer;
  layer.number = number;
  const auto here = lattice_.layers().find(number);
  if (here == lattice_.layers().end()) return layer;
  for (LatticeBlock& block : here->second) layer.blocks.push_back({&block, {}});
  std::sort(layer.blocks.begin(), layer.blocks.end(),
            [](const NumberedBlock& a, const NumberedBlock& b) { return reversed(*a.block) < reversed(*b.block); });
  Index next = 0;
  for (std::size_t b = 0; b < layer.blocks.size(); ++b) {
    NumberedBlock& numbered = layer.blocks[b];
    numbered.block->number = b;
    for (std::size_t w = 0; w < numbered.first.size(); ++w) {
      numbered.first[w] = next;
      const BlockBits& crossed = numbered.block->crossed[w / BlockBits::word_count];
      next += static_cast<Index>(std::popcount(crossed.word(w % BlockBits::word_count)));
    }
  }
  layer.points.resize(next);
  if (options_.covered) layer.covered.assign(next, 0);
  return layer;
}

void CubeLayers::place(int number, Progress& progress) {
  lattice_.link(number);
  Layer layer = numbered(number);
  for_each_part(layer.blocks.size(), blocks_per_part, options_.threads, progress,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t b = begin; b < end; ++b) place_vertices(layer.blocks[b], layer);
                });
  if (has_below_) {
    above_ = std::move(layer);
    return;
  }
  below_ = std::move(layer);
  has_below_ = true;
  made_.first_vertices = {0};
  made_.first_corners = {0};
  append_points(below_);
}

void CubeLayers::place_vertices(const NumberedBlock& numbered, Layer& layer) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned local = 0; local < LatticeBlock::size; ++local) {
      if (!numbered.block->crossed[axis].test(local)) continue;
      const Index vertex = numbered.vertex(axis, local);
      const LatticePlace edge = {numbered.block, static_cast<std::uint16_t>(local)};
      layer.points[vertex] = crossing(lattice_, edge, static_cast<int>(axis));
      if (options_.covered) layer.covered[vertex] = numbered.block->covered[axis].test(local) ? 1 : 0;
    }
  }
}

void CubeLayers::append_points(const Layer& layer) {
  made_.positions.insert(made_.positions.end(), layer.points.begin(), layer.points.end());
  made_.covered.insert(made_.covered.end(), layer.covered.begin(), layer.covered.end());
}

void CubeLayers::finish(Progress& progress) {
  std::vector<Piece> pieces((below_.blocks.size() + blocks_per_part - 1) / blocks_per_part);
  for_each_part(below_.blocks.size(), blocks_per_part, options_.threads, progress,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t b = begin; b < end; ++b)
                    add_triangles(*below_.blocks[b].block, pieces[begin / blocks_per_part]);
                });
  const Index own = made_.first_vertices.back();
  Index middle = own + static_cast<Index>(below_.points.size()), middles = 0;
  for (const Piece& piece : pieces) middles += static_cast<Index>(piece.middles.size());
  const Index next = middle + middles;
  for (const Piece& piece : pieces) {
    for (const Index corner : piece.corners) {
      const Index first = (corner & of_middles) != 0 ? middle : (corner & of_next_layer) != 0 ? next : own;
      made_.corners.push_back(first + (corner & number_bits));
    }
    middle += static_cast<Index>(piece.middles.size());
    made_.positions.insert(made_.positions.end(), piece.middles.begin(), piece.middles.end());
  }
  if (options_.covered) made_.covered.resize(made_.positions.size(), 0);
  made_.first_vertices.push_back(next);
  made_.first_corners.push_back(static_cast<Index>(made_.corners.size()));
  below_ = std::exchange(above_, {});
  append_points(below_);
}

std::size_t CubeLayers::bytes() const {
  return (below_.blocks.capacity() + above_.blocks.capacity()) * sizeof(NumberedBlock) +
         (below_.points.capacity() + above_.points.capacity()) * sizeof(Vec3);
}

void CubeLayers::add_triangles(LatticeBlock& block, Piece& piece) {
  for (unsigned local = 0; local < LatticeBlock::size; ++local) {
    if (!block.active.test(local)) continue;
    const LatticePlace cube = {&block, static_cast<std::uint16_t>(local)};
    const CubeLoops loops = cube_loops(lattice_.values(cube));
    for (std::size_t i = 0; i < loops.count; ++i) add_loop(cube, loops.loop(i), piece);
  }
}

void CubeLayers::add_loop(const LatticePlace& cube, std::span<const std::uint8_t> edges, Piece& piece) {
  std::array<Index, 12> vertices;
  std::array<Vec3, 12> points;
  const std::size_t n = edges.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto [axis, corner] = cube_edge(edges[k]);
    const LatticePlace place = lattice_.upper(cube, corner);
    const bool is_next = lattice_.layer_of(*place.block) != below_.number;
    const Layer& layer = is_next ? above_ : below_;
    const Index vertex = layer.blocks[place.block->number].vertex(static_cast<std::size_t>(axis), place.local);
    vertices[k] = is_next ? vertex | of_next_layer : vertex;
    points[k] = layer.points[vertex];
  }
  const LoopTriangles found = triangulate_loop(edges, {points.data(), n});
  for (std::size_t t = 0; t < found.count; ++t)
    for (const std::uint8_t k : found.triangles[t]) piece.corners.push_back(vertices[k]);
  if (found.count > 0) return;
  const auto middle = static_cast<Index>(piece.middles.size()) | of_middles;
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < n; ++k) mean += points[k] / static_cast<double>(n);
  piece.middles.push_back(mean);
  for (std::size_t k = 0; k < n; ++k)
    for (const Index corner : {vertices[k], vertices[(k + 1) % n], middle}) piece.corners.push_back(corner);
}

}  // namespace croquis::implicit
