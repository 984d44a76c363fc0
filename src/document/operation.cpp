// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/operation.h"

#include <utility>

#include "croquis/base/error.h"

namespace croquis {

OperationResult run(const Operation& operation, const Values& inputs, ParameterValues parameters, Context& context) {
  const OperationDescription description = operation.describe();
  Findings findings;
  for (const PortDescription& port : description.inputs) {
    const auto given = inputs.find(port.name);
    if (given != inputs.end() && type_of(given->second) == port.type) continue;
    findings.push_back(
        make_error(Category::Usage, "E_INPUT",
                   description.title + " needs a " + to_string(port.type) + " as its input '" + port.name + "'.",
                   {{SubjectKind::Parameter, port.name, {}, {}, {}}}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return operation.compute(inputs, complete(description.parameters, std::move(parameters)), context);
}

}  // namespace croquis
