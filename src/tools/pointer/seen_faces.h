// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/parallel.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// Threads that a query may use: all of the machine's, up to a few.
inline int query_threads() {
  constexpr std::size_t most_query_threads = 8;
  return static_cast<int>(std::min(thread_count(0), most_query_threads));
}

/// Where a view shows an edge, or the part of it before the eye.
struct ScreenSegment {
  Projected a, b;
  double weight_a = 1, weight_b = 1;  ///< the clip coordinate w at both ends
  double from = 0, to = 1;            ///< the part of the edge

  /// What part of the edge a part 0..1 of the segment on the screen stands for.
  double on_edge(double on_screen) const;
  Projected at(double on_screen) const;
};

/// The edge from a place to another, cut at the near plane; nothing when all of it lies before that.
std::optional<ScreenSegment> project_segment(const ViewFrame& frame, const Vec3& a, const Vec3& b);

/// All vertices of a mesh as a view shows them.
struct ScreenMesh {
  std::vector<Projected> vertices;  ///< #V
  std::vector<char> shown;          ///< #V, 0 before the near plane or behind the eye: then the place means nothing

  ScreenMesh(const PolyMesh& mesh, const ViewFrame& frame);

  /// Upright bounds of what is shown; nothing when nothing is.
  std::optional<PickBox> bounds() const;
};

/// A face as a view shows it, cut at the near plane: empty, or at least three corners.
void project_face(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen, Index face,
                  std::vector<Projected>& polygon);

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
