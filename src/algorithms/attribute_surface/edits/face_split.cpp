// SPDX-License-Identifier: GPL-3.0-or-later
// A face divided by a curve from one place of its loop to another.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/edits/loop_shape.h"
#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/face_edit.h"
#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

/// The place of a loop that is nearest to another place: a node of it, or within a side.
struct LoopPlace {
  Index node = no_index;
  Index curve = no_index;  ///< where there is no node
  double at = 0;           ///< fraction of the curve's arc length
  double distance = std::numeric_limits<double>::infinity();
};

LoopPlace nearest_on_loop(const AttributeNetwork& network, const AttributeFace& face, const Vec3& place, double reach) {
  LoopPlace nearest;
  for (const AttributeSide& side : face.loop) {
    const Index node = start_node(network, side);
    const double distance = node == no_index ? nearest.distance : (network.nodes[node].point - place).norm();
    if (distance < nearest.distance) nearest = {node, no_index, 0, distance};
  }
  if (nearest.distance <= reach) return nearest;
  for (const AttributeSide& side : face.loop) {
    const double at = nearest_fraction(network, side.curve, place);
    if (!(at > 1e-9 && at < 1 - 1e-9)) continue;  // an end: its node was looked at
    const ArcLengthCurve curve(control_polygon(network, network.curves[side.curve]));
    const double distance = (curve.at(at) - place).norm();
    if (distance < nearest.distance) nearest = {no_index, side.curve, at, distance};
  }
  return nearest;
}

/// The node of a face's loop at an end of the cut; one is made by splitting where there is none.
Index node_on_loop(AttributeNetwork& network, Index face, Index cut, bool last, double reach) {
  const Vec3 place = end_place(network, {cut, !last});
  const LoopPlace found = nearest_on_loop(network, network.faces[face], place, reach);
  if (found.distance > reach) {
    const std::string& id = network.curves[cut].id;
    throw Error(make_error(Category::Geometry, "E_OPEN_LOOP",
                           "Curve \"" + id + "\" ends " + length_text(network, found.distance) +
                               " away from the loop of face \"" + network.faces[face].id +
                               "\": bring its ends to the loop.",
                           {named_curve(id), named_face(network.faces[face].id)}));
  }
  if (found.node != no_index) return found.node;
  const std::string found_id = network.curves[found.curve].id;
  SplitCurve split = split_curve(std::move(network), found_id, found.at);
  network = std::move(split.network);
  return find_element(network, NetworkElement::Node, split.node);
}

/// The loop begun at a node and divided at another one.
std::optional<std::pair<std::vector<AttributeSide>, std::vector<AttributeSide>>> parts_of_loop(
    const AttributeNetwork& network, std::vector<AttributeSide> loop, Index from, Index to) {
  const auto starts_at = [&](Index node) {
    return std::ranges::find_if(loop, [&](const AttributeSide& side) { return start_node(network, side) == node; });
  };
  if (from == to || starts_at(from) == loop.end() || starts_at(to) == loop.end()) return std::nullopt;
  std::ranges::rotate(loop, starts_at(from));
  const auto middle = starts_at(to);
  return std::pair{std::vector(loop.begin(), middle), std::vector(middle, loop.end())};
}

/// Which of two faces a place of the undivided one's domain is in: the first one's outline in that domain decides.
class HalfTest {
 public:
  HalfTest(FaceMap map, const std::vector<Vec3>& first_loop) : map_(std::move(map)) {
    for (const Vec3& place : first_loop) outline_.push_back(map_(place));
  }

  template <typename Place>
  bool in_first(const Place& place) const {
    return encloses(outline_, map_(place));
  }

 private:
  FaceMap map_;
  std::vector<Vec2> outline_;
};

void share_out(AttributeNetwork& network, Index first, Index second, const HalfTest& half) {
  for (PointAttribute& point : network.points) {
    if (point.face != first) continue;
    const bool stays = point.fan ? half.in_first(*point.fan) : half.in_first(point.point);
    point.face = stays ? first : second;
    point.fan.reset();
  }
  std::vector<InnerCurve> stay;
  for (const InnerCurve& inner : network.faces[first].inner) {
    const Vec3 middle = bezier_point(control_polygon(network, network.curves[inner.curve]), 0.5);
    (half.in_first(middle) ? stay : network.faces[second].inner).push_back(inner);
  }
  network.faces[first].inner = std::move(stay);
}

/// Slopes meant for the face go to that part of it that has their curve.
void share_out_slopes(AttributeNetwork& network, Index first, Index second) {
  const auto& loop = network.faces[second].loop;
  for (SlopeAttribute& slope : network.slopes) {
    if (slope.face == first && std::ranges::find(loop, slope.curve, &AttributeSide::curve) != loop.end())
      slope.face = second;
  }
}

/// Gives the cut these nodes. Its old ones go where no other curve has them.
AttributeNetwork tied_to(AttributeNetwork network, Index cut, Index from, Index to) {
  AttributeCurve& curve = network.curves[cut];
  const Index old[] = {curve.from, curve.to};
  const Vec3 start = network.nodes[from].point;
  const Vec3 end = network.nodes[to].point;
  if (!curve.control.empty()) curve.control = with_ends_moved(curve.control, start, end);
  curve.from = from;
  curve.to = to;
  RemovedElements removed(network);
  for (const Index node : old) {
    if (node == no_index) continue;
    removed.nodes[node] = std::ranges::none_of(
        network.curves, [&](const AttributeCurve& other) { return other.from == node || other.to == node; });
  }
  return without_elements(std::move(network), removed);
}

}  // namespace

bool can_split_face(const AttributeNetwork& network, Index face, Index curve, double reach) {
  const AttributeFace& whole = network.faces[face];
  if (whole.loop.size() < 2 || std::ranges::find(whole.loop, curve, &AttributeSide::curve) != whole.loop.end())
    return false;
  const LoopPlace start = nearest_on_loop(network, whole, start_place(network, {curve, false}), reach);
  const LoopPlace end = nearest_on_loop(network, whole, end_place(network, {curve, false}), reach);
  if (start.distance > reach || end.distance > reach) return false;
  return start.node != end.node || start.curve != end.curve || std::abs(start.at - end.at) > 1e-3;
}

SplitFace split_face(AttributeNetwork network, const std::string& face_id, const std::string& curve, double reach) {
  const Index face = require_element(network, NetworkElement::Face, face_id);
  const Index cut = require_element(network, NetworkElement::Curve, curve);
  const auto& loop = network.faces[face].loop;
  if (loop.size() < 2 || std::ranges::find(loop, cut, &AttributeSide::curve) != loop.end())
    refuse_edit("Curve \"" + curve + "\" is a side of face \"" + face_id + "\": choose one across it.",
                {named_curve(curve), named_face(face_id)});
  FaceMap map(network, network.faces[face]);
  // Splits made for one end stay when the other one is refused, so they are made in a copy.
  AttributeNetwork edited = network;
  std::vector<std::optional<FanPlace>> fans;
  for (const PointAttribute& point : network.points) fans.push_back(point.fan);
  const Index from = node_on_loop(edited, face, cut, false, reach);
  const Index to = node_on_loop(edited, face, cut, true, reach);
  for (std::size_t i = 0; i < fans.size(); ++i) {
    if (edited.points[i].face == face) edited.points[i].fan = fans[i];  // of the undivided domain still
  }
  const auto parts = parts_of_loop(edited, edited.faces[face].loop, from, to);
  if (!parts)
    refuse_edit("Curve \"" + curve + "\" begins and ends at the same place of face \"" + face_id +
                    "\": draw it from one place of the loop to another.",
                {named_curve(curve), named_face(face_id)});
  edited = tied_to(std::move(edited), cut, from, to);
  SplitFace split;
  AttributeFace second = edited.faces[face];
  second.id = split.second = new_element_id(edited, NetworkElement::Face);
  second.inner.clear();
  edited.faces[face].loop = parts->first;
  edited.faces[face].loop.push_back({cut, true});
  second.loop = parts->second;
  second.loop.push_back({cut, false});
  std::erase_if(edited.faces[face].inner, [&](const InnerCurve& inner) { return inner.curve == cut; });
  edited.faces.push_back(std::move(second));
  const auto index = static_cast<Index>(edited.faces.size() - 1);
  share_out(edited, face, index, HalfTest(std::move(map), traced_loop(edited, edited.faces[face].loop)));
  share_out_slopes(edited, face, index);
  split.network = std::move(edited);
  return split;
}

}  // namespace croquis
