// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/tag_editor.h"

#include <algorithm>
#include <map>
#include <utility>

#include "croquis/base/error.h"
#include "tools/mesh/selection_edit.h"

namespace croquis {

std::vector<EditLine> sharpening_lines(const PolyMesh& mesh, const MeshTopology& topology, const Elements& edges,
                                       double by) {
  const std::vector<double> before = edge_sharpness(mesh.tags, topology);
  const std::vector<double> after = edge_sharpness(with_sharpness_changed(mesh.tags, topology, edges, by), topology);
  std::map<double, Elements> by_value;
  for (const Index edge : edges) {
    if (after[edge] != before[edge]) by_value[std::min(after[edge], greatest_sharpness)].push_back(edge);
  }
  std::vector<EditLine> lines;
  for (auto& [value, own] : by_value) {
    lines.push_back(edit_of("sharpness", ComponentKind::Edge, std::move(own), {{"value", value}}));
  }
  return lines;
}

// ---- Sharpness and pins

Verdict TagEditor::tag_these(const Elements& edges, double sharpness, std::optional<recorded::Step> step) {
  if (edges.empty()) return Verdict::Continue;
  const std::string label = selector_.counted(sharpness > 0 ? "Sharpen" : "Smooth", ComponentKind::Edge, edges.size());
  // The edit takes finite numbers; from the greatest on all are infinite.
  const double value = std::clamp(sharpness, 0.0, greatest_sharpness);
  const EditLine line = edit_of("sharpness", ComponentKind::Edge, edges, {{"value", value}});
  return editor_.run(line, label, std::move(step), SelectAfter::AsBefore);
}

Verdict TagEditor::tag(double sharpness) {
  return tag_these(selector_.selected_edges(), sharpness,
                   recorded::Tag{editable_.node_name(), "selected", 0, sharpness, std::nullopt});
}

Verdict TagEditor::tag_edges(const Elements& edges, double sharpness) {
  return tag_these(edges, sharpness, std::nullopt);
}

Verdict TagEditor::tag_sharper_than(double degrees, double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  return tag_these(edges_sharper_than(*now->topology, *now->mesh, degrees), sharpness,
                   recorded::Tag{editable_.node_name(), "sharper-than", degrees, sharpness, std::nullopt});
}

std::size_t TagEditor::count_sharper_than(double degrees) {
  const PreparedMesh* now = editable_.prepared();
  return now == nullptr ? 0 : edges_sharper_than(*now->topology, *now->mesh, degrees).size();
}

Verdict TagEditor::tag_boundary(double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  return tag_these(boundary_edges(*now->topology), sharpness,
                   recorded::Tag{editable_.node_name(), "boundary", 0, sharpness, std::nullopt});
}

Verdict TagEditor::change_sharpness(double by) {
  const PreparedMesh* now = editable_.prepared();
  const Elements edges = selector_.selected_edges();
  if (now == nullptr || edges.empty()) return Verdict::Continue;
  const std::string label = selector_.counted("Sharpen", ComponentKind::Edge, edges.size());
  recorded::Tag step{editable_.node_name(), "selected", 0, std::nullopt, by};
  if (editable_.is_computed())
    return editor_.run_lines(sharpening_lines(*now->mesh, *now->topology, edges, by), label, std::move(step));
  return commit(label, with_sharpness_changed(now->mesh->tags, *now->topology, edges, by), std::move(step));
}

Verdict TagEditor::pin(bool pinned) {
  if (selector_.mode() == MeshMode::Object || selector_.selected_vertices().empty()) return Verdict::Continue;
  const Elements vertices = selector_.selected_vertices();
  const std::string label = selector_.counted(pinned ? "Pin" : "Unpin", ComponentKind::Vertex, vertices.size());
  const EditLine line = edit_of("pin", ComponentKind::Vertex, vertices, {{"pinned", pinned}});
  return editor_.run(line, label, recorded::Pin{editable_.node_name(), pinned}, SelectAfter::AsBefore);
}

// ---- Sets

Verdict TagEditor::commit(const std::string& label, MeshTags tags, recorded::Step step) {
  log_.begin();
  const auto now = editable_.mesh();
  if (!now || now->tags == tags) return Verdict::Continue;
  if (editable_.is_computed()) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "Crease sets belong to meshes that aren't computed: freeze the step first"));
  }
  log_.notes.clear();
  PolyMesh edited = *now;
  edited.tags = std::move(tags);
  editable_.session().edit(label, editable_.with_mesh(std::move(edited)));
  log_.done = std::move(step);
  return Verdict::Commit;
}

Verdict TagEditor::make_set(const std::string& name, double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  const MeshMode mode = selector_.mode();
  if (now == nullptr || mode == MeshMode::Object) return Verdict::Continue;
  const Elements vertices = mode == MeshMode::Vertex ? selector_.selected() : Elements{};
  const Elements edges = mode == MeshMode::Vertex ? Elements{} : selector_.selected_edges();
  return commit("Make the set " + name, with_set(now->mesh->tags, *now->topology, name, edges, vertices, sharpness),
                recorded::TagSet{editable_.node_name(), "make", name, "", sharpness});
}

Verdict TagEditor::rename_set(const std::string& name, const std::string& new_name) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Rename the set " + name, with_set_renamed(now->tags, name, new_name),
                recorded::TagSet{editable_.node_name(), "rename", name, new_name, std::nullopt});
}

Verdict TagEditor::set_set_sharpness(const std::string& name, double sharpness) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Sharpen the set " + name, with_set_sharpness(now->tags, name, sharpness),
                recorded::TagSet{editable_.node_name(), "sharpness", name, "", sharpness});
}

Verdict TagEditor::select_set(const std::string& name) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  const CreaseSet* set = find_set(now->mesh->tags, name);
  if (set == nullptr) throw Error(make_error(Category::Usage, "E_INPUT", "There is no set \"" + name + "\""));
  const bool pins = set->edges.empty();
  return selector_.choose(pins ? ComponentKind::Vertex : ComponentKind::Edge,
                          pins ? set_vertices(*set, *now->topology) : set_edges(*set, *now->topology),
                          recorded::TagSet{editable_.node_name(), "select", name, "", std::nullopt});
}

Verdict TagEditor::merge_sets(const std::string& into, const std::string& from) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Merge the sets " + into + " and " + from, with_sets_merged(now->tags, into, from),
                recorded::TagSet{editable_.node_name(), "merge", into, from, std::nullopt});
}

Verdict TagEditor::remove_set(const std::string& name, bool untag) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Remove the set " + name, without_set(now->tags, name, untag),
                recorded::TagSet{editable_.node_name(), untag ? "untag" : "remove", name, "", std::nullopt});
}

}  // namespace croquis
