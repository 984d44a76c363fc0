// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "croquis/geometry/mesh_report.h"
#include "croquis/hole_filling/fill_holes.h"

/// What holds whatever is filled, however, and by whatever method.
namespace croquis::test {

hole_filling::FillResult fill(const PolyMesh& mesh, const hole_filling::FillOptions& options = {});

/// The usual options, with patches of another kind.
hole_filling::FillOptions by(hole_filling::Fairness fairness);

/// With self-intersections.
MeshReport report_of(const PolyMesh& mesh);

std::size_t filled(const hole_filling::FillResult& result);
std::size_t filled_by(const hole_filling::FillResult& result, const std::string& method);

/// The sentence of the only warning with that code, or nothing.
std::string sentence_of(const hole_filling::FillResult& result, const std::string& code);

/// Mean distance from the unit sphere of the new vertices that have a face with one given.
double mean_error_of_first_ring(const hole_filling::FillResult& result);

/// The first vertices and faces are those given, bit by bit.
bool begins_with(const PolyMesh& grown, const PolyMesh& given);

/// Nothing given changes, what is closed is closed soundly, the rest stays: rims, edges, direction, intersections and
/// Euler number as they must be.
/// @param pinches vertices that two rims of one patch share
void check_invariants(const PolyMesh& mesh, const hole_filling::FillResult& result, std::int64_t pinches = 0);

}  // namespace croquis::test
