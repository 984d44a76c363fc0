// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/remeshing/remesh_pieces.h"
#include "croquis/implicit/box_weight.h"

namespace croquis::remeshing {

/// How much room a piece takes.
struct PieceRoom {
  implicit::Box box;
  std::optional<double> volume;  ///< signed; none where there are rims
  double area = 0;
};

/// Of the scan: as if flat fans closed its holes. No volume where some stay open.
PieceRoom room_of_scan(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis, const RemeshPiece& piece);

/// Of what was made of it. @param is_closed whether it has no rims
PieceRoom room_of_surface(const PolyMesh& surface, bool is_closed);

/// What the room that a piece takes differs by from the scan's.
struct RoomChange {
  double shrunk = 0;           ///< of the box, on the side where it lacks most, model units; 0 where little
  double grown = 0;            ///< the same for what it has too much
  double given = 0, made = 0;  ///< volumes, where these differ

  bool any() const { return shrunk > 0 || grown > 0 || given != made; }
};

/// Boxes may differ by two cells, and be as much larger as surfaces in holes may. Volumes may differ by a twentieth, by
/// a tenth of a cell all over the surface, and by what surfaces in holes may enclose.
RoomChange change_of(const PieceRoom& given, const PieceRoom& made, const hole_filling::HoleAnalysis& analysis,
                     const RemeshPiece& piece, double cell);

/// Of a solid made of several closed surfaces, or of one that crosses itself: it encloses no less than the largest of
/// them less what cavities take, or half of one alone, and no more than all of them. A twentieth and a tenth of a cell
/// all over are allowed for. Nothing where a surface isn't closed.
RoomChange change_of_solid(const std::vector<std::optional<double>>& volumes, const PolyMesh& solid, double cell);

}  // namespace croquis::remeshing
