// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "croquis/document/operation.h"

namespace croquis {

struct OperationOutcome {
  OperationResult result;  ///< of a failed operation: its findings as `warnings`, and no outputs
  bool failed = false;
  bool repeatable = true;  ///< false when the same inputs may well succeed at another time
};

/// Does some work and turns whatever it throws into findings.
/// @throws Cancelled alone
OperationOutcome guarded(const std::function<OperationResult()>& work, const Progress& progress);

/// Runs an operation in the same way.
/// @throws Cancelled alone
OperationOutcome run_guarded(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                             Context& context);

}  // namespace croquis
