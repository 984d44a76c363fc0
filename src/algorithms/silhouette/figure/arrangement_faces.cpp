// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/arrangement_faces.h"

#include <array>
#include <cmath>
#include <queue>

namespace croquis::silhouette {
namespace {

std::vector<Vec2> conflict_places(const Arrangement& arrangement, const PlanarConflict& conflict) {
  std::vector<Vec2> places;
  for (const auto& [a, b] : conflict.coincident_points) places.push_back(arrangement.points[a]);
  for (const Index c : conflict.blocked_constraints) {
    const auto& [a, b] = arrangement.segments[c];
    places.emplace_back(0.5 * (arrangement.points[a] + arrangement.points[b]));
  }
  return places;
}

/// The triangles on the left and the right of every segment; no_index is the outside of the hull.
std::vector<std::array<Index, 2>> beside_segments(const Arrangement& arrangement,
                                                  const PlanarTriangulation& triangulation) {
  std::vector<std::array<Index, 2>> beside(arrangement.segments.size(), {no_index, no_index});
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index segment = triangulation.constraints[t][i];
      if (segment == no_index) continue;
      const bool forward = triangulation.triangles[t][(i + 1) % 3] == arrangement.segments[segment][0];
      beside[segment][forward ? 0 : 1] = t;
    }
  }
  return beside;
}

/// Spreads a face from one triangle over all that no segment separates from it.
void flood(const PlanarTriangulation& triangulation, Index start, Index face, std::vector<Index>& of_triangle) {
  std::vector<Index> stack{start};
  of_triangle[start] = face;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = triangulation.neighbours[t][i];
      if (next == no_index || triangulation.constraints[t][i] != no_index || of_triangle[next] != no_index) continue;
      of_triangle[next] = face;
      stack.push_back(next);
    }
  }
}

/// Numbers the faces; those that reach the hull through an edge that is no segment are face 0.
Index number_faces(const PlanarTriangulation& triangulation, std::vector<Index>& of_triangle) {
  of_triangle.assign(triangulation.triangles.size(), no_index);
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool open = triangulation.neighbours[t][i] == no_index && triangulation.constraints[t][i] == no_index;
      if (open && of_triangle[t] == no_index) flood(triangulation, t, 0, of_triangle);
    }
  }
  Index count = 1;
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    if (of_triangle[t] == no_index) flood(triangulation, t, count++, of_triangle);
  }
  return count;
}

/// Winding numbers spread from outside: stepping over a contour from its right to its left adds one turn.
void wind(const Arrangement& arrangement, Faces& faces) {
  std::vector<std::vector<Index>> arcs_of(faces.area.size());
  for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
    arcs_of[faces.left[arc]].push_back(arc);
    arcs_of[faces.right[arc]].push_back(arc);
  }
  faces.winding.assign(faces.area.size(), {});
  faces.winding[0].assign(arrangement.contours.size(), 0);
  std::queue<Index> open;
  for (open.push(0); !open.empty(); open.pop()) {
    const Index face = open.front();
    for (const Index arc : arcs_of[face]) {
      const bool inwards = faces.right[arc] == face;
      const Index next = inwards ? faces.left[arc] : faces.right[arc];
      if (!faces.winding[next].empty()) continue;
      faces.winding[next] = faces.winding[face];
      faces.winding[next][arrangement.arcs[arc].contour] += inwards ? 1 : -1;
      open.push(next);
    }
  }
}

}  // namespace

FacesResult find_faces(const Arrangement& arrangement) {
  FacesResult result;
  PlanarTriangulationResult made = triangulate(arrangement.points, arrangement.segments);
  if (!made.conflict.empty()) {
    result.conflicts = conflict_places(arrangement, made.conflict);
    return result;
  }
  if (made.triangulation.triangles.empty()) {
    result.conflicts = {arrangement.points.front()};  // all on one line
    return result;
  }
  Faces& faces = result.faces;
  faces.triangulation = std::move(made.triangulation);
  faces.area.assign(number_faces(faces.triangulation, faces.of_triangle), 0.0);
  for (Index t = 0; t < faces.of_triangle.size(); ++t) {
    const auto& [a, b, c] = faces.triangulation.triangles[t];
    const Points& p = arrangement.points;
    if (faces.of_triangle[t] != 0) faces.area[faces.of_triangle[t]] += 0.5 * cross(p[b] - p[a], p[c] - p[a]);
  }
  const std::vector<std::array<Index, 2>> beside = beside_segments(arrangement, faces.triangulation);
  const auto face_of = [&](Index triangle) { return triangle == no_index ? 0 : faces.of_triangle[triangle]; };
  faces.left.assign(arrangement.arcs.size(), 0);
  faces.right.assign(arrangement.arcs.size(), 0);
  for (Index s = 0; s < arrangement.segments.size(); ++s) {
    faces.left[arrangement.segment_arc[s]] = face_of(beside[s][0]);
    faces.right[arrangement.segment_arc[s]] = face_of(beside[s][1]);
  }
  wind(arrangement, faces);
  return result;
}

}  // namespace croquis::silhouette
