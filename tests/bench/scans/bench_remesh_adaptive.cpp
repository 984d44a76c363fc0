// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/scans/scan_choice.h"
#include "bench/statistics.h"
#include "croquis/base/error.h"
#include "croquis/remeshing/remesh.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/virtual_scans.h"

namespace croquis::bench {
namespace {

using namespace remeshing;
using test::KnownScan;

constexpr std::array bounds = {0.0, 0.05, 0.1, 0.2, 0.3};  // × cell; the first is what the others are compared with
constexpr std::size_t samples = 50'000;
constexpr double slender = 15;  // degrees

/// Distances × cell, angles in degrees.
struct Figures {
  double faces = 0;      ///< share of the full model's
  double farthest = 0;   ///< of places all over this and the full model to the other one
  double mean = 0;       ///< the same
  double scan_off = 0;   ///< mean distance of the scan's vertices, beside the full model's
  double holes_off = 0;  ///< of the places that are missing, mean over holes, beside the full model's
  double angle = 0;      ///< median of the triangles' least angles
  double slender = 0;    ///< share of triangles with a lesser angle than 15 degrees
  double time = 0;       ///< beside the full model's
};

std::vector<Vec3> places_on(const PolyMesh& mesh) {
  std::vector<Index> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), Index{0});
  return test::sample_faces(mesh, faces, samples);
}

std::vector<double> least_angles(const PolyMesh& mesh) {
  std::vector<double> angles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    double least = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = mesh.positions[face[i]];
      const Vec3 b = (mesh.positions[face[(i + 1) % 3]] - a).normalized();
      const Vec3 c = (mesh.positions[face[(i + 2) % 3]] - a).normalized();
      least = std::min(least, std::acos(std::clamp(b.dot(c), -1.0, 1.0)) * 180 / std::numbers::pi);
    }
    angles.push_back(least);
  }
  return angles;
}

double holes_off(const KnownScan& scan, const test::SurfaceDistance& made) {
  std::vector<double> holes;
  for (const test::KnownHole& hole : scan.holes)
    if (hole.kind != test::HoleKind::Opening) holes.push_back(test::summary_of_distances(hole.places, made).mean);
  return mean(holes);
}

struct Model {
  PolyMesh mesh;
  double ms = 0, cell = 0;
};

Model made_by(const KnownScan& scan, double bound) {
  RemeshOptions options;
  options.fill.threads = 1;
  options.adaptive = bound;
  Progress progress;
  Model model;
  model.ms = cpu_ms([&] {
    RemeshResult result = remesh_surface(scan.mesh, options, progress);
    model.mesh = std::move(result.mesh);
    model.cell = std::min(test::mean_edge_of(scan.mesh), test::diagonal_of(scan.mesh) / 40) * result.coarsening;
  });
  return model;
}

Figures compared(const KnownScan& scan, const Model& full, const Model& model) {
  const test::SurfaceDistance to_full(full.mesh), to_made(model.mesh);
  const auto there = test::summary_of_distances(places_on(model.mesh), to_full);
  const auto back = test::summary_of_distances(places_on(full.mesh), to_made);
  Figures figures;
  figures.faces = static_cast<double>(model.mesh.face_count()) / static_cast<double>(full.mesh.face_count());
  figures.farthest = std::max(there.greatest, back.greatest) / full.cell;
  figures.mean = std::max(there.mean, back.mean) / full.cell;
  figures.scan_off = test::summary_of_distances(scan.mesh.positions, to_made).mean /
                     test::summary_of_distances(scan.mesh.positions, to_full).mean;
  const double holes = holes_off(scan, to_full);
  figures.holes_off = holes > 0 ? holes_off(scan, to_made) / holes : 1;
  const std::vector<double> angles = least_angles(model.mesh);
  figures.angle = median(angles);
  figures.slender = static_cast<double>(std::ranges::count_if(angles, [](double a) { return a < slender; })) /
                    static_cast<double>(angles.size());
  figures.time = model.ms / full.ms;
  return figures;
}

void print(std::ostream& out, const std::string& name, double bound, const std::vector<Figures>& all) {
  const auto values = [&](double Figures::*member) {
    std::vector<double> found;
    for (const Figures& figures : all) found.push_back(figures.*member);
    return found;
  };
  out << "| " << name << " | " << bound << " | " << all.size();
  for (double Figures::*member : {&Figures::faces, &Figures::farthest, &Figures::mean, &Figures::scan_off,
                                  &Figures::holes_off, &Figures::angle, &Figures::slender, &Figures::time})
    out << " | " << median(values(member)) << ", " << quantile(values(member), 0) << " to "
        << quantile(values(member), 1);
  out << " |" << std::endl;
}

}  // namespace

void bench_remesh_adaptive(std::ostream& out, const std::vector<std::string>& words) {
  const ScanChoice choice = scan_choice(words);
  out << std::setprecision(3) << "Known scans of seeds " << choice.first << " to " << choice.first + choice.count - 1
      << " made anew on one thread, with faces merged where the surface is flat, beside the same with none merged. "
         "Medians, least and most.\n\n"
      << "| | bound, cells | models | faces | greatest distance, cells | mean | scan's vertices off | missing places "
         "off | triangles' least angle, median | below 15 degrees | time |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|" << std::endl;
  std::array<std::vector<Figures>, bounds.size()> all;
  for (const test::ScanKind kind : choice.kinds) {
    std::array<std::vector<Figures>, bounds.size()> of_kind;
    for (std::uint64_t seed = choice.first; seed < choice.first + choice.count; ++seed) {
      const KnownScan scan = known_scan(kind, seed);
      try {
        const Model full = made_by(scan, bounds[0]);
        for (std::size_t b = 0; b < bounds.size(); ++b)
          of_kind[b].push_back(compared(scan, full, b == 0 ? full : made_by(scan, bounds[b])));
      } catch (const Error& error) {
        out << "| " << name_of(kind) << ' ' << seed << " | " << error.findings().front().code
            << " | | | | | | | | | |\n";
      }
    }
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      print(out, name_of(kind), bounds[b], of_kind[b]);
      all[b].insert(all[b].end(), of_kind[b].begin(), of_kind[b].end());
    }
  }
  for (std::size_t b = 0; b < bounds.size(); ++b) print(out, "all", bounds[b], all[b]);
}

}  // namespace croquis::bench
