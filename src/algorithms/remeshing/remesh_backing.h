// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_attributes.h"
#include "croquis/hole_filling/hole_request.h"

namespace croquis::remeshing {

/// Where a surface that closes a piece's holes may lie: no farther from a hole's rim than 0.75 of its diameter (half a
/// sphere over its rim reaches 0.71), or from a place that it was asked to go through.
class HoleReach {
 public:
  HoleReach(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece,
            std::span<const hole_filling::HoleRequest> requests);

  /// Thread-safe. Linear in the holes, and in the rims of those that are near.
  bool contains(const Vec3& place) const;

  double area() const { return area_; }  ///< that surfaces in all holes together may have

 private:
  struct Zone {
    std::vector<Vec3> points;  // on the rims
    Eigen::AlignedBox3d box;   // of these, grown
    double reach = 0;
  };

  std::vector<Zone> zones_;  // the largest first
  double area_ = 0;
};

/// What of a remeshed surface the mesh given doesn't back.
struct Strays {
  std::vector<std::uint8_t> vertices;  ///< per vertex: 1 where it lies far from the mesh, in no hole's reach
  std::size_t count = 0;               ///< of these
  double hole_area = 0;                ///< of faces far from the mesh in the reach of holes
  bool overfills = false;              ///< that is more than holes explain

  bool any() const { return count > 0 || overfills; }
};

/// Checks every vertex of a surface, whatever made it: how far from the triangles given it lies. Far is more than two
/// cells or mean edges, whichever are longer. The distance is to the triangles at the nearest vertex or sample: never
/// less than the least.
/// @throws Cancelled
Strays find_strays(const PolyMesh& surface, const NearestSurface& given, const HoleReach& holes, double far,
                   int threads, Progress& progress);

/// Share of a piece's area that a surface has nothing near to. @param lost of the points, ascending
double lost_share(const PolyMesh& mesh, const hole_filling::SurfaceView& view, const RemeshPiece& piece,
                  const RemeshPoints& points, std::span<const Index> lost);

}  // namespace croquis::remeshing
