// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/attribute_surface/domain_comparison.h"
#include "small_networks.h"

namespace croquis::test {
namespace {

/// A loop with a point that is pulled straight up from a place of its domain.
AttributeNetwork pulled(AttributeNetwork network, const FanPlace& fan, double by) {
  Progress progress;
  const AttributeSurface base = make_attribute_surface(network, progress);
  REQUIRE(base.faces[0].surface);
  const FaceSurface& face = *base.faces[0].surface;
  const Vec3 foot = face.base_at(place_in(face.domain(), fan));
  PointAttribute point;
  point.id = "p";
  point.face = 0;
  point.fan = fan;
  point.point = foot + by * Vec3::UnitZ();
  network.points.push_back(point);
  return network;
}

DentMeasures dent_of(const AttributeNetwork& network) {
  Progress progress;
  const AttributeSurface surface = make_attribute_surface(network, progress);
  const FaceSurface& face = *surface.faces[0].surface;
  const auto dent = measure_dent(face, 0, face.base_at(face.points()[0].place));
  REQUIRE(dent);
  return *dent;
}

/// A triangle whose sides are as far from equal as a strip of sheet metal's.
AttributeNetwork strip() { return straight_loop({{0, 0, 0}, {8, 0, 0}, {8.3, 1, 0}}); }

TEST_CASE("in the middle of a regular polygon a dent lies at its point and is round", "[attribute_surface]") {
  for (const std::size_t sides : {3U, 5U, 6U}) {
    std::vector<Vec3> corners;
    for (std::size_t k = 0; k < sides; ++k) {
      const double angle = 2 * M_PI * static_cast<double>(k) / static_cast<double>(sides);
      corners.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const DentMeasures dent = dent_of(pulled(straight_loop(corners), {0, 0, 0}, 0.1));
    CHECK(dent.offset < 1e-3);
    CHECK(dent.anisotropy < 1.01);
  }
}

TEST_CASE("the measures of a dent don't depend on how far its point is pulled, and grow with the model",
          "[attribute_surface]") {
  const AttributeNetwork once = pulled(strip(), {0, 0.2, 0.3}, 0.1);
  const AttributeNetwork twice = pulled(strip(), {0, 0.2, 0.3}, 0.2);
  CHECK(dent_of(once).offset == Approx(dent_of(twice).offset).margin(1e-9));
  CHECK(dent_of(once).anisotropy == Approx(dent_of(twice).anisotropy));
  const Affine3 larger{3 * Eigen::Matrix3d::Identity(), Vec3(1, 2, 3)};
  CHECK(dent_of(transformed(once, larger)).offset == Approx(3 * dent_of(once).offset));
}

TEST_CASE("a flat triangle is mapped without distortion by its lengths, and drawn out by a uniform domain",
          "[attribute_surface]") {
  Progress progress;
  for (const FanPlace& fan : {FanPlace{0, 0, 0}, FanPlace{0, 0.2, 0.3}, FanPlace{1, 0.4, 0.1}, FanPlace{2, 0.1, 0.3}}) {
    const AttributeNetwork network = pulled(strip(), fan, 0.1);
    const AttributeSurface surface = make_attribute_surface(network, progress);
    const DomainComparison compared = compare_with_uniform(network, surface, progress);
    REQUIRE(compared.points.size() == 1);
    REQUIRE(compared.points[0].own);
    REQUIRE(compared.points[0].uniform);
    CHECK(compared.points[0].uniform->anisotropy > 2 * compared.points[0].own->anisotropy);
  }
}

TEST_CASE("points keep their places of space when domains become uniform, and are met there", "[attribute_surface]") {
  Progress progress;
  const AttributeNetwork network = pulled(hill(5, 0.4), {2, 0.3, 0.2}, 0.3);
  const AttributeSurface surface = make_attribute_surface(network, progress);
  const DomainComparison compared = compare_with_uniform(network, surface, progress);
  const FaceSurface& own = *surface.faces[0].surface;
  const FaceSurface& uniform = *compared.surface.faces[0].surface;
  CHECK((own.base_at(own.points()[0].place) - uniform.base_at(uniform.points()[0].place)).norm() < 0.05);
  CHECK((uniform.at(uniform.points()[0].place) - network.points[0].point).norm() < 1e-9);
  CHECK(uniform.points()[0].radius == own.points()[0].radius);
  CHECK(compared.network.faces[0].domain == AttributeDomain::Uniform);
}

TEST_CASE("a point that lies on the surface makes no dent", "[attribute_surface]") {
  Progress progress;
  const AttributeNetwork network = pulled(strip(), {0, 0.2, 0.3}, 0);
  const AttributeSurface surface = make_attribute_surface(network, progress);
  const DomainComparison compared = compare_with_uniform(network, surface, progress);
  REQUIRE(compared.points.size() == 1);
  CHECK_FALSE(compared.points[0].own);
}

}  // namespace
}  // namespace croquis::test
