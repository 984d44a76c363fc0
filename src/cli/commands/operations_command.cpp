// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/operations_command.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/parameter_reference.h"

namespace croquis::cli {
namespace {

Report describe_ports(const std::vector<PortDescription>& ports) {
  Report list = Report::array();
  for (const PortDescription& port : ports) {
    Report entry;
    entry.set("name", port.name).set("type", to_string(port.type)).set("sentence", port.sentence);
    if (port.optional) entry.set("optional", true);
    list.push(std::move(entry));
  }
  return list;
}

Report describe_operation(const OperationDescription& description) {
  Report entry;
  entry.set("id", description.id)
      .set("version", description.version)
      .set("title", description.title)
      .set("sentence", description.sentence)
      .set("inputs", describe_ports(description.inputs))
      .set("outputs", describe_ports(description.outputs))
      .set("parameters", describe_parameters(description.parameters));
  return entry;
}

/// One operation's part of the reference page, as Markdown.
std::string reference(const OperationDescription& description) {
  std::string text = "## " + description.id + "\n\n" + description.sentence + "\n\n";
  text += "| Port | Direction | Type | |\n|---|---|---|---|\n";
  for (const PortDescription& port : description.inputs) {
    const std::string type = std::string(to_string(port.type)) + (port.optional ? ", optional" : "");
    text += "| " + port.name + " | in | " + type + " | " + port.sentence + " |\n";
  }
  for (const PortDescription& port : description.outputs) {
    text += "| " + port.name + " | out | " + to_string(port.type) + " | " + port.sentence + " |\n";
  }
  return text + "\n" + parameter_table(description.parameters);
}

}  // namespace

CommandDescription OperationsCommand::describe() const {
  CommandDescription description;
  description.name = "operations";
  description.sentence = "Lists every operation with its parameters, from their own descriptions.";
  description.needs_input = false;
  description.examples = {"croquis-cli operations --json", "croquis-cli operations > operations.md"};
  return description;
}

void OperationsCommand::run(const Invocation&, CommandResult& result, Progress&) const {
  Report list = Report::array();
  result.text = "# Operations\n\nWritten by `croquis-cli operations` from each operation's own description.";
  for (const auto& operation : registry_.operations()) {
    const OperationDescription description = operation->describe();
    list.push(describe_operation(description));
    result.text += "\n\n" + reference(description);
    result.text.pop_back();
  }
  Report details;
  details.set("operations", std::move(list));
  result.details = std::move(details);
}

}  // namespace croquis::cli
