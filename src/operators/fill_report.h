// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "croquis/base/report.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/operators/fill_result.h"
#include "croquis/remeshing/remesh.h"

namespace croquis {

/// What patches made of a scan.
FillResult result_of_filling(std::shared_ptr<const PolyMesh> scan, const hole_filling::FillResult& filled);

/// The same of a remeshed model, and what it was proven to be.
FillResult result_of_remeshing(std::shared_ptr<const PolyMesh> scan, const remeshing::RemeshResult& made);

/// The same before anything is filled: FillAction::Fill for the holes that would be.
FillResult result_of_listing(std::shared_ptr<const PolyMesh> scan, const hole_filling::HoleAnalysis& analysis,
                             const hole_filling::HoleChoice& choice);

/// Every hole with what became of it, and how much is new. Angles in degrees; null for what isn't known.
Report to_report(const FillResult& result);

/// The rims as closed polylines and nothing else: line i is the rim of hole i, its first vertex at the end again.
PolyMesh rim_lines(const PolyMesh& scan, std::span<const hole_filling::Hole> holes);

}  // namespace croquis
