// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/child_process.h"
#include "bench/cpu_time.h"
#include "bench/scans/bench_holes.h"
#include "bench/scans/hole_case.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/io/mesh_file.h"
#include "support/scans/virtual_scans.h"
#include "support/scratch_folder.h"

namespace croquis::bench {
namespace {

constexpr int runs = 3;  // the best counts

HoleCase scan_of(std::size_t triangles, std::size_t holes) {
  test::RaggedCuts cuts;
  cuts.count = holes, cuts.high = 0.05;
  return case_of("beast", test::ragged_cuts(test::sculpt(test::Sculpture::Beast, triangles), cuts));
}

template <typename Run>
std::optional<double> best_of(const Run& run) {
  std::optional<double> best;
  for (int i = 0; i < runs; ++i) {
    const std::optional<double> time = run();
    if (time && (!best || *time < *best)) best = time;
  }
  return best;
}

void print(std::ostream& out, const std::string& what, std::optional<double> ms, std::optional<double> peer,
           const char* target) {
  out << "| " << what << " | ";
  if (ms) {
    out << *ms << " ms | ";
  } else {
    out << "not installed, or failed | ";
  }
  if (ms && peer) out << *ms / *peer;
  out << " | " << target << " |\n";
}

void report_programs(std::ostream& out, const HoleCase& scan) {
  const test::ScratchFolder scratch;
  Progress progress;
  std::ofstream(scratch / "scan.ply", std::ios::binary) << write_mesh(scan.mesh, MeshFormat::Ply, {}, progress).bytes;
  double most_mebibytes = 0;
  const auto croquis = [&](const std::string& fairness) {
    return best_of([&] {
      const auto use =
          use_of({CROQUIS_CLI, "fill", scratch / "scan.ply", "-o", scratch / "out.ply", "--fairness", fairness});
      if (use) most_mebibytes = std::max(most_mebibytes, use->mebibytes);
      return use ? std::optional(use->cpu_ms) : std::nullopt;
    });
  };
  const auto peer = best_of([&] { return meshlab_fill_file(scratch / "scan.ply", scratch / "peer.ply"); });
  out << "| from file to file: " << scan.mesh.face_count() << " triangles, " << scan.removed.size()
      << " holes | processor time | / MeshLab | target |\n|---|---|---|---|\n";
  print(out, "MeshLab, Close Holes", peer, std::nullopt, "");
  print(out, "croquis-cli fill, rbf", croquis("rbf"), peer, "<= 2");
  print(out, "croquis-cli fill, smooth", croquis("smooth"), peer, "<= 2");
  print(out, "croquis-cli fill, flat", croquis("flat"), peer, "");
  const double millions = 1e-6 * static_cast<double>(scan.mesh.face_count());
  out << "\nAt most " << most_mebibytes << " MiB for the whole process (wanted: " << 205 + 150 * millions << ").\n"
      << std::endl;
}

double wall_ms(const HoleCase& scan, int threads) {
  hole_filling::FillOptions options;
  options.threads = threads;
  Progress progress;
  const auto began = std::chrono::steady_clock::now();
  hole_filling::fill_holes(scan.mesh, options, progress);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
}

void report_phases(std::ostream& out, const HoleCase& scan) {
  Progress progress;
  const double cgal = *best_of([&] { return std::optional(cgal_fill(scan.mesh, 1).cpu_ms); });
  const double analysis =
      *best_of([&] { return std::optional(cpu_ms([&] { hole_filling::analyse_holes(scan.mesh, progress); })); });
  const double whole = *best_of([&] { return std::optional(fill(scan.mesh, Method::Implicit)->cpu_ms); });
  out << "| in-process, the same scan | processor time | / CGAL C1 | target |\n|---|---|---|---|\n";
  print(out, "CGAL C1, filling", cgal, std::nullopt, "");
  print(out, "analysis", analysis, std::nullopt, "");
  print(out, "rbf without analysis", whole - analysis, cgal, "<= 2");
  const double one = *best_of([&] { return std::optional(wall_ms(scan, 1)); });
  const double two = *best_of([&] { return std::optional(wall_ms(scan, 2)); });
  double load = 0;
  getloadavg(&load, 1);
  out << "\nBy the clock, one thread " << one << " ms, two threads " << two << " ms: " << one / two
      << " times as fast, at a load of " << load << ".\n";
}

}  // namespace

void report_hole_speed(std::ostream& out) {
  const HoleCase scan = scan_of(300000, 40);
  report_programs(out, scan);
  report_programs(out, scan_of(1400000, 39));
  report_phases(out, scan);
}

}  // namespace croquis::bench
