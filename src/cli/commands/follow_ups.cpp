// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/follow_ups.h"

#include <algorithm>

namespace croquis::cli {

bool has_files(ValueType type) { return type != ValueType::Brep; }

bool reads_files(const OperationDescription& operation) { return has_files(operation.inputs.front().type); }

std::vector<FollowUp> follow_ups_of(const OperationDescription& operation, const Registry& registry) {
  std::vector<FollowUp> result;
  for (const auto& other : registry.operations()) {
    OperationDescription description = other->describe();
    const auto source = std::ranges::find_if(operation.outputs, [&](const PortDescription& port) {
      return !has_files(port.type) && port.type == description.inputs.front().type;
    });
    if (source == operation.outputs.end()) continue;
    result.push_back({other.get(), std::move(description), source->name});
  }
  return result;
}

std::vector<ParameterDescription> options_of(const FollowUp& follow_up) {
  std::vector<ParameterDescription> options;
  options.push_back(file_parameter(follow_up.option(), "Write to FILE: " + follow_up.output().sentence));
  for (ParameterDescription parameter : follow_up.description.parameters) {
    parameter.sentence = "For --" + follow_up.option() + ": " + parameter.sentence;
    parameter.name = follow_up.option(parameter);
    options.push_back(std::move(parameter));
  }
  return options;
}

OperationResult run(const FollowUp& follow_up, const Values& outputs, const Invocation& invocation,
                    Progress& progress) {
  ParameterValues parameters;
  for (const ParameterDescription& parameter : follow_up.description.parameters)
    parameters[parameter.name] = invocation.parameters.at(follow_up.option(parameter));
  Context context{progress};
  context.threads = static_cast<int>(invocation.threads);
  const Values inputs{{follow_up.description.inputs.front().name, outputs.at(follow_up.source)}};
  return croquis::run(*follow_up.operation, inputs, std::move(parameters), context);
}

}  // namespace croquis::cli
