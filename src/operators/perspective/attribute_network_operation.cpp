// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/attribute_network_operation.h"

#include <memory>
#include <utility>

#include "croquis/perspective/solid_network.h"

namespace croquis {

OperationDescription AttributeNetworkOperation::describe() const {
  return {"attribute_network",
          1,
          "Attribute Network",
          "Makes an attribute network of a solid: its curves, and a face for each loop of 2 to 12 of them.",
          {{"solid", ValueType::Brep, "Faces, edges and vertices with their curves."}},
          {{"network", ValueType::AttributeNetwork, "The solid's curves and faces as an attribute network."}},
          {}};
}

OperationResult AttributeNetworkOperation::compute(const Values& inputs, const ParameterValues&,
                                                   Context& context) const {
  SolidNetwork made = network_of_solid(inputs.at("solid").get<Brep>());
  OperationResult result;
  result.warnings = std::move(made.warnings);
  result.outputs["network"] = std::make_shared<const AttributeNetwork>(std::move(made.network));
  context.progress.report(1);
  return result;
}

}  // namespace croquis
