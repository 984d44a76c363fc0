// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "croquis/document/operation.h"
#include "croquis/geometry/brep.h"

/// Files of exact solids: STEP, and the surfaces as JSON.
namespace croquis::cli {

/// Whether a B-rep is among the outputs of an operation.
bool has_exact_solid(const OperationDescription& description);

/// Whether the main output is to be a STEP file, which only operations with a B-rep among their outputs can give.
/// @throws Error (E_NO_STEP, Category::Usage) where this program can't write them
bool writes_step(const OperationDescription& description, const Invocation& invocation);

/// Puts the solid's STEP file among the result's files, in the unit of the drawing that it was made from, and its
/// figures among the details.
/// @throws Error
void stage_step(const Invocation& invocation, const Values& inputs, const Values& outputs, CommandResult& result,
                Progress& progress);

/// Reports of patches get each patch's B-spline surface as "bicubic"; other reports stay as they are.
Report with_fits(const Report& report, const Values& outputs, Progress& progress);

}  // namespace croquis::cli
