// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/loop_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "croquis/attribute_surface/domain_polygon.h"
#include "croquis/attribute_surface/network_elements.h"

namespace croquis {
namespace {

constexpr double on_side = 1e-12;  // × the polygon's size: nearer places are on the side

/// tan of half the angle under which a side is seen, signed; from both ways to its ends.
double half_tangent(const Vec2& a, const Vec2& b) {
  const double sine = cross(a, b);
  const double product = a.norm() * b.norm();
  return sine / (product + a.dot(b));
}

constexpr std::size_t rim_parts = 16;  // of each side, even

/// A side's places at even parameters, both ends included.
std::vector<Vec3> traced_side(const AttributeNetwork& network, const AttributeSide& side, std::size_t parts) {
  std::vector<Vec3> control = control_polygon(network, network.curves[side.curve]);
  if (side.reversed) std::ranges::reverse(control);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i <= parts; ++i)
    places.push_back(bezier_point(control, static_cast<double>(i) / static_cast<double>(parts)));
  return places;
}

/// For each place of a side the fraction of its length.
std::vector<double> fractions_of(const std::vector<Vec3>& places) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < places.size(); ++i)
    lengths.push_back(lengths.back() + (places[i] - places[i - 1]).norm());
  const double whole = lengths.back();
  for (double& length : lengths) length = whole > 0 ? length / whole : 0;
  return lengths;
}

double length_of(const std::vector<Vec3>& places) {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += (places[i] - places[i - 1]).norm();
  return sum;
}

/// The domain's corners. @param lengths of the sides; of two each is halved
DomainPolygon domain_of(const AttributeFace& face, std::vector<double> lengths) {
  if (lengths.size() == 2) lengths = {lengths[0] / 2, lengths[0] / 2, lengths[1] / 2, lengths[1] / 2};
  const bool flat = std::ranges::all_of(lengths, [](double length) { return length == 0; });
  if (face.domain == AttributeDomain::Uniform || flat) return uniform_polygon(lengths.size());
  return chordlength_polygon(lengths);
}

/// Where a fraction of a side is in the domain; `halves` 2 where a side has two of the polygon's.
Vec2 place_of_side(const std::vector<Vec2>& corners, std::size_t side, double fraction, std::size_t halves) {
  const double along = fraction * static_cast<double>(halves);
  const std::size_t half = std::min(static_cast<std::size_t>(along), halves - 1);
  const std::size_t corner = side * halves + half;
  const double share = along - static_cast<double>(half);
  return (1 - share) * corners[corner] + share * corners[(corner + 1) % corners.size()];
}

}  // namespace

std::vector<double> mean_value_weights(std::span<const Vec2> polygon, const Vec2& place) {
  const std::size_t count = polygon.size();
  std::vector<double> weights(count, 0.0);
  double size = 0;
  for (const Vec2& corner : polygon) size = std::max(size, (corner - place).norm());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Vec2 a = polygon[i] - place;
    const Vec2 b = polygon[next] - place;
    if (a.norm() <= on_side * size || (a.dot(b) < 0 && std::abs(cross(a, b)) <= on_side * size * (b - a).norm())) {
      weights.assign(count, 0.0);
      const double whole = a.norm() + b.norm();
      weights[i] = whole > 0 ? b.norm() / whole : 1;
      weights[next] += 1 - weights[i];
      return weights;
    }
    if (b.norm() <= on_side * size) continue;  // the next side says so
    const double tangent = half_tangent(a, b);
    weights[i] += tangent / a.norm();
    weights[next] += tangent / b.norm();
    sum += tangent / a.norm() + tangent / b.norm();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::vector<Vec3> traced_loop(const AttributeNetwork& network, const std::vector<AttributeSide>& loop,
                              std::size_t parts) {
  std::vector<Vec3> places;
  for (const AttributeSide& side : loop) {
    const std::vector<Vec3> traced = traced_side(network, side, parts);
    places.insert(places.end(), traced.begin(), traced.end() - 1);
  }
  return places;
}

Vec3 newell_normal(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  if (places.empty()) return sum;
  const Vec3 origin = places.front();  // near the places, so that large coordinates cost no digits
  for (std::size_t i = 0; i < places.size(); ++i)
    sum += (places[i] - origin).cross(places[(i + 1) % places.size()] - origin);
  return sum;
}

FaceMap::FaceMap(const AttributeNetwork& network, const AttributeFace& face) {
  const Vec3 normal = newell_normal(traced_loop(network, face.loop, rim_parts));
  const Vec3 across = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
  right_ = across.unitOrthogonal();
  up_ = across.cross(right_);
  std::vector<std::vector<Vec3>> sides;
  std::vector<double> lengths;
  for (const AttributeSide& side : face.loop) {
    sides.push_back(traced_side(network, side, rim_parts));
    lengths.push_back(length_of(sides.back()));
  }
  if (sides.size() < 2) return;
  const DomainPolygon domain = domain_of(face, lengths);
  corners_ = domain.corners;
  middle_ = domain.middle;
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const std::vector<double> fractions = fractions_of(sides[side]);
    for (std::size_t i = 0; i < rim_parts; ++i) {
      rim_.push_back(seen(sides[side][i]));
      places_.push_back(place_of_side(corners_, side, fractions[i], sides.size() == 2 ? 2 : 1));
    }
  }
}

Vec2 FaceMap::operator()(const Vec3& place) const {
  if (rim_.empty()) return Vec2::Zero();
  const std::vector<double> weights = mean_value_weights(rim_, seen(place));
  Vec2 mean = Vec2::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) mean += weights[i] * places_[i];
  return mean;
}

Vec2 FaceMap::operator()(const FanPlace& fan) const {
  if (corners_.empty()) return Vec2::Zero();
  const Vec2& a = corners_[fan.corner % corners_.size()];
  const Vec2& b = corners_[(fan.corner + 1) % corners_.size()];
  return middle_ + fan.a * (a - middle_) + fan.b * (b - middle_);
}

}  // namespace croquis
