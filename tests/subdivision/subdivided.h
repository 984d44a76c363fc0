// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "croquis/subdivision/doo_sabin.h"

/// A cage refined, and what can be measured on its levels.
namespace croquis::test {

struct Subdivided {
  subdivision::Cage cage;
  subdivision::DooSabinPlan plan;
  subdivision::PositionBuffers buffers;

  const subdivision::HalfEdges& topology(int k) const { return plan.level(k).topology; }
  const std::vector<Vec3>& points(int k) const { return buffers.levels[static_cast<std::size_t>(k)]; }
};

Subdivided subdivide(const PolyMesh& mesh, int levels, const subdivision::Rules& rules = {});

using Counts = std::array<std::size_t, 3>;  ///< V, E, F
Counts counts(const subdivision::HalfEdges& mesh);
std::map<std::size_t, std::size_t> faces_by_size(const subdivision::HalfEdges& mesh);

double sum_of_squares(const std::vector<Vec3>& points);

/// Of the triangles (face's mean, v_i, v_i+1) with the origin.
double volume(const subdivision::HalfEdges& mesh, const std::vector<Vec3>& points);
double area(const subdivision::HalfEdges& mesh, const std::vector<Vec3>& points);

/// Degrees between the planes that fit both faces of an edge best (by their area vectors).
double dihedral_degrees(const subdivision::HalfEdges& mesh, const std::vector<Vec3>& points, Index edge);

/// Over edges inside without tags.
double largest_untagged_dihedral(const subdivision::Level& level, const std::vector<Vec3>& points);

/// The ends of an edge, in the direction of its half-edge.
std::array<Index, 2> edge_ends(const subdivision::HalfEdges& mesh, Index edge);

/// Vertices at tagged edges, ascending.
std::vector<Index> tagged_vertices(const subdivision::Level& level);

/// Whether each point of one list lies at one of the other, which has as many.
bool same_points(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance);

/// "" or the first thing that is wrong with the arrays: every rule that HalfEdges promises, and that faces are those of
/// an oriented manifold where each vertex has one fan (counted anew from the faces).
std::string fault(const subdivision::HalfEdges& mesh);

}  // namespace croquis::test
