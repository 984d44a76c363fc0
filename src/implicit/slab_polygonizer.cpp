// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/slab_polygonizer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "croquis/base/parallel.h"
#include "croquis/implicit/marching_cubes.h"
#include "implicit/cube_loops.h"
#include "implicit/point_checks.h"
#include "implicit/surface_search.h"

namespace croquis::implicit {
namespace {

/// Makes the mesh of a lattice layer by layer: of every layer the vertices on its crossed edges, in the order of its
/// blocks' places, then those in the middles of loops; triangles in the order of blocks and cubes.
class CubeLayers {
 public:
  /// @param made gets vertices and triangles
  CubeLayers(SparseLattice& lattice, const PolygonizerOptions& options, LayeredMesh& made);

  /// The next layer's vertices; layers come without gaps. Nothing more may be found in it.
  void place(int layer, Progress& progress);

  /// Triangles of the layer before the one that was placed last, or of that one when there is nothing above.
  void finish(Progress& progress);

  /// Held beside the mesh.
  std::size_t bytes() const;

 private:
  /// A block with the numbers of its vertices in their layer.
  struct NumberedBlock {
    LatticeBlock* block;
    std::array<Index, 3 * BlockBits::word_count> first = {};  // vertex of every word's first edge

    Index vertex(std::size_t axis, unsigned local) const;
  };

  /// What one part of the blocks gives.
  struct Piece {
    std::vector<std::uint32_t> corners;  // three per triangle: a vertex of this layer, the next one's, or a middle
    std::vector<Vec3> middles;
  };

  struct Layer {
    int number = 0;
    std::vector<NumberedBlock> blocks;
    std::vector<Vec3> points;
    std::vector<std::uint8_t> covered;
  };

  Layer numbered(int layer);
  void place_vertices(const NumberedBlock& numbered, Layer& layer);
  void add_triangles(LatticeBlock& block, Piece& piece);
  void add_loop(const LatticePlace& cube, std::span<const std::uint8_t> edges, Piece& piece);
  void append_points(const Layer& layer);

  SparseLattice& lattice_;
  const PolygonizerOptions& options_;
  LayeredMesh& made_;
  Layer below_, above_;  // the layer to be finished next and the one after it
  bool has_below_ = false;
};

constexpr std::size_t blocks_per_part = 16;  // blocks per part

// Corners of triangles until their layers' numbers are known.
constexpr Index of_next_layer = Index{1} << 30;
constexpr Index of_middles = Index{1} << 31;
constexpr Index number_bits = of_next_layer - 1;

std::array<std::int32_t, 3> reversed(const LatticeBlock& block) {
  return {block.first[2], block.first[1], block.first[0]};
}

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

using Cube = std::array<std::int64_t, 3>;

constexpr std::size_t check_after = 65536;  // seeds
constexpr int most_tries = 3;               // the last in one slab
constexpr double reserve = 1.05;            // of the room for vertices and triangles that the seeds so far suggest
constexpr int lowest = std::numeric_limits<int>::min();
constexpr int highest = std::numeric_limits<int>::max();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr int no_layer = -1;                // of seeds below everything
constexpr int beyond_layers = 4194304 / 8;  // and above

/// Seeds by the layers that they lie in.
class Seeds {
 public:
  Seeds(std::span<const Vec3> seeds, const SparseLattice& lattice, const Progress& progress) : order_(seeds.size()) {
    std::vector<int> layers(seeds.size());
    int last = no_layer;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (i % check_after == 0) progress.check();
      layers[i] = std::clamp(lattice.layer_of(lattice.cube_at(seeds[i])), no_layer, beyond_layers);
      last = std::max(last, layers[i]);
    }
    first_.assign(static_cast<std::size_t>(last - no_layer) + 2, 0);
    for (const int layer : layers) ++first_[place(layer) + 1];
    for (std::size_t l = 1; l < first_.size(); ++l) first_[l] += first_[l - 1];
    std::vector<std::size_t> next = first_;
    for (std::size_t i = 0; i < seeds.size(); ++i) order_[next[place(layers[i])]++] = static_cast<Index>(i);
  }

  /// First layers beyond slabs of so many seeds, the last one unbounded.
  std::vector<int> ends(std::size_t seeds_per_slab) const {
    std::vector<int> ends;
    std::size_t begin = 0;
    for (std::size_t l = 1; l + 1 < first_.size(); ++l) {
      if (first_[l + 1] == first_[l] || first_[l] - begin < seeds_per_slab) continue;
      ends.push_back(static_cast<int>(l) + no_layer);
      begin = first_[l];
    }
    ends.push_back(highest);
    return ends;
  }

  /// Those in layers below `end` that weren't taken before.
  std::vector<Vec3> take_until(int end, std::span<const Vec3> seeds) {
    const std::size_t last = std::min(place(end), first_.size() - 1);
    std::vector<Vec3> taken;
    for (; next_ < first_[last]; ++next_) taken.push_back(seeds[order_[next_]]);
    return taken;
  }

  double share_taken() const { return static_cast<double>(next_) / static_cast<double>(order_.size()); }
  void begin_anew() { next_ = 0; }

 private:
  static std::size_t place(int layer) { return static_cast<std::size_t>(std::int64_t{layer} - no_layer); }

  std::vector<Index> order_;
  std::vector<std::size_t> first_;  // into order_, of every layer from no_layer on, and the end
  std::size_t next_ = 0;
};

/// One pass through all slabs.
class Sweep {
 public:
  Sweep(const Field& field, const PolygonizerOptions& options, int axis, const SlabEvents& events,
        SlabPolygonized& result)
      : options_(options),
        events_(events),
        result_(result),
        lattice_(options.origin, options.cell, options.bounds, axis),
        search_(lattice_, field, options, result.report),
        layers_(lattice_, options, result.made) {}

  /// @param more cubes to begin at as well @return false when the surface led back too far: see missed()
  bool run(std::span<const Vec3> all, Seeds& seeds, const std::vector<Cube>& more, const std::vector<int>& ends,
           Progress& progress);
  const std::vector<Cube>& missed() const { return search_.missed(); }

 private:
  void search(std::span<const Vec3> seeds, const std::vector<Cube>& more, int open, int begin, int end,
              Progress& progress);
  void make_layers(int end, Progress& progress);
  void make_last(Progress& progress);
  void make_room_for_all();
  void make_room(double share);

  const PolygonizerOptions& options_;
  const SlabEvents& events_;
  SlabPolygonized& result_;
  SparseLattice lattice_;
  SurfaceSearch search_;
  CubeLayers layers_;
  std::optional<int> next_;  // layer to be placed
};

bool Sweep::run(std::span<const Vec3> all, Seeds& seeds, const std::vector<Cube>& more, const std::vector<int>& ends,
                Progress& progress) {
  int open = lowest, begin = lowest;  // of the slab before and of this one
  for (const int end : ends) {
    Progress slab = progress.step("polygonize", 1 / static_cast<double>(ends.size()));
    const double share = seeds.share_taken();
    search(seeds.take_until(end, all), more, open, begin, end, slab);
    if (options_.only_complete && !result_.report.complete()) return true;
    if (!missed().empty()) return false;
    result_.most_bytes = std::max(result_.most_bytes, lattice_.bytes() + layers_.bytes());
    if (ends.size() == 1) make_room_for_all();
    Progress making = slab.step("mesh", 0.1);
    make_layers(begin, making);
    make_room(share);
    if (events_.finished && next_) events_.finished(result_.made, slab);
    if (result_.report.reached_max_cells) break;
    open = begin;
    begin = end;
  }
  make_last(progress);
  if (events_.finished && next_) events_.finished(result_.made, progress);
  return true;
}

void Sweep::search(std::span<const Vec3> seeds, const std::vector<Cube>& more, int open, int begin, int end,
                   Progress& progress) {
  if (events_.enter) {
    Progress entering = progress.step("enter slab", 0.4);
    const double from = begin == lowest ? -infinite : lattice_.bottom(begin);
    const double to = end == highest ? infinite : lattice_.bottom(end) + options_.cell;
    events_.enter(from, to, entering);
  }
  std::vector<Cube> cubes;
  for (const Cube& cube : more) {
    const int layer = lattice_.layer_of(cube);
    if (layer >= begin && layer < end) cubes.push_back(cube);
  }
  Progress searching = progress.step("search", events_.enter ? 0.4 : 0.8);
  search_.run_slab(seeds, cubes, open, end, searching);
}

/// Places and finishes layers below `end`; the last of them isn't finished, as what is above may still change.
void Sweep::make_layers(int end, Progress& progress) {
  const SparseLattice::Layers& layers = lattice_.layers();
  if (!next_ && !layers.empty() && layers.begin()->first < end) {
    next_ = layers.begin()->first;
    layers_.place((*next_)++, progress);
  }
  if (!next_) return;
  for (; *next_ < end && *next_ <= layers.rbegin()->first; ++*next_) {
    progress.check();
    Progress silent = progress.silent();
    layers_.place(*next_, silent);
    layers_.finish(silent);
    lattice_.drop(*next_ - 1);
  }
}

void Sweep::make_last(Progress& progress) {
  make_layers(highest, progress);
  Progress silent = progress.silent();
  if (next_) layers_.finish(silent);
}

/// All cubes are known: a closed surface has as many vertices as they are, and twice as many triangles.
void Sweep::make_room_for_all() {
  const auto expected = static_cast<std::size_t>(reserve * static_cast<double>(result_.report.cells));
  result_.made.positions.reserve(expected);
  result_.made.corners.reserve(6 * expected);
}

void Sweep::make_room(double share) {
  LayeredMesh& made = result_.made;
  if (!(share > 0)) return;
  const auto expected = [&](std::size_t count) {
    return static_cast<std::size_t>(reserve * static_cast<double>(count) / share);
  };
  made.positions.reserve(expected(made.positions.size()));
  made.corners.reserve(expected(made.corners.size()));
}

constexpr std::size_t most_cells = 500'000'000;  // their vertices and corners have 32-bit numbers
constexpr int farthest_reach = 16;

}  // namespace

SlabPolygonized polygonize_by_slabs(const Field& field, std::span<const Vec3> seeds, const PolygonizerOptions& options,
                                    const SlabOptions& slabs, const SlabEvents& events, Progress& progress) {
  require_polygonizer(options);
  require_parameter(slabs.axis >= 0 && slabs.axis <= 2 && slabs.seeds_per_slab > 0, "slabs",
                    "the axis must be 0, 1 or 2, and slabs need at least one seed");
  Seeds order(seeds, SparseLattice(options.origin, options.cell, options.bounds, slabs.axis), progress);
  std::vector<Cube> more;
  for (int tried = 1;; ++tried) {
    SlabPolygonized result;
    const std::vector<int> ends = tried < most_tries ? order.ends(slabs.seeds_per_slab) : std::vector<int>{highest};
    result.slabs = ends.size();
    Sweep sweep(field, options, slabs.axis, events, result);
    Progress sweeping = progress.step("polygonize", tried == 1 ? 0.9 : 0.03);
    if (sweep.run(seeds, order, more, ends, sweeping)) return result;
    more.insert(more.end(), sweep.missed().begin(), sweep.missed().end());
    order.begin_anew();
    if (events.begun_anew) events.begun_anew();
  }
}

void require_polygonizer(const PolygonizerOptions& options) {
  require_parameter(options.max_cells <= most_cells, "max-cells", "at most 500000000 cubes are possible");
  require_parameter(options.seed_reach >= 0 && options.seed_reach <= farthest_reach, "seed-reach",
                    "it must lie between 0 and 16 cubes");
}

Polygonized polygonize(const Field& field, std::span<const Vec3> seeds, const PolygonizerOptions& options,
                       Progress& progress) {
  const SlabOptions one_slab = {2, std::numeric_limits<std::size_t>::max()};
  SlabPolygonized found = polygonize_by_slabs(field, seeds, options, one_slab, {}, progress);
  Polygonized result = std::move(found.report);
  PolyMesh& mesh = result.mesh;
  mesh.positions = std::move(found.made.positions);
  mesh.corners = std::move(found.made.corners);
  mesh.face_offsets.resize(mesh.corners.size() / 3 + 1);
  for (std::size_t f = 0; f < mesh.face_offsets.size(); ++f) mesh.face_offsets[f] = static_cast<Index>(3 * f);
  result.covered = std::move(found.made.covered);
  result.bytes = found.most_bytes + mesh.positions.capacity() * sizeof(Vec3) +
                 (mesh.corners.capacity() + mesh.face_offsets.capacity()) * sizeof(Index);
  return result;
}

}  // namespace croquis::implicit
