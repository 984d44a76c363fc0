// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/implicit/partition_of_unity.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::implicit {

/// All points of a field, and what a domain takes of them.
class DomainPoints {
 public:
  DomainPoints(std::span<const Vec3> positions, std::span<const Vec3> normals, const DomainOptions& options,
               Progress& progress);

  /// The points in the box, with their normals or, for kernels without gradients, their offset points: if fewer than
  /// min_points, the nearest to its middle instead; if more than `most`, thinned.
  Constraints of(const Box& box, std::size_t most) const;

  /// True when the box holds more than `most` points on the surface.
  bool holds_more_than(std::size_t most, const Box& box) const { return tree_.holds_more_than(most, box); }

  std::span<const Vec3> positions() const { return positions_; }
  std::size_t bytes() const;

 private:
  void make_offsets();

  DomainOptions options_;
  std::vector<Vec3> own_positions_, own_normals_;  // none when they are borrowed
  std::span<const Vec3> positions_, normals_;
  PointTree tree_;
  Constraints offsets_;                    // points off the surface, behind those on it
  std::vector<std::size_t> first_offset_;  // #N+1 into offsets_, or none
};

}  // namespace croquis::implicit
