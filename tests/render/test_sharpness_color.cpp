// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <glm/glm.hpp>

#include "croquis/geometry/mesh_tags.h"
#include "croquis/render/render_options.h"
#include "croquis/render/sharpness_color.h"

using namespace croquis;
using namespace croquis::render;

namespace {

double linear(std::uint8_t level) { return std::pow(level / 255.0, 2.2); }

/// CIE lightness, 0 … 100.
double lightness(const Color& color) {
  const double luminance = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  return 116 * std::cbrt(luminance) - 16;
}

double difference(const Color& a, const Color& b) { return glm::distance(glm::vec3(a), glm::vec3(b)); }

}  // namespace

TEST_CASE("sharper edges are darker all the way, so that no colour vision is needed to order them") {
  double previous = lightness(sharpness_color(0));
  for (int halves = 1; halves <= 20; ++halves) {
    const double here = lightness(sharpness_color(0.5 * halves));
    CHECK(here < previous);
    previous = here;
  }
  CHECK(lightness(sharpness_color(0)) - lightness(sharpness_color(10)) > 50);
}

TEST_CASE("the legend's colours differ from each other and from those of selection and hovering") {
  const std::vector<SharpnessSample> legend = sharpness_legend();
  const EmphasisOptions emphasis;
  std::set<std::string> labels;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    CHECK(legend[i].color == sharpness_color(legend[i].sharpness));
    CHECK(difference(legend[i].color, emphasis.selected) > 100);
    CHECK(difference(legend[i].color, emphasis.hovered) > 60);
    for (std::size_t j = 0; j < i; ++j) CHECK(difference(legend[i].color, legend[j].color) > 20);
    labels.insert(legend[i].label);
  }
  CHECK(labels.size() == legend.size());
  CHECK(legend.front().label == "0.5");
  CHECK(legend.back().label == "infinite");
}

TEST_CASE("any number has a colour and a width") {
  CHECK(sharpness_color(std::numeric_limits<double>::quiet_NaN()) == sharpness_color(0));
  CHECK(sharpness_color(-1) == sharpness_color(0));
  CHECK(sharpness_color(11) == sharpness_color(infinite_sharpness));
  CHECK(sharpness_color(10) != sharpness_color(infinite_sharpness));
  CHECK(sharpness_width(0.5) < sharpness_width(5));
  CHECK(sharpness_width(10) < sharpness_width(infinite_sharpness));
}
