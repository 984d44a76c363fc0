// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/patch_cage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/perspective/solid/plane_outlines.h"
#include "croquis/geometry/cage_builder.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/rational_cubic.h"
#include "croquis/geometry/vector.h"

namespace croquis {
namespace {

constexpr int curve_samples = 64;  // of a piece: a cubic bends too little to hide a nearer place between two
constexpr int section_steps = 40;  // of golden section: 0.618^40 of an interval
constexpr double golden = 0.6180339887498949;

double nearest_parameter(const RationalCubic& cubic, const Vec3& point, double low, double high) {
  const auto distance = [&](double t) { return (cubic.at(t) - point).squaredNorm(); };
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = distance(left), at_right = distance(right);
  for (int step = 0; step < section_steps; ++step) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = distance(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = distance(right);
    }
  }
  return (low + high) / 2;
}

/// The place of a curve of one or more pieces that is nearest to a point: on the curve to rounding, nearest to about
/// 1e-8 of its length.
Vec3 nearest_on_curve(const std::vector<RationalCubic>& pieces, const Vec3& point) {
  const RationalCubic* best = &pieces.front();
  int best_sample = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const RationalCubic& piece : pieces) {
    for (int i = 0; i <= curve_samples; ++i) {
      const double distance = (piece.at(static_cast<double>(i) / curve_samples) - point).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      best = &piece;
      best_sample = i;
    }
  }
  const double low = static_cast<double>(std::max(best_sample - 1, 0)) / curve_samples;
  const double high = static_cast<double>(std::min(best_sample + 1, curve_samples)) / curve_samples;
  return best->at(nearest_parameter(*best, point, low, high));
}

constexpr double straight_sine = 1e-7;  // corners that turn to the right by less are straight

bool is_convex_corner(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 arriving = at - before, leaving = after - at;
  return cross(arriving, leaving) >= -straight_sine * arriving.norm() * leaving.norm();
}

bool is_convex(std::span<const Vec2> points, std::span<const Index> polygon) {
  const std::size_t n = polygon.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &before = points[polygon[i]], &at = points[polygon[(i + 1) % n]], &after = points[polygon[(i + 2) % n]];
    if (!is_convex_corner(before, at, after)) return false;
    const Vec2 arriving = at - before, leaving = after - at;
    turned += std::atan2(cross(arriving, leaving), arriving.dot(leaving));
  }
  return turned > 0 && turned < 7;  // once around, not twice
}

/// Whether the triangles from the polygon's first corner to all sides have an area.
bool sees_all_sides(std::span<const Vec2> points, std::span<const Index> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = points[polygon[i]] - points[polygon[0]], b = points[polygon[i + 1]] - points[polygon[0]];
    if (cross(a, b) <= straight_sine * a.norm() * b.norm()) return false;
  }
  return true;
}

bool begin_at_fan(std::span<const Vec2> points, std::vector<Index>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (sees_all_sides(points, polygon)) return true;
    std::ranges::rotate(polygon, polygon.begin() + 1);
  }
  return false;
}

class PieceMerger {
 public:
  PieceMerger(std::span<const Vec2> points, std::span<const std::array<Index, 3>> triangles) : points_(points) {
    for (const auto& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) piece_of_[{triangle[i], triangle[(i + 1) % 3]}] = pieces_.size();
      pieces_.emplace_back(triangle.begin(), triangle.end());
    }
  }

  std::vector<std::vector<Index>> run() {
    for (const Diagonal& diagonal : diagonals()) remove(diagonal[0], diagonal[1]);
    std::erase_if(pieces_, [](const auto& piece) { return piece.empty(); });
    return std::move(pieces_);
  }

 private:
  using Diagonal = std::array<Index, 2>;

  /// The longest first; equal ones in the order of their vertices.
  std::vector<Diagonal> diagonals() const {
    std::vector<std::tuple<double, Index, Index>> found;
    for (const auto& [side, piece] : piece_of_) {
      const auto [a, b] = side;
      if (a < b && piece_of_.contains({b, a})) found.emplace_back(-(points_[a] - points_[b]).norm(), a, b);
    }
    std::ranges::sort(found);
    std::vector<Diagonal> result;
    for (const auto& [length, a, b] : found) result.push_back({a, b});
    return result;
  }

  /// The piece's vertices from b on, round to a: those of its side (a, b) are last and first.
  std::vector<Index> from_side(const std::vector<Index>& piece, Index a, Index b) const {
    std::vector<Index> result = piece;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i] != a || piece[(i + 1) % piece.size()] != b) continue;
      std::ranges::rotate(result, result.begin() + static_cast<std::ptrdiff_t>((i + 1) % piece.size()));
      break;
    }
    return result;
  }

  void remove(Index a, Index b) {
    const std::size_t left = piece_of_.at({a, b}), right = piece_of_.at({b, a});
    if (left == right) return;
    const std::vector<Index> first = from_side(pieces_[left], a, b);    // b … a
    const std::vector<Index> second = from_side(pieces_[right], b, a);  // a … b
    const bool convex = is_convex_corner(points_[second[second.size() - 2]], points_[b], points_[first[1]]) &&
                        is_convex_corner(points_[first[first.size() - 2]], points_[a], points_[second[1]]);
    if (!convex) return;
    std::vector<Index> joined = first;
    joined.insert(joined.end(), second.begin() + 1, second.end() - 1);
    if (std::set<Index>(joined.begin(), joined.end()).size() < joined.size()) return;
    if (!begin_at_fan(points_, joined)) return;
    for (std::size_t i = 0; i + 1 < second.size(); ++i) piece_of_[{second[i], second[i + 1]}] = left;
    piece_of_.erase({a, b});
    piece_of_.erase({b, a});
    pieces_[left] = std::move(joined);
    pieces_[right].clear();
  }

  std::span<const Vec2> points_;
  std::vector<std::vector<Index>> pieces_;
  std::map<std::array<Index, 2>, std::size_t> piece_of_;  ///< by the directed side
};

/// Convex polygons made of triangles: diagonals are taken away, the longest first, as long as what is joined stays
/// convex and has each vertex once (Hertel and Mehlhorn 1983: at most four times as many pieces as need be), and can
/// begin at a corner that sees all its other sides: the fan from there, as meshes are drawn and judged by, has no
/// triangle without area. Corners that are straight up to rounding count as convex. O(n²) at worst.
/// @param points    #P by 2
/// @param triangles counter-clockwise, indices into points
std::vector<std::vector<Index>> convex_pieces(std::span<const Vec2> points,
                                              std::span<const std::array<Index, 3>> triangles) {
  return PieceMerger(points, triangles).run();
}

/// Turns a counter-clockwise polygon so that it begins at a corner that sees all its other sides.
/// @return false where it isn't convex, or no corner does
bool make_fan(std::span<const Vec2> points, std::vector<Index>& polygon) {
  return is_convex(points, polygon) && begin_at_fan(points, polygon);
}

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
    return croquis::vertices_along(brep_, half_edge, along_[brep_.half_edges[half_edge].edge]);
  }

  // ---- Plane faces

  void add_plane_face(Index f) {
    const BrepFace& face = brep_.faces[f];
    const PlaneOutlines outlines = plane_outlines(brep_, face, builder_.mesh.positions,
                                                  [&](Index half_edge) { return vertices_along(half_edge); });
    std::vector<Index> first;
    for (const auto& [from, to] : outlines.sides) first.push_back(from);
    std::vector<std::vector<Index>> pieces;
    if (outlines.loops.size() == 1 && make_fan(outlines.places, first)) {
      pieces = {std::move(first)};
    } else {
      const PlanarTriangulationResult plane = triangulate(outlines.places, outlines.sides);
      if (!plane.conflict.empty()) return add_crossing(f, outlines.loops);
      pieces = convex_pieces(outlines.places, triangles_inside(plane.triangulation));
    }
    for (std::vector<Index>& piece : pieces) {
      for (Index& vertex : piece) vertex = outlines.vertices[vertex];
      builder_.mesh.add_face(piece);
      note_cuts(outlines.loops, piece);
    }
  }

  /// The sides of a piece that aren't on the face's outlines; of the two pieces at a cut one notes it.
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
