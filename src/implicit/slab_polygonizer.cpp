// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/slab_polygonizer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "implicit/cube_layers.h"
#include "implicit/point_checks.h"
#include "implicit/sparse_lattice.h"
#include "implicit/surface_search.h"

namespace croquis::implicit {
namespace {

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

}  // namespace croquis::implicit
