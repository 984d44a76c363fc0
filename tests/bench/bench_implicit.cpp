// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <vector>

#include <Eigen/LU>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "croquis/implicit/local_fit.h"
#include "croquis/implicit/marching_cubes.h"
#include "croquis/implicit/partition_of_unity.h"
#include "implicit/fit_system.h"
#include "implicit/sample_points.h"

namespace croquis::bench {
namespace {

using namespace croquis::implicit;
using namespace croquis::test;

/// Seconds by the clock, for what several threads do; the best of two.
template <typename Work>
double wall_seconds(Work&& work) {
  double best = 1e300;
  for (int run = 0; run < 2; ++run) {
    const auto began = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }
  return best;
}

/// Assembling and solving the same system by LU with partial pivoting.
double lu_ms(const Constraints& points, const FitOptions& options) {
  return median_cpu_ms(5, [&] {
    const FitSystem system = assemble(unit_centres(points, options), options);
    const Eigen::Index n = system.a.rows();
    Eigen::MatrixXd whole(n + 4, n + 4);
    whole << system.a, system.q, system.q.transpose(), Eigen::MatrixXd::Zero(4, 4);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 4);
    right.head(n) = system.h;
    const Eigen::VectorXd solved = Eigen::PartialPivLU<Eigen::MatrixXd>(whole).solve(right);
    if (!solved.allFinite()) std::abort();
  });
}

void bench_fits(std::ostream& out) {
  out << "Peer: the same matrix by Eigen's PartialPivLU. Evaluation on one thread, per point.\n\n"
      << "| centres | unknowns | fit ms | LU ms | LU / fit | fits per s | value ns | with gradient ns |\n"
      << "|---|---|---|---|---|---|---|---|\n";
  const std::vector<Vec3> places = random_points(4000, 1);
  std::vector<double> values(places.size());
  std::vector<Vec3> gradients(places.size());
  const double points = static_cast<double>(places.size());
  for (const std::size_t count : {30U, 60U, 120U, 250U}) {
    const Constraints data = sphere_points(count, Vec3::Zero(), 1);
    const FitOptions options;
    const double own = median_cpu_ms(9, [&] { LocalFit(data, options); });
    const double lu = lu_ms(data, options);
    const LocalFit fit(data, options);
    const double value = median_cpu_ms(5, [&] { fit.evaluate(places, values); });
    const double steep = median_cpu_ms(5, [&] { fit.evaluate(places, values, gradients); });
    out << "| " << count << " | " << fit.report().unknowns << " | " << std::fixed << std::setprecision(2) << own
        << " | " << lu << " | " << lu / own << " | " << std::setprecision(0) << 1e3 / own << " | "
        << value * 1e6 / points << " | " << steep * 1e6 / points << " |" << std::endl;
  }
}

void bench_cubes(std::ostream& out) {
  out << "\nCubes along a sphere (a field that costs next to nothing), processor time of one thread.\n\n"
      << "| cell | cubes | evaluations per cube | bytes per cube | cubes per s | wall clock of 1 thread / 2 threads |\n"
      << "|---|---|---|---|---|---|\n";
  const Field sphere = [](std::span<const Vec3> points, std::span<double> values, std::span<Vec3>) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i].squaredNorm() - 1;
  };
  for (const double cell : {0.04, 0.02, 0.01, 0.005}) {
    PolygonizerOptions options;
    options.cell = cell;
    options.bounds = {Vec3::Constant(-2), Vec3::Constant(2)};
    Polygonized surface;
    const auto run = [&](int threads) {
      options.threads = threads;
      Progress progress;
      surface = polygonize(sphere, std::vector{Vec3(1, 0, 0)}, options, progress);
    };
    const double cpu = median_cpu_ms(3, [&] { run(1); });
    const double one = wall_seconds([&] { run(1); });
    const double two = wall_seconds([&] { run(2); });
    const auto cells = static_cast<double>(surface.cells);
    out << "| " << std::fixed << std::setprecision(3) << cell << " | " << surface.cells << " | " << std::setprecision(2)
        << static_cast<double>(surface.evaluations) / cells << " | " << std::setprecision(0)
        << static_cast<double>(surface.bytes) / cells << " | " << 1e3 * cells / cpu << " | " << std::setprecision(2)
        << one / two << " |" << std::endl;
  }
}

/// Fit and surface of one run, with the processor time of each in seconds.
struct FieldRun {
  DomainReport domains;
  std::size_t triangles = 0;
  double fit = 0;
  double cubes = 0;
};

FieldRun run_field(const Constraints& data, int threads) {
  FieldRun run;
  DomainOptions options;
  options.threads = threads;
  Progress progress;
  const std::clock_t began = std::clock();
  const PartitionOfUnity field(data.positions, data.gradients, {}, options, progress);
  const std::clock_t fitted = std::clock();
  PolygonizerOptions cubes;
  cubes.cell = std::sqrt(4 * M_PI * M_PI * 0.4 / static_cast<double>(data.size()));
  cubes.bounds = {Vec3::Constant(-2), Vec3::Constant(2)};
  cubes.seed_reach = 0;
  cubes.threads = threads;
  run.triangles = polygonize(field.field(), data.positions, cubes, progress).mesh.face_count();
  run.domains = field.report();
  run.fit = static_cast<double>(fitted - began) / CLOCKS_PER_SEC;
  run.cubes = static_cast<double>(std::clock() - fitted) / CLOCKS_PER_SEC;
  return run;
}

void bench_fields(std::ostream& out) {
  out << "\nA torus from points and normals: blended Hermite fits, then cubes of one spacing seeded at every point; "
         "processor time.\n\n"
      << "| points | domains | fitted, with fillers | median centres | fit s | points per s | cubes s | triangles per "
         "s | "
         "bytes per point | wall clock of 1 thread / 2 threads |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const std::size_t count : {5000U, 20000U, 80000U, 320000U}) {
    const Constraints data = torus_points(count, 1, 0.4);
    FieldRun run;
    const double one = wall_seconds([&] { run = run_field(data, 1); });
    const double two = wall_seconds([&] { run_field(data, 2); });
    out << "| " << count << " | " << run.domains.data_domains << " | " << run.domains.fitted << " | "
        << run.domains.median_centres << " | " << std::fixed << std::setprecision(2) << run.fit << " | "
        << std::setprecision(0) << static_cast<double>(count) / run.fit << " | " << std::setprecision(2) << run.cubes
        << " | " << std::setprecision(0) << static_cast<double>(run.triangles) / run.cubes << " | "
        << run.domains.bytes / count << " | " << std::setprecision(2) << one / two << " |" << std::endl;
  }
}

}  // namespace

void bench_implicit(std::ostream& out) {
  bench_fits(out);
  bench_cubes(out);
  bench_fields(out);
}

}  // namespace croquis::bench
