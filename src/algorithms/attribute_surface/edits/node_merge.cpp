// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that become one.
#include <algorithm>
#include <numeric>

#include "algorithms/attribute_surface/edits/edit_errors.h"
#include "algorithms/attribute_surface/edits/element_removal.h"
#include "croquis/attribute_surface/curve_edit.h"

namespace croquis {
namespace {

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

AttributeNetwork merge_nodes(AttributeNetwork network, const std::string& node, const std::string& into) {
  std::vector<Index> targets = each_itself(network);
  const Index target = require_element(network, NetworkElement::Node, into);
  targets[require_element(network, NetworkElement::Node, node)] = target;
  return merged_into(std::move(network), targets);
}

AttributeNetwork merge_near_nodes(AttributeNetwork network, double tolerance) {
  std::vector<Index> targets = each_itself(network);
  std::vector<Index> by_x = targets;
  const auto place = [&](Index node) -> const Vec3& { return network.nodes[node].point; };
  std::ranges::stable_sort(by_x, [&](Index a, Index b) { return place(a).x() < place(b).x(); });
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    for (std::size_t k = i + 1; k < by_x.size() && place(by_x[k]).x() - place(by_x[i]).x() <= tolerance; ++k) {
      if ((place(by_x[k]) - place(by_x[i])).norm() > tolerance) continue;
      const auto [first, later] = std::minmax(by_x[i], by_x[k]);
      targets[later] = std::min(targets[later], first);
    }
  }
  for (Index i = 0; i < targets.size(); ++i) targets[i] = targets[targets[i]];  // the target of a lower one is final
  return merged_into(std::move(network), targets);
}

}  // namespace croquis
