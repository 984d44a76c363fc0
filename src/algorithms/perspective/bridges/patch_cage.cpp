// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/patch_cage.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "algorithms/perspective/bridges/convex_pieces.h"
#include "algorithms/perspective/bridges/nearest_on_curve.h"
#include "algorithms/perspective/solid/plane_axes.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis {
namespace {

/// Two sharp edges that turn more at a vertex have a corner there.
constexpr double corner_turn = 15 * std::numbers::pi / 180;

class PatchCageMaker {
 public:
  PatchCageMaker(const Brep& brep, const PatchCageOptions& options, Progress& progress)
      : brep_(brep), segments_(options.segments), progress_(progress) {}

  PatchCage run() {
    for (const BrepVertex& vertex : brep_.vertices) cage_.mesh.positions.push_back(vertex.point);
    for (const BrepEdge& edge : brep_.edges) {
      progress_.check();
      along_.push_back(vertices_on(edge));
    }
    for (Index f = 0; f < brep_.faces.size(); ++f) {
      progress_.check();
      brep_.faces[f].patches.empty() ? add_plane_face(f) : add_patches(brep_.faces[f]);
    }
    add_creases();
    add_sharp_cuts();
    add_pins();
    progress_.report(1);
    return std::move(cage_);
  }

 private:
  Index add_vertex(const Vec3& point) {
    cage_.mesh.positions.push_back(point);
    return static_cast<Index>(cage_.mesh.positions.size() - 1);
  }

  // ---- Edges

  bool has_patches(Index half_edge) const {
    return half_edge != no_index && !brep_.faces[brep_.face_of(half_edge)].patches.empty();
  }

  bool is_divided(const BrepEdge& edge) const {
    return !edge.straight || has_patches(edge.half_edges[0]) || has_patches(edge.half_edges[1]);
  }

  /// A place of the curve that patches are spanned from, whose middle is where they are split.
  Vec3 fitted_point(const BrepEdge& edge, std::size_t k) const {
    if (edge.fitted.size() == 1) return edge.fitted[0].at(static_cast<double>(k) / static_cast<double>(segments_));
    const std::size_t half = segments_ / 2;
    const double step = static_cast<double>(half);
    return k <= half ? edge.fitted[0].at(static_cast<double>(k) / step)
                     : edge.fitted[1].at(static_cast<double>(k - half) / step);
  }

  std::vector<Index> vertices_on(const BrepEdge& edge) {
    std::vector<Index> vertices{edge.start};
    for (std::size_t k = 1; is_divided(edge) && k < segments_; ++k)
      vertices.push_back(add_vertex(nearest_on_curve(edge.pieces, fitted_point(edge, k))));
    vertices.push_back(edge.end);
    return vertices;
  }

  std::vector<Index> vertices_along(Index half_edge) const {
    std::vector<Index> vertices = along_[brep_.half_edges[half_edge].edge];
    if (brep_.half_edges[half_edge].reversed) std::ranges::reverse(vertices);
    return vertices;
  }

  // ---- Plane faces

  std::vector<std::vector<Index>> outlines_of(const BrepFace& face) const {
    std::vector<std::vector<Index>> outlines;
    for (const Index loop : face.loops) {
      std::vector<Index>& outline = outlines.emplace_back();
      for (const Index half_edge : brep_.around(loop)) {
        const std::vector<Index> along = vertices_along(half_edge);
        outline.insert(outline.end(), along.begin(), along.end() - 1);
      }
    }
    return outlines;
  }

  void add_plane_face(Index f) {
    const BrepFace& face = brep_.faces[f];
    const std::vector<std::vector<Index>> outlines = outlines_of(face);
    const auto [u, v] = plane_axes(face.normal);
    std::vector<Vec2> places;
    std::vector<Index> vertices;
    std::map<Index, Index> numbers;
    std::vector<std::array<Index, 2>> sides;
    const auto number_of = [&](Index vertex) {
      const auto [known, is_new] = numbers.try_emplace(vertex, static_cast<Index>(vertices.size()));
      if (is_new) {
        vertices.push_back(vertex);
        places.emplace_back(u.dot(cage_.mesh.positions[vertex]), v.dot(cage_.mesh.positions[vertex]));
      }
      return known->second;
    };
    for (const std::vector<Index>& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i)
        sides.push_back({number_of(outline[i]), number_of(outline[(i + 1) % outline.size()])});
    }
    std::vector<Index> first;
    for (const Index vertex : outlines[0]) first.push_back(numbers.at(vertex));
    std::vector<std::vector<Index>> pieces;
    if (outlines.size() == 1 && make_fan(places, first)) {
      pieces = {std::move(first)};
    } else {
      const PlanarTriangulationResult plane = triangulate(places, sides);
      if (!plane.conflict.empty()) return add_crossing(f, outlines);
      pieces = convex_pieces(places, triangles_inside(plane.triangulation));
    }
    for (std::vector<Index>& piece : pieces) {
      for (Index& vertex : piece) vertex = vertices[vertex];
      cage_.mesh.add_face(piece);
      note_cuts(outlines, piece);
    }
  }

  /// The sides of a piece that aren't on the face's outlines; of the two pieces at a cut one tells it.
  void note_cuts(const std::vector<std::vector<Index>>& outlines, const std::vector<Index>& piece) {
    std::set<std::array<Index, 2>> rim;
    for (const std::vector<Index>& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) rim.insert({outline[i], outline[(i + 1) % outline.size()]});
    }
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Index a = piece[i], b = piece[(i + 1) % piece.size()];
      if (a < b && !rim.contains({a, b})) cuts_.push_back({a, b});
    }
  }

  /// Each outline a polygon of its own: closed all the same.
  void add_crossing(Index f, const std::vector<std::vector<Index>>& outlines) {
    for (const std::vector<Index>& outline : outlines) cage_.mesh.add_face(outline);
    cage_.warnings.push_back(make_warning(
        Category::Geometry, "PATCH_FOLDED",
        "The outlines of the plane face " + std::to_string(f) + " cross each other in the cage: take more segments.",
        {numbered_subject(SubjectKind::Face, f)}));
  }

  // ---- Patches

  /// The four sides of a grid, each from its corner to the next one.
  using GridSides = std::array<std::vector<Index>, 4>;

  void add_grid(const GregoryPatch& patch, const GridSides& sides) {
    const std::size_t n = sides[0].size() - 1;
    std::vector<std::vector<Index>> rows(n + 1, std::vector<Index>(n + 1));
    for (std::size_t row = 0; row <= n; ++row) {
      for (std::size_t column = 0; column <= n; ++column) {
        Index& vertex = rows[row][column];
        if (row == 0) {
          vertex = sides[0][column];
        } else if (row == n) {
          vertex = sides[2][n - column];
        } else if (column == 0) {
          vertex = sides[3][n - row];
        } else if (column == n) {
          vertex = sides[1][row];
        } else {
          const double step = 1 / static_cast<double>(n);
          vertex = add_vertex(patch.at(static_cast<double>(column) * step, static_cast<double>(row) * step).at);
        }
      }
    }
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t column = 0; column < n; ++column) {
        cage_.mesh.add_face(
            std::array{rows[row][column], rows[row][column + 1], rows[row + 1][column + 1], rows[row + 1][column]});
      }
    }
  }

  static std::vector<Index> part(const std::vector<Index>& vertices, std::size_t first, std::size_t last) {
    return {vertices.begin() + static_cast<std::ptrdiff_t>(first),
            vertices.begin() + static_cast<std::ptrdiff_t>(last + 1)};
  }

  void add_patches(const BrepFace& face) {
    std::vector<std::vector<Index>> sides;
    for (const Index half_edge : brep_.around(face.loops[0])) sides.push_back(vertices_along(half_edge));
    const std::size_t n = sides.size(), half = segments_ / 2;
    if (face.patches.size() == 1) return add_grid(face.patches[0], {sides[0], sides[1], sides[2], sides[3]});
    const Index middle = add_vertex(face.patches[0].boundary[6]);
    std::vector<std::vector<Index>> spokes;  // from the middles of sides to the middle of the face
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Index>& spoke = spokes.emplace_back();
      spoke.push_back(sides[i][half]);
      for (std::size_t k = 1; k < half; ++k)
        spoke.push_back(add_vertex(face.patches[i].at(1, static_cast<double>(k) / static_cast<double>(half)).at));
      spoke.push_back(middle);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      std::vector<Index> back(spokes[before].rbegin(), spokes[before].rend());
      add_grid(face.patches[i],
               {part(sides[i], 0, half), spokes[i], std::move(back), part(sides[before], half, segments_)});
    }
  }

  // ---- Tags

  static bool is_sharp(const BrepEdge& edge) {
    return !edge.smooth && edge.half_edges[0] != no_index && edge.half_edges[1] != no_index;
  }

  void add_creases() {
    for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
      if (!is_sharp(brep_.edges[e])) continue;
      for (std::size_t i = 0; i + 1 < along_[e].size(); ++i)
        cage_.mesh.tags.creases.push_back({{along_[e][i], along_[e][i + 1]}, infinite_sharpness});
    }
  }

  /// Around reflex corners the schemes would move points of a plane face's cuts beyond its outline. Between corners,
  /// where chains of sharp edges end anyway, a sharp cut stays where it is and changes nothing else.
  void add_sharp_cuts() {
    std::vector<int> sharp_edges(brep_.vertices.size(), 0);
    for (const BrepEdge& edge : brep_.edges) {
      if (!is_sharp(edge)) continue;
      ++sharp_edges[edge.start];
      ++sharp_edges[edge.end];
    }
    const auto is_corner = [&](Index vertex) { return vertex < sharp_edges.size() && sharp_edges[vertex] > 2; };
    for (const auto& cut : cuts_) {
      if (is_corner(cut[0]) && is_corner(cut[1])) cage_.mesh.tags.creases.push_back({cut, infinite_sharpness});
    }
  }

  /// Where more than two sharp edges meet there is a corner anyway.
  void add_pins() {
    std::map<Index, std::vector<Vec3>> leaving;
    for (const BrepEdge& edge : brep_.edges) {
      if (!is_sharp(edge)) continue;
      leaving[edge.start].push_back(edge.pieces.front().derivative(0));
      leaving[edge.end].push_back(-edge.pieces.back().derivative(1));
    }
    for (const auto& [vertex, directions] : leaving) {
      const bool turns = directions.size() == 2 && angle_between(directions[0], -directions[1]) > corner_turn;
      if (turns) cage_.mesh.tags.pins.push_back(vertex);
    }
  }

  const Brep& brep_;
  const std::size_t segments_;
  Progress& progress_;
  PatchCage cage_;
  std::vector<std::array<Index, 2>> cuts_;  ///< through plane faces
  std::vector<std::vector<Index>> along_;   ///< per edge, the vertices from its start to its end
};

}  // namespace

PatchCage make_patch_cage(const Brep& brep, const PatchCageOptions& options, Progress& progress) {
  return PatchCageMaker(brep, options, progress).run();
}

}  // namespace croquis
