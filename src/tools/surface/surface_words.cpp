// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/surface_words.h"

#include <algorithm>
#include <set>
#include <utility>

#include "croquis/attribute_surface/face_edit.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr NetworkElement all_kinds[] = {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Face,
                                        NetworkElement::Point};
constexpr const char* kind_names[] = {"node", "curve", "patch", "point"};
constexpr const char* kinds_names[] = {"nodes", "curves", "patches", "points"};

}  // namespace

std::string element_label(const std::string& verb, const NetworkElements& elements) {
  std::size_t count = 0;
  std::size_t kinds = 0;
  std::string text;
  for (const NetworkElement kind : all_kinds) {
    const std::vector<std::string>& ids = elements.of(kind);
    if (ids.empty()) continue;
    const auto number = static_cast<std::size_t>(kind);
    count += ids.size();
    ++kinds;
    text = ids.size() == 1 ? std::string(kind_names[number]) + " " + ids[0]
                           : counted(ids.size(), kind_names[number], kinds_names[number]);
  }
  return verb + " " + (kinds == 1 ? text : counted(count, "element", "elements"));
}

NetworkElements one_element(NetworkElement kind, const std::string& id) {
  NetworkElements elements;
  elements.of(kind).push_back(id);
  return elements;
}

AttributeNetwork with_moved(AttributeNetwork network, const NetworkElements& elements, const Vec3& by) {
  std::set<std::string> curves(elements.curves.begin(), elements.curves.end());
  std::set<std::string> points(elements.points.begin(), elements.points.end());
  for (const std::string& id : elements.faces) {
    const Index index = require_element(network, NetworkElement::Face, id);
    const AttributeFace& face = network.faces[index];
    for (const AttributeSide& side : face.loop) curves.insert(network.curves[side.curve].id);
    for (const InnerCurve& inner : face.inner) curves.insert(network.curves[inner.curve].id);
    for (const PointAttribute& point : network.points) {
      if (point.face == index) points.insert(point.id);
    }
  }
  std::set<std::string> nodes(elements.nodes.begin(), elements.nodes.end());
  for (const std::string& id : curves) {
    const AttributeCurve& curve = network.curves[require_element(network, NetworkElement::Curve, id)];
    for (const Index node : {curve.from, curve.to}) {
      if (node != no_index) nodes.erase(network.nodes[node].id);  // moved with the curve
    }
  }
  network = move_curves(std::move(network), {curves.begin(), curves.end()}, by);
  network = move_nodes(std::move(network), {nodes.begin(), nodes.end()}, by);
  return move_points(std::move(network), {points.begin(), points.end()}, by);
}

}  // namespace croquis
