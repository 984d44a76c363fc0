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
#include "croquis/geometry/cage_builder.h"
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
    for (const BrepVertex& vertex : brep_.vertices) builder_.mesh.positions.push_back(vertex.point);
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
    builder_.add_pins(corner_turn);
    progress_.report(1);
    return {std::move(builder_.mesh), std::move(warnings_)};
  }

 private:
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
      vertices.push_back(builder_.add_vertex(nearest_on_curve(edge.pieces, fitted_point(edge, k))));
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
        places.emplace_back(u.dot(builder_.mesh.positions[vertex]), v.dot(builder_.mesh.positions[vertex]));
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
      builder_.mesh.add_face(piece);
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
    for (const std::vector<Index>& outline : outlines) builder_.mesh.add_face(outline);
    warnings_.push_back(make_warning(
        Category::Geometry, "PATCH_FOLDED",
        "The outlines of the plane face " + std::to_string(f) + " cross each other in the cage: take more segments.",
        {numbered_subject(SubjectKind::Face, f)}));
  }

  // ---- Patches

  void add_patches(const BrepFace& face) {
    std::vector<CageBuilder::Row> sides;
    for (const Index half_edge : brep_.around(face.loops[0])) sides.push_back(vertices_along(half_edge));
    const auto& patches = face.patches;
    if (patches.size() == 1) {
      builder_.add_grid({sides[0], sides[1], sides[2], sides[3]},
                        [&](double u, double v) { return patches[0].at(u, v).at; });
    } else {
      builder_.add_star(sides, patches[0].boundary[6],
                        [&](std::size_t corner, double u, double v) { return patches[corner].at(u, v).at; });
    }
  }

  // ---- Tags

  static bool is_sharp(const BrepEdge& edge) {
    return !edge.smooth && edge.half_edges[0] != no_index && edge.half_edges[1] != no_index;
  }

  void add_creases() {
    for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
      const BrepEdge& edge = brep_.edges[e];
      if (is_sharp(edge))
        builder_.add_crease(along_[e], edge.pieces.front().derivative(0), edge.pieces.back().derivative(1));
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
      if (is_corner(cut[0]) && is_corner(cut[1])) builder_.mesh.tags.creases.push_back({cut, infinite_sharpness});
    }
  }

  const Brep& brep_;
  const std::size_t segments_;
  Progress& progress_;
  CageBuilder builder_;
  Findings warnings_;
  std::vector<std::array<Index, 2>> cuts_;  ///< through plane faces
  std::vector<std::vector<Index>> along_;   ///< per edge, the vertices from its start to its end
};

}  // namespace

PatchCage make_patch_cage(const Brep& brep, const PatchCageOptions& options, Progress& progress) {
  return PatchCageMaker(brep, options, progress).run();
}

}  // namespace croquis
