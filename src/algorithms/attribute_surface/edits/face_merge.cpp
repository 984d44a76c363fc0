// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that become one, and what is deleted.
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/edits/edit_errors.h"
#include "algorithms/attribute_surface/edits/element_removal.h"
#include "croquis/attribute_surface/face_edit.h"

namespace croquis {
namespace {

/// Two faces and the curves that go from between them.
struct FaceMerge {
  Index first = no_index;
  Index second = no_index;
  std::vector<Index> between;
  std::vector<AttributeSide> loop;  ///< of the merged face
  bool turned = false;              ///< the second one had to be turned round
};

bool is_in(const std::vector<AttributeSide>& loop, Index curve) {
  return std::ranges::find(loop, curve, &AttributeSide::curve) != loop.end();
}

/// The loop begun behind its sides along these curves, without them; nothing where they aren't in one row.
std::optional<std::vector<AttributeSide>> rest_of(std::vector<AttributeSide> loop, const std::vector<Index>& row) {
  const auto in_row = [&](const AttributeSide& side) { return std::ranges::find(row, side.curve) != row.end(); };
  const std::size_t count = loop.size();
  if (row.size() >= count) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    if (!in_row(loop[i]) || in_row(loop[(i + 1) % count])) continue;
    std::ranges::rotate(loop, loop.begin() + static_cast<std::ptrdiff_t>((i + 1) % count));
    break;
  }
  const std::size_t left = count - row.size();
  if (std::any_of(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(left), in_row)) return std::nullopt;
  loop.resize(left);
  return loop;
}

std::optional<FaceMerge> plan_merge(const AttributeNetwork& network, Index curve) {
  const std::vector<Index> faces = faces_along(network, curve);
  if (faces.size() != 2) return std::nullopt;
  FaceMerge merge{faces[0], faces[1], {}, {}, false};
  const std::vector<AttributeSide>& first = network.faces[merge.first].loop;
  std::vector<AttributeSide> second = network.faces[merge.second].loop;
  for (const AttributeSide& side : first) {
    if (!is_in(second, side.curve)) continue;
    merge.between.push_back(side.curve);
    if (faces_along(network, side.curve).size() != 2) return std::nullopt;
  }
  merge.turned = std::ranges::find(first, curve, &AttributeSide::curve)->reversed ==
                 std::ranges::find(second, curve, &AttributeSide::curve)->reversed;
  if (merge.turned) {
    std::ranges::reverse(second);
    for (AttributeSide& side : second) side.reversed = !side.reversed;
  }
  auto first_rest = rest_of(first, merge.between);
  const auto second_rest = rest_of(second, merge.between);
  if (!first_rest || !second_rest) return std::nullopt;
  merge.loop = std::move(*first_rest);
  merge.loop.insert(merge.loop.end(), second_rest->begin(), second_rest->end());
  return merge;
}

/// Marks nodes that have lost their last curve.
void remove_bare_nodes(const AttributeNetwork& network, RemovedElements& removed) {
  std::vector<bool> used(network.nodes.size());
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    for (const Index node : {network.curves[i].from, network.curves[i].to}) {
      if (node != no_index && !removed.curves[i]) used[node] = true;
    }
  }
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    for (const Index node : {network.curves[i].from, network.curves[i].to}) {
      if (node != no_index && removed.curves[i] && !used[node]) removed.nodes[node] = true;
    }
  }
}

/// Marks inner curves without nodes that only faces that go have.
void remove_lone_inner_curves(const AttributeNetwork& network, RemovedElements& removed) {
  std::set<Index> kept;
  for (std::size_t i = 0; i < network.faces.size(); ++i) {
    for (const InnerCurve& inner : network.faces[i].inner) {
      if (!removed.faces[i]) kept.insert(inner.curve);
    }
  }
  for (std::size_t i = 0; i < network.faces.size(); ++i) {
    for (const InnerCurve& inner : network.faces[i].inner) {
      const AttributeCurve& curve = network.curves[inner.curve];
      const bool is_free = curve.from == no_index && curve.to == no_index;
      if (removed.faces[i] && is_free && !kept.contains(inner.curve)) removed.curves[inner.curve] = true;
    }
  }
}

void give_to_first(AttributeNetwork& network, const FaceMerge& merge) {
  AttributeFace& first = network.faces[merge.first];
  for (const InnerCurve& inner : network.faces[merge.second].inner) {
    if (std::ranges::find(first.inner, inner.curve, &InnerCurve::curve) == first.inner.end())
      first.inner.push_back(inner);
  }
  network.faces[merge.second].inner.clear();
  for (PointAttribute& point : network.points) {
    if (point.face == merge.second) point.face = merge.first;
  }
  for (SlopeAttribute& slope : network.slopes) {
    if (slope.face != merge.second) continue;
    slope.face = merge.first;
    for (Vec3& normal : slope.normals) normal = merge.turned ? Vec3(-normal) : normal;
  }
  first.loop = merge.loop;
  std::erase_if(first.inner, [&](const InnerCurve& inner) { return is_in(merge.loop, inner.curve); });
  forget_places(network, merge.first);
}

AttributeNetwork merged(AttributeNetwork network, const FaceMerge& merge) {
  give_to_first(network, merge);
  RemovedElements removed(network);
  for (const Index curve : merge.between) removed.curves[curve] = true;
  removed.faces[merge.second] = true;
  remove_bare_nodes(network, removed);
  return without_elements(std::move(network), removed);
}

/// Curves that are named, or end at nodes that are; unknown ids are left out.
std::vector<std::string> curves_to_delete(const AttributeNetwork& network, const NetworkElements& elements) {
  std::vector<std::string> ids;
  for (const AttributeCurve& curve : network.curves) {
    bool goes = elements.has(NetworkElement::Curve, curve.id);
    for (const Index node : {curve.from, curve.to})
      goes = goes || (node != no_index && elements.has(NetworkElement::Node, network.nodes[node].id));
    if (goes) ids.push_back(curve.id);
  }
  return ids;
}

}  // namespace

bool can_merge_faces(const AttributeNetwork& network, Index curve) { return plan_merge(network, curve).has_value(); }

AttributeNetwork merge_faces(AttributeNetwork network, const std::string& curve) {
  const auto merge = plan_merge(network, require_element(network, NetworkElement::Curve, curve));
  if (!merge)
    refuse_edit("Curve \"" + curve + "\" isn't all that two faces share: choose a curve between exactly two faces.",
                {named_curve(curve)});
  return merged(std::move(network), *merge);
}

AttributeNetwork delete_elements(AttributeNetwork network, const NetworkElements& elements) {
  const std::vector<std::string> curves = curves_to_delete(network, elements);
  for (const std::string& id : curves) {
    const Index curve = find_element(network, NetworkElement::Curve, id);
    if (curve == no_index) continue;
    const auto merge = plan_merge(network, curve);
    const auto is_named = [&](Index face) { return elements.has(NetworkElement::Face, network.faces[face].id); };
    if (merge && !is_named(merge->first) && !is_named(merge->second)) network = merged(std::move(network), *merge);
  }
  RemovedElements removed(network);
  for (std::size_t i = 0; i < network.nodes.size(); ++i)
    removed.nodes[i] = elements.has(NetworkElement::Node, network.nodes[i].id);
  for (const std::string& id : curves) {
    const Index curve = find_element(network, NetworkElement::Curve, id);
    if (curve != no_index) removed.curves[curve] = true;
  }
  for (std::size_t i = 0; i < network.faces.size(); ++i) {
    const AttributeFace& face = network.faces[i];
    removed.faces[i] =
        elements.has(NetworkElement::Face, face.id) ||
        std::ranges::any_of(face.loop, [&](const AttributeSide& side) { return removed.curves[side.curve]; });
  }
  for (std::size_t i = 0; i < network.points.size(); ++i)
    removed.points[i] = elements.has(NetworkElement::Point, network.points[i].id);
  remove_lone_inner_curves(network, removed);
  remove_bare_nodes(network, removed);
  return without_elements(std::move(network), removed);
}

}  // namespace croquis
