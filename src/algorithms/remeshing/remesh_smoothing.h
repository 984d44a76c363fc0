// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/remeshing/remesh_improvement.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/implicit/slab_polygonizer.h"

namespace croquis::remeshing {

/// Rounds of smoothing with projection (Yoo 2005, eq. 9) that run over a mesh one behind the other, from its first
/// vertex to its last: each as far as the one before allows. So they need the field in one place at a time, and the
/// result is that of rounds over the whole mesh, bit by bit.
class SweptSmoothing {
 public:
  SweptSmoothing(const ImprovedField& field, const ImprovementOptions& options);

  /// Goes on as far as the layers that are finished allow. Rounds their coordinates by the options.
  void advance(implicit::LayeredMesh& made, bool is_last, Progress& progress);

  /// All of a mesh, which is there already, in as many steps as it takes not to need the field everywhere at once.
  void run(const std::vector<Vec3>& positions, const std::vector<Index>& corners, Progress& progress);

  void begin_anew();

  /// The smoothed vertices, when all have come.
  std::vector<Vec3> take();

 private:
  /// Vertices after one round. Those that no later round needs are gone.
  struct Stage {
    std::size_t first = 0;
    std::vector<Vec3> places;
    std::size_t end() const { return first + places.size(); }
    const Vec3& at(std::size_t vertex) const { return places[vertex - first]; }
  };

  /// The mesh around the vertices under way.
  struct Window {
    std::span<const Vec3> raw;
    const TriangleFans& fans;
    Index first = 0;  // vertex of the mesh that is the fans' first
  };

  void advance(const Window& window, std::span<const Index> bounds, bool is_last, Progress& progress);
  void advance_stage(std::size_t stage, std::size_t end, const Window& window, Progress& progress);
  const Vec3& before(std::size_t stage, std::size_t vertex, const Window& window) const;
  Vec3 centroid(std::size_t stage, std::size_t vertex, const Window& window) const;
  void drop_what_is_done(std::span<const Index> bounds);
  void forget(double lowest) const;

  const ImprovedField& field_;
  const ImprovementOptions& options_;
  std::vector<Stage> stages_;
  std::size_t rounded_ = 0;
};

}  // namespace croquis::remeshing
