// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/network_elements.h"

#include <algorithm>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

/// Calls `use` with the list of that kind.
template <typename Network, typename Use>
auto with_elements(Network& network, NetworkElement kind, Use use) {
  switch (kind) {
    case NetworkElement::Node: return use(network.nodes);
    case NetworkElement::Curve: return use(network.curves);
    case NetworkElement::Face: return use(network.faces);
    case NetworkElement::Point: break;
  }
  return use(network.points);
}

const char* kind_word(NetworkElement kind) {
  constexpr const char* words[] = {"node", "curve", "face", "point"};
  return words[static_cast<std::size_t>(kind)];
}

}  // namespace

std::vector<std::string>& NetworkElements::of(NetworkElement kind) {
  return const_cast<std::vector<std::string>&>(std::as_const(*this).of(kind));
}

const std::vector<std::string>& NetworkElements::of(NetworkElement kind) const {
  return with_elements(*this, kind, [](const std::vector<std::string>& ids) { return std::ref(ids); }).get();
}

bool NetworkElements::has(NetworkElement kind, std::string_view id) const {
  return std::ranges::find(of(kind), id) != of(kind).end();
}

Index find_element(const AttributeNetwork& network, NetworkElement kind, std::string_view id) {
  return with_elements(network, kind, [&](const auto& elements) {
    for (Index i = 0; i < elements.size(); ++i) {
      if (elements[i].id == id) return i;
    }
    return no_index;
  });
}

Index require_element(const AttributeNetwork& network, NetworkElement kind, std::string_view id) {
  const Index found = find_element(network, kind, id);
  if (found == no_index)
    refuse_edit(std::string("The network has no ") + kind_word(kind) + " \"" + std::string(id) +
                "\": name one of its own.");
  return found;
}

std::string new_element_id(const AttributeNetwork& network, NetworkElement kind) {
  const char letter = kind_word(kind)[0];
  return with_elements(network, kind, [&](const auto& elements) {
    std::uint64_t highest = 0;
    for (const auto& element : elements) {
      std::uint64_t number = 0;
      const std::string_view id = element.id;
      if (id.size() < 2 || id[0] != letter || id.size() > 12 || !read_number(id.substr(1), number)) continue;
      highest = std::max(highest, number);
    }
    return letter + std::to_string(highest + 1);
  });
}

std::vector<std::string> element_ids(const AttributeNetwork& network, NetworkElement kind) {
  return with_elements(network, kind, [](const auto& elements) {
    std::vector<std::string> ids;
    for (const auto& element : elements) ids.push_back(element.id);
    return ids;
  });
}

double tolerance_of(const AttributeNetwork& network) {
  if (network.tolerance) return *network.tolerance;
  const BoundingBox box = bounds_of(network);
  return box ? 1e-4 * ((*box)[1] - (*box)[0]).norm() : 0;
}

Index start_node(const AttributeNetwork& network, const AttributeSide& side) {
  const AttributeCurve& curve = network.curves[side.curve];
  return side.reversed ? curve.to : curve.from;
}

Index end_node(const AttributeNetwork& network, const AttributeSide& side) {
  return start_node(network, {side.curve, !side.reversed});
}

Vec3 start_place(const AttributeNetwork& network, const AttributeSide& side) {
  const Index node = start_node(network, side);
  if (node != no_index) return network.nodes[node].point;
  const std::vector<Vec3>& control = network.curves[side.curve].control;
  return side.reversed ? control.back() : control.front();
}

Vec3 end_place(const AttributeNetwork& network, const AttributeSide& side) {
  return start_place(network, {side.curve, !side.reversed});
}

std::vector<Index> faces_along(const AttributeNetwork& network, Index curve) {
  std::vector<Index> faces;
  for (Index i = 0; i < network.faces.size(); ++i) {
    const auto& loop = network.faces[i].loop;
    if (std::ranges::find(loop, curve, &AttributeSide::curve) != loop.end()) faces.push_back(i);
  }
  return faces;
}

std::vector<Vec3> traced_curve(const AttributeNetwork& network, Index curve, std::size_t parts) {
  std::vector<Vec3> control = control_polygon(network, network.curves[curve]);
  if (control.size() == 2) return control;
  std::vector<Vec3> places;
  places.reserve(parts + 1);
  for (std::size_t i = 0; i <= parts; ++i)
    places.push_back(bezier_point(control, static_cast<double>(i) / static_cast<double>(parts)));
  return places;
}

}  // namespace croquis
