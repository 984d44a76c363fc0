// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "attribute_surface/small_networks.h"
#include "croquis/attribute_surface/surface_measures.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"

using namespace croquis;
using namespace croquis::test;

namespace {

SurfaceMeasures measures_of(const AttributeNetwork& network, const AttributeSurfaceOptions& options = {}) {
  Progress progress;
  return measure(network, make_attribute_surface(network, progress, options));
}

AttributeNetwork shipped(const std::string& name) {
  const std::string path = CROQUIS_SOURCE_DIR "/examples/data/surface/" + name + ".json";
  return read_attribute_network(read_file(path), name).network;
}

}  // namespace

TEST_CASE("a flat polygon in a circle is mapped without stretch, a rectangle from a square by its ratio") {
  AttributeSurfaceOptions options;
  options.mode = AttributeMode::Position;
  const AttributeNetwork rectangle = straight_loop({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}});
  const SurfaceMeasures even = measures_of(rectangle, options);
  REQUIRE(even.patches.size() == 1);
  CHECK(even.patches[0].anisotropy == Approx(1).epsilon(1e-9));
  CHECK(even.patches[0].sigma == Approx(8));
  CHECK(even.patches[0].radius == Approx(std::sqrt(10.0) / 2 / 8));
  CHECK(even.patches[0].centre_inside);
  CHECK(even.patches[0].side_lengths.size() == 4);
  CHECK(even.patches[0].folded == 0);
  CHECK(even.boundary_error < 1e-12);
  CHECK(even.largest_normal_jump == 0);
  options.domain = AttributeDomain::Uniform;
  CHECK(measures_of(rectangle, options).patches[0].anisotropy == Approx(3).epsilon(1e-9));
}

TEST_CASE("the chordlength domain stretches the car less than the uniform one") {
  const AttributeNetwork network = shipped("car_intact");
  AttributeSurfaceOptions uniform;
  uniform.domain = AttributeDomain::Uniform;
  const SurfaceMeasures by_length = measures_of(network), regular = measures_of(network, uniform);
  double chord_sum = 0, uniform_sum = 0;
  for (std::size_t i = 0; i < by_length.patches.size(); ++i) {
    chord_sum += std::log(by_length.patches[i].anisotropy);
    uniform_sum += std::log(regular.patches[i].anisotropy);
  }
  CHECK(chord_sum < 0.7 * uniform_sum);
}

TEST_CASE("faces meet their curves, points and inner curves, and smooth curves have one tangent plane") {
  constexpr double tenth_degree = 0.1 * std::numbers::pi / 180;
  for (const std::string name : {"car_intact", "car_crashed", "pocket5", "tri_point"}) {
    INFO(name);
    const AttributeNetwork network = shipped(name);
    const SurfaceMeasures measures = measures_of(network);
    CHECK(measures.patches.size() == network.faces.size());
    CHECK(measures.boundary_error < 1e-11);
    REQUIRE(measures.point_errors.size() == network.points.size());
    for (const auto& error : measures.point_errors) CHECK(error.value() < 1e-12);
    CHECK(measures.largest_normal_jump < tenth_degree);
    std::size_t smooth = 0;
    for (const auto& jump : measures.normal_jumps) smooth += jump ? 1U : 0U;
    CHECK(smooth == (name == "pocket5" ? 1U : name == "tri_point" ? 0U : 17U));
  }
  const SurfaceMeasures pocket = measures_of(shipped("pocket5"));
  REQUIRE(pocket.inner_errors[0].size() == 1);
  CHECK(pocket.inner_errors[0][0].value() < 5e-4);
  CHECK(pocket.inner_errors[0][0].value() > 0);  // between its samples
}

TEST_CASE("a face of two curves has four halves, and what failed isn't measured") {
  AttributeNetwork network = leaf_between_triangles();
  network.points.push_back({"p", 1, {1.5, -1.5, 0.3}, {}, {}, PointProfile::Smooth, {}});
  const SurfaceMeasures whole = measures_of(network);
  REQUIRE(whole.patches.size() == 3);
  CHECK(whole.patches[0].side_lengths.size() == 4);
  CHECK(whole.patches[0].side_lengths[0] == whole.patches[0].side_lengths[1]);
  CHECK(whole.point_errors[0].value() < 1e-12);
  network.faces[1].loop[0].reversed = true;
  const SurfaceMeasures broken = measures_of(network);
  REQUIRE(broken.patches.size() == 2);
  CHECK(broken.patches[1].face == 2);
  CHECK_FALSE(broken.point_errors[0].has_value());
}
