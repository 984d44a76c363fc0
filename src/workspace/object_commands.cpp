// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/object_commands.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_names.h"

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

std::vector<NodeId> first_nodes(const Workspace& workspace, const std::vector<NodeId>& objects) {
  std::vector<NodeId> firsts;
  for (const NodeId node : objects) {
    const WorkObject* each = workspace.object(node);
    if (each != nullptr && !names(firsts, each->chain.front())) firsts.push_back(each->chain.front());
  }
  return firsts;
}

/// One step of the history, called by the object's name, or by their number.
void edit_objects(Workspace& workspace, const std::string& verb, const std::vector<NodeId>& objects,
                  Document document) {
  if (objects.empty()) return;
  const WorkObject* only = objects.size() == 1 ? workspace.object(objects.front()) : nullptr;
  const std::string what = only == nullptr ? std::to_string(objects.size()) + " objects" : readable_name(only->name);
  workspace.session().edit(verb + ' ' + what, std::move(document));
}

}  // namespace

std::vector<NodeId> picked(const Workspace& workspace) {
  std::vector<NodeId> nodes;
  for (const SelectedItem& item : workspace.session().selection()) {
    const WorkObject* owner = item.part.empty() ? workspace.object(item.node) : nullptr;
    if (owner != nullptr) nodes.push_back(owner->node);
  }
  std::vector<NodeId> ordered;
  for (const WorkObject& each : workspace.objects()) {
    if (names(nodes, each.node)) ordered.push_back(each.node);
  }
  return ordered;
}

std::vector<NodeId> picked_or_active(const Workspace& workspace) {
  std::vector<NodeId> nodes = picked(workspace);
  const WorkObject* object = workspace.active();
  if (nodes.empty() && object != nullptr) nodes.push_back(object->node);
  return nodes;
}

std::vector<NodeId> with_groups(const Workspace& workspace, const std::vector<NodeId>& wanted) {
  std::set<std::string> groups;
  for (const NodeId node : wanted) {
    if (const WorkObject* each = workspace.object(node); each != nullptr && !each->group.empty())
      groups.insert(each->group);
  }
  std::vector<NodeId> nodes;
  for (const WorkObject& each : workspace.objects()) {
    if (names(wanted, each.node) || groups.contains(each.group)) nodes.push_back(each.node);
  }
  return nodes;
}

NodeId add_source(Workspace& workspace, const std::string& name, Value value) {
  const Document& before = workspace.session().document();
  const NodeId id = before.next_id();
  Node node;
  node.name = free_name(before, name);
  node.source = std::move(value);
  Document document = before.with(std::move(node));
  // The first object of an empty document is no step of the history.
  if (before.nodes().empty() && workspace.session().undo_labels().empty() && !workspace.session().modified()) {
    workspace.load(std::move(document));
  } else {
    workspace.session().edit("Open " + readable_name(name), std::move(document));
  }
  workspace.session().select({{id, ""}});
  return id;
}

void remove_objects(Workspace& workspace, const std::vector<NodeId>& objects) {
  std::vector<NodeId> removed;
  Document document = workspace.session().document();
  for (const NodeId node : objects) {
    const WorkObject* each = workspace.object(node);
    if (each == nullptr) continue;
    document = without_object(document, each->node);
    removed.push_back(each->node);
  }
  edit_objects(workspace, "Delete", removed, std::move(document));
}

void copy_objects(Workspace& workspace, const std::vector<NodeId>& wanted) {
  std::vector<NodeId> objects;
  for (const NodeId node : wanted) {
    if (workspace.object(node) != nullptr) objects.push_back(workspace.object(node)->node);
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::map<std::string, std::string> groups;
  for (const NodeId node : objects) {
    const WorkObject& each = *workspace.object(node);
    if (!each.group.empty()) groups.try_emplace(each.group, free_group(workspace.session().document(), each.group));
    if (const BoundingBox box = placed_bounds(workspace, each)) {
      low = std::min(low, (*box)[0].x());
      high = std::max(high, (*box)[1].x());
    }
  }
  Document document = workspace.session().document();
  Selection copies;
  for (const NodeId node : objects) {
    AddedNode added = with_object_copied(document, node);
    const NodeId front = chain_to(added.document, workspace.registry(), added.node).front();
    document = with_each(std::move(added.document), {front}, [&](Node& first) {
      if (low < high) first.placement.position.x() += copy_gap * (high - low);
      if (!first.group.empty()) first.group = groups.at(first.group);
    });
    copies.push_back({added.node, ""});
  }
  edit_objects(workspace, "Duplicate", objects, std::move(document));
  if (copies.empty()) return;
  workspace.set_active(copies.front().node);
  workspace.session().select(std::move(copies));
}

void rename_object(Workspace& workspace, NodeId id, const std::string& name) {
  const WorkObject* renamed = workspace.object(id);
  if (renamed == nullptr || name.empty() || name == renamed->name) return;
  Node node = *workspace.session().document().find(renamed->chain.front());
  node.name = free_name(workspace.session().document(), name);
  edit_objects(workspace, "Rename", {id}, workspace.session().document().with(std::move(node)));
}

void show_objects(Workspace& workspace, const std::vector<NodeId>& objects, bool visible) {
  std::vector<NodeId> changed;
  for (const NodeId node : objects) {
    const WorkObject* each = workspace.object(node);
    if (each != nullptr && workspace.session().document().find(each->node)->visible != visible)
      changed.push_back(each->node);
  }
  if (visible && !workspace.isolated().empty()) {
    std::vector<NodeId> seen(workspace.isolated().begin(), workspace.isolated().end());
    seen.insert(seen.end(), objects.begin(), objects.end());
    workspace.isolate(seen);
  }
  edit_objects(workspace, visible ? "Show" : "Hide", changed,
               with_each(workspace.session().document(), changed, [&](Node& node) { node.visible = visible; }));
}

Document with_objects_placed(const Workspace& workspace, Document document, const std::vector<PlacedObject>& objects) {
  for (const PlacedObject& placed : objects) {
    document = with_each(std::move(document), first_nodes(workspace, {placed.node}),
                         [&](Node& node) { node.placement = placed.placement; });
  }
  return document;
}

void place_objects(Workspace& workspace, const std::vector<PlacedObject>& objects) {
  std::vector<NodeId> nodes;
  for (const PlacedObject& placed : objects) {
    nodes.push_back(placed.node);
    if (is_valid(placed.placement)) continue;
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "An object can't stand there: its numbers must be finite, and its size above 0"));
  }
  edit_objects(workspace, "Place", nodes, with_objects_placed(workspace, workspace.session().document(), objects));
}

void group_objects(Workspace& workspace, const std::vector<NodeId>& objects) {
  const std::string name = free_group(workspace.session().document(), "Group");
  edit_objects(workspace, "Group", objects,
               with_each(workspace.session().document(), first_nodes(workspace, objects),
                         [&](Node& node) { node.group = name; }));
}

void ungroup_objects(Workspace& workspace, const std::vector<NodeId>& objects) {
  edit_objects(workspace, "Ungroup", objects,
               with_each(workspace.session().document(), first_nodes(workspace, objects),
                         [](Node& node) { node.group.clear(); }));
}

void rename_group(Workspace& workspace, const std::string& group, const std::string& name) {
  if (name.empty() || name == group) return;
  std::vector<NodeId> firsts;
  for (const auto& node : workspace.session().document().nodes()) {
    if (node->group == group) firsts.push_back(node->id);
  }
  const std::string free = free_group(workspace.session().document(), name);
  workspace.session().edit("Rename " + group,
                           with_each(workspace.session().document(), firsts, [&](Node& node) { node.group = free; }));
}

}  // namespace croquis
