// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

struct OperationOutcome {
  OperationResult result;  ///< of a failed operation: its findings as `warnings`, and no outputs
  bool failed = false;
  bool repeatable = true;  ///< false when the same inputs may well succeed at another time
};

/// Runs an operation and turns whatever it throws into findings.
/// @throws Cancelled alone
OperationOutcome run_guarded(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                             Context& context);

}  // namespace croquis
