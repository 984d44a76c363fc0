// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// The largest cell that may be asked for, in mean edges.
inline constexpr double most_cell = 64;

/// Points of a slab. Pieces with open rims are smoothed when all slabs are done, which costs them every fit twice: they
/// are made in one slab unless memory needs more slabs.
struct SlabPoints {
  std::size_t closed = 0, open = 0;
};

/// What remeshing a model takes, in bytes, the mesh given not counted. From counts, area and edges alone.
class RemeshMemory {
 public:
  /// Linear, allocates nothing.
  RemeshMemory(const PolyMesh& mesh, const RemeshOptions& options);

  /// Without anything that has to be repaired. @param slab_points of a slab; more than there are: in one slab
  double making(double slab_points) const;

  /// With the thinnest slabs, or those asked for.
  double least() const;

  /// What cells of half the size, so many times, take more for a share of the model.
  double halving(double share, int times) const;

  /// While a share of the model is made as one solid.
  double uniting(double share) const;

  /// With everything that may be tried within the limit, or within 1.5 GB more without one.
  double most() const;

  /// Whether cells of half the size may be tried, and solids be made.
  bool may_halve(double share, int times) const;
  bool may_unite(double share) const;

  /// The usual ones, or thinner ones where these would exceed the limit.
  SlabPoints slabs() const;

  /// What cells are larger by than asked for, so that the faces aren't many times those of the scan; 1: nothing.
  double coarsening() const { return coarsening_; }

  /// Faces of the result, at most about, unless pieces are tried again.
  double faces() const { return made_; }

  /// The cell, × mean edge, with which the model fits the limit; more than 64 when none is large enough.
  double fitting_cell() const;

 private:
  double held() const;
  double under_way(double slab_points) const;
  double merging() const;

  const RemeshOptions& options_;
  double triangles_ = 0, vertices_ = 0, points_ = 0;
  double made_ = 0;  // triangles
  double coarsening_ = 1;
};

}  // namespace croquis::remeshing
