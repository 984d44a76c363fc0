// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/remeshing/remesh_points.h"
#include "croquis/implicit/partition_of_unity.h"

namespace croquis::remeshing {

/// How space is cut and fitted for the options: see remesh_preset for what presets change.
implicit::DomainOptions domain_options(const RemeshOptions& options, double edge);

/// Boxes around the holes of each of a piece's groups: that of its rims, larger on every side by `growth` × the largest
/// rim's diameter, with 400 centres at most, the sparser the farther from the rims. None under Preset::Paper.
/// @throws Cancelled
std::vector<implicit::ExtraDomain> hole_domains(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                                                const RemeshPiece& piece, const std::vector<Vec3>& normals,
                                                const RemeshOptions& options, double growth, const Progress& progress);

}  // namespace croquis::remeshing
