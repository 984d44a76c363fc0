// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/base/report.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/remeshing/remesh.h"

namespace croquis {

/// Every hole with what became of it, and how much is new. Angles in degrees; null for what isn't known.
Report fill_details(const PolyMesh& scan, const hole_filling::FillResult& result);

/// The same of a remeshed model, and what it was proven to be.
Report remesh_details(const remeshing::RemeshResult& result);

/// The same before anything is filled: "fill" for the holes that would be.
Report list_details(const PolyMesh& scan, std::span<const hole_filling::Hole> holes,
                    const hole_filling::HoleChoice& choice);

/// The rims as closed polylines and nothing else: line i is the rim of hole i, its first vertex at the end again.
PolyMesh rim_lines(const PolyMesh& scan, std::span<const hole_filling::Hole> holes);

}  // namespace croquis
