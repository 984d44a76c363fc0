// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/domain_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace croquis {
namespace {

constexpr double pi = std::numbers::pi;

/// A side shorter than this part of the perimeter would leave no room for its weights.
constexpr double least_side = 1e-3;
/// How much of the other sides together one side may have: at 1 the polygon is flat.
constexpr double longest_part = 0.95;

/// Raises what is too short, then to the sum 1.
std::vector<double> floored(std::span<const double> lengths) {
  std::vector<double> result(lengths.begin(), lengths.end());
  const double floor = least_side * std::accumulate(result.begin(), result.end(), 0.0);
  for (double& length : result) length = std::max(length, floor);
  const double sum = std::accumulate(result.begin(), result.end(), 0.0);
  for (double& length : result) length /= sum;
  return result;
}

/// Moves lengths of the sum 1 towards equal ones until they allow a polygon, and gives how far. The share grows with
/// the excess e as e / (e + c), with c such that an infinite excess gives equal lengths.
double relax(std::vector<double>& lengths) {
  const auto count = static_cast<double>(lengths.size());
  const double longest = *std::ranges::max_element(lengths);
  const double excess = longest - longest_part * (1 - longest);
  if (excess <= 1e-14) return 0;  // rounding of the sum
  const double beta = excess / (excess + (longest_part * (count - 1) - 1) / count);
  for (double& length : lengths) length = (1 - beta) * length + beta / count;
  return beta;
}

/// Half the central angles of the sides of a polygon in a circle, the longest side's apart.
struct HalfAngles {
  std::size_t longest = 0;
  std::vector<double> ratios;  ///< to the longest side

  /// The whole half turn when phi is half the angle of the longest side.
  double sum(double phi) const {
    double result = phi;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      if (i != longest) result += std::asin(std::min(1.0, ratios[i] * std::sin(phi)));
    }
    return result;
  }

  double slope(double phi) const {
    double result = 1;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const double sine = ratios[i] * std::sin(phi);
      if (i != longest) result += ratios[i] * std::cos(phi) / std::sqrt(std::max(1e-300, 1 - sine * sine));
    }
    return result;
  }
};

/// Solves sum(phi) = pi. With the centre outside, pi itself is a false root at the end of the bracket.
double half_angle_of_longest(const HalfAngles& angles) {
  const bool inside = angles.sum(pi / 2) >= pi;
  double low = inside ? 0 : pi / 2;
  double high = inside ? pi / 2 : pi * (1 - 1e-12);
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (angles.sum(middle) >= pi ? high : low) = middle;
  }
  const double found = 0.5 * (low + high);
  const double better = found - (angles.sum(found) - pi) / angles.slope(found);
  const bool helps = std::abs(angles.sum(better) - pi) < std::abs(angles.sum(found) - pi);
  return helps ? better : found;
}

Vec2 area_centroid(const std::vector<Vec2>& corners) {
  double area = 0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double part = cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    area += part;
    sum += part * (corners[0] + corners[i] + corners[i + 1]) / 3;
  }
  return sum / area;
}

void fill_in_middles(DomainPolygon& polygon) {
  const Vec2 sum = std::accumulate(polygon.corners.begin(), polygon.corners.end(), Vec2(Vec2::Zero()));
  polygon.middle = sum / static_cast<double>(polygon.corners.size());
  polygon.centroid = area_centroid(polygon.corners);
}

}  // namespace

DomainPolygon chordlength_polygon(std::span<const double> lengths) {
  DomainPolygon polygon;
  polygon.side_lengths = floored(lengths);
  polygon.beta = relax(polygon.side_lengths);
  HalfAngles angles;
  const auto longest = std::ranges::max_element(polygon.side_lengths);
  angles.longest = static_cast<std::size_t>(longest - polygon.side_lengths.begin());
  for (const double length : polygon.side_lengths) angles.ratios.push_back(length / *longest);

  const double phi = half_angle_of_longest(angles);
  polygon.centre_inside = phi <= pi / 2;
  polygon.radius = *longest / (2 * std::sin(phi));
  double angle = 0;
  for (std::size_t i = 0; i < polygon.side_lengths.size(); ++i) {
    polygon.corners.emplace_back(polygon.radius * std::cos(angle), polygon.radius * std::sin(angle));
    angle += 2 * (i == angles.longest ? phi : std::asin(std::min(1.0, angles.ratios[i] * std::sin(phi))));
  }
  fill_in_middles(polygon);
  return polygon;
}

DomainPolygon uniform_polygon(std::size_t sides) {
  DomainPolygon polygon;
  if (sides == 3) polygon.corners = {{0, 0}, {1, 0}, {0, 1}};
  if (sides == 4) polygon.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; sides > 4 && i < sides; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    polygon.corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  double perimeter = 0;
  for (std::size_t i = 0; i < sides; ++i) {
    polygon.side_lengths.push_back((polygon.corners[(i + 1) % sides] - polygon.corners[i]).norm());
    perimeter += polygon.side_lengths.back();
  }
  for (Vec2& corner : polygon.corners) corner /= perimeter;
  for (double& length : polygon.side_lengths) length /= perimeter;
  fill_in_middles(polygon);
  if (sides > 4) polygon.radius = polygon.corners[0].norm();
  if (sides <= 4) polygon.radius = std::numbers::sqrt2 / 2 / perimeter;
  return polygon;
}

Vec2 place_in(const DomainPolygon& polygon, const FanPlace& fan) {
  const Vec2& first = polygon.corners[fan.corner];
  const Vec2& second = polygon.corners[(fan.corner + 1) % polygon.corners.size()];
  return polygon.middle + fan.a * (first - polygon.middle) + fan.b * (second - polygon.middle);
}

FanPlace fan_place_in(const DomainPolygon& polygon, const Vec2& place) {
  const std::size_t count = polygon.corners.size();
  const Vec2 offset = place - polygon.middle;
  FanPlace best;
  double least = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 first = polygon.corners[k] - polygon.middle;
    const Vec2 second = polygon.corners[(k + 1) % count] - polygon.middle;
    const double whole = cross(first, second);
    const FanPlace fan{k, cross(offset, second) / whole, cross(first, offset) / whole};
    const double smaller = std::min(fan.a, fan.b);
    if (smaller > least) {
      least = smaller;
      best = fan;
    }
  }
  return best;
}

double distance_inside(const DomainPolygon& polygon, const Vec2& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2& from = polygon.corners[i];
    const Vec2 along = polygon.corners[(i + 1) % polygon.corners.size()] - from;
    least = std::min(least, cross(along, place - from) / along.norm());
  }
  return least;
}

}  // namespace croquis
