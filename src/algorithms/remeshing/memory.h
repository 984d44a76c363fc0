// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// @throws Error (E_PARAMETER) with one finding for every option out of its range
void require_options(const RemeshOptions& options);

/// What remeshing a model takes, in bytes, the mesh given not counted. From counts, area and edges alone.
class RemeshMemory {
 public:
  /// Linear, allocates nothing.
  RemeshMemory(const PolyMesh& mesh, const RemeshOptions& options);

  /// With the thinnest slabs, or those asked for, when nothing has to be tried again.
  double least() const;

  /// With everything that may be tried within the limit, or within 1.5 GB more without one.
  double most() const;

  /// @throws Error (E_MEMORY) when the least that is needed is above the limit, with the coarser cell that would fit
  void require_limit() const;

  /// Whether cells of half the size, so many times, may be tried for a share of the model, and a solid be made of it.
  bool may_halve(double share, int times) const;
  bool may_unite(double share) const;

  /// Points of a slab. Surfaces are smoothed when all slabs are done, with fits that are made anew for every round:
  /// they are made in one slab unless memory needs thinner ones. Retries, which have many more cubes, are always made
  /// in slabs.
  std::size_t slab_points(int retry) const;

  /// What cells are larger by than asked for, so that the faces aren't many times those of the scan; 1: nothing.
  double coarsening() const { return coarsening_; }

  /// Faces of the result, at most about, unless pieces are tried again.
  double faces() const { return made_; }

 private:
  double held() const;
  double under_way(double slab_points) const;
  double making(double slab_points) const;
  double halving(double share, int times) const;
  double uniting(double share) const;
  double merging() const;
  double fitting_cell() const;

  const RemeshOptions& options_;
  double limit_ = 0;
  double triangles_ = 0, points_ = 0;
  double made_ = 0;  // triangles
  double coarsening_ = 1;
};

/// As predicted_remesh_bytes when nothing has to be tried again, in thin slabs: the least limit that isn't refused.
std::size_t least_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options);

/// A number of bytes as it is reported.
std::size_t whole_bytes(double bytes);

}  // namespace croquis::remeshing
