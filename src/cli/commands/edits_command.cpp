// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/edits_command.h"

#include <string>
#include <utility>

#include "cli/parameter_reference.h"
#include "croquis/edits/edit.h"

namespace croquis::cli {
namespace {

Report describe_edit(const EditDescription& description) {
  Report kinds = Report::array();
  for (const ComponentKind kind : description.kinds) kinds.push(plural(kind));
  Report entry;
  entry.set("id", description.id)
      .set("title", description.title)
      .set("sentence", description.sentence)
      .set("elements", std::move(kinds))
      .set("parameters", describe_parameters(description.parameters));
  return entry;
}

/// One edit's part of the reference page, as Markdown.
std::string reference_of(const EditDescription& description) {
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

}  // namespace

CommandDescription EditsCommand::describe() const {
  CommandDescription description;
  description.name = "edits";
  description.sentence = "Lists every edit with its parameters, from their own descriptions.";
  description.needs_input = false;
  description.examples = {"croquis-cli edits --json", "croquis-cli edits > edits.md"};
  return description;
}

void EditsCommand::run(const Invocation&, CommandResult& result, Progress&) const {
  Report list = Report::array();
  result.text = introduction;
  for (const auto& edit : all_edits().edits()) {
    const EditDescription description = edit->describe();
    list.push(describe_edit(description));
    result.text += "\n\n" + reference_of(description);
    result.text.pop_back();
  }
  Report details;
  details.set("edits", std::move(list));
  result.details = std::move(details);
}

}  // namespace croquis::cli
