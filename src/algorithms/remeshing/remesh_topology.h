// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "algorithms/remeshing/remesh_pieces.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/triangle_fans.h"

namespace croquis::remeshing {

/// What no deformation changes of a surface.
struct SurfaceTopology {
  std::size_t components = 0;
  std::int64_t euler = 0;  ///< as if every rim were closed by a disc: 2 for a ball, 0 with one handle

  friend bool operator==(const SurfaceTopology&, const SurfaceTopology&) = default;
};

/// How far apart two are: components and handles, counted.
std::size_t difference(const SurfaceTopology& a, const SurfaceTopology& b);

/// What a piece is once its chosen holes are closed; nothing where the mesh given isn't clear about it: non-manifold
/// edges, fans that share a vertex, sides that don't agree.
/// @param links of the vertices of the view
std::optional<SurfaceTopology> wanted_topology(const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece,
                                               std::span<const TriangleFans::Link> links);

/// What a piece's triangles and closed holes imply where wanted_topology has nothing to say: one part, with the handles
/// that its sheets have by themselves, fans that share a vertex taken apart and edges of many triangles cut, and those
/// that holes closed together add. Views that are joined add none: what only several show together is for the user to
/// judge. Nothing where a sheet has one side. Near-linear.
std::optional<SurfaceTopology> implied_topology(const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece);

/// Of triangles; parts that only share a vertex count as they are.
/// @throws Cancelled
SurfaceTopology topology_of(const PolyMesh& mesh, int threads, Progress& progress);

/// A vertex of the connected part with the fewest vertices; at least one triangle is needed.
Vec3 place_of_smallest_part(const PolyMesh& mesh);

}  // namespace croquis::remeshing
