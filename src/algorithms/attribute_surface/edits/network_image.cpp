// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/network_image.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/loop_search.h"

namespace croquis {
namespace {

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum;
}

/// Whether `other` is a mirrored curve backwards rather than forwards.
bool runs_backwards(const std::vector<Vec3>& mirrored, const std::vector<Vec3>& other) {
  const std::vector<Vec3> reversed(mirrored.rbegin(), mirrored.rend());
  return difference(reversed, other) < difference(mirrored, other);
}

void turn_slope(SlopeAttribute& slope) {
  std::ranges::reverse(slope.at);
  std::ranges::reverse(slope.normals);
  for (double& at : slope.at) at = 1 - at;
}

/// The fan place for a loop that begins elsewhere; none where it isn't the same loop.
std::optional<FanPlace> fan_in(const FanPlace& fan, const std::vector<AttributeSide>& from,
                               const std::vector<AttributeSide>& to) {
  if (from.empty() || from.size() != to.size()) return std::nullopt;
  const auto found = std::ranges::find(to, from.front());
  if (found == to.end()) return std::nullopt;
  const std::size_t halves = to.size() == 2 ? 2 : 1;
  const auto shift = static_cast<std::size_t>(found - to.begin()) * halves;
  return FanPlace{(fan.corner + shift) % (to.size() * halves), fan.a, fan.b};
}

}  // namespace

Affine3 reflection_at(const SymmetryPlane& plane) {
  const Vec3 normal = plane.normal.normalized();
  return {Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose(), 2 * plane.point.dot(normal) * normal};
}

NetworkImage::NetworkImage(const AttributeNetwork& network, const SymmetryPlane& plane, NetworkPartners partners)
    : plane_(plane),
      map_(reflection_at(plane)),
      original_(network),
      image_(transformed(network, map_)),
      result_(network),
      partners_(std::move(partners)),
      backwards_(network.curves.size()) {
  for (std::size_t i = 0; i < backwards_.size(); ++i) {
    const Index partner = partners_.curves[i];
    if (partner == no_index) continue;
    backwards_[i] = runs_backwards(control_polygon(image_, image_.curves[i]),
                                   control_polygon(original_, original_.curves[partner]));
  }
}

std::string NetworkImage::name_for(NetworkElement kind, const std::string& original) {
  const std::string base = original + "_m";
  std::string name = base;
  for (int number = 2; find_element(result_, kind, name) != no_index; ++number) name = base + std::to_string(number);
  added_.of(kind).push_back(name);
  return name;
}

AttributeSide NetworkImage::side(const AttributeSide& original) {
  const Index image = curve(original.curve);
  return {image, original.reversed != backwards_[original.curve]};
}

std::vector<AttributeSide> NetworkImage::loop(Index original) {
  std::vector<AttributeSide> sides;
  for (const AttributeSide& one : image_.faces[original].loop) sides.push_back(side(one));
  return sides;
}

std::vector<InnerCurve> NetworkImage::inner_curves(Index original) {
  std::vector<InnerCurve> inner = image_.faces[original].inner;
  for (InnerCurve& one : inner) one.curve = curve(one.curve);
  return inner;
}

AttributeCurve NetworkImage::curve_image(Index original) {
  AttributeCurve made = image_.curves[original];
  if (made.from != no_index) made.from = node(made.from);
  if (made.to != no_index) made.to = node(made.to);
  if (!backwards_[original]) return made;
  std::swap(made.from, made.to);
  std::ranges::reverse(made.control);
  return made;
}

PointAttribute NetworkImage::point_image(Index original, Index face) {
  PointAttribute made = image_.points[original];
  made.face = face;
  if (made.fan) made.fan = fan_in(*made.fan, loop(image_.points[original].face), result_.faces[face].loop);
  return made;
}

void NetworkImage::add_slope(std::size_t original) {
  SlopeAttribute slope = image_.slopes[original];
  if (slope.face != no_index && partners_.faces[slope.face] == no_index) return;  // the face has no image
  if (slope.face != no_index) slope.face = partners_.faces[slope.face];
  if (backwards_[slope.curve]) turn_slope(slope);
  slope.curve = curve(slope.curve);
  result_.slopes.push_back(std::move(slope));
}

Index NetworkImage::node(Index original) {
  Index& image = partners_.nodes[original];
  if (image != no_index) return image;
  image = static_cast<Index>(result_.nodes.size());
  AttributeNode made = image_.nodes[original];
  made.id = name_for(NetworkElement::Node, made.id);
  result_.nodes.push_back(std::move(made));
  return image;
}

Index NetworkImage::curve(Index original) {
  if (partners_.curves[original] != no_index) return partners_.curves[original];
  AttributeCurve made = curve_image(original);
  made.id = name_for(NetworkElement::Curve, made.id);
  partners_.curves[original] = static_cast<Index>(result_.curves.size());
  result_.curves.push_back(std::move(made));
  return partners_.curves[original];
}

Index NetworkImage::face(Index original) {
  if (partners_.faces[original] != no_index) return partners_.faces[original];
  AttributeFace made = image_.faces[original];
  made.loop = loop(original);
  made.inner = inner_curves(original);
  made.id = name_for(NetworkElement::Face, made.id);
  partners_.faces[original] = static_cast<Index>(result_.faces.size());
  result_.faces.push_back(std::move(made));
  return partners_.faces[original];
}

Index NetworkImage::point(Index original) {
  if (partners_.points[original] != no_index) return partners_.points[original];
  PointAttribute made = point_image(original, face(image_.points[original].face));
  made.id = name_for(NetworkElement::Point, made.id);
  partners_.points[original] = static_cast<Index>(result_.points.size());
  result_.points.push_back(std::move(made));
  return partners_.points[original];
}

void NetworkImage::renew_node(Index original) { result_.nodes[node(original)].point = image_.nodes[original].point; }

void NetworkImage::renew_curve(Index original) {
  AttributeCurve made = curve_image(original);
  const Index partner = partners_.curves[original];
  made.id = result_.curves[partner].id;
  result_.curves[partner] = std::move(made);
}

void NetworkImage::renew_face_settings(Index original) {
  const AttributeFace& from = image_.faces[original];
  AttributeFace& to = result_.faces[partners_.faces[original]];
  to.mode = from.mode;
  to.domain = from.domain;
  to.fullness = from.fullness;
}

void NetworkImage::renew_face_loop(Index original) {
  const Index partner = partners_.faces[original];
  result_.faces[partner].loop = loop(original);
  forget_places(result_, partner);
}

void NetworkImage::renew_inner_curves(Index original) {
  std::vector<InnerCurve> inner = inner_curves(original);
  result_.faces[partners_.faces[original]].inner = std::move(inner);
}

void NetworkImage::renew_point(Index original) {
  const Index partner = partners_.points[original];
  PointAttribute made = point_image(original, face(image_.points[original].face));
  made.id = result_.points[partner].id;
  result_.points[partner] = std::move(made);
}

void NetworkImage::renew_slopes(Index original) {
  const Index partner = curve(original);
  std::erase_if(result_.slopes, [&](const SlopeAttribute& slope) { return slope.curve == partner; });
  for (std::size_t i = 0; i < image_.slopes.size(); ++i) {
    if (image_.slopes[i].curve == original) add_slope(i);
  }
}

void NetworkImage::centre_node(Index node) {
  Vec3& place = result_.nodes[node].point;
  place = (place + map_(place)) / 2;
}

void NetworkImage::centre_curve(Index index) {
  std::vector<Vec3>& control = result_.curves[index].control;
  std::vector<Vec3> mirror = control;
  for (Vec3& place : mirror) place = map_(place);
  if (backwards_[index]) std::ranges::reverse(mirror);
  for (std::size_t i = 0; i < control.size(); ++i) control[i] = (control[i] + mirror[i]) / 2;
}

void NetworkImage::centre_point(Index point) {
  Vec3& place = result_.points[point].point;
  place = (place + map_(place)) / 2;
}

void NetworkImage::complete_loop(Index face) {
  std::vector<Index> curves;
  const auto add = [&](const AttributeSide& one) {
    if (std::ranges::find(curves, one.curve) == curves.end()) curves.push_back(one.curve);
  };
  for (const AttributeSide& one : result_.faces[face].loop) add(one);
  for (const AttributeSide& one : loop(face)) add(one);
  if (curves.size() == result_.faces[face].loop.size()) return;
  SortedLoop sorted = sort_loop(result_, curves, 0);
  if (!sorted.closed()) return;
  const AttributeSide& first = result_.faces[face].loop.front();
  if (std::ranges::find(sorted.sides, first) == sorted.sides.end()) {
    std::ranges::reverse(sorted.sides);
    for (AttributeSide& one : sorted.sides) one.reversed = !one.reversed;
  }
  result_.faces[face].loop = std::move(sorted.sides);
  forget_places(result_, face);
}

std::optional<AttributeSide> NetworkImage::new_side(Index from, Index to) const {
  for (Index i = static_cast<Index>(original_.curves.size()); i < result_.curves.size(); ++i) {
    for (const bool reversed : {false, true}) {
      const AttributeSide side{i, reversed};
      if (start_node(result_, side) == from && end_node(result_, side) == to) return side;
    }
  }
  return std::nullopt;
}

void NetworkImage::meet_nodes() {
  for (AttributeCurve& curve : result_.curves) {
    if (curve.control.empty() || (curve.from == no_index && curve.to == no_index)) continue;
    const Vec3 start = curve.from == no_index ? curve.control.front() : result_.nodes[curve.from].point;
    const Vec3 end = curve.to == no_index ? curve.control.back() : result_.nodes[curve.to].point;
    curve.control = with_ends_moved(std::move(curve.control), start, end);
  }
}

void NetworkImage::mend_loops() {
  for (Index index = 0; index < result_.faces.size(); ++index) {
    std::vector<AttributeSide>& loop = result_.faces[index].loop;
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index end = end_node(result_, loop[i]);
      const Index start = start_node(result_, loop[(i + 1) % loop.size()]);
      const auto between = end == start ? std::nullopt : new_side(end, start);
      if (between) loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i + 1), *between);
    }
    if (loop.size() != count) forget_places(result_, index);
  }
}

}  // namespace croquis
