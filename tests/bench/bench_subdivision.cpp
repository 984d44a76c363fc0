// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>
#include <iomanip>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/subdivision_peers.h"
#include "croquis/subdivision/doo_sabin.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis::bench {
namespace {

using subdivision::Cage;
using subdivision::DooSabinPlan;
using subdivision::PositionBuffers;

constexpr int runs = 7;

struct Row {
  std::string name;
  std::function<double()> ms;
  std::vector<double> times;

  double median() {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
  }
};

/// One call of each row in turn, so that a busy moment meets all of them.
void run_interleaved(std::vector<Row>& rows) {
  for (int run = 0; run <= runs; ++run) {
    for (Row& row : rows) {
      const double ms = row.ms();
      if (run > 0) row.times.push_back(ms);
    }
  }
}

DooSabinPlan plan_of(const Cage& cage, int levels) {
  Progress progress;
  return {cage, {}, levels, progress};
}

/// Everything anew into fresh memory, as after a change of the tags. What frees it isn't counted, nor is it for the
/// others.
double from_nothing_ms(const Cage& cage, int levels) {
  std::optional<DooSabinPlan> plan;
  PositionBuffers buffers;
  return cpu_ms([&] {
    plan.emplace(plan_of(cage, levels));
    plan->positions(cage.positions, buffers);
  });
}

PolyMesh with_one_edge_in(PolyMesh mesh, std::uint32_t part) {
  test::Random random(1);
  for (const test::VertexPair& edge : test::all_edges(mesh)) {
    if (random.below(part) == 0) mesh.tags.creases.push_back({edge, infinite_sharpness});
  }
  return mesh;
}

/// What a pass over positions can't avoid: writing all new points, reading the old and the corners between.
std::size_t touched_bytes(const DooSabinPlan& plan) {
  std::size_t bytes = 0;
  for (int k = 1; k <= plan.levels(); ++k) {
    const auto& old = plan.level(k - 1).topology;
    bytes += old.corner_count() * sizeof(Index) +
             (old.vertex_count() + plan.level(k).topology.vertex_count()) * sizeof(Vec3);
  }
  return bytes;
}

double copy_ms(std::vector<char>& from, std::vector<char>& to) {
  return cpu_ms([&] {
    std::memcpy(to.data(), from.data(), from.size());
    from[0] = static_cast<char>(to[from.size() / 2] + 1);
  });
}

void print(std::ostream& out, std::vector<Row>& rows, double reference) {
  out << "| what | ms | times faster than CGAL |\n|---|---|---|\n" << std::fixed;
  for (Row& row : rows) {
    out << "| " << row.name << " | " << std::setprecision(1) << row.median() << " | " << reference / row.median()
        << " |\n";
  }
}

void compare_with_peers(std::ostream& out) {
  constexpr int levels = 3;
  const PolyMesh mesh = test::torus(100, 100), tagged_mesh = with_one_edge_in(mesh, 100);
  const Cage cage = subdivision::make_cage(mesh).cage, tagged = subdivision::make_cage(tagged_mesh).cage;
  const DooSabinPlan plan = plan_of(cage, levels), tagged_plan = plan_of(tagged, levels);
  PositionBuffers buffers, tagged_buffers;
  OpenSubdivPeer opensubdiv(mesh, levels);
  // Half is read, half is written.
  std::vector<char> from(touched_bytes(plan) / 2), to(touched_bytes(plan) / 2);
  std::vector<Row> rows = {
      {"CGAL Doo-Sabin", [&] { return cgal_doo_sabin_ms(mesh, levels); }, {}},
      {"OpenMesh Catmull-Clark", [&] { return openmesh_catmull_clark_ms(mesh, levels); }, {}},
      {"OpenSubdiv Catmull-Clark, topology and positions (float)", [&] { return opensubdiv.refine_ms(); }, {}},
      {"OpenSubdiv, positions (float)", [&] { return opensubdiv.positions_ms(); }, {}},
      {"Croquis, plan and positions", [&] { return from_nothing_ms(cage, levels); }, {}},
      {"Croquis, plan and positions, 1 % of edges sharp", [&] { return from_nothing_ms(tagged, levels); }, {}},
      {"Croquis, positions", [&] { return cpu_ms([&] { plan.positions(cage.positions, buffers); }); }, {}},
      {"Croquis, positions, 1 % sharp",
       [&] { return cpu_ms([&] { tagged_plan.positions(tagged.positions, tagged_buffers); }); },
       {}},
      {"memcpy of the bytes positions touch", [&] { return copy_ms(from, to); }, {}}};
  run_interleaved(rows);
  out << "Torus of 100 x 100 quads to level 3 (" << plan.level(levels).topology.face_count()
      << " faces), one thread, CPU time, medians of " << runs << " interleaved runs.\n\n";
  print(out, rows, rows[0].median());
  out << "\nPositions against memcpy: " << rows[6].median() / rows[8].median()
      << " (1 % sharp: " << rows[7].median() / rows[8].median() << "). Bytes per face of the last level: "
      << static_cast<double>(plan.bytes(levels) + buffers.levels.back().size() * sizeof(Vec3)) /
             static_cast<double>(plan.level(levels).topology.face_count())
      << ".\n";
}

double wall_ms(const std::function<void()>& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
}

void compare_threads(std::ostream& out) {
  const Cage cage = subdivision::make_cage(test::torus(100, 100)).cage;
  const DooSabinPlan plan = plan_of(cage, 4);
  PositionBuffers buffers;
  const auto compute = [&](int threads) { plan.positions(cage.positions, buffers, threads); };
  std::vector<Row> rows;
  for (const int threads : {1, 2}) {
    const std::string name = std::to_string(threads) + (threads == 1 ? " thread" : " threads");
    rows.push_back({name + ", CPU", [&, threads] { return cpu_ms([&] { compute(threads); }); }, {}});
    rows.push_back({name + ", wall", [&, threads] { return wall_ms([&] { compute(threads); }); }, {}});
  }
  run_interleaved(rows);
  out << "\nPositions up to level 4 (2.56 million faces):";
  for (Row& row : rows) out << " " << row.name << " " << row.median() << " ms;";
  out << " CPU of two against one: " << std::setprecision(2) << rows[2].median() / rows[0].median() << ".\n";
}

void time_drags(std::ostream& out) {
  const PolyMesh mesh = with_one_edge_in(test::torus(100, 100), 100);
  Cage cage = subdivision::make_cage(mesh).cage;
  const DooSabinPlan plan = plan_of(cage, 2);
  PositionBuffers buffers;
  std::vector<Row> rows = {{"drag",
                            [&] {
                              cage.positions[17] += Vec3(0.001, 0.002, 0.003);
                              return cpu_ms([&] { plan.positions(cage.positions, buffers); });
                            },
                            {}},
                           {"tags changed", [&] { return from_nothing_ms(cage, 2); }, {}}};
  run_interleaved(rows);
  out << std::setprecision(1) << "\nOne of 10,000 faces' points dragged, level 2 (160,000 faces): " << rows[0].median()
      << " ms; a tag changed: " << rows[1].median() << " ms.\n";
}

void measure_growth(std::ostream& out) {
  out << "\n| faces | make_cage ms per 1000 cage faces | plan ns per face | positions ns per face "
         "|\n|---|---|---|---|\n";
  for (const Index side : {25u, 79u, 250u, 790u}) {
    const PolyMesh mesh = with_one_edge_in(test::torus(side, side), 100);
    Cage cage;
    const double cage_ms = median_cpu_ms(3, [&] { cage = subdivision::make_cage(mesh).cage; });
    const double plan_ms = median_cpu_ms(3, [&] { plan_of(cage, 2); });
    const DooSabinPlan plan = plan_of(cage, 2);
    PositionBuffers buffers;
    const double positions_ms = median_cpu_ms(3, [&] { plan.positions(cage.positions, buffers); });
    const auto faces = static_cast<double>(plan.level(2).topology.face_count());
    out << "| " << std::setprecision(0) << faces << std::setprecision(2) << " | "
        << 1e3 * cage_ms / static_cast<double>(mesh.face_count()) << " | " << 1e6 * plan_ms / faces << " | "
        << 1e6 * positions_ms / faces << " |\n";
  }
}

}  // namespace

void bench_subdivision(std::ostream& out) {
  compare_with_peers(out);
  compare_threads(out);
  time_drags(out);
  measure_growth(out);
}

}  // namespace croquis::bench
