// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <catch2/catch.hpp>

#include "support/allocation_count.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {
namespace {

/// Places on sides, in corners and inside, in all parts of the domain.
std::vector<Vec2> places_of(const FaceSurface& surface) {
  std::vector<Vec2> places;
  for (std::size_t corner = 0; corner < surface.domain().corners.size(); ++corner) {
    for (int ring = 0; ring <= 8; ++ring) {
      for (int part = 0; part <= ring; ++part) {
        places.push_back(place_in(surface.domain(), {corner, (ring - part) / 8.0, part / 8.0}));
      }
    }
  }
  return places;
}

}  // namespace

TEST_CASE("surfaces are read without allocating") {
  std::vector<AttributeNetwork> networks{example_network("car_crashed"), example_network("pocket5"), leaf_loop(),
                                         wavy_star(12)};
  for (AttributeNetwork& network : strained_loops()) networks.push_back(network);
  for (const AttributeMode mode : {AttributeMode::Smooth, AttributeMode::Position, AttributeMode::Paper}) {
    for (const AttributeNetwork& network : networks) {
      AttributeSurfaceOptions options;
      options.mode = mode;
      const AttributeSurface made = surface_of(network, options);
      for (const SurfaceFace& face : made.faces) {
        if (!face.surface) continue;
        const std::vector<Vec2> places = places_of(*face.surface);
        Vec3 sum = Vec3::Zero();
        const AllocationPeak peak;
        for (const Vec2& place : places) {
          sum += face.surface->at(place) + face.surface->base_at(place);
          sum += face.surface->evaluate(place).du + face.surface->normal(place);
        }
        const auto bytes = peak.bytes();
        INFO(network.name);
        CHECK(sum.allFinite());
        if (bytes) CHECK(*bytes == 0);
      }
    }
  }
}

}  // namespace croquis::test
