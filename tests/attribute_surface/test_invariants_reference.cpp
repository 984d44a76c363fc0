// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "croquis/io/file.h"
#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const std::map<std::string, AttributeMode>& modes_by_name() {
  static const std::map<std::string, AttributeMode> modes{
      {"smooth", AttributeMode::Smooth}, {"position", AttributeMode::Position}, {"paper", AttributeMode::Paper}};
  return modes;
}

/// Values of an independent program: 9 decimals of places, side lengths, radii and points' footprints.
Json expected_values() { return Json::parse(read_file(CROQUIS_SOURCE_DIR "/tests/cli/networks/expected.json")); }

Vec3 vector_of(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

FanPlace fan_of(const Json& json) { return {json[0].get<std::size_t>(), json[1].get<double>(), json[2].get<double>()}; }

Index face_named(const AttributeNetwork& network, const std::string& id) {
  const auto face = std::ranges::find(network.faces, id, &AttributeFace::id);
  REQUIRE(face != network.faces.end());
  return static_cast<Index>(face - network.faces.begin());
}

AttributeSurfaceOptions options_of(AttributeMode mode) {
  AttributeSurfaceOptions options;
  options.mode = mode;
  return options;
}

std::string file_of(const std::string& key) { return key.substr(key.find('/') + 1); }

/// Greatest difference of a face from the reference, with its points.
double reference_error(const AttributeNetwork& network, const AttributeSurface& surface, Index f, std::size_t count) {
  const FaceSurface& face = *surface.faces[f].surface;
  const ReferenceSurface reference(face.frame(), reference_points(network, f));
  double largest = 0;
  for (const FanPlace& fan : spread_places(face.domain().corners.size(), count, 12))
    largest = std::max(largest, (face.at(place_in(face.domain(), fan)) - reference.at(fan)).norm());
  return largest;
}

}  // namespace

TEST_CASE("the values of an independent program are met in all modes") {
  const Json expected = expected_values();
  for (const auto& [key, faces] : expected.items()) {
    const AttributeNetwork network = example_network(file_of(key));
    CAPTURE(network.name);
    for (const auto& [name, mode] : modes_by_name()) {
      const AttributeSurface surface = surface_of(network, options_of(mode));
      for (const auto& [id, values] : faces.items()) {
        if (!values.contains(name)) continue;
        CAPTURE(id, name);
        const FaceSurface& face = *surface.faces[face_named(network, id)].surface;
        for (const Json& value : values[name]) {
          const Vec3 found = face.at(place_in(face.domain(), fan_of(value["fan"])));
          CHECK((found - vector_of(value["p"])).norm() < 1e-7);
        }
      }
    }
  }
}

TEST_CASE("lengths, domains and what lies below points are those of an independent program") {
  const Json expected = expected_values();
  for (const auto& [key, faces] : expected.items()) {
    const AttributeNetwork network = example_network(file_of(key));
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    for (const auto& [id, values] : faces.items()) {
      CAPTURE(id);
      const FaceSurface& face = *surface.faces[face_named(network, id)].surface;
      for (std::size_t i = 0; i < face.frame().sides.size(); ++i)
        CHECK(face.frame().sides[i].curve->length() == Approx(values["side_lengths"][i].get<double>()).margin(2e-9));
      CHECK(face.domain().beta == Approx(values["beta"].get<double>()).margin(1e-9));
      CHECK(face.domain().radius == Approx(values["R"].get<double>()).margin(2e-9));
      CHECK(face.domain().centre_inside == values["centre_inside"].get<bool>());
      for (const Json& point : values.value("points", Json::array())) {
        const auto own = std::ranges::find(network.points, point["id"].get<std::string>(), &PointAttribute::id);
        const FanPlace fan = surface.points[static_cast<std::size_t>(own - network.points.begin())].fan.value();
        CHECK((face.base_at(place_in(face.domain(), fan)) - vector_of(point["base"])).norm() < 1e-6);
      }
    }
  }
}

TEST_CASE("surfaces agree with their formulas evaluated slowly, for any number of sides") {
  std::vector<AttributeNetwork> networks{leaf_loop(), wavy_star(6)};
  for (std::size_t sides = 2; sides <= 12; ++sides) networks.push_back(random_loop(sides, 40));
  for (const AttributeNetwork& network : strained_loops()) networks.push_back(network);
  for (const ExactPatch& patch : exact_patches()) networks.push_back(patch.network);
  for (const AttributeNetwork& plain : networks) {
    const AttributeNetwork network = with_points(plain, 3, 0.15, 10);
    CAPTURE(network.name);
    for (const auto& [name, mode] : modes_by_name()) {
      CAPTURE(name);
      CHECK(reference_error(network, surface_of(network, options_of(mode)), 0, 4) < 1e-9 * (1 + extent(network)));
    }
  }
}

TEST_CASE("fullness and domains are those of the formulas") {
  for (const std::size_t sides : std::vector<std::size_t>{2, 3, 4, 5, 8}) {
    AttributeNetwork network = random_loop(sides, 50);
    for (const AttributeDomain domain : {AttributeDomain::Uniform, AttributeDomain::Chordlength}) {
      for (const double fullness : {-1.0, 0.0, 0.7, 1.0, 2.0}) {
        CAPTURE(sides, fullness);
        network.faces[0].domain = domain;
        network.faces[0].fullness = fullness;
        CHECK(reference_error(network, surface_of(network), 0, 3) < 1e-9);
      }
    }
  }
}

TEST_CASE("faces of networks agree with their formulas, their fences given") {
  for (const AttributeNetwork& network : {boat_hull(), cube_sphere(), example_network("car_crashed")}) {
    CAPTURE(network.name);
    const AttributeSurface surface = surface_of(network);
    for (Index f = 0; f < network.faces.size(); f += 3) CHECK(reference_error(network, surface, f, 3) < 1e-9 * 5);
  }
}

}  // namespace croquis::test
