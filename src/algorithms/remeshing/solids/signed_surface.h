// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/implicit/box_weight.h"

namespace croquis::remeshing {

/// How a place lies to a surface.
struct SignedPlace {
  double distance = 0;           ///< to the triangles; negative on the surface's inner side
  double value = 0;              ///< the same to the curved surface that they stand for
  Vec3 gradient = Vec3::Zero();  ///< of the distance, unit length
  Index triangle = no_index;     ///< that the nearest point lies on
  double out = 0;                ///< beyond a border, how far out of it; else 0
};

/// The signed distance of a surface of triangles. The side is that of the normal at the nearest point: of its triangle,
/// of both at an edge, of all at a vertex, weighted by angles (Baerentzen, Aanaes 2005), which is right everywhere when
/// the surface is closed. Beyond a border the surface goes on as it ends.
///
/// Where it is smooth a curved surface is meant, given by the vertices and their normals: half of what the tangent
/// planes at a triangle's corners lie above it, weighted as the foot, is what quadratic surfaces lie above it.
class SignedSurface {
 public:
  /// @param mesh manifold triangles, at least one; a copy is kept
  /// @throws Cancelled
  SignedSurface(const PolyMesh& mesh, int threads, Progress& progress);

  /// Thread-safe; log n near the surface.
  /// @param within faster when the surface is known to be as near as this
  SignedPlace at(const Vec3& place, double within = std::numeric_limits<double>::infinity()) const;

  const PolyMesh& mesh() const { return mesh_; }
  const implicit::Box& box() const { return box_; }
  bool is_closed() const { return is_closed_; }

  /// Signed: negative when the surface looks inwards. With borders as if cones over the middle of the box closed it.
  double volume() const { return volume_; }

 private:
  Vec3 normal_of(Index triangle) const;
  Vec3 across(Index corner, bool& is_border) const;
  void find_vertex_normals(int threads, Progress& progress);
  void find_smooth_places();
  double bulge(Index triangle, const Vec3& foot) const;
  void find_ways_out(const Progress& progress);

  PolyMesh mesh_;
  TriangleFans fans_;
  TriangleTree tree_;
  implicit::Box box_;
  std::vector<Vec3> normals_;  // of the vertices, unit
  std::vector<float> smooth_;  // per vertex: 1 where its triangles look about the same way, 0 at creases
  std::vector<Vec3> outs_;     // of the vertices: out of the border there, not unit, 0 inside; or none
  bool is_closed_ = true;
  double volume_ = 0;
};

}  // namespace croquis::remeshing
