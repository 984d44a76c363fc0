// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/edits/edit_errors.h"
#include "algorithms/attribute_surface/edits/normal_turn.h"
#include "croquis/attribute_surface/curve_edit.h"

namespace croquis {
namespace {

constexpr double same_slope_place = 1e-6;  // fractions of a curve: two handles there couldn't be told apart

/// Of unit vectors; opposite ones turn by way of none.
Vec3 turned_between(const Vec3& a, const Vec3& b, double share) {
  const double angle = angle_between(a, b);
  const double sine = std::sin(angle);
  if (sine < 1e-9) return share < 0.5 ? a : b;
  return (std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / sine;
}

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

Vec3 normal_between(const SlopeAttribute& slope, double at) {
  if (at <= slope.at.front()) return slope.normals.front();
  if (at >= slope.at.back()) return slope.normals.back();
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(slope.at, at) - slope.at.begin());
  const double share = (at - slope.at[next - 1]) / (slope.at[next] - slope.at[next - 1]);
  return turned_between(slope.normals[next - 1].normalized(), slope.normals[next].normalized(), share);
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
