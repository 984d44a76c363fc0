// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tools/pointer/screen_mesh.h"

namespace croquis {

/// Which face each cell of a grid over a part of the view shows: a small picture with faces for colours, drawn without
/// any graphics system, so it is the same everywhere.
class SeenFaces {
 public:
  /// @param region of the view, that the grid covers; not empty
  SeenFaces(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen, const PickBox& region);

  enum class Answer {
    Seen,    ///< a cell there or beside shows one of the place's own faces, or all show what lies behind it
    Hidden,  ///< all cells around show faces nearer to the eye
    Unclear  ///< too fine for the grid
  };

  /// @param own_faces that have the place
  Answer ask(const Projected& place, std::span<const Index> own_faces) const;

  /// Per face, whether a cell shows it.
  std::vector<char> faces_shown(std::size_t face_count) const;

 private:
  struct Cell {
    double depth;
    Index face;
  };

  /// A band of the picture: [first, end).
  struct Rows {
    int first, end;
  };

  Projected in_cells(const Projected& place) const;  ///< what is drawn has cells for pixels
  Rows rows_between(double top, double bottom, const Rows& rows) const;
  bool covers_cells(const std::vector<Projected>& polygon, const Rows& rows) const;
  void draw_rows(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen,
                 const std::vector<Projected>& vertices, const Rows& rows);
  void draw_face(const PolyMesh& mesh, Index face, const std::vector<Projected>& polygon, const Rows& rows);
  void draw_triangle(const Projected& a, const Projected& b, const Projected& c, Index face, const Rows& rows);
  void draw_polygon(const std::vector<Projected>& polygon, Index face, const Rows& rows);
  void put(int column, int row, double depth, Index face);

  PickBox region_;
  int columns_ = 1, rows_ = 1;
  Vec2 cells_per_pixel_ = {1, 1};
  std::vector<Cell> cells_;  ///< row by row
};

}  // namespace croquis
