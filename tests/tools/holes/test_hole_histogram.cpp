// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/tools/holes/hole_histogram.h"
#include "support/random.h"

namespace croquis {
namespace {

std::vector<double> some_diameters(unsigned seed, int count) {
  test::Random random(seed);
  std::vector<double> diameters;
  for (int i = 0; i < count; ++i) diameters.push_back(std::pow(10, random.between(-3, 2)));
  return diameters;
}

TEST_CASE("every hole is in the one bin that spans its diameter") {
  const unsigned seed = GENERATE(1U, 2U, 3U);
  const std::vector<double> diameters = some_diameters(seed, 500);
  const HoleHistogram histogram(diameters, 17);
  REQUIRE(histogram.bins().size() == 17);
  CHECK(histogram.bins().front().low == *std::min_element(diameters.begin(), diameters.end()));
  CHECK(histogram.bins().back().high == *std::max_element(diameters.begin(), diameters.end()));
  std::size_t most = 0;
  for (std::size_t i = 0; i < 17; ++i) {
    const HoleHistogram::Bin& bin = histogram.bins()[i];
    if (i > 0) CHECK(bin.low == histogram.bins()[i - 1].high);
    const bool last = i == 16;
    const auto inside = std::count_if(diameters.begin(), diameters.end(), [&](double d) {
      return d >= bin.low && (d < bin.high || (last && d == bin.high));
    });
    CHECK(bin.count == static_cast<std::size_t>(inside));
    most = std::max(most, bin.count);
    CHECK(bin.high / bin.low == Approx(histogram.bins()[0].high / histogram.bins()[0].low));
  }
  CHECK(histogram.highest() == most);
}

TEST_CASE("holes up to a size are counted, that size included") {
  const HoleHistogram histogram(std::vector<double>{3, 1, 2, 2});
  CHECK(histogram.count_up_to(0.5) == 0);
  CHECK(histogram.count_up_to(1) == 1);
  CHECK(histogram.count_up_to(2) == 3);
  CHECK(histogram.count_up_to(1e9) == 4);
}

TEST_CASE("the slider's scale is logarithmic, and both ways undo each other") {
  const HoleHistogram histogram(std::vector<double>{0.01, 1, 100});
  CHECK(histogram.position(0.01) == 0);
  CHECK(histogram.position(1) == Approx(0.5));
  CHECK(histogram.position(100) == 1);
  CHECK(histogram.position(0) == 0);
  CHECK(histogram.position(1e6) == 1);
  CHECK(histogram.diameter(0.25) == Approx(0.1));
  for (const double place : {0.0, 0.1, 0.77, 1.0})
    CHECK(histogram.position(histogram.diameter(place)) == Approx(place));
}

TEST_CASE("the slider stops where a hole begins to be taken in") {
  const HoleHistogram histogram(std::vector<double>{1, 10, 100});
  const double near_ten = histogram.position(10) - 0.01;
  CHECK(histogram.count_up_to(histogram.diameter(near_ten)) == 1);
  const double snapped = histogram.snapped(near_ten, 0.02);
  CHECK(snapped >= 10);
  CHECK(snapped < 10.001);
  CHECK(histogram.count_up_to(snapped) == 2);
  CHECK(histogram.snapped(near_ten, 0.001) == histogram.diameter(near_ten));
  CHECK(histogram.count_up_to(histogram.snapped(1, 0.02)) == 3);
  CHECK(histogram.count_up_to(histogram.snapped(0, 0.02)) == 1);
}

TEST_CASE("a snapped size parts even holes that are almost as large") {
  const std::vector<double> twins = {1, 5, 5 * (1 + 1e-9), 50};
  const HoleHistogram histogram(twins);
  CHECK(histogram.count_up_to(histogram.snapped(histogram.position(5), 0.01)) == 2);
}

TEST_CASE("histograms of nothing, of one size and of nonsense") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const HoleHistogram& none : {HoleHistogram(), HoleHistogram(std::vector<double>{0, -1, nan, 1 / 0.0})}) {
    CHECK(none.empty());
    CHECK(none.bins().empty());
    CHECK(none.highest() == 0);
    CHECK(none.diameter(0.5) == 0);
    CHECK(none.snapped(0.5) == 0);
    CHECK(none.count_up_to(1) == 0);
  }
  const HoleHistogram one(std::vector<double>{2, 2, 2});
  REQUIRE(one.bins().size() == 1);
  CHECK(one.bins()[0].count == 3);
  CHECK(one.diameter(0.3) == 2);
  CHECK(one.count_up_to(one.snapped(0.5)) == 3);
}

}  // namespace
}  // namespace croquis
