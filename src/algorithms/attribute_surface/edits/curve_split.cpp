// SPDX-License-Identifier: GPL-3.0-or-later
// Curves divided in two, and places of curves.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/curve_edit.h"
#include "croquis/geometry/attribute_network.h"

namespace croquis {
namespace {

/// Of unit vectors; opposite ones turn by way of none.
Vec3 turned_between(const Vec3& a, const Vec3& b, double share) {
  const double angle = angle_between(a, b);
  const double sine = std::sin(angle);
  if (sine < 1e-9) return share < 0.5 ? a : b;
  return (std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / sine;
}

/// The normal of a slope at a fraction of its curve: turned evenly between those given, beyond them as the nearest one.
Vec3 normal_between(const SlopeAttribute& slope, double at) {
  if (at <= slope.at.front()) return slope.normals.front();
  if (at >= slope.at.back()) return slope.normals.back();
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(slope.at, at) - slope.at.begin());
  const double share = (at - slope.at[next - 1]) / (slope.at[next] - slope.at[next - 1]);
  return turned_between(slope.normals[next - 1].normalized(), slope.normals[next].normalized(), share);
}

struct ControlHalves {
  std::vector<Vec3> first;
  std::vector<Vec3> second;
};

/// de Casteljau: the edges of its triangle are the control polygons of the two parts.
ControlHalves halves_of(std::vector<Vec3> control, double t) {
  ControlHalves halves;
  while (!control.empty()) {
    halves.first.push_back(control.front());
    halves.second.push_back(control.back());
    for (std::size_t i = 0; i + 1 < control.size(); ++i) control[i] = (1 - t) * control[i] + t * control[i + 1];
    control.pop_back();
  }
  std::ranges::reverse(halves.second);
  return halves;
}

/// A curve that is split, and its parts.
struct CurveParts {
  Index first = no_index;
  Index second = no_index;
  double at = 0;
};

void split_in_loop(AttributeFace& face, const CurveParts& parts) {
  const auto found = std::ranges::find(face.loop, parts.first, &AttributeSide::curve);
  if (found == face.loop.end()) return;
  const AttributeSide second{parts.second, found->reversed};
  face.loop.insert(found->reversed ? found : std::next(found), second);
}

void split_inside(AttributeFace& face, const CurveParts& parts) {
  const auto found = std::ranges::find(face.inner, parts.first, &InnerCurve::curve);
  if (found == face.inner.end()) return;
  InnerCurve second = *found;
  second.curve = parts.second;
  face.inner.insert(std::next(found), second);
}

/// A slope on the part of a curve between two fractions of it; both get the normal where they meet.
SlopeAttribute slope_part(const SlopeAttribute& slope, Index curve, double from, double to) {
  SlopeAttribute part{curve, slope.face, {}, {}, slope.magnitude};
  const auto add = [&](double at, const Vec3& normal) {
    part.at.push_back(std::clamp((at - from) / (to - from), 0.0, 1.0));
    part.normals.push_back(normal);
  };
  if (from > 0) add(from, normal_between(slope, from));
  for (std::size_t i = 0; i < slope.at.size(); ++i) {
    if (slope.at[i] > from && slope.at[i] < to) add(slope.at[i], slope.normals[i]);
    if ((slope.at[i] == 0 && from == 0) || (slope.at[i] == 1 && to == 1)) add(slope.at[i], slope.normals[i]);
  }
  if (to < 1) add(to, normal_between(slope, to));
  return part;
}

void split_slopes(AttributeNetwork& network, const CurveParts& parts) {
  const std::size_t count = network.slopes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const SlopeAttribute whole = network.slopes[i];
    if (whole.curve != parts.first) continue;
    network.slopes[i] = slope_part(whole, parts.first, 0, parts.at);
    network.slopes.push_back(slope_part(whole, parts.second, parts.at, 1));
  }
}

constexpr double same_slope_place = 1e-6;  // fractions of a curve: two handles there couldn't be distinguished

Index face_of(const AttributeNetwork& network, const SlopeSide& side) {
  return side.face.empty() ? no_index : require_element(network, NetworkElement::Face, side.face);
}

/// The slope of that side, or a new one without normals. One for a face is added to that for all of them.
SlopeAttribute slope_or_new(const AttributeNetwork& network, const SlopeSide& side) {
  const Index found = find_slope(network, side);
  SlopeAttribute slope;
  if (found != no_index) slope = network.slopes[found];
  slope.curve = require_element(network, NetworkElement::Curve, side.curve);
  slope.face = face_of(network, side);
  return slope;
}

void set_normal(SlopeAttribute& slope, double at, const Vec3& normal) {
  for (std::size_t i = 0; i < slope.at.size(); ++i) {
    if (std::abs(slope.at[i] - at) > same_slope_place) continue;
    slope.normals[i] = normal;
    return;
  }
  const auto place = std::ranges::upper_bound(slope.at, at);
  slope.normals.insert(slope.normals.begin() + std::distance(slope.at.begin(), place), normal);
  slope.at.insert(place, at);
}

}  // namespace

SplitCurve split_curve(AttributeNetwork network, const std::string& id, double at) {
  const CurveParts parts{require_element(network, NetworkElement::Curve, id), static_cast<Index>(network.curves.size()),
                         at};
  const std::vector<Vec3> control = control_polygon(network, network.curves[parts.first]);
  if (!(at > 0 && at < 1) || !(bezier_length(control) > 0))
    refuse_edit("Curve \"" + id + "\" can only be split between its ends.", {named_curve(id)});
  const ControlHalves halves = halves_of(control, ArcLengthCurve(control).parameter(at));
  SplitCurve split;
  AttributeCurve second = network.curves[parts.first];
  second.id = split.second = new_element_id(network, NetworkElement::Curve);
  AttributeCurve& first = network.curves[parts.first];
  if (first.from != no_index || first.to != no_index) {
    split.node = new_element_id(network, NetworkElement::Node);
    first.to = second.from = static_cast<Index>(network.nodes.size());
    network.nodes.push_back({split.node, halves.second.front()});
  }
  if (!first.control.empty()) {
    first.control = halves.first;
    second.control = halves.second;
  }
  network.curves.push_back(std::move(second));
  for (const Index face : faces_along(network, parts.first)) forget_places(network, face);
  for (AttributeFace& face : network.faces) {
    split_in_loop(face, parts);
    split_inside(face, parts);
  }
  split_slopes(network, parts);
  split.network = std::move(network);
  return split;
}

double nearest_fraction(const AttributeNetwork& network, Index index, const Vec3& place) {
  const std::vector<Vec3> control = control_polygon(network, network.curves[index]);
  if (!(bezier_length(control) > 0)) return 0;
  const ArcLengthCurve curve(control);
  constexpr int samples = 64;
  const auto distance = [&](double s) { return (curve.at(s) - place).squaredNorm(); };
  int nearest = 0;
  for (int i = 1; i <= samples; ++i) {
    if (distance(static_cast<double>(i) / samples) < distance(static_cast<double>(nearest) / samples)) nearest = i;
  }
  double low = std::max(0, nearest - 1) / static_cast<double>(samples);
  double high = std::min(samples, nearest + 1) / static_cast<double>(samples);
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int step = 0; step < 60; ++step) {  // golden section: the interval ends below 1e-13
    const double a = high - ratio * (high - low);
    const double b = low + ratio * (high - low);
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  const double found = (low + high) / 2;
  if (distance(0) <= distance(found)) return 0;
  return distance(1) <= distance(found) ? 1 : found;
}

Index find_slope(const AttributeNetwork& network, const SlopeSide& side) {
  const Index curve = require_element(network, NetworkElement::Curve, side.curve);
  const Index face = face_of(network, side);
  for (Index i = 0; i < network.slopes.size(); ++i) {
    if (network.slopes[i].curve == curve && network.slopes[i].face == face) return i;
  }
  return no_index;
}

AttributeNetwork set_slope(AttributeNetwork network, const SlopeSide& side, const SlopeHandle& handle) {
  require_fraction(handle.at);
  if (handle.normal) require_direction(*handle.normal);
  if (handle.magnitude && !std::isfinite(*handle.magnitude)) refuse_edit("A slope's magnitude must be finite.");
  SlopeAttribute slope = slope_or_new(network, side);
  if (handle.normal) set_normal(slope, handle.at, *handle.normal);
  if (slope.at.empty())
    refuse_edit("The slope along curve \"" + side.curve + "\" is found automatically: give it a normal first.",
                {named_curve(side.curve)});
  if (handle.magnitude) slope.magnitude = *handle.magnitude;
  const Index found = find_slope(network, side);
  if (found == no_index) {
    network.slopes.push_back(std::move(slope));
  } else {
    network.slopes[found] = std::move(slope);
  }
  return network;
}

AttributeNetwork remove_slope(AttributeNetwork network, const SlopeSide& side, std::optional<double> at) {
  const Index found = find_slope(network, side);
  if (found == no_index) return network;
  SlopeAttribute& slope = network.slopes[found];
  for (std::size_t i = slope.at.size(); at && i-- > 0;) {
    if (std::abs(slope.at[i] - *at) > same_slope_place) continue;
    slope.at.erase(slope.at.begin() + static_cast<std::ptrdiff_t>(i));
    slope.normals.erase(slope.normals.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (!at || slope.at.empty()) network.slopes.erase(network.slopes.begin() + static_cast<std::ptrdiff_t>(found));
  return network;
}

}  // namespace croquis
