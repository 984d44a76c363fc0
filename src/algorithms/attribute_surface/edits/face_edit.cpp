// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/face_edit.h"

#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/edits/edit_errors.h"

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

}  // namespace croquis
