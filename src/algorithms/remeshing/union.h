// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "algorithms/remeshing/shape.h"
#include "croquis/base/progress.h"

namespace croquis::remeshing {

/// A part of the joined mesh: one piece, or several that crossed and became one solid.
struct RemeshPart {
  std::vector<std::size_t> pieces;                 ///< ascending
  std::size_t first_vertex = 0, vertex_count = 0;  ///< in the joined mesh
  std::size_t first_face = 0, face_count = 0;
  std::vector<std::pair<std::size_t, Index>> patched;  ///< faces of patches, of the joined mesh, with their holes
  std::vector<Index> piece_at;  ///< per vertex, where there are several pieces: the one whose surface it lies on
  std::size_t lost = 0;         ///< places of the pieces' surfaces that the solid has no surface near, if many
  Vec3 lost_at = Vec3::Zero();  ///< one of these
  bool is_solid = false;        ///< was made of its pieces' surfaces as a solid
  bool stays = false;           ///< crosses itself, and no solid stands for it
};

/// The surface of a part.
PolyMesh surface_of(const RemeshPart& part, const PolyMesh& joined);

/// A piece that was left out of the result, since what was made of it doesn't represent it.
struct RefusedPiece {
  std::size_t piece = 0;
  double lost_share = 0;         ///< of the piece's area; 0 where that isn't the reason
  std::size_t other = no_piece;  ///< that it crosses, and that was kept
  Vec3 at = Vec3::Zero();        ///< a place where it doesn't

  static constexpr auto no_piece = static_cast<std::size_t>(-1);
};

/// All surfaces in one mesh.
struct JoinedShapes {
  PolyMesh mesh;
  std::vector<RemeshPart> parts;  ///< by their first piece
  std::size_t cuts = 0;           ///< pairs of faces that intersect all the same
  std::size_t crossings = 0;      ///< of these, the ones of different parts
  std::size_t united = 0;         ///< pieces that are one solid with others
  std::vector<RefusedPiece> left_out;
};

/// Joins the surfaces of all pieces. Those that cross each other or themselves are polygonised again as the boundary of
/// the solid that they enclose together (see UnitedSolid), which cubes' triangles can't but do without intersections;
/// the others stay as they are. Vertices inside other pieces' solids end there. Where no solid stands for its pieces
/// (see faults_of), as for sheets that have no inside, the largest of those that don't cross each other are kept.
/// @param shapes of all pieces; their meshes are taken
/// @throws Cancelled
JoinedShapes join_shapes(const RemeshModel& model, std::vector<PieceShape>& shapes, Progress progress);

}  // namespace croquis::remeshing
