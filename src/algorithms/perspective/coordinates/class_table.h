// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"

namespace croquis {

/// What ties coordinates: strokes by their groups, and pairs that were found equal.
struct CoordinateTies {
  std::vector<std::array<Index, 2>> of_stroke;  ///< vertices at the ends of each stroke, no_index for unused ones
  std::vector<StrokeGroup> groups;              ///< #strokes, Unknown: ties nothing
  std::vector<std::pair<Index, Index>> equal;   ///< slots (3 · vertex + axis) of the same axis
};

/// Coordinates that are one and the same number. Numbered by their lowest slots, so by vertices alone.
struct ClassTable {
  std::vector<std::array<Index, 3>> of_vertex;  ///< the classes of x, y and z
  std::vector<int> axis;                        ///< of each class
  std::vector<Index> component;                 ///< of each vertex: those that share a class, directly or not
  Index components = 0;

  std::size_t class_count() const { return axis.size(); }
  std::size_t vertex_count() const { return of_vertex.size(); }
};

ClassTable make_classes(std::size_t vertex_count, const CoordinateTies& ties);

/// Vertices that have all three coordinates in common with another one.
bool has_coincident_vertices(const ClassTable& table);

}  // namespace croquis
