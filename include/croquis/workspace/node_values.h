// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/document.h"
#include "croquis/document/operation.h"

/// The values of a node's parameters, of which the document keeps those that were given.
namespace croquis {

/// The value of every parameter: the node's own, else that of its preset, else the default.
ParameterValues values_of(const Node& node, const OperationDescription& operation);

/// The node with these values in place of its own. What the operation has no parameter for is left out, and so is what
/// leaves a parameter to the preset or the default (see is_given).
Node with_values(Node node, const OperationDescription& operation, const ParameterValues& values);

}  // namespace croquis
