// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_scrawls.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "support/random.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_modifiers.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

using Outline = std::vector<Vec2>;

Outline lobed_blob(Random& random, const Vec2& centre, double size, double lobes) {
  struct Wave {
    int count;
    double size;
    double turn;
  };
  std::vector<Wave> waves;
  for (int k = 2; k < 7; ++k)
    waves.push_back({k, random.between(0, lobes / std::pow(k, 0.7)), random.between(0, 6.28)});
  const double flatness = random.between(0.35, 1);
  const double turn = random.between(0, pi);
  Outline outline;
  const int count = std::max(40, static_cast<int>(2 * pi * size / 4));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    double radius = 1;
    for (const Wave& wave : waves) radius += wave.size * std::cos(wave.count * angle + wave.turn);
    radius = size * std::max(0.15, radius);
    const Vec2 flat(radius * std::cos(angle), flatness * radius * std::sin(angle));
    outline.emplace_back(centre + flat.x() * Vec2(std::cos(turn), std::sin(turn)) +
                         flat.y() * Vec2(-std::sin(turn), std::cos(turn)));
  }
  return outline;
}

Vec2 place_in(Random& random, double left, double right, double low, double high) {
  const double x = random.between(left, right);
  return {x, random.between(low, high)};
}

/// The later ones cover the earlier; one that nothing of would be in sight is left out.
Drawing layers_of(std::vector<Outline> outlines) {
  while (!outlines.empty()) {
    std::vector<LayeredPart> parts;
    for (const Outline& outline : outlines) parts.push_back({outline, static_cast<int>(parts.size())});
    try {
      return layered_sketch(std::move(parts)).drawing;
    } catch (const std::exception&) {
      outlines.erase(outlines.begin());
    }
  }
  return {};
}

std::vector<Outline> blobs(Random& random) {
  std::vector<Outline> outlines;
  const int count = 2 + static_cast<int>(random.below(10));
  const double lobes = random.between(0.05, 0.3);
  for (int i = 0; i < count; ++i) {
    const Vec2 centre = place_in(random, 200, 700, 150, 550);
    outlines.push_back(lobed_blob(random, centre, random.between(30, count < 6 ? 200 : 140), lobes));
  }
  return outlines;
}

std::vector<Outline> slivers(Random& random) {
  std::vector<Outline> outlines;
  const auto put = [&](Outline outline) {
    const auto place = static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(outlines.size()) + 1));
    outlines.insert(outlines.begin() + place, std::move(outline));
  };
  const int bases = 1 + static_cast<int>(random.below(4));
  for (int i = 0; i < bases; ++i) {
    const Vec2 centre = place_in(random, 250, 650, 200, 500);
    const Outline base = lobed_blob(random, centre, random.between(60, 180), random.between(0.05, 0.15));
    const auto copies = random.below(3);
    const auto specks = random.below(4);
    put(base);
    for (std::uint32_t k = 0; k < copies; ++k) {
      const Vec2 shift = place_in(random, -10, 10, -10, 10);
      const double growth = random.between(0.93, 1.03);
      Outline copy = base;
      for (Vec2& point : copy) point = centre + growth * (point - centre) + shift;
      put(std::move(copy));
    }
    for (std::uint32_t k = 0; k < specks; ++k) {
      const Vec2 on_rim = base[random.below(static_cast<std::uint32_t>(base.size()))];
      put(lobed_blob(random, on_rim + place_in(random, -12, 12, -12, 12), random.between(5, 16), 0.1));
    }
  }
  return outlines;
}

std::vector<Outline> sticks(Random& random) {
  std::vector<Outline> outlines;
  const int count = 2 + static_cast<int>(random.below(8));
  for (int i = 0; i < count; ++i) {
    const Vec2 centre = place_in(random, 300, 600, 250, 450);
    const double angle = random.between(0, pi);
    const Vec2 half = random.between(30, 175) * Vec2(std::cos(angle), std::sin(angle));
    const double radius = std::exp(random.between(std::log(3), std::log(70)));
    outlines.push_back(tube_outline(bar(centre - half, centre + half, radius, [](double) { return 0.0; })));
  }
  return outlines;
}

Drawing chain(Random& random) {
  const int rings = 2 + static_cast<int>(random.below(6));
  const double radius = random.between(8, 20);
  const double spacing = random.between(95, 110);
  std::vector<TubeStrand> strands;
  for (int i = 0; i < rings; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    strands.push_back(ring(Vec2(100 + spacing * i, 300), 70, radius * random.between(0.8, 1.2),
                           [side](double t) { return side * std::sin(2 * pi * t); }));
  }
  return tube_sketch(strands).drawing;
}

/// Of some sizes nobody could say which ring is in front.
Drawing readable_chain(Random& random) {
  for (;;) {
    try {
      return chain(random);
    } catch (const std::logic_error&) {
      continue;
    }
  }
}

Drawing scribbles(Random& random) {
  Drawing drawing;
  const auto count = 1 + random.below(8);
  for (std::uint32_t s = 0; s < count; ++s) {
    Vec2 pen = place_in(random, 100, 800, 100, 600);
    double heading = random.between(0, 2 * pi);
    double bend = 0;
    std::vector<Vec2> points;
    const auto steps = 20 + random.below(230);
    for (std::uint32_t i = 0; i < steps; ++i) {
      points.push_back(pen);
      bend = 0.9 * bend + random.between(-0.04, 0.04);
      heading += bend;
      pen += 5 * Vec2(std::cos(heading), std::sin(heading));
    }
    drawing.strokes.push_back(stroke_of("scribble-" + std::to_string(s + 1), points, random.below(5) < 2));
  }
  return drawing;
}

Drawing steady_scrawl(Scrawl family, std::uint64_t seed, Random& random) {
  switch (family) {
    case Scrawl::Blobs: return layers_of(blobs(random));
    case Scrawl::Slivers: return layers_of(slivers(random));
    case Scrawl::Sticks: return layers_of(sticks(random));
    case Scrawl::Chain: return readable_chain(random);
    case Scrawl::Tube: return random_tube_sketch(seed).drawing;
    case Scrawl::Scribbles: return scribbles(random);
  }
  return {};
}

}  // namespace

const std::vector<Scrawl>& scrawl_families() {
  static const std::vector<Scrawl> families = {Scrawl::Blobs, Scrawl::Slivers, Scrawl::Sticks,
                                               Scrawl::Chain, Scrawl::Tube,    Scrawl::Scribbles};
  return families;
}

std::string to_string(Scrawl family) {
  switch (family) {
    case Scrawl::Blobs: return "blobs";
    case Scrawl::Slivers: return "slivers";
    case Scrawl::Sticks: return "sticks";
    case Scrawl::Chain: return "chain";
    case Scrawl::Tube: return "tube";
    case Scrawl::Scribbles: return "scribbles";
  }
  return "";
}

ScrawledDrawing random_scrawl(Scrawl family, std::uint64_t seed) {
  Random random(seed * 1000003 + static_cast<std::uint64_t>(family));
  ScrawledDrawing scrawl{steady_scrawl(family, seed, random), random.below(2) == 0};
  if (scrawl.shaky) scrawl.drawing = noisy(scrawl.drawing, seed);
  return scrawl;
}

}  // namespace croquis::test
