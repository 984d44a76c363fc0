// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/operation.h"

#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

bool fits(const PortDescription& port, const Values& values) {
  const auto given = values.find(port.name);
  return given != values.end() && given->second.type() == port.type && given->second.has_content();
}

void check_outputs(const OperationDescription& description, const Values& outputs) {
  Findings findings;
  for (const PortDescription& port : description.outputs) {
    if (fits(port, outputs)) continue;
    findings.push_back(make_error(Category::Internal, "E_INTERNAL",
                                  description.title + " made no output '" + port.name + "'; please report it."));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace

OperationResult run(const Operation& operation, const Values& inputs, ParameterValues parameters, Context& context) {
  const OperationDescription& description = operation.describe();
  Findings findings;
  for (const PortDescription& port : description.inputs) {
    if (fits(port, inputs) || (port.optional && !inputs.contains(port.name))) continue;
    findings.push_back(
        make_error(Category::Usage, "E_INPUT",
                   description.title + " needs a " + to_string(port.type) + " as its input '" + port.name + "'.",
                   {{SubjectKind::Parameter, port.name, {}, {}, {}}}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
  OperationResult result = operation.compute(inputs, complete(description.parameters, std::move(parameters)), context);
  check_outputs(description, result.outputs);
  return result;
}

}  // namespace croquis
