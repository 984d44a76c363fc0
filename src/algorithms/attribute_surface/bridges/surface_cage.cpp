// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/surface_cage.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "croquis/geometry/cage_builder.h"

namespace croquis {
namespace {

/// Two sharp curves that turn more at a node have a corner there.
constexpr double crease_corner_turn = 15 * std::numbers::pi / 180;

Vec2 between(const std::array<Vec2, 4>& corners, double u, double v) {
  return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
}

class SurfaceCageMaker {
 public:
  SurfaceCageMaker(const AttributeNetwork& network, const AttributeSurface& surface, std::size_t segments)
      : network_(network), surface_(surface), segments_(segments) {}

  PolyMesh run(Progress& progress) {
    for (Index f = 0; f < surface_.faces.size(); ++f) {
      progress.report(f, surface_.faces.size());
      if (surface_.faces[f].surface != nullptr) add_face(f);
    }
    for (const auto& [curve, row] : rows_) {
      const SurfaceCurve& made = surface_.curves[curve];
      if (made.faces.size() > 1 && !made.smooth)
        cage_.add_crease(row, made.curve->start_derivative(), made.curve->end_derivative());
    }
    cage_.add_pins(crease_corner_turn);
    progress.report(1);
    return std::move(cage_.mesh);
  }

 private:
  Index vertex_at(std::size_t corner, const Vec3& point) {
    const auto [known, is_new] = corners_.try_emplace(corner, no_index);
    if (is_new) known->second = cage_.add_vertex(point);
    return known->second;
  }

  /// The vertices along a curve, from its start.
  const CageBuilder::Row& row_of(Index curve) {
    const auto [known, is_new] = rows_.try_emplace(curve);
    if (!is_new) return known->second;
    const SurfaceCurve& made = surface_.curves[curve];
    known->second.push_back(vertex_at(made.start, made.curve->at(0)));
    for (std::size_t k = 1; k < segments_; ++k)
      known->second.push_back(
          cage_.add_vertex(made.curve->at(static_cast<double>(k) / static_cast<double>(segments_))));
    known->second.push_back(vertex_at(made.end, made.curve->at(1)));
    return known->second;
  }

  std::vector<CageBuilder::Row> rows_around(Index f) {
    std::vector<CageBuilder::Row> rows;
    for (const AttributeSide& side : network_.faces[f].loop) {
      CageBuilder::Row row = row_of(side.curve);
      if (side.reversed) std::ranges::reverse(row);
      rows.push_back(std::move(row));
    }
    return rows;
  }

  void add_face(Index f) {
    const std::vector<CageBuilder::Row> rows = rows_around(f);
    const FaceSurface& surface = *surface_.faces[f].surface;
    const std::size_t first = cage_.mesh.face_count();
    switch (rows.size()) {
      case 2: add_leaf(rows, surface); break;
      case 4: add_quad({rows[0], rows[1], rows[2], rows[3]}, surface); break;
      default: add_star(rows, surface);
    }
    if (surface_.faces[f].flipped) turn_round(first);
  }

  void add_quad(const std::array<CageBuilder::Row, 4>& rows, const FaceSurface& surface) {
    const auto& corners = surface.domain().corners;
    const std::array<Vec2, 4> quad{corners[0], corners[1], corners[2], corners[3]};
    cage_.add_grid(rows, [&](double u, double v) { return surface.at(between(quad, u, v)); });
  }

  /// The domain of two sides has its other two corners at the middles of these.
  void add_leaf(const std::vector<CageBuilder::Row>& rows, const FaceSurface& surface) {
    const auto half = static_cast<std::ptrdiff_t>(segments_ / 2);
    std::array<CageBuilder::Row, 4> halves;
    for (std::size_t side = 0; side < 2; ++side) {
      halves[2 * side].assign(rows[side].begin(), rows[side].begin() + half + 1);
      halves[2 * side + 1].assign(rows[side].begin() + half, rows[side].end());
    }
    add_quad(halves, surface);
  }

  void add_star(const std::vector<CageBuilder::Row>& rows, const FaceSurface& surface) {
    const auto& corners = surface.domain().corners;
    const Vec2 middle = surface.domain().middle;
    const auto place = [&](std::size_t corner, double u, double v) {
      const std::size_t n = corners.size();
      const Vec2 &here = corners[corner], &next = corners[(corner + 1) % n], &before = corners[(corner + n - 1) % n];
      return surface.at(between({here, Vec2((here + next) / 2), middle, Vec2((before + here) / 2)}, u, v));
    };
    cage_.add_star(rows, surface.at(middle), place);
  }

  void turn_round(std::size_t first) {
    PolyMesh& mesh = cage_.mesh;
    for (std::size_t f = first; f < mesh.face_count(); ++f)
      std::reverse(mesh.corners.begin() + mesh.face_offsets[f], mesh.corners.begin() + mesh.face_offsets[f + 1]);
  }

  const AttributeNetwork& network_;
  const AttributeSurface& surface_;
  const std::size_t segments_;
  CageBuilder cage_;
  std::map<std::size_t, Index> corners_;    ///< vertices by the surface's numbers of corners
  std::map<Index, CageBuilder::Row> rows_;  ///< by curve
};

}  // namespace

PolyMesh make_surface_cage(const AttributeNetwork& network, const AttributeSurface& surface,
                           const SurfaceCageOptions& options, Progress& progress) {
  return SurfaceCageMaker(network, surface, options.segments).run(progress);
}

}  // namespace croquis
