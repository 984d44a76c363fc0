// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "croquis/base/parameter_list.h"
#include "croquis/document/operation.h"

/// The operations, one function for each: their descriptions say what they do. all_operations.cpp lists them.
namespace croquis {

std::unique_ptr<const Operation> attribute_network_operation();
std::unique_ptr<const Operation> cage_operation();
std::unique_ptr<const Operation> contour_network_operation();
std::unique_ptr<const Operation> edge_network_operation();
std::unique_ptr<const Operation> edit_operation();
std::unique_ptr<const Operation> fair_operation();
std::unique_ptr<const Operation> fill_operation();
std::unique_ptr<const Operation> inflate_operation();
std::unique_ptr<const Operation> patch_cage_operation();
std::unique_ptr<const Operation> perspective_operation();
std::unique_ptr<const Operation> subdivide_operation();
std::unique_ptr<const Operation> surface_cage_operation();
std::unique_ptr<const Operation> surface_operation();
std::unique_ptr<const Operation> surface_patch_operation();

/// An operation of settings whose parameters are listed.
/// @param description without parameters
template <typename Settings>
std::unique_ptr<const Operation> operation_of(OperationDescription description,
                                              ListParameters<Settings> list_parameters,
                                              OperationResult (*compute)(const Values&, Settings, Context&)) {
  description.parameters = parameters_of(list_parameters);
  return std::make_unique<Operation>(std::move(description),
                                     [=](const Values& inputs, const ParameterValues& parameters, Context& context) {
                                       return compute(inputs, settings_of(list_parameters, parameters), context);
                                     });
}

}  // namespace croquis
