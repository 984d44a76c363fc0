// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that become one.
#include "croquis/attribute_surface/curve_edit.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/network/loop_curves.h"

namespace croquis {
namespace {

/// The node of that id, or a new one at a place where there is no id.
Index node_or_new(AttributeNetwork& network, const std::string& id, const Vec3& place) {
  if (!id.empty()) return require_element(network, NetworkElement::Node, id);
  network.nodes.push_back({new_element_id(network, NetworkElement::Node), place});
  return static_cast<Index>(network.nodes.size() - 1);
}

void require_control(const std::vector<Vec3>& control) {
  if (control.size() == 1) refuse_edit("A curve needs two control points or more.");
  for (const Vec3& point : control) require_finite(point);
}

std::vector<bool> nodes_named(const AttributeNetwork& network, const std::vector<std::string>& ids) {
  std::vector<bool> named(network.nodes.size());
  for (const std::string& id : ids) named[require_element(network, NetworkElement::Node, id)] = true;
  return named;
}

/// Moves nodes with the ends of their curves.
void move_ends(AttributeNetwork& network, const std::vector<bool>& moved, const Vec3& by) {
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i]) network.nodes[i].point += by;
  }
  const auto way = [&](Index node) { return node != no_index && moved[node] ? by : Vec3(Vec3::Zero()); };
  for (AttributeCurve& curve : network.curves) {
    const bool moves = (curve.from != no_index && moved[curve.from]) || (curve.to != no_index && moved[curve.to]);
    if (moves && !curve.control.empty())
      curve.control = with_ends_moved_by(curve.control, way(curve.from), way(curve.to));
  }
}

/// The same curve with a control point more.
std::vector<Vec3> with_degree_raised(const std::vector<Vec3>& control) {
  const std::size_t count = control.size();
  std::vector<Vec3> raised = {control.front()};
  for (std::size_t i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    raised.push_back(share * control[i - 1] + (1 - share) * control[i]);
  }
  raised.push_back(control.back());
  return raised;
}

/// The node that a handle of a curve is at, or no_index.
Index node_of_handle(const AttributeCurve& curve, std::size_t control, std::size_t count) {
  if (control == 0) return curve.from;
  return control + 1 == count ? curve.to : no_index;
}

/// A handle that isn't at a node, and where it goes.
struct HandleTarget {
  Index curve = no_index;
  std::size_t control = 0;
  Vec3 place = Vec3::Zero();
};

bool is_one_place(const AttributeCurve& curve) {
  if (curve.control.empty()) return curve.from == curve.to;
  return std::ranges::all_of(curve.control, [&](const Vec3& point) { return point == curve.control.front(); });
}

/// Takes curves that go out of the loops of faces; those of which less than two sides are left go, too.
void shorten_loops(AttributeNetwork& network, RemovedElements& removed) {
  for (Index i = 0; i < network.faces.size(); ++i) {
    AttributeFace& face = network.faces[i];
    const std::size_t before = face.loop.size();
    std::erase_if(face.loop, [&](const AttributeSide& side) { return removed.curves[side.curve]; });
    if (face.loop.size() == before) continue;
    removed.faces[i] = face.loop.size() < 2;
    forget_places(network, i);
  }
}

/// Each node goes into another one, or stays where that is itself.
AttributeNetwork merged_into(AttributeNetwork network, const std::vector<Index>& into) {
  RemovedElements removed(network);
  const auto way = [&](Index node) {
    return node == no_index ? Vec3(Vec3::Zero()) : Vec3(network.nodes[into[node]].point - network.nodes[node].point);
  };
  for (Index i = 0; i < network.curves.size(); ++i) {
    AttributeCurve& curve = network.curves[i];
    const auto moves = [&](Index node) { return node != no_index && into[node] != node; };
    if (!moves(curve.from) && !moves(curve.to)) continue;
    const bool starts = moves(curve.from);
    const bool ends = moves(curve.to);
    if (!curve.control.empty()) curve.control = with_ends_moved_by(curve.control, way(curve.from), way(curve.to));
    for (Index* node : {&curve.from, &curve.to}) {
      if (*node != no_index) *node = into[*node];
    }
    if (!curve.control.empty() && starts) curve.control.front() = network.nodes[curve.from].point;
    if (!curve.control.empty() && ends) curve.control.back() = network.nodes[curve.to].point;
    removed.curves[i] = is_one_place(curve);
  }
  for (Index i = 0; i < into.size(); ++i) removed.nodes[i] = into[i] != i;
  shorten_loops(network, removed);
  return without_elements(std::move(network), removed);
}

std::vector<Index> each_itself(const AttributeNetwork& network) {
  std::vector<Index> nodes(network.nodes.size());
  std::iota(nodes.begin(), nodes.end(), Index{0});
  return nodes;
}

}  // namespace

AddedElement add_node(AttributeNetwork network, const Vec3& point) {
  require_finite(point);
  std::string id = new_element_id(network, NetworkElement::Node);
  network.nodes.push_back({id, point});
  return {std::move(network), std::move(id)};
}

AddedElement add_curve(AttributeNetwork network, const NewCurve& curve) {
  require_control(curve.control);
  AttributeCurve added{new_element_id(network, NetworkElement::Curve), no_index, no_index, curve.control, curve.join};
  if (curve.free) {
    if (curve.control.empty()) refuse_edit("A curve without nodes needs control points.");
  } else {
    if (curve.control.empty() && (curve.from.empty() || curve.to.empty()))
      refuse_edit("A straight curve needs a node at both ends.");
    const Vec3 start = curve.control.empty() ? Vec3(Vec3::Zero()) : curve.control.front();
    const Vec3 end = curve.control.empty() ? Vec3(Vec3::Zero()) : curve.control.back();
    added.from = node_or_new(network, curve.from, start);
    added.to = node_or_new(network, curve.to, end);
  }
  if (!curve.free && !added.control.empty())
    added.control = with_ends_moved(added.control, network.nodes[added.from].point, network.nodes[added.to].point);
  std::string id = added.id;
  network.curves.push_back(std::move(added));
  return {std::move(network), std::move(id)};
}

std::vector<Vec3> with_ends_moved_by(std::vector<Vec3> control, const Vec3& start, const Vec3& end) {
  const double degree = static_cast<double>(std::max<std::size_t>(control.size(), 2) - 1);
  for (std::size_t j = 0; j < control.size(); ++j) {
    const double share = static_cast<double>(j) / degree;
    control[j] += (1 - share) * start + share * end;
  }
  return control;
}

AttributeNetwork move_nodes(AttributeNetwork network, const std::vector<std::string>& nodes, const Vec3& by) {
  require_finite(by);
  const std::vector<bool> moved = nodes_named(network, nodes);
  move_ends(network, moved, by);
  return network;
}

std::vector<Vec3> control_handles(const AttributeNetwork& network, const AttributeCurve& curve) {
  std::vector<Vec3> control = control_polygon(network, curve);
  while (control.size() < 4) control = with_degree_raised(control);
  return control;
}

AttributeNetwork move_handles(AttributeNetwork network, const std::vector<ControlHandle>& handles, const Vec3& by) {
  require_finite(by);
  std::vector<bool> moved(network.nodes.size());
  std::vector<HandleTarget> targets;
  for (const ControlHandle& handle : handles) {
    const Index curve = require_element(network, NetworkElement::Curve, handle.curve);
    const std::vector<Vec3> polygon = control_handles(network, network.curves[curve]);
    if (handle.control >= polygon.size())
      refuse_edit("Curve \"" + handle.curve + "\" has no control point " + std::to_string(handle.control) + ".",
                  {named_curve(handle.curve)});
    const Index node = node_of_handle(network.curves[curve], handle.control, polygon.size());
    if (node != no_index) {
      moved[node] = true;
    } else {
      targets.push_back({curve, handle.control, polygon[handle.control] + by});
    }
  }
  move_ends(network, moved, by);
  for (const HandleTarget& target : targets) {
    AttributeCurve& curve = network.curves[target.curve];
    curve.control = control_handles(network, curve);
    curve.control[target.control] = target.place;
  }
  return network;
}

AttributeNetwork move_curves(AttributeNetwork network, const std::vector<std::string>& curves, const Vec3& by) {
  require_finite(by);
  std::vector<bool> moved(network.nodes.size());
  std::vector<std::pair<Index, std::vector<Vec3>>> loose;  // with an end that no node takes along
  for (const std::string& id : curves) {
    const Index index = require_element(network, NetworkElement::Curve, id);
    const AttributeCurve& curve = network.curves[index];
    for (const Index node : {curve.from, curve.to}) {
      if (node != no_index) moved[node] = true;
    }
    if (curve.from != no_index && curve.to != no_index) continue;
    loose.emplace_back(index, curve.control);
    for (Vec3& point : loose.back().second) point += by;
  }
  move_ends(network, moved, by);
  for (auto& [index, control] : loose) network.curves[index].control = std::move(control);
  return network;
}

AttributeNetwork tie_ends(AttributeNetwork network, const std::string& id, double reach) {
  const Index index = require_element(network, NetworkElement::Curve, id);
  const auto tie = [&](Index node, const Vec3& place) {
    if (node != no_index) return node;
    Index nearest = no_index;
    double least = reach;
    for (Index i = 0; i < network.nodes.size(); ++i) {
      const double distance = (network.nodes[i].point - place).norm();
      if (distance > least || (distance == least && nearest != no_index)) continue;
      least = distance;
      nearest = i;
    }
    return nearest != no_index ? nearest : node_or_new(network, {}, place);
  };
  const std::vector<Vec3> control = control_polygon(network, network.curves[index]);
  const Index from = tie(network.curves[index].from, control.front());
  const Index to = tie(network.curves[index].to, control.back());
  AttributeCurve& curve = network.curves[index];
  curve.from = from;
  curve.to = to;
  if (!curve.control.empty())
    curve.control = with_ends_moved(control, network.nodes[from].point, network.nodes[to].point);
  return network;
}

AttributeNetwork set_join(AttributeNetwork network, const std::vector<std::string>& curves, CurveJoin join) {
  for (const std::string& id : curves) network.curves[require_element(network, NetworkElement::Curve, id)].join = join;
  return network;
}

AttributeNetwork merge_nodes(AttributeNetwork network, const std::string& node, const std::string& into) {
  std::vector<Index> targets = each_itself(network);
  const Index target = require_element(network, NetworkElement::Node, into);
  targets[require_element(network, NetworkElement::Node, node)] = target;
  return merged_into(std::move(network), targets);
}

}  // namespace croquis
