// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/vector.h"

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

/// Vertices as an eye at the origin sees them.
struct SeenVertices {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< rows right, down, forward
  double focal = 1;                                        ///< u
  std::vector<Vec2> places;                                ///< u, relative to the principal point
  std::vector<double> weights;                             ///< > 0, of each vertex

  Vec3 ray(Index vertex) const;  ///< of depth 1
};

/// Values of all classes, the eye at the origin; every component has a mean depth of 1 of its own.
struct ClassSolution {
  std::vector<double> values;
  std::vector<Vec2> residuals;  ///< u, of each vertex: seen minus drawn
  double squares = 0;           ///< u^2, weighted sum
  int freedom = 0;              ///< equations beyond unknowns
  bool in_front = true;         ///< all depths are positive

  Vec3 position(const ClassTable& table, Index vertex) const;
  double rms() const;             ///< u, per coordinate
  double rms_of_freedom() const;  ///< u, over the degrees of freedom
  double worst() const;           ///< u, the largest residual of a vertex
};

/// Values for which vertices are seen where they were drawn, with the least sum of squared distances.
///
/// Starts from the smallest singular vector of n · X = 0 with weights 1 / depth, found by inverse iteration; Gauss and
/// Newton then minimise the distances themselves, which doesn't depend on the scale that is left free. Sparse (Eigen's
/// SimplicialLDLT): about linear in the number of vertices.
/// @param near   positions of the vertices that are nearly right already, or null
/// @param rounds of Gauss and Newton; with few of them the result is only good for comparing
ClassSolution solve_classes(const SeenVertices& seen, const ClassTable& table, const std::vector<Vec3>* near = nullptr,
                            int rounds = 12);

/// Standard deviation of each vertex along its ray for a noise of 1 u, where mean depth is 1. For up to 1000 classes,
/// else empty.
std::vector<double> depth_deviations(const SeenVertices& seen, const ClassTable& table, const ClassSolution& solution);

}  // namespace croquis
