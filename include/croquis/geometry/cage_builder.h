// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Builds control meshes of quads over smooth faces whose sides are rows of shared vertices.
class CageBuilder {
 public:
  using Row = std::vector<Index>;  ///< vertices of a side, ends included

  Index add_vertex(const Vec3& point);

  /// A grid over a face of four sides.
  /// @param sides each from its corner to the next one, all with as many vertices, at least 2
  /// @param at    place at u, v in 0..1: u along the first side, v along the second one
  void add_grid(const std::array<Row, 4>& sides, const std::function<Vec3(double u, double v)>& at);

  /// A grid for each corner of a face of any number of sides, around its middle: sides are split at their middles.
  /// @param sides each from its corner to the next one, all with as many edges, an even number
  /// @param at    place in the quarter at a corner: u along its side from 0 there to 1 at the side's middle, v
  ///              along the side before it likewise; at u = v = 1 the face's middle
  void add_star(const std::vector<Row>& sides, const Vec3& middle,
                const std::function<Vec3(std::size_t corner, double u, double v)>& at);

  /// Tags the edges along a row as sharp.
  /// @param leaving, arriving directions of the curve at its ends, of any length above 0
  void add_crease(const Row& row, const Vec3& leaving, const Vec3& arriving);

  /// Pins the vertices where two creases meet and turn by more than an angle, in radians. Where more than two meet
  /// there is a corner anyway.
  void add_pins(double corner_turn);

  PolyMesh mesh;

 private:
  std::map<Index, std::vector<Vec3>> leaving_;  ///< directions of creases, by the vertex where they begin or end
};

}  // namespace croquis
