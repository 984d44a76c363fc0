// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/surfaces.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "support/random.h"

namespace croquis::test {

AttributeSurface surface_of(const AttributeNetwork& network, const AttributeSurfaceOptions& options) {
  Progress progress;
  return make_attribute_surface(network, progress, options);
}

FaceSurface first_surface(const AttributeNetwork& network, const AttributeSurfaceOptions& options) {
  const AttributeSurface surface = surface_of(network, options);
  if (!surface.faces.at(0).surface)
    throw std::runtime_error(network.name + ": " + (surface.findings.empty() ? "" : surface.findings[0].message));
  return *surface.faces[0].surface;
}

std::vector<FanPlace> spread_places(std::size_t corners, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<FanPlace> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double outwards = random.between(0.02, 0.98), part = random.unit();
    places.push_back({i % corners, outwards * part, outwards * (1 - part)});
  }
  return places;
}

double extent(const AttributeNetwork& network) {
  double largest = 0;
  for (const AttributeNode& node : network.nodes) largest = std::max(largest, node.point.norm());
  for (const AttributeCurve& curve : network.curves) {
    for (const Vec3& point : curve.control) largest = std::max(largest, point.norm());
  }
  return largest;
}

AttributeNetwork with_points(const AttributeNetwork& network, std::size_t most, double off, std::uint64_t seed) {
  AttributeNetwork result = network;
  Random random(seed);
  const AttributeSurface surface = surface_of(network);
  for (std::size_t f = 0; f < network.faces.size(); ++f) {
    if (!surface.faces[f].surface) continue;
    const FaceSurface& face = *surface.faces[f].surface;
    const double size = face.sigma() / static_cast<double>(network.faces[f].loop.size());
    for (std::size_t k = 0; k < std::min(most, face.domain().corners.size()); ++k) {
      const FanPlace fan{k, random.between(0.15, 0.35), random.between(0.15, 0.35)};
      const Vec3 pull(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      PointAttribute point;
      point.id = "p" + std::to_string(result.points.size());
      point.face = static_cast<Index>(f);
      point.fan = fan;
      point.point = face.at(place_in(face.domain(), fan)) + off * size * pull;
      point.profile = k % 2 == 0 ? PointProfile::Smooth : PointProfile::Cone;
      if (k % 3 == 1) point.radius = 0.3 * size;
      result.points.push_back(point);
    }
  }
  return result;
}

std::vector<ReferencePoint> reference_points(const AttributeNetwork& network, Index face) {
  std::vector<ReferencePoint> points;
  for (const PointAttribute& point : network.points) {
    if (point.face == face) points.push_back({point.fan.value(), point.point, point.radius, point.profile});
  }
  return points;
}

}  // namespace croquis::test
