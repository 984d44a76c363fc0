// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that become one, and what is deleted.
#include "croquis/attribute_surface/face_edit.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"

namespace croquis {
namespace {

AttributeFace& face_named(AttributeNetwork& network, const std::string& id) {
  return network.faces[require_element(network, NetworkElement::Face, id)];
}

void require_fullness(const FaceSetting& setting) {
  if (setting.fullness && !(*setting.fullness >= -1 && *setting.fullness <= 2))
    refuse_edit("The fullness of a face must be between -1 and 2.");
}

void take_setting(AttributeFace& face, const FaceSetting& setting) {
  face.mode = setting.mode.value_or(face.mode);
  face.domain = setting.domain.value_or(face.domain);
  face.fullness = setting.fullness.value_or(face.fullness);
}

/// A loop of four in place of a curve that is closed in itself.
std::vector<AttributeSide> divided_in_four(AttributeNetwork& network, const AttributeSide& side) {
  const std::string id = network.curves[side.curve].id;
  const double tolerance = tolerance_of(network);
  network = tie_ends(std::move(network), id, tolerance);
  std::vector<AttributeSide> sides = {side};
  for (int round = 0; round < 2; ++round) {
    std::vector<AttributeSide> halves;
    for (const AttributeSide& whole : sides) {
      const std::string whole_id = network.curves[whole.curve].id;
      network = split_curve(std::move(network), whole_id, 0.5).network;
      const AttributeSide second{static_cast<Index>(network.curves.size() - 1), whole.reversed};
      halves.push_back(whole.reversed ? second : whole);
      halves.push_back(whole.reversed ? whole : second);
    }
    sides = std::move(halves);
  }
  return sides;
}

void require_loop(const AttributeNetwork& network, const std::vector<AttributeSide>& loop) {
  std::set<Index> seen;
  if (loop.empty()) refuse_edit("A face needs curves around it.");
  for (const AttributeSide& side : loop) {
    if (side.curve >= network.curves.size()) refuse_edit("A loop has a curve that isn't there.");
    if (!seen.insert(side.curve).second)
      refuse_edit("Curve \"" + network.curves[side.curve].id + "\" can be in a loop only once.",
                  {named_curve(network.curves[side.curve].id)});
  }
}

void turn_face(AttributeNetwork& network, Index index) {
  AttributeFace& face = network.faces[index];
  std::ranges::reverse(face.loop);
  for (AttributeSide& side : face.loop) side.reversed = !side.reversed;
  const std::size_t corners = domain_corners(face);
  for (PointAttribute& point : network.points) {
    if (point.face == index && point.fan)
      point.fan = FanPlace{corners - 1 - point.fan->corner, point.fan->b, point.fan->a};
  }
  for (SlopeAttribute& slope : network.slopes) {
    if (slope.face != index) continue;
    for (Vec3& normal : slope.normals) normal = -normal;
  }
}

void require_fan(const AttributeFace& face, const std::optional<FanPlace>& fan) {
  if (!fan) return;
  if (!std::isfinite(fan->a) || !std::isfinite(fan->b)) refuse_edit("A fan place must be finite.");
  if (fan->corner >= domain_corners(face))
    refuse_edit("Face \"" + face.id + "\" has no corner " + std::to_string(fan->corner) + " in its domain.",
                {named_face(face.id)});
}

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

AddedElement add_face(AttributeNetwork network, std::vector<AttributeSide> loop, const FaceSetting& setting) {
  require_loop(network, loop);
  require_fullness(setting);
  if (loop.size() == 1) loop = divided_in_four(network, loop.front());
  AttributeFace face;
  face.id = new_element_id(network, NetworkElement::Face);
  face.loop = std::move(loop);
  take_setting(face, setting);
  std::string id = face.id;
  network.faces.push_back(std::move(face));
  return {std::move(network), std::move(id)};
}

AttributeNetwork set_faces(AttributeNetwork network, const std::vector<std::string>& faces,
                           const FaceSetting& setting) {
  require_fullness(setting);
  for (const std::string& id : faces) take_setting(face_named(network, id), setting);
  return network;
}

AttributeNetwork turn_faces(AttributeNetwork network, const std::vector<std::string>& faces) {
  const std::set<std::string> each(faces.begin(), faces.end());
  for (const std::string& id : each) turn_face(network, require_element(network, NetworkElement::Face, id));
  return network;
}

// ---- Points

AddedElement add_point(AttributeNetwork network, const NewPoint& point) {
  require_finite(point.point);
  require_radius(point.radius);
  const Index face = require_element(network, NetworkElement::Face, point.face);
  require_fan(network.faces[face], point.fan);
  std::string id = new_element_id(network, NetworkElement::Point);
  network.points.push_back({id, face, point.point, point.fan, point.radius, point.profile, std::nullopt});
  return {std::move(network), std::move(id)};
}

AttributeNetwork move_points(AttributeNetwork network, const std::vector<std::string>& points, const Vec3& by) {
  require_finite(by);
  std::set<Index> moved;
  for (const std::string& id : points) moved.insert(require_element(network, NetworkElement::Point, id));
  for (const Index index : moved) network.points[index].point += by;
  return network;
}

AttributeNetwork set_points(AttributeNetwork network, const std::vector<std::string>& points,
                            const PointSetting& setting) {
  if (setting.point) require_finite(*setting.point);
  if (setting.radius) require_radius(*setting.radius);
  if (setting.normal && *setting.normal) require_direction(**setting.normal);
  for (const std::string& id : points) {
    PointAttribute& point = network.points[require_element(network, NetworkElement::Point, id)];
    point.point = setting.point.value_or(point.point);
    point.radius = setting.radius.value_or(point.radius);
    point.profile = setting.profile.value_or(point.profile);
    point.normal = setting.normal.value_or(point.normal);
  }
  return network;
}

// ---- Inner curves

AttributeNetwork add_inner_curve(AttributeNetwork network, const std::string& id, const InnerCurve& inner) {
  AttributeFace& face = face_named(network, id);
  require_radius(inner.radius);
  if (inner.curve >= network.curves.size()) refuse_edit("The inner curve isn't in the network.");
  const std::string& name = network.curves[inner.curve].id;
  if (std::ranges::find(face.loop, inner.curve, &AttributeSide::curve) != face.loop.end() ||
      std::ranges::find(face.inner, inner.curve, &InnerCurve::curve) != face.inner.end())
    refuse_edit("Face \"" + id + "\" has curve \"" + name + "\" already: choose another one.",
                {named_face(id), named_curve(name)});
  face.inner.push_back(inner);
  return network;
}

AttributeNetwork set_inner_curve(AttributeNetwork network, const std::string& curve, const InnerSetting& setting) {
  if (setting.radius) require_radius(*setting.radius);
  const Index index = require_element(network, NetworkElement::Curve, curve);
  for (AttributeFace& face : network.faces) {
    for (InnerCurve& inner : face.inner) {
      if (inner.curve != index) continue;
      inner.profile = setting.profile.value_or(inner.profile);
      inner.radius = setting.radius.value_or(inner.radius);
    }
  }
  return network;
}

AttributeNetwork remove_inner_curve(AttributeNetwork network, const std::string& id, const std::string& curve) {
  AttributeFace& face = face_named(network, id);
  const Index index = require_element(network, NetworkElement::Curve, curve);
  std::erase_if(face.inner, [&](const InnerCurve& inner) { return inner.curve == index; });
  return network;
}

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
