// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/remeshing/remesh_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/remeshing/remesh_points.h"
#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

// Bytes, measured: see "The whole model anew" in docs/algorithms/hole_filling.md.
constexpr double per_triangle = 75;              // the view and its neighbours
constexpr double per_point = 420;                // fits, trees, normals
constexpr double per_new_triangle = 130;         // cubes, triangles, their improvement and checks
constexpr double fixed_bytes = 32e6;             // of the fits and buffers that are there for any mesh
constexpr double triangles_per_cube_face = 3.3;  // new triangles per area of one cube's face
constexpr std::size_t usual_slab = 50'000;       // points: thinner ones save little more and keep few threads busy
constexpr double gibibyte = 1073741824;
constexpr double most_cell = 64;

/// Triangles, area and mean edge, polygons taken as fans.
struct Extent {
  double triangles = 0, area = 0, edges = 0;
  Eigen::AlignedBox3d box;

  double typical_edge() const {
    return triangles > 0 ? std::min(edges / (3 * triangles), longest_typical_edge * box.diagonal().norm()) : 0;
  }
};

Extent extent_of(const PolyMesh& mesh) {
  Extent extent;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] >= mesh.vertex_count()) return {};  // the analysis will tell
      extent.box.extend(mesh.positions[face[i]]);
    }
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Vec3 b = mesh.positions[face[i - 1]] - mesh.positions[face[0]];
      const Vec3 c = mesh.positions[face[i]] - mesh.positions[face[0]];
      extent.area += 0.5 * b.cross(c).norm();
      extent.edges += b.norm() + c.norm() + (c - b).norm();
      extent.triangles += 1;
    }
  }
  return extent;
}

double without_cells(const PolyMesh& mesh, const Extent& extent) {
  return fixed_bytes + per_triangle * extent.triangles + per_point * static_cast<double>(mesh.vertex_count());
}

/// Of all that grows as cells get smaller.
double of_cells(const Extent& extent, const RemeshOptions& options) {
  const double cell = options.cell * extent.typical_edge();
  if (!(cell > 0)) return 0;
  const double triangles = triangles_per_cube_face * extent.area / (cell * cell) * std::pow(4, options.refine);
  return per_new_triangle * triangles;
}

std::string gibibytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 0.1 * gibibyte ? "%.3f GiB" : "%.1f GiB", bytes / gibibyte);
  return text;
}

std::string advice(const PolyMesh& mesh, const RemeshOptions& options) {
  const Extent extent = extent_of(mesh);
  const double room = static_cast<double>(options.memory_limit) - without_cells(mesh, extent);
  const double cell = room > 0 ? options.cell * std::sqrt(of_cells(extent, options) / room) : most_cell + 1;
  if (!(cell <= most_cell)) return "fill its holes by patches";
  char text[64];
  std::snprintf(text, sizeof text, "choose cells of %.2g times the mean edge", std::ceil(20 * cell) / 20 + 0.05);
  return std::string(text) + ", or fill its holes by patches";
}

Finding out_of_range(const std::string& name, const std::string& range) {
  return make_error(Category::Usage, "E_PARAMETER", "The option " + name + " is out of range: choose " + range + ".",
                    {{SubjectKind::Parameter, name, {}, {}, {}}});
}

}  // namespace

RemeshOptions remesh_preset(Preset preset) {
  RemeshOptions options;
  options.fill.preset = preset;
  if (preset == Preset::Paper) {
    options.fill.implicit.kernel = implicit::Kernel::ThinPlate;
    options.overlap = 0.1;
  }
  if (preset == Preset::Noisy) {
    options.fill.implicit.value_smoothing = 10;
    options.fill.implicit.gradient_smoothing = 30;
  }
  if (preset == Preset::Sharp) {
    options.cell = 0.5;
    options.snap = 0.3;
  }
  return options;
}

void require_options(const RemeshOptions& options) {
  Findings findings;
  const auto require = [&](bool holds, const std::string& name, const std::string& range) {
    if (!holds) findings.push_back(out_of_range(name, range));
  };
  require(options.cell >= 0.05 && options.cell <= most_cell, "cell", "0.05 to 64 mean edges");
  require(options.overlap >= 0 && options.overlap <= 1, "overlap", "0 to 1");
  require(options.min_points >= 1 && options.max_points >= options.min_points && options.max_points <= 2000 &&
              options.leaf_points >= 1,
          "points-per-domain", "at least 1, at most 2000, and no less at most than at least");
  require(options.smoothing >= 0 && options.smoothing <= 100, "smoothing", "0 to 100 rounds");
  require(options.refine >= 0 && options.refine <= 4, "refine", "0 to 4 rounds");
  require(options.chord >= 0, "chord", "0 or a length");
  require(options.snap >= 0 && options.snap <= 0.5, "snap", "0 to 0.5 cells");
  require(options.min_component >= 0 && options.min_component < 1, "min-component", "0 to 1");
  if (!findings.empty()) throw Error(std::move(findings));
}

std::size_t predicted_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options) {
  const Extent extent = extent_of(mesh);
  const double bytes = without_cells(mesh, extent) + of_cells(extent, options);
  return bytes < 1e18 ? static_cast<std::size_t>(bytes) : static_cast<std::size_t>(1e18);
}

SlabPoints slab_points(const RemeshOptions& options) {
  if (options.slab_points > 0) return {options.slab_points, options.slab_points};
  return {usual_slab, std::numeric_limits<std::size_t>::max()};
}

std::size_t require_memory(const PolyMesh& mesh, const RemeshOptions& options) {
  const std::size_t bytes = predicted_remesh_bytes(mesh, options);
  if (options.memory_limit == 0 || bytes <= options.memory_limit) return bytes;
  throw Error(make_error(Category::Limit, "E_MEMORY",
                         "Making this model anew needs about " + gibibytes(static_cast<double>(bytes)) + ", and " +
                             gibibytes(static_cast<double>(options.memory_limit)) +
                             " are allowed: " + advice(mesh, options) + ".",
                         {{SubjectKind::Parameter, "memory-limit", {}, {}, {}}}));
}

}  // namespace croquis::hole_filling
