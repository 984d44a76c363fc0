// SPDX-License-Identifier: GPL-3.0-or-later
// What people do to whole objects.
#include <algorithm>
#include <limits>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/object_names.h"
#include "croquis/workspace/workspace.h"

namespace croquis {
namespace {

constexpr double copy_gap = 1.1;  // from a copy to its original, times how wide they are

/// The same in each of these nodes.
template <class Change>
Document with_each(Document document, const std::vector<NodeId>& nodes, const Change& change) {
  for (const NodeId id : nodes) {
    Node node = *document.find(id);
    change(node);
    document = document.with(std::move(node));
  }
  return document;
}

bool names(const std::vector<NodeId>& nodes, NodeId node) { return std::ranges::find(nodes, node) != nodes.end(); }

/// A group's name that none has yet.
std::string free_group(const Document& document, const std::string& wanted) {
  std::string name = wanted;
  const auto is_taken = [&](const auto& node) { return node->group == name; };
  for (int number = 2; std::ranges::any_of(document.nodes(), is_taken); ++number)
    name = wanted + ' ' + std::to_string(number);
  return name;
}

}  // namespace

std::vector<NodeId> Workspace::picked() const {
  std::vector<NodeId> nodes;
  for (const SelectedItem& item : session_.selection()) {
    const WorkObject* owner = item.part.empty() ? object(item.node) : nullptr;
    if (owner != nullptr) nodes.push_back(owner->node);
  }
  std::vector<NodeId> ordered;
  for (const WorkObject& each : objects_) {
    if (names(nodes, each.node)) ordered.push_back(each.node);
  }
  return ordered;
}

std::vector<NodeId> Workspace::picked_or_active() const {
  std::vector<NodeId> nodes = picked();
  const WorkObject* object = active();
  if (nodes.empty() && object != nullptr) nodes.push_back(object->node);
  return nodes;
}

std::vector<NodeId> Workspace::with_groups(const std::vector<NodeId>& wanted) const {
  std::set<std::string> groups;
  for (const NodeId node : wanted) {
    if (const WorkObject* each = object(node); each != nullptr && !each->group.empty()) groups.insert(each->group);
  }
  std::vector<NodeId> nodes;
  for (const WorkObject& each : objects_) {
    if (names(wanted, each.node) || groups.contains(each.group)) nodes.push_back(each.node);
  }
  return nodes;
}

BoundingBox Workspace::own_bounds(const WorkObject& object) const {
  const auto& mesh = object.shown();
  if (!mesh) return std::nullopt;
  Measured& measured = measured_[object.node];
  if (measured.mesh.lock() != mesh) measured = {mesh, bounds_of(*mesh)};
  return measured.box;
}

BoundingBox Workspace::bounds(const WorkObject& object) const {
  const BoundingBox own = own_bounds(object);
  return own ? BoundingBox(transformed(*own, object.placement.map())) : std::nullopt;
}

void Workspace::isolate(const std::vector<NodeId>& objects) {
  const std::vector<NodeId> firsts = first_nodes(objects);
  isolated_ = {firsts.begin(), firsts.end()};
  list_again();
}

std::vector<NodeId> Workspace::first_nodes(const std::vector<NodeId>& objects) const {
  std::vector<NodeId> firsts;
  for (const NodeId node : objects) {
    const WorkObject* each = object(node);
    if (each != nullptr && !names(firsts, each->chain.front())) firsts.push_back(each->chain.front());
  }
  return firsts;
}

/// One step of the history, called by the object's name, or by their number.
void Workspace::edit_objects(const std::string& verb, const std::vector<NodeId>& objects, Document document) {
  if (objects.empty()) return;
  const WorkObject* only = objects.size() == 1 ? object(objects.front()) : nullptr;
  const std::string what = only == nullptr ? std::to_string(objects.size()) + " objects" : readable_name(only->name);
  session_.edit(verb + ' ' + what, std::move(document));
}

void Workspace::remove_objects(const std::vector<NodeId>& objects) {
  std::vector<NodeId> removed;
  Document document = session_.document();
  for (const NodeId node : objects) {
    const WorkObject* each = object(node);
    if (each == nullptr) continue;
    document = without_object(document, each->node);
    removed.push_back(each->node);
  }
  edit_objects("Delete", removed, std::move(document));
}

void Workspace::copy_objects(const std::vector<NodeId>& wanted) {
  std::vector<NodeId> objects;
  for (const NodeId node : wanted) {
    if (object(node) != nullptr) objects.push_back(object(node)->node);
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::map<std::string, std::string> groups;
  for (const NodeId node : objects) {
    const WorkObject& each = *object(node);
    if (!each.group.empty()) groups.try_emplace(each.group, free_group(session_.document(), each.group));
    if (const BoundingBox box = bounds(each)) {
      low = std::min(low, (*box)[0].x());
      high = std::max(high, (*box)[1].x());
    }
  }
  Document document = session_.document();
  Selection copies;
  for (const NodeId node : objects) {
    AddedNode added = with_object_copied(document, node);
    const NodeId front = chain_to(added.document, registry_, added.node).front();
    document = with_each(std::move(added.document), {front}, [&](Node& first) {
      if (low < high) first.placement.position.x() += copy_gap * (high - low);
      if (!first.group.empty()) first.group = groups.at(first.group);
    });
    copies.push_back({added.node, ""});
  }
  edit_objects("Duplicate", objects, std::move(document));
  if (copies.empty()) return;
  active_ = copies.front().node;
  session_.select(std::move(copies));
}

void Workspace::rename_object(NodeId id, const std::string& name) {
  const WorkObject* renamed = object(id);
  if (renamed == nullptr || name.empty() || name == renamed->name) return;
  Node node = *session_.document().find(renamed->chain.front());
  node.name = free_name(session_.document(), name);
  edit_objects("Rename", {id}, session_.document().with(std::move(node)));
}

void Workspace::show_objects(const std::vector<NodeId>& objects, bool visible) {
  std::vector<NodeId> changed;
  for (const NodeId node : objects) {
    const WorkObject* each = object(node);
    if (each != nullptr && session_.document().find(each->node)->visible != visible) changed.push_back(each->node);
  }
  if (visible && is_isolating()) {
    for (const NodeId first : first_nodes(objects)) isolated_.insert(first);
    if (changed.empty()) return list_again();
  }
  edit_objects(visible ? "Show" : "Hide", changed,
               with_each(session_.document(), changed, [&](Node& node) { node.visible = visible; }));
}

Document Workspace::with_objects_placed(Document document, const std::vector<PlacedObject>& objects) const {
  for (const PlacedObject& placed : objects) {
    document = with_each(std::move(document), first_nodes({placed.node}),
                         [&](Node& node) { node.placement = placed.placement; });
  }
  return document;
}

void Workspace::place_objects(const std::vector<PlacedObject>& objects) {
  std::vector<NodeId> nodes;
  for (const PlacedObject& placed : objects) {
    nodes.push_back(placed.node);
    if (is_valid(placed.placement)) continue;
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "An object can't stand there: its numbers must be finite, and its size above 0"));
  }
  edit_objects("Place", nodes, with_objects_placed(session_.document(), objects));
}

void Workspace::group_objects(const std::vector<NodeId>& objects) {
  const std::string name = free_group(session_.document(), "Group");
  edit_objects("Group", objects,
               with_each(session_.document(), first_nodes(objects), [&](Node& node) { node.group = name; }));
}

void Workspace::ungroup_objects(const std::vector<NodeId>& objects) {
  edit_objects("Ungroup", objects,
               with_each(session_.document(), first_nodes(objects), [](Node& node) { node.group.clear(); }));
}

void Workspace::rename_group(const std::string& group, const std::string& name) {
  if (name.empty() || name == group) return;
  std::vector<NodeId> firsts;
  for (const auto& node : session_.document().nodes()) {
    if (node->group == group) firsts.push_back(node->id);
  }
  const std::string free = free_group(session_.document(), name);
  session_.edit("Rename " + group, with_each(session_.document(), firsts, [&](Node& node) { node.group = free; }));
}

}  // namespace croquis
