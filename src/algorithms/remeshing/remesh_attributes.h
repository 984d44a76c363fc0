// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/remeshing/remesh_points.h"
#include "croquis/base/progress.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {

/// A place on the mesh given.
struct NearestScanPlace {
  Index point = no_index;     ///< of the piece's points, the one nearest to what was asked for
  Index triangle = no_index;  ///< of the view; no_index where no triangle is at the point
  std::array<double, 3> weights = {1, 0, 0};
  double distance = 0;
};

/// What is nearest to a place, among the triangles at the nearest point.
class NearestSurface {
 public:
  /// Keeps references to all.
  NearestSurface(const PolyMesh& mesh, const hole_filling::SurfaceView& view, const TriangleFans& fans,
                 const RemeshPiece& piece, const RemeshPoints& points, int threads);

  /// Thread-safe; log n.
  NearestScanPlace nearest(const Vec3& place) const;

 private:
  const PolyMesh& mesh_;
  const hole_filling::SurfaceView& view_;
  const TriangleFans& fans_;
  const RemeshPiece& piece_;
  const RemeshPoints& points_;
  implicit::PointTree tree_;
};

/// Which new vertices lie in holes that were filled, and how much is known of them.
struct HoleMarks {
  std::vector<Index> hole;        ///< per new vertex; no_index on what was given
  std::vector<float> confidence;  ///< per new vertex: 1 on what was given, else its backing
};

/// Vertices of the result that one piece has values for.
struct NewVertices {
  std::size_t first = 0, count = 0;
  std::span<const Index> piece_at;  ///< per vertex: whose surface it lies on; none: all on one
  Index piece = 0;
};

/// The vertex channels of the result, all empty: those of the mesh given but "confidence".
std::vector<AttributeChannel> channels_like(const PolyMesh& mesh);

/// Lets channels and marks have values for so many vertices: 0, and of no hole.
void make_room(std::size_t count, std::vector<AttributeChannel>& channels, HoleMarks& marks);

/// Leaves channels and marks of some vertices, and the labels of some faces. @param vertices,faces ascending
void keep_values(std::span<const Index> vertices, std::span<const Index> faces, std::vector<AttributeChannel>& channels,
                 HoleMarks& marks, std::vector<std::int32_t>& labels);

/// Sets the values of one piece's new vertices in the result's channels, interpolated in the nearest triangle
/// ("normal" is left 0: see compute_normals), and marks the vertices in holes.
/// @param made the result, whose channels and marks have room @param cell of the cubes, model units
/// @throws Cancelled
void transfer(PolyMesh& made, const NewVertices& vertices, const NearestSurface& nearest, const PolyMesh& mesh,
              const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece, const std::vector<RimPlace>& rims,
              double cell, int threads, HoleMarks& marks, Progress& progress);

/// Of a triangle, as long as twice its area.
Vec3 face_normal(const PolyMesh& mesh, std::size_t face);

/// Sets the greatest fold across the rims and the least angle of every patch that has faces, on all its holes; NaN
/// where it has none.
/// @param patches per face, -1 for none; @param patch_of per hole
void measure_patches(const PolyMesh& mesh, const std::vector<std::int32_t>& patches, const std::vector<Index>& patch_of,
                     std::vector<hole_filling::HoleOutcome>& outcomes);

/// Fills a channel "normal" of three floating numbers per vertex, if there is one, from the faces around.
void compute_normals(PolyMesh& mesh, int threads, Progress& progress);

}  // namespace croquis::remeshing
