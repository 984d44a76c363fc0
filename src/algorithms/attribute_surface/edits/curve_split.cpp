// SPDX-License-Identifier: GPL-3.0-or-later
// Curves divided in two, and places of curves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/attribute_surface/edits/edit_errors.h"
#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/edits/normal_turn.h"
#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/curve_edit.h"

namespace croquis {
namespace {

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

}  // namespace croquis
