// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/remeshing/comparison.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/implicit/field.h"
#include "croquis/implicit/marching_cubes.h"

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
  /// @param mesh manifold triangles, at least one, no channels
  /// @throws Cancelled
  SignedSurface(PolyMesh mesh, const Progress& progress);

  /// Thread-safe; log n near the surface.
  /// @param within faster when the surface is known to be as near as this
  SignedPlace at(const Vec3& place, double within = std::numeric_limits<double>::infinity()) const;

  const PolyMesh& mesh() const { return mesh_; }
  const implicit::Box& box() const { return extent_.box; }
  bool is_closed() const { return outs_.empty(); }

  /// Signed: negative when the surface looks inwards. With borders as if cones over the middle of the box closed it.
  double volume() const { return *extent_.volume; }

  /// How often the surface goes round a place, 1 within a closed one (Jacobson, Kavan, Sorkine-Hornung 2013); linear.
  double winding_number(const Vec3& place) const;

 private:
  Vec3 normal_of(Index triangle) const;
  Vec3 across(Index corner, bool& is_border) const;
  double bulge(Index triangle, const Vec3& foot) const;

  PolyMesh mesh_;
  TriangleFans fans_;
  TriangleTree tree_;
  PieceExtent extent_;
  std::vector<Vec3> normals_;  // of the vertices, unit
  std::vector<float> smooth_;  // per vertex: 1 where its triangles look about the same way, 0 at creases
  std::vector<Vec3> outs_;     // of the vertices: out of the border there, not unit, 0 inside; none of closed surfaces
};

using SolidMembers = std::vector<const SignedSurface*>;

/// Several surfaces as one solid: the union of what they enclose, less the cavities of those that look inwards.
///
/// A cavity belongs to the smallest body that it lies in, and is taken out of that one alone. Cavities without a body
/// are all in one that is larger than everything. Surfaces with borders count as bodies that end there, or as cavities
/// where they look inwards in a body.
class UnitedSolid {
 public:
  /// @param members at least one; must outlive this @param cell the scale of what happens at borders, model units
  UnitedSolid(const SolidMembers& members, double cell);

  struct Place {
    double value = 0;  ///< negative inside; the distance of the member that decides here, or less where that is far
    Vec3 gradient = Vec3::Zero();
    Index member = no_index;  ///< that decides here
  };

  /// Thread-safe; log n near the surfaces.
  Place at(const Vec3& place) const;

  /// Of many places at once, on several threads.
  std::vector<Place> at(std::span<const Vec3> places, int threads, Progress progress) const;

  /// This as a field. It must outlive what it returns.
  implicit::Field field() const;

  /// Where borders cut the field off: places on its surface where no member is. Empty when all are closed.
  implicit::Covered covered() const;

  implicit::Box box() const;

 private:
  struct Solid {
    Index body = no_index;  // none: all of space
    std::vector<Index> cavities;
  };

  Place at_member(Index member, const Vec3& place, bool is_cavity) const;
  bool lies_in(Index cavity, Index body) const;

  const SolidMembers& members_;
  double cell_;
  std::vector<Solid> solids_;
};

/// Share of a surface's area that what is made of it may lack; more is another surface.
inline constexpr double most_lost = 0.1;

/// How a mesh compares with the surfaces that it was made of as one solid.
struct UnionFaults {
  bool leaves_members = true;       ///< a vertex lies farther than two cells from all of them
  std::vector<std::size_t> losing;  ///< members of which more than a tenth has no vertex within 1.25 cells

  bool none() const { return !leaves_members && losing.empty(); }
};

/// What lies in another member isn't lost. A surface with borders encloses what it goes more than half around. Where
/// all are closed their inside is no guess, and nothing is asked.
/// @throws Cancelled
UnionFaults faults_of(const PolyMesh& made, const SolidMembers& members, double cell, int threads, Progress progress);

}  // namespace croquis::remeshing
