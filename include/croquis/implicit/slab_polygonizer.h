// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "croquis/implicit/marching_cubes.h"

namespace croquis::implicit {

/// A mesh that grows along an axis, layer of cubes by layer.
struct LayeredMesh {
  std::vector<Vec3> positions;
  std::vector<Index> corners;         ///< three per triangle
  std::vector<std::uint8_t> covered;  ///< per vertex, or none without a predicate
  std::vector<Index> first_vertices;  ///< of every finished layer, and of the one above it
  std::vector<Index> first_corners;   ///< of every finished layer, and its end
};

/// Called while a surface is polygonised slab by slab, by the calling thread.
struct SlabEvents {
  /// The field will be asked for places in [low, high] along the axis, and hardly any others until the next call.
  std::function<void(double low, double high, Progress& progress)> enter;

  /// More layers are finished. All triangles at their vertices are there but for those with the next layer; vertices of
  /// the layer above have their positions.
  /// Positions may be rounded, nothing else changed.
  std::function<void(LayeredMesh& made, Progress& progress)> finished;

  /// What was made so far is thrown away and made again: the surface led back to a slab that was finished.
  std::function<void()> begun_anew;
};

struct SlabOptions {
  int axis = 2;                         ///< 0..2, along which slabs follow each other
  std::size_t seeds_per_slab = 50'000;  ///< slabs take layers of eight cubes until they hold so many; at least one
};

/// A surface that was polygonised slab by slab.
struct SlabPolygonized {
  LayeredMesh made;
  Polygonized report;  ///< its mesh is empty
  std::size_t slabs = 0;
  std::size_t most_bytes = 0;  ///< of lattice and vertices at a time, the mesh not counted
};

/// The same surface as polygonize finds, of which lattice, values and cubes are held for three slabs at a time alone.
/// Vertices and triangles are ordered by layers along the axis: number and thickness of slabs change no bit of them,
/// nor do threads, unless a limit is met. Slabs begin where seeds are, and follow the surface both ways; when it leads
/// back further than one slab, everything is made again, the third time in one slab.
/// @throws Error (E_PARAMETER) as polygonize; Cancelled
SlabPolygonized polygonize_by_slabs(const Field& field, std::span<const Vec3> seeds, const PolygonizerOptions& options,
                                    const SlabOptions& slabs, const SlabEvents& events, Progress& progress);

}  // namespace croquis::implicit
