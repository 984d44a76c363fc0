// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/editable_mesh.h"

#include <chrono>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/chain_edit.h"
#include "croquis/workspace/computed.h"
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

/// A computed mesh is edited by a step of edits after it: the lines are appended to the node when it is such a step
/// itself, else a new step gets them.
/// @param mesh what the node gives
/// @return the document, and the node that gives the edited mesh
/// @throws Error (E_STEP) when the registry has no operation that edits its input
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

constexpr std::size_t most_faces_at_once = 50'000;  // their neighbourhoods take about 10 ms

bool same_connectivity(const PolyMesh& a, const PolyMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_offsets == b.face_offsets && a.corners == b.corners;
}

}  // namespace

void EditableMesh::set_node(NodeId node) {
  if (node == node_) return;
  node_ = node;
  coming_ = {};
  prepared_.reset();
  ++connectivity_;
  prepared_if_ready();
}

std::string EditableMesh::node_name() const {
  const Node* node = session_.document().find(node_);
  return node == nullptr ? "" : node->name;
}

/// Numbers of the elements of connected faces stay, so the picking tree stays, too.
void EditableMesh::go_on_with(NodeId node) { node_ = node; }

bool EditableMesh::is_computed() const {
  const Node* node = workspace_ == nullptr ? nullptr : session_.document().find(node_);
  return node != nullptr && !node->source;
}

std::shared_ptr<const PolyMesh> EditableMesh::mesh() const {
  if (!is_computed()) return source_mesh(session_.document(), node_);
  if (computed_ && computed_node_ == node_ && computed_revision_ == session_.revision()) return computed_;
  computed_ = final_mesh(*workspace_, session_.document(), node_);
  computed_node_ = node_;
  computed_revision_ = session_.revision();
  return computed_;
}

AddedNode EditableMesh::with_lines(const Document& document, const std::vector<EditLine>& lines) const {
  const auto before = final_mesh(*workspace_, document, node_);
  if (!before) {
    throw Error(make_error(Category::Usage, "E_STEP", "The mesh can't be edited before it is computed"));
  }
  AddedNode edited = with_edit_lines(document, workspace_->registry(), node_, *before, lines);
  compute(*workspace_, edited.document, edited.node);
  return edited;
}

PreparedMesh* EditableMesh::prepared() {
  auto now = mesh();
  if (coming_.valid()) prepared_ = coming_.get();
  if (!now) {
    prepared_.reset();
  } else if (prepared_ && prepared_->mesh == now) {
    // As it was.
  } else if (prepared_ && same_connectivity(*prepared_->mesh, *now)) {
    prepared_->mesh = now;
    prepared_->picker.move_to(std::move(now));
  } else {
    prepared_ = std::make_unique<PreparedMesh>(std::move(now));
    ++connectivity_;
  }
  return prepared_.get();
}

PreparedMesh* EditableMesh::prepared_if_ready() {
  const auto now = mesh();
  const auto fits = [&] { return prepared_->mesh == now || same_connectivity(*prepared_->mesh, *now); };
  const bool small = !now || now->face_count() < most_faces_at_once;
  if (small || (prepared_ && fits())) return prepared();
  if (!coming_.valid()) {
    prepared_.reset();
    ++connectivity_;
    coming_ = std::async(std::launch::async, [now] {
      auto made = std::make_unique<PreparedMesh>(now);
      made->picker.prepare();
      return made;
    });
  }
  if (coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
  prepared_ = coming_.get();
  // The mesh may have changed meanwhile.
  return fits() ? prepared() : nullptr;
}

std::shared_ptr<const MeshTopology> EditableMesh::topology() {
  const PreparedMesh* now = prepared();
  return now == nullptr ? nullptr : now->topology;
}

const std::vector<double>& EditableMesh::edge_sharpness() {
  static const std::vector<double> none;
  const PreparedMesh* now = prepared();
  if (now == nullptr) return none;
  if (sharpness_of_ != now->mesh->tags || sharpness_connectivity_ != connectivity_) {
    sharpness_ = croquis::edge_sharpness(now->mesh->tags, *now->topology);
    sharpness_of_ = now->mesh->tags;
    sharpness_connectivity_ = connectivity_;
  }
  return sharpness_;
}

Document EditableMesh::with_mesh(PolyMesh mesh) const {
  Node node = *session_.document().find(node_);
  node.source = std::make_shared<const PolyMesh>(std::move(mesh));
  return session_.document().with(std::move(node));
}

}  // namespace croquis
