// SPDX-License-Identifier: GPL-3.0-or-later
// What operations and edits say of themselves, as JSON and as the reference pages of docs/.
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/command.h"
#include "croquis/base/described.h"
#include "croquis/edits/edit.h"

namespace croquis::cli {
namespace {

struct DefaultEntry {
  Report operator()(const ParsedText& value) const { return value.text(); }
  template <typename Plain>
  Report operator()(const Plain& value) const {
    return value;
  }
};

Report describe_parameter(const ParameterDescription& parameter) {
  Report entry;
  entry.set("name", parameter.name).set("type", to_string(parameter.type));
  entry.set("default", std::visit(DefaultEntry(), parameter.default_value));
  if (parameter.type == ParameterType::Integer || parameter.type == ParameterType::Number) {
    entry.set("minimum", parameter.minimum).set("maximum", parameter.maximum);
  }
  if (!parameter.choices.empty()) entry.set("choices", Report::list(parameter.choices));
  if (!parameter.choice_titles.empty()) entry.set("choice_titles", Report::list(parameter.choice_titles));
  if (!parameter.default_title.empty()) entry.set("default_title", parameter.default_title);
  entry.set("title", title_of(parameter)).set("unit", parameter.unit).set("sentence", parameter.sentence);
  return entry;
}

std::string range_text(const ParameterDescription& parameter) {
  if (!parameter.choices.empty()) {
    std::string list;
    for (const std::string& choice : parameter.choices) list += (list.empty() ? "" : ", ") + choice;
    return list;
  }
  if (parameter.type == ParameterType::Integer || parameter.type == ParameterType::Number) {
    const bool low = std::isfinite(parameter.minimum), high = std::isfinite(parameter.maximum);
    std::string range = low && high ? to_text(parameter.minimum) + " to " + to_text(parameter.maximum)
                        : low       ? "at least " + to_text(parameter.minimum)
                        : high      ? "at most " + to_text(parameter.maximum)
                                    : "any number";
    if (parameter.unit.empty()) return range;
    return range + (low || high ? " " : " of ") + parameter.unit;
  }
  return to_string(parameter.type);
}

Report describe_parameters(const std::vector<ParameterDescription>& parameters) {
  Report list = Report::array();
  for (const ParameterDescription& parameter : parameters) list.push(describe_parameter(parameter));
  return list;
}

std::string parameter_table(const std::vector<ParameterDescription>& parameters) {
  std::string text = "| Parameter | Default | Values | |\n|---|---|---|---|\n";
  for (const ParameterDescription& parameter : parameters) {
    text += "| " + parameter.name + " | " + to_text(parameter.default_value) + " | " + range_text(parameter) + " | " +
            parameter.sentence + " |\n";
  }
  return text;
}

Report describe_ports(const std::vector<PortDescription>& ports) {
  Report list = Report::array();
  for (const PortDescription& port : ports) {
    Report entry = to_report(
        fields(named("name", port.name), named("type", to_string(port.type)), named("sentence", port.sentence)));
    if (port.optional) entry.set("optional", true);
    list.push(std::move(entry));
  }
  return list;
}

Report describe_operation(const OperationDescription& description) {
  return to_report(fields(named("id", description.id), named("version", description.version),
                          named("title", description.title), named("sentence", description.sentence),
                          named("inputs", describe_ports(description.inputs)),
                          named("outputs", describe_ports(description.outputs)),
                          named("parameters", describe_parameters(description.parameters))));
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

Report describe_edit(const Edit& edit) {
  const EditDescription& description = edit.description;
  Report kinds = Report::array();
  for (const ComponentKind kind : description.kinds) kinds.push(plural(kind));
  return to_report(fields(named("id", description.id), named("title", description.title),
                          named("sentence", description.sentence), named("elements", kinds),
                          named("parameters", describe_parameters(description.parameters))));
}

/// One edit's part of the reference page, as Markdown.
std::string reference_of(const Edit& edit) {
  const EditDescription& description = edit.description;
  std::string elements;
  for (const ComponentKind kind : description.kinds) {
    elements += (elements.empty() ? "`" : " or `") + std::string(plural(kind)) + "=`";
  }
  std::string text = "## " + description.id + "\n\n" + description.sentence + " Takes " + elements + ".\n";
  if (!description.parameters.empty()) text += "\n" + parameter_table(description.parameters);
  return text;
}

constexpr const char* introduction =
    "# Edits\n\nWritten by `croquis-cli edits` from each edit's own description.\n\n"
    "An edit is a line: its name, its elements (numbers from 0 such as `0,3-5`, or `all`), and its parameters as "
    "`name=value`, separated by blanks. Lines are separated by `;` or line ends; those that begin with `#` are left "
    "out. Each line counts the elements of the mesh that the one before made.\n\n"
    "```sh\n"
    "croquis-cli edit box.obj --do 'inset faces=5 width=0.1' --do 'extrude faces=5 distance=-0.5' -o "
    "box_with_hole.obj\n"
    "croquis-cli edit box.obj --do @steps.txt -o edited.obj     # one edit a line\n"
    "```";

/// One reference page.
/// @param list        name of the list in the report
/// @param describe    what the report has of an element
/// @param part_of     its part of the page
template <typename Elements, typename Describe, typename PartOf>
void list_all(const char* list, const Elements& elements, Describe&& describe, PartOf&& part_of,
              CommandResult& result) {
  Report entries = Report::array();
  for (const auto& element : elements) {
    entries.push(describe(element));
    result.text += "\n\n" + part_of(element);
    result.text.pop_back();
  }
  result.details = Report().set(list, std::move(entries));
}

}  // namespace

Command operations_command(const Registry& registry) {
  return {{.name = "operations",
           .sentence = "Lists every operation with its parameters, from their own descriptions.",
           .needs_input = false,
           .examples = {"croquis-cli operations --json", "croquis-cli operations > operations.md"}},
          [&registry](const Invocation&, CommandResult& result, Progress&) {
            result.text = "# Operations\n\nWritten by `croquis-cli operations` from each operation's own description.";
            list_all("operations", registry.descriptions(), describe_operation, reference, result);
          }};
}

Command edits_command() {
  return {{.name = "edits",
           .sentence = "Lists every edit with its parameters, from their own descriptions.",
           .needs_input = false,
           .examples = {"croquis-cli edits --json", "croquis-cli edits > edits.md"}},
          [](const Invocation&, CommandResult& result, Progress&) {
            result.text = introduction;
            list_all("edits", all_edits(), describe_edit, reference_of, result);
          }};
}

}  // namespace croquis::cli
