// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis::test {

/// Checks, in both qualities, that an operation is the function of its arguments that it promises to be: the same
/// bytes and findings without a memo, with an empty one, with that one when it is warm, and on another thread.
/// An operation that refuses the input must do so with the same findings every time.
void check_operation(const Operation& operation, const Values& inputs, const ParameterValues& parameters);

}  // namespace croquis::test
