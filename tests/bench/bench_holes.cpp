// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "algorithms/hole_filling/edge_pairing.h"
#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "croquis/hole_filling/fill_holes.h"
#include "support/mesh_shapes.h"
#include "support/random.h"
#include "support/scans.h"

namespace croquis::bench {
namespace {

using namespace hole_filling;

constexpr int hole_count = 40;

/// A torus of about so many triangles with 40 round holes whose rims have about as many edges whatever the size.
PolyMesh holed_torus(double triangles) {
  const auto sides = static_cast<Index>(std::sqrt(triangles / 4));
  const PolyMesh whole = test::ring_torus(2 * sides, sides);
  const double radius = 12 * std::numbers::pi / sides;
  std::vector<Index> removed;
  for (Index f = 0; f < whole.face_count(); ++f) {
    const Vec3& p = whole.positions[whole.face(f)[0]];
    const double around = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) * hole_count;
    const double off_centre = (around - std::round(around)) * 2 * std::numbers::pi / hole_count * 1.4;
    const double distance = std::hypot(off_centre, p.z());
    if (p.head<2>().norm() > 1 && distance < std::min(radius, 0.08)) removed.push_back(f);
  }
  return test::without_faces(whole, removed);
}

/// The keys whose sorting finds every edge's triangles.
std::vector<std::uint64_t> edge_keys(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<std::uint64_t> keys;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
      keys.push_back((std::uint64_t{low} << 32) | high);
    }
  }
  return keys;
}

/// One row of the table of growth; the exponents are those of time over triangles since the row before.
class GrowthRow {
 public:
  explicit GrowthRow(const PolyMesh& mesh) : faces_(static_cast<double>(mesh.face_count())) {
    const int runs = faces_ > 2e6 ? 1 : 3;
    Progress progress;
    const SurfaceView view = view_surface(mesh, progress);
    const std::vector<std::uint64_t> keys = edge_keys(view.triangles);
    sort_ = median_cpu_ms(runs, [&] {
      auto copy = keys;
      std::sort(copy.begin(), copy.end());
    });
    pairing_ = median_cpu_ms(runs, [&] { pair_edges(view.triangles, mesh.vertex_count(), progress); });
    analysis_ = median_cpu_ms(runs, [&] { holes_ = analyse_holes(mesh, progress).holes.size(); });
    fill_ = median_cpu_ms(runs, [&] { fill_holes(mesh, {}, progress); });
  }

  void print(std::ostream& out, const char* order, const GrowthRow* before) const {
    out << "| " << static_cast<std::size_t>(faces_) << ' ' << order << " | " << holes_ << " | " << pairing_ / sort_
        << " | " << analysis_ * 1e3 / faces_ << " | " << analysis_ << " ms | " << fill_ << " ms | ";
    if (before != nullptr)
      out << exponent(*before, analysis_, before->analysis_) << ", " << exponent(*before, fill_, before->fill_);
    out << " |\n";
  }

 private:
  double exponent(const GrowthRow& before, double time, double time_before) const {
    return std::log(time / time_before) / std::log(faces_ / before.faces_);
  }

  double faces_, sort_ = 0, pairing_ = 0, analysis_ = 0, fill_ = 0;
  std::size_t holes_ = 0;
};

void report_growth(std::ostream& out) {
  out << "| triangles | holes | pairing edges / std::sort of their keys | analysis, s per million | analysis | "
         "smooth fill | exponents |\n|---|---|---|---|---|---|---|\n";
  std::optional<GrowthRow> before;
  for (const double triangles : {7e4, 3.3e5, 1.05e6, 4e6}) {
    const GrowthRow row(holed_torus(triangles));
    row.print(out, "", before ? &*before : nullptr);
    before = row;
  }
  GrowthRow(test::shuffled(holed_torus(1.05e6), 1)).print(out, "in random order", nullptr);
}

/// A plate with one hole of that many edges, its rim wavy in and out of the plane by `waves`.
PolyMesh long_rim(Index edges, double waves) {
  const std::vector<Vec2> profile = {{1.5, 0}, {1.0, 0}};
  PolyMesh mesh = test::revolved(profile, edges);
  test::Random random(1);
  for (Index i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * i / edges;
    Vec3& p = mesh.positions[edges + i];
    p.head<2>() *= 1 + waves * std::cos(17 * angle) + 1e-5 * random.unit();
    p.z() = waves * std::sin(11 * angle);
  }
  return mesh;
}

void report_long_rims(std::ostream& out) {
  out << "\n| rim of 10,000 edges | analysis | flat fill | smooth fill | methods |\n|---|---|---|---|---|\n";
  for (const double waves : {0.0, 0.1}) {
    const PolyMesh mesh = long_rim(10000, waves);
    Progress progress;
    const double analysis = cpu_ms([&] { analyse_holes(mesh, progress); });
    std::string methods;
    const auto fill = [&](Fairness fairness) {
      FillOptions options;
      options.fairness = fairness;
      options.only = {1};
      options.flat_caps = false;
      methods += fill_holes(mesh, options, progress).outcomes[1].method + " ";
    };
    const double flat = cpu_ms([&] { fill(Fairness::Flat); });
    const double smooth = cpu_ms([&] { fill(Fairness::Tangent); });
    out << "| " << (waves > 0 ? "wavy" : "round") << " | " << analysis << " ms | " << flat << " ms | " << smooth
        << " ms | " << methods << " |\n";
  }
}

}  // namespace

void bench_holes(std::ostream& out) {
  out << std::setprecision(3) << "Processor time on one thread.\n\n";
  report_growth(out);
  report_long_rims(out);
}

}  // namespace croquis::bench
