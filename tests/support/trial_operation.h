// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "croquis/document/document.h"
#include "croquis/document/operation.h"
#include "croquis/document/registry.h"

/// Operations and documents as small as a test of evaluation needs them.
namespace croquis::test {

/// Takes a mesh as "mesh" and gives one as "mesh"; its parameter "factor" is 2 by default, from -10 to 10.
OperationDescription mesh_to_mesh(std::string id, int version = 1);

/// Adds to the registry.
void add_operation(Registry& registry, OperationDescription description, Operation::Compute compute);

/// A mesh of one point (x, 0, 0).
Value point(double x);

/// x of a mesh of one point.
double x_of(const Value& value);

/// The result of mesh_to_mesh: its input's x times the factor.
OperationResult scaled(const Values& inputs, const ParameterValues& parameters);

Node source_node(Value value, std::string name = "source");

/// An operation on the output of one node, "value" of a source or "mesh" of an operation.
Node operation_node(std::string operation, Link input, double factor, std::string name = "node");

}  // namespace croquis::test
