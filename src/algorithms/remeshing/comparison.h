// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/remeshing/pieces.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/implicit/box_weight.h"

/// What a piece of the scan is, and what was made of it: topology, box and volume.
namespace croquis::remeshing {

/// What no deformation changes of a surface.
struct SurfaceTopology {
  std::size_t components = 0;
  std::int64_t euler = 0;  ///< as if every rim were closed by a disc: 2 for a ball, 0 with one handle

  friend bool operator==(const SurfaceTopology&, const SurfaceTopology&) = default;
};

/// How far apart two are: components and handles, counted.
std::size_t difference(const SurfaceTopology& a, const SurfaceTopology& b);

/// What a piece's triangles and closed holes imply: one part, with the handles that its sheets have by themselves, fans
/// that share a vertex taken apart and edges of many triangles cut, and those that holes closed together add.
struct ExpectedTopology {
  SurfaceTopology topology;

  /// The mesh given has no non-manifold edges, no fans that share a vertex, sides that agree, and no views: else what
  /// only several sheets show together is for the user to judge.
  bool is_clear = false;
};

/// Nothing where a sheet has one side, unless the piece is clear. Near-linear.
/// @param links of the vertices of the view
std::optional<ExpectedTopology> expected_topology(const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece,
                                                  std::span<const TriangleFans::Link> links);

/// Of triangles; parts that only share a vertex count as they are.
/// @throws Cancelled
SurfaceTopology topology_of(const PolyMesh& mesh, int threads, Progress progress);

/// A vertex of the connected part with the fewest vertices; at least one triangle is needed.
Vec3 place_of_smallest_part(const PolyMesh& mesh);

/// What a piece takes up in space.
struct PieceExtent {
  implicit::Box box;
  std::optional<double> volume;  ///< signed; none where there are rims
  double area = 0;
};

/// Of the scan: as if flat fans closed its holes. No volume where some stay open.
PieceExtent extent_of_scan(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece);

/// Of what was made of it. @param is_closed whether it has no rims
PieceExtent extent_of_surface(const PolyMesh& surface, bool is_closed);

/// What the extent of a piece differs by from the scan's.
struct ExtentChange {
  double shrunk = 0;           ///< of the box, on the side where it lacks most, model units; 0 where little
  double grown = 0;            ///< the same for what it has too much
  double given = 0, made = 0;  ///< volumes, where these differ

  bool any() const { return shrunk > 0 || grown > 0 || given != made; }
};

/// Boxes may differ by two cells, and be as much larger as surfaces in holes may. Volumes may differ by a twentieth, by
/// a tenth of a cell all over the surface, and by what surfaces in holes may enclose.
ExtentChange change_of(const PieceExtent& given, const PieceExtent& made, const hole_filling::HoleAnalysis& analysis,
                       const RemeshPiece& piece, double cell);

/// Of a solid made of several closed surfaces, or of one that crosses itself: it encloses no less than the largest of
/// them less what cavities take, or half of one alone, and no more than all of them. A twentieth and a tenth of a cell
/// all over are allowed for. Nothing where a surface isn't closed.
ExtentChange change_of_solid(const std::vector<std::optional<double>>& volumes, const PolyMesh& solid, double cell);

}  // namespace croquis::remeshing
