// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "support/random.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int attempts = 4000;

// --- layers ----------------------------------------------------------------------------------------------------------

std::vector<Vec2> random_blob(Random& random, const Vec2& centre, double size) {
  const double lobes2 = random.between(0, 0.16);
  const double lobes3 = random.between(0, 0.10);
  const double turn2 = random.between(0, 2 * pi);
  const double turn3 = random.between(0, 2 * pi);
  std::vector<Vec2> outline;
  const int count = static_cast<int>(2 * pi * size / 3);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    const double radius = size * (1 + lobes2 * std::cos(2 * angle + turn2) + lobes3 * std::cos(3 * angle + turn3));
    outline.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

std::vector<Vec2> random_capsule(Random& random, const Vec2& centre, double size) {
  const double angle = random.between(0, pi);
  const Vec2 half = size * random.between(0.9, 1.5) * Vec2(std::cos(angle), std::sin(angle));
  return tube_outline(bar(centre - half, centre + half, size * random.between(0.35, 0.6), [](double) { return 0.0; }));
}

double shortest_distance_between(const std::vector<TrueCrossing>& places) {
  double shortest = 1e9;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      shortest = std::min(shortest, (places[i].at - places[k].at).norm());
    }
  }
  return shortest;
}

/// Every contour crosses another (so none lies free inside another), crossings are apart and not tangential.
bool clear_to_read(const Sketch& sketch, double apart) {
  const SketchTruth& truth = sketch.truth;
  for (int c = 0; c < truth.contours; ++c) {
    const bool meets = std::any_of(truth.places.begin(), truth.places.end(),
                                   [c](const TrueCrossing& place) { return place.over == c || place.under == c; });
    if (!meets) return false;
  }
  if (shortest_distance_between(truth.places) < apart) return false;
  return std::all_of(truth.places.begin(), truth.places.end(),
                     [](const TrueCrossing& place) { return place.sine > 0.5; });
}

std::optional<Sketch> try_layers(const std::vector<LayeredPart>& parts) {
  try {
    return layered_sketch(parts);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// --- tubes -----------------------------------------------------------------------------------------------------------

/// A rosette or a Lissajous figure, bent by a few harmonics: free random harmonics nearly always make cusps.
struct RandomCurve {
  bool rosette = false;
  int turns = 1;
  int petals = 2;
  Vec2 size = Vec2::Zero();
  double phase = 0;
  std::vector<Vec2> cosine;
  std::vector<Vec2> sine;

  Vec2 at(double t) const {
    const double angle = 2 * pi * t;
    Vec2 place(450, 350);
    if (rosette) {
      place +=
          (size.x() + size.y() * std::cos(petals * angle)) * Vec2(std::cos(turns * angle), std::sin(turns * angle));
    } else {
      place += Vec2(size.x() * std::sin(turns * angle + phase), size.y() * std::sin(petals * angle));
    }
    for (std::size_t k = 0; k < cosine.size(); ++k) {
      const double wave = static_cast<double>(k + 1) * angle;
      place += std::cos(wave) * cosine[k] + std::sin(wave) * sine[k];
    }
    return place;
  }
};

RandomCurve random_curve(Random& random) {
  RandomCurve curve;
  curve.rosette = random.below(2) == 0;
  if (curve.rosette) {
    curve.turns = 2;
    curve.petals = random.below(2) == 0 ? 3 : 5;
    curve.size = Vec2(random.between(165, 210), random.between(60, 110));
  } else {
    curve.petals = random.below(2) == 0 ? 2 : 3;
    curve.turns = curve.petals - 1;
    curve.size = Vec2(random.between(260, 350), random.between(180, 250));
    curve.phase = random.between(-0.5, 0.5);
  }
  for (int k = 1; k <= 3; ++k) {
    const double bend = 45.0 / k;
    const auto vector = [&] { return Vec2(random.between(-bend, bend), random.between(-bend, bend)); };
    curve.cosine.push_back(vector());
    curve.sine.push_back(vector());
  }
  return curve;
}

struct SelfCrossing {
  double first;
  double second;
  Vec2 at;
};

std::vector<SelfCrossing> self_crossings(const RandomCurve& curve) {
  constexpr int count = 360;
  std::vector<SelfCrossing> found;
  const auto point = [&](int i) { return curve.at((i + 0.5) / count); };
  for (int i = 0; i < count; ++i) {
    for (int k = i + 2; k < count - (i == 0 ? 1 : 0); ++k) {
      const Vec2 a = point(i + 1) - point(i);
      const Vec2 b = point(k + 1) - point(k);
      const Vec2 apart = point(k) - point(i);
      const double ta = cross(apart, b) / cross(a, b);
      const double tb = cross(apart, a) / cross(a, b);
      if (ta < 0 || ta >= 1 || tb < 0 || tb >= 1) continue;
      found.push_back({(i + 0.5 + ta) / count, (k + 0.5 + tb) / count, point(i) + ta * a});
    }
  }
  return found;
}

bool bends_gently(const RandomCurve& curve, double radius) {
  for (int i = 0; i < 400; ++i) {
    const double t = i / 400.0;
    const Vec2 before = curve.at(t) - curve.at(t - 0.002);
    const Vec2 after = curve.at(t + 0.002) - curve.at(t);
    const double turn = std::atan2(std::abs(cross(before, after)), before.dot(after));
    if (turn * 1.4 * radius > before.norm()) return false;
  }
  return true;
}

bool crossings_apart(const std::vector<SelfCrossing>& crossings, double distance) {
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    for (std::size_t k = i + 1; k < crossings.size(); ++k) {
      if ((crossings[i].at - crossings[k].at).norm() < distance) return false;
    }
  }
  return true;
}

/// At each crossing one of the two passes is raised at random; in between the nearest crossing decides.
std::function<double(double)> random_heights(Random& random, const std::vector<SelfCrossing>& crossings) {
  std::vector<std::pair<double, double>> passes;
  for (const SelfCrossing& crossing : crossings) {
    const double up = random.below(2) == 0 ? 1 : -1;
    passes.emplace_back(crossing.first, up);
    passes.emplace_back(crossing.second, -up);
  }
  return [passes](double t) {
    double nearest = 2;
    double height = 0;
    for (const auto& [at, up] : passes) {
      const double apart = std::abs(t - at);
      const double distance = std::min(apart, 1 - apart);
      if (distance < nearest) height = up;
      nearest = std::min(nearest, distance);
    }
    return height;
  };
}

std::optional<Sketch> try_tube(Random& random, double radius) {
  const RandomCurve curve = random_curve(random);
  if (!bends_gently(curve, radius)) return std::nullopt;
  const std::vector<SelfCrossing> crossings = self_crossings(curve);
  if (crossings.empty() || !crossings_apart(crossings, 3.5 * radius)) return std::nullopt;
  const auto centre = [curve](double t) { return curve.at(t); };
  const TubeStrand strand{centre, [radius](double) { return radius; }, random_heights(random, crossings), true};
  try {
    Sketch sketch = tube_sketch({strand});
    const bool clean = sketch.truth.crossings == 4 * static_cast<int>(crossings.size()) &&
                       sketch.truth.hidden_arcs == 2 * static_cast<int>(crossings.size());
    if (clean && clear_to_read(sketch, 1.9 * radius)) return sketch;
  } catch (const std::logic_error&) {
    // Two passes too close to tell apart: another curve.
  }
  return std::nullopt;
}

}  // namespace

Sketch random_layered_sketch(std::uint64_t seed, int parts) {
  Random random(seed);
  const double size = 260 / std::sqrt(static_cast<double>(parts));
  std::vector<LayeredPart> chosen;
  std::optional<Sketch> sketch;
  for (int attempt = 0; attempt < attempts && static_cast<int>(chosen.size()) < parts; ++attempt) {
    const Vec2 centre(random.between(150, 750), random.between(130, 570));
    const bool round = random.below(3) > 0;
    const double own_size = size * random.between(0.7, 1.2);
    LayeredPart part{round ? random_blob(random, centre, own_size) : random_capsule(random, centre, own_size), 0};
    part.priority = static_cast<int>(random.below(1000)) * 16 + static_cast<int>(chosen.size());
    chosen.push_back(std::move(part));
    std::optional<Sketch> next = try_layers(chosen);
    if (next && (chosen.size() == 1 || clear_to_read(*next, 45))) {
      sketch = std::move(next);
    } else {
      chosen.pop_back();
    }
  }
  if (static_cast<int>(chosen.size()) != parts) throw std::logic_error("no room for that many random parts");
  return *sketch;
}

Sketch random_tube_sketch(std::uint64_t seed) {
  Random random(seed);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (std::optional<Sketch> sketch = try_tube(random, random.between(18, 28))) return *sketch;
  }
  throw std::logic_error("no clean random tube");
}

std::vector<NamedSketch> sketches_with_random_ones(std::uint64_t count) {
  std::vector<NamedSketch> sketches = all_sketches();
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const int parts = 2 + static_cast<int>(seed % 11);
    sketches.push_back({"layers " + std::to_string(seed), random_layered_sketch(seed, parts)});
    sketches.push_back({"tube " + std::to_string(seed), random_tube_sketch(seed)});
  }
  return sketches;
}

}  // namespace croquis::test
