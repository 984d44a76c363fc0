// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/edit_step.h"

#include <optional>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/work_object.h"

namespace croquis {
namespace {

/// The description of the node's operation when it edits its input, and more lines can follow: those of a step that is
/// off do nothing, and a transform comes after all lines.
const OperationDescription* open_edits(const Node& node, const Registry& registry) {
  if (!edits_input(node, registry) || !node.enabled || !(node.transform == Node().transform)) return nullptr;
  return operation_of(node, registry);
}

const OperationDescription& editing_operation(const Registry& registry) {
  for (const OperationDescription& description : registry.descriptions()) {
    if (description.edits_input) return description;
  }
  throw Error(make_error(Category::Usage, "E_STEP", "There is no operation that edits computed meshes"));
}

}  // namespace

AddedNode with_edit_lines(const Document& document, const Registry& registry, NodeId id, const PolyMesh& mesh,
                          const std::vector<EditLine>& lines) {
  if (const auto description = open_edits(*document.find(id), registry)) {
    Node node = *document.find(id);
    const std::string& name = description->edits_input->lines;
    const std::string before = text_of(complete(description->parameters, node.parameters), name);
    node.parameters[name] = before.empty() ? to_text(lines) : before + "; " + to_text(lines);
    return {document.with(std::move(node)), id};
  }
  const OperationDescription operation = editing_operation(registry);
  return with_step(
      document, registry, id, operation.id,
      {{operation.edits_input->lines, to_text(lines)}, {operation.edits_input->connectivity, connectivity_name(mesh)}});
}

}  // namespace croquis
