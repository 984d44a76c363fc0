// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <malloc.h>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "bench/cpu_time.h"
#include "bench/peak_memory.h"
#include "bench/scans/bench_holes.h"
#include "croquis/hole_filling/fill_holes.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

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

/// One size of the table of growth.
struct GrowthRow {
  double faces = 0;
  std::size_t holes = 0;
  double sort = 0, pairing = 0, analysis = 0, smooth = 0, implicit = 0;  // ms, the fills without analysis
  double peak = 0;  // MiB of an implicit fill, with mesh and result
};

GrowthRow growth_row(const std::function<PolyMesh()>& make) {
  PeakMemory memory;
  const PolyMesh mesh = make();
  Progress progress;
  GrowthRow row;
  row.faces = static_cast<double>(mesh.face_count());
  FillOptions options;
  memory.restart();
  fill_holes(mesh, options, progress);
  row.peak = memory.used();
  const int runs = row.faces > 2e6 ? 1 : 3;
  row.analysis = median_cpu_ms(runs, [&] { row.holes = analyse_holes(mesh, progress).holes.size(); });
  row.implicit = median_cpu_ms(runs, [&] { fill_holes(mesh, options, progress); }) - row.analysis;
  options.fairness = Fairness::Tangent;
  row.smooth = median_cpu_ms(runs, [&] { fill_holes(mesh, options, progress); }) - row.analysis;
  const SurfaceView view = view_surface(mesh, progress);
  const std::vector<std::uint64_t> keys = edge_keys(view.triangles);
  row.sort = median_cpu_ms(runs, [&] {
    auto copy = keys;
    std::sort(copy.begin(), copy.end());
  });
  row.pairing = median_cpu_ms(runs, [&] { pair_edges(view.triangles, mesh.vertex_count(), progress); });
  return row;
}

void print(std::ostream& out, const GrowthRow& row, const char* order) {
  const double millions = row.faces / 1e6;
  out << "| " << static_cast<std::size_t>(row.faces) << order << " | " << row.holes << " | " << row.pairing / row.sort
      << " | " << row.analysis << " ms | " << row.smooth << " ms | " << row.implicit << " ms | " << row.peak
      << " MiB | " << row.peak / (0.2 * 1024 + 150 * millions) << " |\n";
}

/// The slope of log time over log triangles, by least squares.
double exponent(const std::vector<GrowthRow>& rows, double GrowthRow::*time) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const GrowthRow& row : rows) {
    const double size = std::log(row.faces), value = std::log(row.*time);
    x += size, y += value, xx += size * size, xy += size * value;
  }
  const auto n = static_cast<double>(rows.size());
  return (n * xy - x * y) / (n * xx - x * x);
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

}  // namespace

void report_hole_growth(std::ostream& out) {
  // As croquis-cli does: else small meshes get their memory from the heap and large ones page by page from the system.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  out << "| triangles | holes | pairing edges / std::sort of their keys (<= 1.5) | analysis | smooth fill | rbf fill | "
         "peak of it | / (0.2 GiB + 150 MiB per million) (<= 1) |\n|---|---|---|---|---|---|---|---|\n";
  std::vector<GrowthRow> rows;
  for (const double triangles : {7e4, 3.3e5, 1.05e6, 4e6}) {
    rows.push_back(growth_row([&] { return holed_torus(triangles); }));
    print(out, rows.back(), "");
  }
  print(out, growth_row([] { return test::shuffled(holed_torus(1.05e6), 1); }), " in random order");
  out << "\nTime grows like triangles to the power (<= 1.1) of " << exponent(rows, &GrowthRow::pairing)
      << " for pairing, " << exponent(rows, &GrowthRow::analysis) << " for analysis, "
      << exponent(rows, &GrowthRow::smooth) << " for smooth and " << exponent(rows, &GrowthRow::implicit)
      << " for rbf fills.\n";
}

void report_long_rims(std::ostream& out) {
  out << "| rim of 10,000 edges (each < 5 s) | analysis | flat fill | smooth fill | rbf fill | methods |\n"
         "|---|---|---|---|---|---|\n";
  for (const double waves : {0.0, 0.1}) {
    const PolyMesh mesh = long_rim(10000, waves);
    Progress progress;
    out << "| " << (waves > 0 ? "wavy" : "round") << " | " << cpu_ms([&] { analyse_holes(mesh, progress); }) << " ms";
    std::string methods;
    for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
      FillOptions options;
      options.fairness = fairness;
      options.only = {1};
      options.flat_caps = false;
      out << " | " << cpu_ms([&] { methods += fill_holes(mesh, options, progress).outcomes[1].method + " "; }) << " ms";
    }
    out << " | " << methods << "|\n";
  }
}

}  // namespace croquis::bench
