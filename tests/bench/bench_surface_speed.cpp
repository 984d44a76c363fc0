// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <memory>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "bench/bench_surface.h"
#include "bench/cpu_time.h"
#include "bench/peak_memory.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/stage_cache.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/network_builder.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::bench {
namespace {

using namespace croquis::test;

constexpr int runs = 15;

/// The peer: a tensor product of cubic Bernstein polynomials.
struct BicubicPatch {
  std::array<Vec3, 16> control;  ///< row by row

  Vec3 at(const Vec2& place) const {
    const std::array<double, 4> u = basis(place.x()), v = basis(place.y());
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) sum += u[i] * v[j] * control[4 * i + j];
    }
    return sum;
  }

  static std::array<double, 4> basis(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
  }
};

BicubicPatch any_patch() {
  BicubicPatch patch;
  for (std::size_t i = 0; i < 16; ++i) {
    const auto row = static_cast<double>(i / 4), column = static_cast<double>(i % 4);
    patch.control[i] = Vec3(row, column, 0.3 * row * column - 0.1 * row * row);
  }
  return patch;
}

/// Nanoseconds per place. Results are kept, so that nothing can be left out.
template <typename Evaluate>
double ns_per_place(const std::vector<Vec2>& places, Evaluate&& evaluate) {
  std::vector<Vec3> results(places.size());
  const double ms = median_cpu_ms(runs, [&] {
    for (std::size_t i = 0; i < places.size(); ++i) results[i] = evaluate(places[i]);
  });
  return 1e6 * ms / static_cast<double>(places.size());
}

std::vector<Vec2> places_in(const DomainPolygon& domain) {
  std::vector<Vec2> places;
  for (const FanPlace& fan : spread_places(domain.corners.size(), 40000, 1)) places.push_back(place_in(domain, fan));
  return places;
}

/// Cubics between corners in a circle, up and down by turns.
AttributeNetwork cubic_loop(std::size_t sides) {
  NetworkBuilder builder("cubics");
  std::vector<AttributeSide> loop;
  const auto corner = [&](std::size_t i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % sides) / static_cast<double>(sides);
    return Vec3(1.3 * std::cos(angle), std::sin(angle), i % sides % 2 == 0 ? 0.1 : -0.1);
  };
  for (std::size_t i = 0; i < sides; ++i) {
    const Vec3 from = corner(i), along = corner(i + 1) - from;
    const Vec3 up(0, 0, 0.15 * along.norm());
    loop.push_back(
        {builder.curve({from, from + 0.3 * along + up, from + 0.65 * along + up, corner(i + 1)}, CurveJoin::Crease),
         false});
  }
  builder.face(std::move(loop));
  return std::move(builder.network);
}

struct EvaluationCase {
  const char* what;
  AttributeNetwork network;
};

void bench_evaluation(std::ostream& out) {
  const BicubicPatch patch = any_patch();
  const std::vector<Vec2> square = places_in(uniform_polygon(4));
  const double peer = ns_per_place(square, [&](const Vec2& place) { return patch.at(place); });
  out << "One place after the other, ns per place; ratios against a bicubic Bézier patch (16 control points, "
      << std::setprecision(1) << peer << " ns).\n\n"
      << "| sides | position | smooth | ratio | with derivatives | ratio | smooth with 3 points | ratio |\n"
      << "|---|---|---|---|---|---|---|---|\n";
  const std::vector<EvaluationCase> cases{{"3", cubic_loop(3)},
                                          {"4", cubic_loop(4)},
                                          {"6", cubic_loop(6)},
                                          {"12", cubic_loop(12)},
                                          {"4 of degree up to 6", random_loop(4, 90)},
                                          {"3, one nearly stops", random_loop(3, 90)}};
  for (const EvaluationCase& each : cases) {
    AttributeSurfaceOptions position;
    position.mode = AttributeMode::Position;
    const FaceSurface plain = first_surface(each.network, position), smooth = first_surface(each.network);
    const FaceSurface pulled = first_surface(with_points(each.network, 3, 0.1, 1));
    const std::vector<Vec2> places = places_in(smooth.domain());
    const double base = ns_per_place(places, [&](const Vec2& place) { return plain.at(place); });
    const double full = ns_per_place(places, [&](const Vec2& place) { return smooth.at(place); });
    const double slopes = ns_per_place(places, [&](const Vec2& place) {
      const SurfacePlace at = smooth.evaluate(place);
      return Vec3(at.du + at.dv);
    });
    const double points = ns_per_place(places, [&](const Vec2& place) { return pulled.at(place); });
    out << "| " << each.what << " | " << base << " | " << full << " | " << full / peer << " | " << slopes << " | "
        << slopes / peer << " | " << points << " | " << points / peer << " |" << std::endl;
  }
}

/// Keeps everything, and counts.
class KeepAll : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    std::string key = std::string(stage) + '\n' + std::string(content);
    const auto found = kept_.find(key);
    if (found != kept_.end()) return found->second;
    return kept_[std::move(key)] = make().result;
  }

 private:
  std::unordered_map<std::string, std::shared_ptr<const void>> kept_;
};

/// The car with one of its points pulled a little further.
AttributeNetwork dragged(AttributeNetwork car, int step) {
  car.points[0].point += Vec3(0, 0, 1e-4 * step);
  return car;
}

/// One of its curves bent a little further.
AttributeNetwork bent(AttributeNetwork car, int step) {
  for (AttributeCurve& curve : car.curves) {
    if (curve.id == "hoodfront") curve.control[1] += Vec3(0, 0, 1e-4 * step);
  }
  return car;
}

struct CarTimes {
  double surface_ms = 0;
  double mesh_ms = 0;
};

template <typename Change>
CarTimes times_of_car(std::size_t samples, StageCache* cache, Change&& change) {
  const AttributeNetwork car = example_network("car_crashed");
  Progress progress;
  AttributeSurfaceOptions options;
  options.cache = cache;
  SurfaceTessellationOptions tessellation;
  tessellation.samples = samples;
  tessellation.cache = cache;
  int step = 0;
  std::vector<double> surfaces, meshes;
  for (int run = 0; run <= runs; ++run) {
    const AttributeNetwork network = change(car, ++step);
    AttributeSurface surface;
    surfaces.push_back(cpu_ms([&] { surface = make_attribute_surface(network, progress, options); }));
    meshes.push_back(cpu_ms([&] { tessellate(network, surface, progress, tessellation); }));
  }
  for (auto* times : {&surfaces, &meshes}) {
    times->erase(times->begin());
    std::ranges::sort(*times);
  }
  return {surfaces[runs / 2], meshes[runs / 2]};
}

void bench_car(std::ostream& out) {
  out << "\nThe crashed car (21 faces, 4 points) made again, ms.\n\n"
      << "| what is moved | samples per side | kept from before | surfaces | triangles | all |\n"
      << "|---|---|---|---|---|---|\n";
  using Change = AttributeNetwork (*)(AttributeNetwork, int);
  for (const auto& [what, change] : {std::pair<const char*, Change>("a point", dragged), {"a curve", bent}}) {
    for (const std::size_t samples : std::vector<std::size_t>{16, 32}) {
      for (const bool kept : {false, true}) {
        KeepAll cache;
        const CarTimes times = times_of_car(samples, kept ? &cache : nullptr, change);
        out << "| " << what << " | " << samples << " | " << (kept ? "yes" : "no") << " | " << times.surface_ms << " | "
            << times.mesh_ms << " | " << times.surface_ms + times.mesh_ms << " |" << std::endl;
      }
    }
  }
}

void bench_memory(std::ostream& out) {
  const AttributeNetwork car = example_network("car_crashed");
  Progress progress;
  std::size_t kept = 0;
  PeakMemory memory;
  memory.restart();
  const AttributeSurface surface = surface_of(car);
  for (const SurfaceFace& face : surface.faces) kept += face.surface ? face.surface->byte_size() : 0;
  const double surfaces = memory.used();
  SurfaceTessellationOptions options;
  options.samples = 32;
  const SurfaceTessellation made = tessellate(car, surface, progress, options);
  out << "\nMemory: surfaces of the car " << static_cast<double>(kept) / 1024 << " KiB by their own count, peak "
      << surfaces << " MiB, with " << made.mesh.positions.size() << " vertices " << memory.used() << " MiB.\n"
      << std::endl;
}

}  // namespace

void bench_surface_speed(std::ostream& out) {
  out << std::fixed;
  bench_evaluation(out);
  bench_car(out);
  bench_memory(out);
}

}  // namespace croquis::bench
