// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/cube_mesh.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "croquis/base/parallel.h"
#include "implicit/cube_loops.h"
#include "implicit/surface_search.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t grain = 16;               // blocks per part
constexpr Index middle_point = Index{1} << 31;  // marks a point in the middle of a loop, until all are counted

/// A block with the numbers of its vertices.
struct NumberedBlock {
  LatticeBlock* block;
  std::array<Index, 3 * BlockBits::word_count> first = {};  // vertex of every word's first edge

  Index vertex(std::size_t axis, unsigned local) const {
    const unsigned w = local / 64;
    const std::uint64_t below = block->crossed[axis].word(w) & ((std::uint64_t{1} << (local % 64)) - 1);
    return first[axis * BlockBits::word_count + w] + static_cast<Index>(std::popcount(below));
  }
};

/// What one part of the blocks gives.
struct Piece {
  std::vector<Index> corners;  // three per triangle
  std::vector<Vec3> middles;
};

class CubeMesher {
 public:
  CubeMesher(SparseLattice& lattice, const PolygonizerOptions& options, Polygonized& result)
      : lattice_(lattice), options_(options), result_(result) {}

  void run(Progress& progress) {
    number_vertices();
    Progress placing = progress.step("vertices", 0.3);
    for_each_part(blocks_.size(), grain, options_.threads, placing, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) place_vertices(blocks_[b]);
    });
    std::vector<Piece> pieces((blocks_.size() + grain - 1) / grain);
    Progress joining = progress.step("triangles", 0.7);
    for_each_part(blocks_.size(), grain, options_.threads, joining, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) add_triangles(*blocks_[b].block, pieces[begin / grain]);
    });
    join(pieces);
  }

 private:
  void number_vertices();
  void place_vertices(const NumberedBlock& numbered);
  void add_triangles(LatticeBlock& block, Piece& piece);
  void add_loop(const LatticePlace& cube, std::span<const std::uint8_t> edges, Piece& piece);
  void join(const std::vector<Piece>& pieces);

  SparseLattice& lattice_;
  const PolygonizerOptions& options_;
  Polygonized& result_;
  std::vector<NumberedBlock> blocks_;
};

void CubeMesher::number_vertices() {
  lattice_.link();
  for (auto& [layer, blocks] : lattice_.layers())
    for (LatticeBlock& block : blocks) blocks_.push_back({&block, {}});
  std::sort(blocks_.begin(), blocks_.end(), [](const NumberedBlock& a, const NumberedBlock& b) {
    const auto reversed = [](const LatticeBlock& block) {
      return std::array{block.first[2], block.first[1], block.first[0]};
    };
    return reversed(*a.block) < reversed(*b.block);
  });
  Index next = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].block->number = b;
    for (std::size_t w = 0; w < blocks_[b].first.size(); ++w) {
      blocks_[b].first[w] = next;
      const BlockBits& crossed = blocks_[b].block->crossed[w / BlockBits::word_count];
      next += static_cast<Index>(std::popcount(crossed.word(w % BlockBits::word_count)));
    }
  }
  result_.mesh.positions.resize(next);
  if (options_.covered) result_.covered.assign(next, 0);
}

void CubeMesher::place_vertices(const NumberedBlock& numbered) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned local = 0; local < LatticeBlock::size; ++local) {
      if (!numbered.block->crossed[axis].test(local)) continue;
      const Index vertex = numbered.vertex(axis, local);
      const LatticePlace edge = {numbered.block, static_cast<std::uint16_t>(local)};
      result_.mesh.positions[vertex] = crossing(lattice_, edge, static_cast<int>(axis));
      if (options_.covered) result_.covered[vertex] = numbered.block->covered[axis].test(local) ? 1 : 0;
    }
  }
}

void CubeMesher::add_triangles(LatticeBlock& block, Piece& piece) {
  for (unsigned local = 0; local < LatticeBlock::size; ++local) {
    if (!block.active.test(local)) continue;
    const LatticePlace cube = {&block, static_cast<std::uint16_t>(local)};
    const CubeLoops loops = cube_loops(lattice_.values(cube));
    for (std::size_t i = 0; i < loops.count; ++i) add_loop(cube, loops.loop(i), piece);
  }
}

void CubeMesher::add_loop(const LatticePlace& cube, std::span<const std::uint8_t> edges, Piece& piece) {
  std::array<Index, 12> vertices;
  std::array<Vec3, 12> points;
  const std::size_t n = edges.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto [axis, corner] = cube_edge(edges[k]);
    const LatticePlace place = lattice_.upper(cube, corner);
    const NumberedBlock& owner = blocks_[place.block->number];
    vertices[k] = owner.vertex(static_cast<std::size_t>(axis), place.local);
    points[k] = result_.mesh.positions[vertices[k]];
  }
  const LoopTriangles found = triangulate_loop(edges, {points.data(), n});
  for (std::size_t t = 0; t < found.count; ++t)
    for (const std::uint8_t k : found.triangles[t]) piece.corners.push_back(vertices[k]);
  if (found.count > 0) return;
  const auto middle = static_cast<Index>(piece.middles.size()) | middle_point;
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < n; ++k) mean += points[k] / static_cast<double>(n);
  piece.middles.push_back(mean);
  for (std::size_t k = 0; k < n; ++k)
    for (const Index corner : {vertices[k], vertices[(k + 1) % n], middle}) piece.corners.push_back(corner);
}

void CubeMesher::join(const std::vector<Piece>& pieces) {
  PolyMesh& mesh = result_.mesh;
  std::size_t count = 0;
  for (const Piece& piece : pieces) count += piece.corners.size();
  mesh.corners.reserve(count);
  for (const Piece& piece : pieces) {
    const auto first_middle = static_cast<Index>(mesh.positions.size());
    for (const Index corner : piece.corners)
      mesh.corners.push_back(corner < middle_point ? corner : first_middle + (corner ^ middle_point));
    mesh.positions.insert(mesh.positions.end(), piece.middles.begin(), piece.middles.end());
  }
  mesh.face_offsets.resize(count / 3 + 1);
  for (std::size_t f = 0; f < mesh.face_offsets.size(); ++f) mesh.face_offsets[f] = static_cast<Index>(3 * f);
  if (options_.covered) result_.covered.resize(mesh.positions.size(), 0);
}

}  // namespace

void make_cube_mesh(SparseLattice& lattice, const PolygonizerOptions& options, Polygonized& result,
                    Progress& progress) {
  CubeMesher(lattice, options, result).run(progress);
}

}  // namespace croquis::implicit
