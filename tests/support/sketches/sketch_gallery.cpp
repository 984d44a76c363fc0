// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_gallery.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_spline.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;
const Vec2 middle(450, 350);

std::function<double(double)> level(double value) {
  return [value](double) { return value; };
}

/// Along a knot whose tube rises and sinks on a torus seen from above.
TubeStrand torus_knot(int turns, int petals, double inner, double swing, double radius) {
  const auto centre = [=](double t) -> Vec2 {
    const double along = 2 * pi * t + 0.05;
    const double from_axis = inner + swing * std::cos(petals * along);
    return middle + from_axis * Vec2(std::cos(turns * along), std::sin(turns * along));
  };
  const auto height = [=](double t) { return std::sin(petals * (2 * pi * t + 0.05)); };
  return {centre, level(radius), height, true};
}

/// The ring at a place of a chain lies over the next one above the axis and under it below.
TubeStrand chain_ring(int index, double x, double ring_radius, double radius) {
  const auto height = [index](double t) {
    const bool right = t < 0.25 || t > 0.75;
    const bool upper = t < 0.5;
    return right == upper ? 1.0 + 0.01 * index : -1.0 - 0.01 * index;
  };
  return ring({x, middle.y()}, ring_radius, radius, height);
}

}  // namespace

Sketch circle_sketch() { return layered_sketch({{circle_outline(middle, 250), 0}}); }

Sketch annulus_sketch() { return tube_sketch({ring(middle, 220, 80, level(0))}); }

Sketch trefoil_sketch() { return torus_knot_sketch(2, 3); }

Sketch torus_knot_sketch(int turns, int petals) {
  if (petals == 3) return tube_sketch({torus_knot(turns, petals, 180, 95, 38)});
  if (turns == 2) return tube_sketch({torus_knot(turns, petals, 215, 75, 26)});
  return tube_sketch({torus_knot(turns, petals, 200, 110, 18)});
}

Sketch snake_sketch() {
  const auto centre = [](double t) -> Vec2 {
    const double angle = 4.3 * (2 * t - 1);
    return middle + Vec2(53 * angle - 172 * std::sin(angle), -165 * std::cos(angle) - 20);
  };
  // Thin at the tail, thicker at the head.
  const auto radius = [](double t) {
    return 13 + 24 * std::sqrt(1 - std::pow(1 - t, 4) + 0.01) + 9 * std::exp(-400 * (t - 0.965) * (t - 0.965));
  };
  return tube_sketch({{centre, radius, [](double t) { return t; }, false}});
}

Sketch figure_eight_sketch() {
  const auto centre = [](double t) -> Vec2 {
    const double angle = 2 * pi * (t + 0.031);
    return middle + Vec2(320 * std::sin(angle), 190 * std::sin(2 * angle));
  };
  return tube_sketch({{centre, level(42), [](double t) { return std::cos(2 * pi * (t + 0.031)); }, true}});
}

Sketch ring_and_bar_sketch() {
  const auto threaded = [](double t) { return t < 0.5 ? 1.0 : -1.0; };
  return tube_sketch({ring(middle, 200, 45, level(0)), bar({90, 310}, {810, 400}, 40, threaded)});
}

Sketch linked_rings_sketch() { return tube_sketch({chain_ring(0, 330, 190, 44), chain_ring(1, 570, 190, 44)}); }

Sketch borromean_sketch() {
  // Each ring lies over the next one at both crossings; shifted by thirds, no ring is higher than another everywhere.
  std::vector<TubeStrand> rings;
  for (int i = 0; i < 3; ++i) {
    const double angle = pi / 2 + 2 * pi * i / 3;
    const Vec2 centre = middle - Vec2(0, 25) + 105 * Vec2(std::cos(angle), std::sin(angle));
    // It meets the next ring a quarter and seven twelfths of a turn from its outermost point, the other one between.
    const auto height = [angle](double t) {
      double from_outside = t - angle / (2 * pi);
      from_outside -= std::floor(from_outside);
      const bool at_next = from_outside < 1.0 / 3 || (from_outside > 0.5 && from_outside < 2.0 / 3);
      return at_next ? 1.0 : -1.0;
    };
    rings.push_back(ring(centre, 185, 26, height));
  }
  return tube_sketch(rings);
}

Sketch chain_sketch(int count) {
  const double ring_radius = 820 / (1.3 * (count - 1) + 2.22);
  std::vector<TubeStrand> rings;
  for (int i = 0; i < count; ++i) {
    const double x = middle.x() + (i - 0.5 * (count - 1)) * 1.3 * ring_radius;
    rings.push_back(chain_ring(i, x, 0.92 * ring_radius, 0.19 * ring_radius));
  }
  return tube_sketch(rings);
}

Sketch weave_sketch(int columns, int rows) {
  constexpr double apart = 140;
  constexpr double overhang = 85;
  const double left = middle.x() - 0.5 * apart * (columns - 1);
  const double low = middle.y() - 0.5 * apart * (rows - 1);
  // The parameter runs over the whole bar; crossing k lies at overhang + k apart of its length.
  const auto alternating = [](int count, bool first_over) {
    const double length = 2 * overhang + apart * (count - 1);
    return [=](double t) {
      const auto k = std::lround((t * length - overhang) / apart);
      return ((k % 2 == 0) == first_over) ? 1.0 : 0.0;
    };
  };
  std::vector<TubeStrand> bars;
  for (int i = 0; i < columns; ++i) {
    const double x = left + apart * i;
    bars.push_back(
        bar({x, low - overhang}, {x, low + apart * (rows - 1) + overhang}, 37, alternating(rows, i % 2 == 0)));
  }
  for (int i = 0; i < rows; ++i) {
    const double y = low + apart * i;
    const auto height = [up = alternating(columns, i % 2 != 0)](double t) { return up(t) - 0.5; };
    bars.push_back(bar({left - overhang, y}, {left + apart * (columns - 1) + overhang, y}, 37, height));
  }
  return tube_sketch(bars);
}

Sketch three_blobs_sketch() {
  // Pairwise 28 units deep in one another, with a gap in their middle.
  std::vector<LayeredPart> blobs;
  for (int i = 0; i < 3; ++i) {
    const double angle = 0.4 + 2 * pi * i / 3;
    blobs.push_back({circle_outline(middle + 172 * Vec2(std::cos(angle), std::sin(angle)), 163), i});
  }
  return layered_sketch(blobs);
}

std::vector<NamedSketch> all_sketches() {
  return {{"circle", circle_sketch()},
          {"annulus", annulus_sketch()},
          {"trefoil", trefoil_sketch()},
          {"torus knot 2,5", torus_knot_sketch(2, 5)},
          {"torus knot 3,4", torus_knot_sketch(3, 4)},
          {"snake", snake_sketch()},
          {"figure eight", figure_eight_sketch()},
          {"ring and bar", ring_and_bar_sketch()},
          {"linked rings", linked_rings_sketch()},
          {"borromean rings", borromean_sketch()},
          {"chain", chain_sketch()},
          {"weave", weave_sketch()},
          {"three blobs", three_blobs_sketch()},
          {"dog", dog_sketch()},
          {"duck", duck_sketch()},
          {"octopus", octopus_sketch()}};
}

}  // namespace croquis::test
