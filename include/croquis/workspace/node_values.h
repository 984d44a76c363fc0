// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/document.h"
#include "croquis/document/operation.h"

/// The values of a node's parameters, of which the document keeps those that differ from the defaults.
namespace croquis {

/// The node's own value, else the default.
const ParameterValue& value_of(const Node& node, const ParameterDescription& parameter);

/// The node with these values in place of its own. What the operation has no parameter for is left out.
Node with_values(Node node, const OperationDescription& operation, const ParameterValues& values);

}  // namespace croquis
