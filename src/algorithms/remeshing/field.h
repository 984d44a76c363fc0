// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/remeshing/pieces.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/implicit/partition_of_unity.h"

namespace croquis::remeshing {

/// Vertices (or triangles) that one thread takes at a time: enough that dividing the work costs little.
inline constexpr std::size_t vertices_per_part = 4096;

/// The places that a piece's function goes through.
struct RemeshPoints {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;     ///< unit, outwards; 0 where unknown
  std::vector<Index> triangles;  ///< of the view: of points behind the piece's vertices, the one they were taken from
};

/// The scale of models of few triangles, × their diagonal: cubes as large as their edges would find nothing.
inline constexpr double longest_typical_edge = 0.025;

inline constexpr double longest_edge = 2.5;    ///< × typical edge: longer ones get points
inline constexpr double sample_spacing = 1.5;  ///< of these, × typical edge

/// Mean length of the view's edges, model units, or longest_typical_edge where that is less; edges of two triangles
/// count twice. Linear.
double typical_edge(const PolyMesh& mesh, const hole_filling::SurfaceView& view);

/// Unit normals of the view's vertices by their sound triangles, weighted by angles, and by quadrics at chosen rims; 0
/// where there is neither.
std::vector<Vec3> vertex_normals(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                                 const TriangleFans& fans, const RemeshPieces& pieces, int threads, Progress& progress);

/// The piece's vertices in their order, then places on triangles with edges far longer than most, so that large flat
/// faces are held in their middle as well.
/// @param edge as typical_edge
RemeshPoints points_of(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece,
                       const std::vector<Vec3>& normals, double edge);

/// How space is cut into domains (Yoo 2005, section 3) and fitted: see remesh_preset for what presets change.
implicit::DomainOptions domain_options(const RemeshOptions& options, double edge);

/// Boxes around the holes of each of a piece's groups: that of its rims, larger on every side by `growth` × the largest
/// rim's diameter, with 400 centres at most, the sparser the farther from the rims. None under Preset::Paper.
/// @throws Cancelled
std::vector<implicit::ExtraDomain> hole_domains(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                                                const RemeshPiece& piece, const std::vector<Vec3>& normals,
                                                const RemeshOptions& options, double growth, const Progress& progress);

}  // namespace croquis::remeshing
