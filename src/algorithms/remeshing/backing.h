// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/remeshing/field.h"
#include "croquis/hole_filling/fill_options.h"
#include "croquis/implicit/point_tree.h"

/// How a new surface lies to the scan: what of it no data backs, and what of the scan it lacks.
namespace croquis::remeshing {

/// A place on the mesh given.
struct NearestScanPlace {
  Index point = no_index;     ///< of the piece's points, the one nearest to what was asked for
  Index triangle = no_index;  ///< of the view; no_index where no triangle is at the point
  std::array<double, 3> weights = {1, 0, 0};
  double distance = 0;
};

/// A piece of the mesh given, and what of it is nearest to a place, among the triangles at the nearest point.
class NearestScan {
 public:
  /// Keeps references to all.
  NearestScan(const PolyMesh& mesh, const hole_filling::SurfaceView& view, const TriangleFans& fans,
              const RemeshPiece& piece, const RemeshPoints& points, int threads);

  /// Thread-safe; log n.
  NearestScanPlace nearest(const Vec3& place) const;

  const PolyMesh& mesh() const { return mesh_; }
  const hole_filling::SurfaceView& view() const { return view_; }
  const RemeshPiece& piece() const { return piece_; }
  int threads() const { return threads_; }

 private:
  const PolyMesh& mesh_;
  const hole_filling::SurfaceView& view_;
  const TriangleFans& fans_;
  const RemeshPiece& piece_;
  const RemeshPoints& points_;
  implicit::PointTree tree_;
  int threads_;
};

/// Where a surface that closes a piece's holes may lie: no farther from a hole's rim than 0.75 of its diameter (half a
/// sphere over its rim reaches 0.71), or from a place that it was asked to go through; and between views as far from
/// their rims as they may be apart. Each hole, with its islands, is a zone of its own.
class HoleReach {
 public:
  /// @param pieces for the rims of the whole mesh; @param edge as typical_edge; @param open holes that stay open, or
  /// are so far
  HoleReach(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece,
            const RemeshPieces& pieces, std::span<const hole_filling::HoleRequest> requests, double edge,
            std::span<const Index> open);

  /// Thread-safe. Linear in the holes, and in the rims of those that are near.
  bool contains(const Vec3& place) const;
  bool contains(const Vec3& place, Index zone) const;

  /// The zone whose rim is nearest, no farther than so much and the distance between its points; no_index: none.
  Index zone_along(const Vec3& place, double distance) const;

 private:
  struct Zone {
    std::vector<Vec3> points;  // on the rims, and to go through
    std::size_t on_rim = 0;    // of these, the first
    Eigen::AlignedBox3d box;   // of these, grown
    double reach = 0, spacing = 0;
  };
  static Zone zone_of(const PolyMesh& mesh, const std::vector<hole_filling::Hole>& holes,
                      const std::vector<Index>& group, std::span<const hole_filling::HoleRequest> requests);

  std::vector<Zone> zones_;        // the largest first
  std::vector<Vec3> seam_places_;  // vertices on rims of views
  implicit::PointTree seams_;
  double seam_reach_ = 0;
};

/// A vertex that lies off the mesh given.
struct LooseVertex {
  Index vertex = no_index;
  Vec3 foot = Vec3::Zero();  ///< the nearest place of the mesh
  double distance = 0;
};

/// What of a remeshed surface the mesh given doesn't back.
struct UnbackedVertices {
  std::vector<std::uint8_t> is_far;  ///< per vertex: 1 where it lies far from the mesh, and closes no hole
  std::size_t far_count = 0;         ///< of these
  std::vector<LooseVertex> loose;    ///< others that aren't near to the mesh, and in no hole's reach, ascending
};

/// Checks every vertex of a surface, whatever made it: how far it lies from the triangles given. What is far and hangs
/// together has to leave them along the rim of a hole, half of its border at least, and stay within that hole's reach.
/// @param near,far model units, the latter the larger one
/// @throws Cancelled
UnbackedVertices find_unbacked(const PolyMesh& surface, const NearestScan& given, const HoleReach& holes, double near,
                               double far, Progress progress);

/// Takes away what hangs on a border and has no corner that is near. @return whether there was anything
/// @throws Cancelled
bool trim_loose(PolyMesh& surface, std::span<const LooseVertex> loose, int threads, Progress& progress);

/// Moves loose vertices towards their feet until they are near, but where the surface would cut through itself.
/// @param loose of the surface; what is left of them stays
/// @throws Cancelled
void bring_near(PolyMesh& surface, std::vector<LooseVertex>& loose, double near, hole_filling::Precision precision,
                Progress& progress);

/// The vertices of a surface that are farther than so much from all triangles given, ascending.
/// @throws Cancelled
std::vector<Index> far_from_scan(const PolyMesh& surface, const PolyMesh& mesh, const hole_filling::SurfaceView& view,
                                 double distance, int threads, Progress& progress);

/// Of the area of a surface, 0..1. @param vertices ascending
double share_of_faces_at(const PolyMesh& surface, std::span<const Index> vertices);

/// Share of a piece's area that a surface has nothing near to. @param lost of the points, ascending
double lost_share(const PolyMesh& mesh, const hole_filling::SurfaceView& view, const RemeshPiece& piece,
                  const RemeshPoints& points, std::span<const Index> lost);

}  // namespace croquis::remeshing
