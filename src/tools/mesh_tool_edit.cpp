// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/base/error.h"
#include "tools/mesh_tool_cache.h"

namespace croquis {
std::string MeshTool::node_name() const {
  const Node* node = session_.document().find(node_);
  return node == nullptr ? "" : node->name;
}

/// "Move 3 vertices", in Object mode "Move bolt".
std::string MeshTool::counted(const std::string& verb, ComponentKind wanted, std::size_t count) const {
  if (mode_ == MeshMode::Object) return verb + ' ' + node_name();
  return verb + ' ' + std::to_string(count) + ' ' + (count == 1 ? singular(wanted) : plural(wanted));
}

Document MeshTool::with_mesh(PolyMesh mesh) const {
  Node node = *session_.document().find(node_);
  node.source = std::make_shared<const PolyMesh>(std::move(mesh));
  return session_.document().with(std::move(node));
}

Verdict MeshTool::commit(const std::string& label, MeshEdit edit, ComponentSelection then) {
  notes_ = std::move(edit.lost);
  const std::uint64_t before = session_.revision();
  session_.edit(label, with_mesh(std::move(edit.mesh)), std::move(then));
  return session_.revision() == before ? Verdict::Continue : Verdict::Commit;
}

// ---- Places

Verdict MeshTool::transform(const std::string& verb, const Eigen::Affine3d& map, recorded::Step step) {
  give_up();
  const auto now = mesh();
  if (!now || selected_vertices().empty()) return Verdict::Continue;
  notes_.clear();
  const std::string label = counted(verb, kind(), selected().size());
  const std::uint64_t before = session_.revision();
  session_.edit(label, with_mesh(transformed(*now, selected_vertices(), map)));
  if (session_.revision() == before) return Verdict::Continue;
  done_ = std::move(step);
  return Verdict::Commit;
}

Verdict MeshTool::move_selected(const Vec3& by) {
  return transform("Move", Eigen::Affine3d(Eigen::Translation3d(by)), recorded::Move{node_name(), by});
}

Verdict MeshTool::rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot) {
  if (fresh() == nullptr || axis.isZero(0)) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : middle();
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.translate(about).rotate(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized())).translate(-about);
  return transform("Rotate", map, recorded::Rotate{node_name(), axis, degrees, about});
}

Verdict MeshTool::scale_selected(const Vec3& factors, std::optional<Vec3> pivot) {
  if (fresh() == nullptr) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : middle();
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.translate(about).scale(factors).translate(-about);
  return transform("Scale", map, recorded::Scale{node_name(), factors, about});
}

// ---- Connectivity

Verdict MeshTool::delete_selected() {
  give_up();
  const Cache* cache = fresh();
  const Elements chosen = selected();
  if (cache == nullptr || chosen.empty()) return Verdict::Continue;
  const PolyMesh& now = *cache->mesh;
  const std::string label = counted(mode_ == MeshMode::Face ? "Delete" : "Dissolve", kind(), chosen.size());
  MeshEdit edit = mode_ == MeshMode::Face   ? delete_faces(now, *cache->topology, chosen)
                  : mode_ == MeshMode::Edge ? dissolve_edges(now, *cache->topology, chosen)
                                            : dissolve_vertices(now, *cache->topology, chosen);
  const bool refused = edit.mesh.face_count() == now.face_count() && edit.mesh.vertex_count() == now.vertex_count() &&
                       edit.mesh.corners == now.corners;
  if (refused) {
    notes_ = std::move(edit.lost);
    return Verdict::Continue;
  }
  done_ = recorded::Action{"delete"};
  return commit(label, std::move(edit), {});
}

Verdict MeshTool::extrude(const Vec3& by) {
  give_up();
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ != MeshMode::Face || selected().empty()) return Verdict::Continue;
  MeshEdit edit = extrude_faces(*cache->mesh, *cache->topology, selected(), by);
  ComponentSelection then{node_, ComponentKind::Face, edit.moved_faces};
  done_ = recorded::Extrude{node_name(), by};
  const std::string label = counted("Extrude", kind(), then.elements.size());
  return commit(label, std::move(edit), std::move(then));
}

Verdict MeshTool::extrude_along_normal(double distance) {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ != MeshMode::Face) return Verdict::Continue;
  return extrude(distance * mean_normal(*cache->mesh, selected()));
}

Verdict MeshTool::cut_loop(Index edge, double at) {
  give_up();
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  MeshEdit edit = loop_cut(*cache->mesh, *cache->topology, edge, at);
  recorded::LoopCut step{node_name(), edge, at};
  const std::vector<std::array<Index, 2>> pairs = edit.new_edges;
  const Verdict verdict = commit("Cut a loop", std::move(edit), {});
  done_ = std::move(step);
  // The new loop is selected, as part of the same step: selections aren't steps of their own.
  if (mode_ != MeshMode::Object) {
    set_mode(MeshMode::Edge);
    session_.select_components({node_, ComponentKind::Edge, edges_of(*fresh()->topology, pairs)});
  }
  return verdict;
}

// ---- Tags

Verdict MeshTool::set_tags(MeshTags tags, const std::string& label) {
  return commit_tags(label, std::move(tags), std::nullopt);
}

Verdict MeshTool::commit_tags(const std::string& label, MeshTags tags, std::optional<recorded::Step> step) {
  give_up();
  const auto now = mesh();
  if (!now || now->tags == tags) return Verdict::Continue;
  notes_.clear();
  PolyMesh edited = *now;
  edited.tags = std::move(tags);
  session_.edit(label, with_mesh(std::move(edited)));
  done_ = std::move(step);
  return Verdict::Commit;
}

Verdict MeshTool::tag(double sharpness) {
  const Cache* cache = fresh();
  const Elements edges = selected_edges();
  if (cache == nullptr || edges.empty()) return Verdict::Continue;
  return commit_tags(counted(sharpness > 0 ? "Tag" : "Untag", ComponentKind::Edge, edges.size()),
                     with_sharpness(cache->mesh->tags, *cache->topology, edges, sharpness),
                     recorded::Tag{node_name(), "selected", 0, sharpness, std::nullopt});
}

Verdict MeshTool::change_sharpness(double by) {
  const Cache* cache = fresh();
  const Elements edges = selected_edges();
  if (cache == nullptr || edges.empty()) return Verdict::Continue;
  return commit_tags(counted("Sharpen", ComponentKind::Edge, edges.size()),
                     with_sharpness_changed(cache->mesh->tags, *cache->topology, edges, by),
                     recorded::Tag{node_name(), "selected", 0, std::nullopt, by});
}

Verdict MeshTool::tag_edges(const Elements& edges, double sharpness) {
  const Cache* cache = fresh();
  if (cache == nullptr || edges.empty()) return Verdict::Continue;
  return commit_tags(counted(sharpness > 0 ? "Tag" : "Untag", ComponentKind::Edge, edges.size()),
                     with_sharpness(cache->mesh->tags, *cache->topology, edges, sharpness), std::nullopt);
}

Verdict MeshTool::tag_sharper_than(double degrees, double sharpness) {
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  const Verdict verdict = tag_edges(edges_sharper_than(*cache->topology, *cache->mesh, degrees), sharpness);
  if (verdict == Verdict::Commit) done_ = recorded::Tag{node_name(), "sharper-than", degrees, sharpness, std::nullopt};
  return verdict;
}

std::size_t MeshTool::count_sharper_than(double degrees) {
  const Cache* cache = fresh();
  return cache == nullptr ? 0 : edges_sharper_than(*cache->topology, *cache->mesh, degrees).size();
}

Verdict MeshTool::tag_boundary(double sharpness) {
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  const Verdict verdict = tag_edges(boundary_edges(*cache->topology), sharpness);
  if (verdict == Verdict::Commit) done_ = recorded::Tag{node_name(), "boundary", 0, sharpness, std::nullopt};
  return verdict;
}

Verdict MeshTool::pin(bool pinned) {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ == MeshMode::Object || selected_vertices().empty()) return Verdict::Continue;
  const Elements& vertices = selected_vertices();
  return commit_tags(counted(pinned ? "Pin" : "Unpin", ComponentKind::Vertex, vertices.size()),
                     with_pins(cache->mesh->tags, vertices, pinned), recorded::Pin{node_name(), pinned});
}

// ---- Sets

Verdict MeshTool::make_set(const std::string& name, double sharpness) {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ == MeshMode::Object) return Verdict::Continue;
  const Elements vertices = mode_ == MeshMode::Vertex ? selected() : Elements{};
  const Elements edges = mode_ == MeshMode::Vertex ? Elements{} : selected_edges();
  return commit_tags("Make the set " + name,
                     with_set(cache->mesh->tags, *cache->topology, name, edges, vertices, sharpness),
                     recorded::TagSet{node_name(), "make", name, "", sharpness});
}

Verdict MeshTool::rename_set(const std::string& name, const std::string& new_name) {
  const auto now = mesh();
  if (!now) return Verdict::Continue;
  return commit_tags("Rename the set " + name, with_set_renamed(now->tags, name, new_name),
                     recorded::TagSet{node_name(), "rename", name, new_name, std::nullopt});
}

Verdict MeshTool::set_set_sharpness(const std::string& name, double sharpness) {
  const auto now = mesh();
  if (!now) return Verdict::Continue;
  return commit_tags("Sharpen the set " + name, with_set_sharpness(now->tags, name, sharpness),
                     recorded::TagSet{node_name(), "sharpness", name, "", sharpness});
}

Verdict MeshTool::select_set(const std::string& name) {
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  const CreaseSet* set = find_set(cache->mesh->tags, name);
  if (set == nullptr) throw Error(make_error(Category::Usage, "E_INPUT", "There is no set \"" + name + "\""));
  const bool pins = set->edges.empty();
  return choose(pins ? ComponentKind::Vertex : ComponentKind::Edge,
                pins ? set_vertices(*set, *cache->topology) : set_edges(*set, *cache->topology),
                recorded::TagSet{node_name(), "select", name, "", std::nullopt});
}

Verdict MeshTool::merge_sets(const std::string& into, const std::string& from) {
  const auto now = mesh();
  if (!now) return Verdict::Continue;
  return commit_tags("Merge the sets " + into + " and " + from, with_sets_merged(now->tags, into, from),
                     recorded::TagSet{node_name(), "merge", into, from, std::nullopt});
}

Verdict MeshTool::remove_set(const std::string& name, bool untag) {
  const auto now = mesh();
  if (!now) return Verdict::Continue;
  return commit_tags("Remove the set " + name, without_set(now->tags, name, untag),
                     recorded::TagSet{node_name(), untag ? "untag" : "remove", name, "", std::nullopt});
}

}  // namespace croquis
