// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "algorithms/remeshing/memory.h"
#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/peak_memory.h"
#include "croquis/remeshing/remesh.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"

namespace croquis::bench {
namespace {

using namespace hole_filling;
using namespace remeshing;

constexpr double million = 1e6;
constexpr int many_threads = 16;
constexpr int serial_runs = 3;

/// A torus of about so many triangles with eight holes.
PolyMesh holed_torus(double triangles) {
  const auto sides = static_cast<Index>(std::sqrt(triangles / 4));
  PolyMesh mesh = test::ring_torus(2 * sides, sides);
  std::vector<Index> removed;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Vec3& p = mesh.positions[mesh.face(f)[0]];
    const double around = std::atan2(p.y(), p.x()) / (2 * M_PI) * 8;
    if (p.head<2>().norm() > 1 && std::hypot((around - std::round(around)) * 2 * M_PI / 8 * 1.4, p.z()) < 0.1)
      removed.push_back(f);
  }
  return test::without_faces(mesh, removed);
}

double thread_cpu_ms() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Processor time per step of a run with one thread, by what the step's name begins with.
class StepTimes {
 public:
  RemeshResult run(const PolyMesh& mesh) {
    RemeshOptions options;
    options.fill.threads = 1;
    std::clock_t began = std::clock();
    std::string step;
    Progress progress([&](double, const std::string& name) {
      if (name == step) return;
      ms_[group(step)] += 1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
      began = std::clock();
      step = name;
    });
    return remesh_surface(mesh, options, progress);
  }

  double share(const std::string& step) const {
    double sum = 0;
    for (const auto& [name, ms] : ms_) sum += ms;
    return 100 * ms_.at(step) / sum;
  }

 private:
  static std::string group(const std::string& step) {
    const auto begins = [&](const char* with) { return step.rfind(with, 0) == 0; };
    if (begins("fit") || begins("cut space") || begins("order points")) return "fit";
    if (begins("search") || begins("mesh") || begins("vertices") || begins("triangles")) return "cubes";
    if (begins("smooth") || begins("project")) return "improve";
    if (begins("look for cuts")) return "cuts";
    return "other";
  }

  std::map<std::string, double> ms_ = {{"fit", 0}, {"cubes", 0}, {"improve", 0}, {"cuts", 0}, {"other", 0}};
};

/// Share of the work that one thread does alone, %: of so many threads the calling one does that and its part of the
/// rest. The least of a few runs: on a busy machine those that help begin late, and it does more than its part.
double serial_share(const PolyMesh& mesh) {
  RemeshOptions options;
  options.fill.threads = many_threads;
  double least = 100;
  for (int run = 0; run < serial_runs; ++run) {
    Progress progress;
    const double own_before = thread_cpu_ms();
    const double all = cpu_ms([&] { remesh_surface(mesh, options, progress); });
    const double own = thread_cpu_ms() - own_before;
    least = std::min(least, 100 * (many_threads * own - all) / (many_threads - 1) / all);
  }
  return std::max(0.0, least);
}

struct Row {
  double triangles = 0, seconds = 0, patch_seconds = 0, mebibytes = 0, least = 0, predicted = 0, serial = 0;
  std::size_t slabs = 0;
  std::size_t made = 0;
  StepTimes steps;
};

Row row_of(double triangles) {
  const PolyMesh mesh = holed_torus(triangles);
  Row row;
  row.triangles = static_cast<double>(mesh.face_count());
  PeakMemory memory;
  memory.restart();
  row.seconds = 1e-3 * cpu_ms([&] {
                  const RemeshResult result = row.steps.run(mesh);
                  row.made = result.mesh.face_count();
                  row.slabs = result.slabs;
                  row.predicted = static_cast<double>(result.predicted_bytes) / 1048576;
                });
  row.mebibytes = memory.used();
  row.least = static_cast<double>(least_remesh_bytes(mesh, {})) / 1048576;
  Progress progress;
  row.patch_seconds = 1e-3 * cpu_ms([&] { fill_holes(mesh, {}, progress); });
  row.serial = serial_share(mesh);
  return row;
}

}  // namespace

void bench_remesh(std::ostream& out) {
  out << "A torus with eight holes, made anew with the standard options; processor time of one thread, memory beside "
         "the mesh given. Least: what the limit must allow; predicted: with all that may be tried again. Serial: what "
         "one "
         "thread does alone. Peer: filling the same holes by implicit patches.\n\n"
      << "| triangles | made | s per million | exponent | MiB per million | slabs | least, predicted / used | fit, "
         "cubes, improve, "
         "cuts, other % | serial % | time / patches' time |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::vector<double> sizes = {7e4, 3.3e5, 1.05e6};
  if (test::sample_count(0, 1) > 0) sizes.push_back(4e6);
  Row before;
  for (const double size : sizes) {
    const Row row = row_of(size);
    out << std::fixed << "| " << std::setprecision(0) << row.triangles << " | " << row.made << " | "
        << std::setprecision(2) << row.seconds / row.triangles * million << " | ";
    if (before.seconds > 0) out << std::log(row.seconds / before.seconds) / std::log(row.triangles / before.triangles);
    out << " | " << std::setprecision(0) << row.mebibytes / row.triangles * million << " | " << row.slabs << " | "
        << std::setprecision(2) << row.least / row.mebibytes << ", " << row.predicted / row.mebibytes << " |"
        << std::setprecision(0);
    for (const char* step : {"fit", "cubes", "improve", "cuts", "other"}) out << ' ' << row.steps.share(step);
    out << " | " << row.serial << " | " << std::setprecision(1) << row.seconds / row.patch_seconds << " |" << std::endl;
    before = row;
  }
}

}  // namespace croquis::bench
