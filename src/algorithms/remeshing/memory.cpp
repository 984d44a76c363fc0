// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <Eigen/Geometry>

#include "algorithms/remeshing/field.h"
#include "croquis/base/error.h"
#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Bytes, measured: see "Remeshing the whole model" in docs/algorithms/hole_filling.md.
constexpr double per_triangle = 80;       // the view and its neighbours
constexpr double per_point = 180;         // points, trees, domains
constexpr double per_point_fit = 200;     // fits, while slabs are under way
constexpr double per_made_cubes = 60;     // the lattice, while slabs are under way
constexpr double per_made = 90;           // a new triangle, while it is improved and checked
constexpr double per_joined = 40;         // a new triangle in the joined mesh
constexpr double per_united = 260;        // the same as part of a solid: tree, sides, and the triangles made of it
constexpr double per_merged = 220;        // the same while flat faces are merged: sides, edges, trees, what is left
constexpr double per_given = 130;         // a triangle given meanwhile: a tree of them
constexpr double fixed_bytes = 64e6;      // of hole boxes' fits and buffers that are there for any mesh
constexpr double bytes_per_thread = 6e6;  // of fits under way

constexpr double slabs_at_a_time = 2.5;          // the one searched, the one before, and what is left of a third one
constexpr double retry_fits = 3;                 // domains of retries have that many more points
constexpr double triangles_per_cube_face = 3.3;  // new triangles per area of one cube's face
constexpr double usual_slab = 50'000;            // thinner ones save little more and keep few threads busy
constexpr double thinnest_slab = 2'000;          // less than what is held beside it, for all but small meshes
constexpr double retry_bytes = 1.5e9;            // for what may be tried, when no limit is given
constexpr int cell_halvings = 2;
constexpr double most_growth = 8;         // × the triangles given, unless smaller cells are asked for
constexpr double small_result = 100'000;  // triangles that any model may have
constexpr double most_cell = 64;          // mean edges, that may be asked for
constexpr double gibibyte = 1073741824;

/// Triangles, area and edges, polygons taken as fans.
struct MeshFigures {
  double triangles = 0, area = 0, edges = 0;
  Eigen::AlignedBox3d box;
};

/// @return false where faces have vertices that the mesh hasn't, which the analysis reports
template <typename Visit>
bool for_each_triangle(const PolyMesh& mesh, const Visit& visit) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const Index v : face)
      if (v >= mesh.vertex_count()) return false;
    for (std::size_t i = 2; i < face.size(); ++i)
      visit(mesh.positions[face[0]], mesh.positions[face[i - 1]], mesh.positions[face[i]]);
  }
  return true;
}

MeshFigures figures_of(const PolyMesh& mesh) {
  MeshFigures figures;
  const bool is_sound = for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& p : {a, b, c}) figures.box.extend(p);
    figures.area += 0.5 * (b - a).cross(c - a).norm();
    figures.edges += (b - a).norm() + (c - a).norm() + (c - b).norm();
    figures.triangles += 1;
  });
  return is_sound ? figures : MeshFigures();
}

double most_faces(double triangles) { return std::max(most_growth * triangles, small_result); }

/// Points that large triangles get in their middle, at most: see points_of.
double most_samples(const PolyMesh& mesh, double edge) {
  double count = 0;
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const double around = (b - a).norm() + (c - a).norm() + (c - b).norm();
    if (std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()}) <= longest_edge * edge) return;
    const double spacing = sample_spacing * edge;
    count += 0.5 * (b - a).cross(c - a).norm() / (spacing * spacing) + 1.5 * around / spacing;
  });
  return count;
}

std::string gibibytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 0.1 * gibibyte ? "%.3f GiB" : "%.1f GiB", bytes / gibibyte);
  return text;
}

}  // namespace

RemeshMemory::RemeshMemory(const PolyMesh& mesh, const RemeshOptions& options)
    : options_(options), limit_(static_cast<double>(options.memory_limit)) {
  const MeshFigures figures = figures_of(mesh);
  triangles_ = figures.triangles;
  if (!(triangles_ > 0)) return;
  const double edge = std::min(figures.edges / (3 * triangles_), longest_typical_edge * figures.box.diagonal().norm());
  if (!(edge > 0)) return;
  // Where triangles are of many sizes their mean edge is that of the small ones.
  const double faces = triangles_per_cube_face * figures.area / (edge * edge);
  coarsening_ = std::sqrt(std::max(faces / most_faces(triangles_), 1.0));
  const double cell = options.cell * edge * coarsening_;
  points_ = static_cast<double>(mesh.vertex_count()) + most_samples(mesh, edge);
  if (cell > 0) made_ = triangles_per_cube_face * figures.area / (cell * cell) * std::pow(4, options.refine);
}

/// All the time.
double RemeshMemory::held() const {
  return fixed_bytes + bytes_per_thread * static_cast<double>(thread_count(options_.fill.threads)) +
         per_triangle * triangles_;
}

/// Share of the model that slabs under way hold.
double RemeshMemory::under_way(double slab_points) const {
  return points_ > 0 ? std::min(slabs_at_a_time * slab_points / points_, 1.0) : 0;
}

/// Without anything that has to be repaired. @param slab_points of a slab; more than there are: in one slab
double RemeshMemory::making(double slab_points) const {
  return held() + per_point * points_ + per_made * made_ +
         under_way(slab_points) * (per_point_fit * points_ + per_made_cubes * made_);
}

/// What cells of half the size, so many times, take more for a share of the model.
double RemeshMemory::halving(double share, int times) const {
  const double finer = std::pow(4, times), slabs = under_way(usual_slab / std::max(share, 1e-9));
  const double each = options_.adaptive > 0 ? std::max(per_made, per_joined + per_merged) : per_made;
  return share * ((finer * each - per_made + per_joined) * made_ +
                  slabs * ((retry_fits - 1) * per_point_fit * points_ + (finer - 1) * per_made_cubes * made_));
}

/// While a share of the model is made as one solid.
double RemeshMemory::uniting(double share) const { return held() + (2 * per_joined + share * per_united) * made_; }

/// While flat faces are merged, if they are.
double RemeshMemory::merging() const {
  if (!(options_.adaptive > 0)) return 0;
  return held() + per_given * triangles_ + per_point * points_ + (per_joined + per_merged) * made_;
}

double RemeshMemory::least() const {
  return std::max(making(options_.slab_points > 0 ? static_cast<double>(options_.slab_points) : thinnest_slab),
                  merging());
}

double RemeshMemory::most() const {
  double tried = std::max(making(std::numeric_limits<double>::infinity()), merging());
  if (options_.fill.preset != Preset::Paper)
    tried = std::max(tried, uniting(1)) + std::min(halving(1, cell_halvings), retry_bytes);
  return limit_ > 0 ? std::clamp(limit_, least(), std::max(least(), tried)) : tried;
}

bool RemeshMemory::may_halve(double share, int times) const {
  if (options_.fill.preset == Preset::Paper) return false;
  if (share * std::pow(4, times) * made_ > most_faces(share * triangles_)) return false;
  const double more = halving(share, times);
  return limit_ > 0 ? making(static_cast<double>(slab_points(0))) + more <= limit_ : more <= retry_bytes;
}

bool RemeshMemory::may_unite(double share) const { return !(limit_ > 0) || uniting(share) <= limit_; }

std::size_t RemeshMemory::slab_points(int retry) const {
  if (options_.slab_points > 0) return options_.slab_points;
  const bool fits_at_once = !(limit_ > 0) || making(std::numeric_limits<double>::infinity()) <= limit_;
  if (retry == 0 && fits_at_once) return std::numeric_limits<std::size_t>::max();
  double points = usual_slab;
  while (limit_ > 0 && points > thinnest_slab && making(points) > limit_) points = std::max(points / 2, thinnest_slab);
  return static_cast<std::size_t>(points);
}

/// The cell, × mean edge, with which the model fits the limit; more than the largest when none is large enough.
double RemeshMemory::fitting_cell() const {
  const double of_cells =  // at most
      std::max(per_made + per_made_cubes, options_.adaptive > 0 ? per_joined + per_merged : 0) * made_;
  const double left = limit_ - (least() - of_cells);
  return left > of_cells / (most_cell * most_cell) ? options_.cell * std::sqrt(of_cells / left) : most_cell + 1;
}

void RemeshMemory::require_limit() const {
  if (!(limit_ > 0) || least() <= limit_) return;
  std::string advice;
  if (const double cell = fitting_cell(); cell <= most_cell) {
    char text[64];
    std::snprintf(text, sizeof text, "choose cells of %.2g times the mean edge, or ", std::ceil(20 * cell) / 20 + 0.05);
    advice = text;
  }
  throw Error(make_error(Category::Limit, "E_MEMORY",
                         "Remeshing this model needs about " + gibibytes(least()) + ", and " + gibibytes(limit_) +
                             " are allowed: " + advice + "fill its holes by patches.",
                         {{SubjectKind::Parameter, "memory-limit", {}, {}, {}}}));
}

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
    if (holds) return;
    findings.push_back(make_error(Category::Usage, "E_PARAMETER",
                                  "The option " + name + " is out of range: choose " + range + ".",
                                  {{SubjectKind::Parameter, name, {}, {}, {}}}));
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
  require(options.adaptive >= 0 && options.adaptive <= 1, "adaptive", "0 to 1 cells");
  require(options.min_component >= 0 && options.min_component < 1, "min-component", "0 to 1");
  if (!findings.empty()) throw Error(std::move(findings));
}

std::size_t whole_bytes(double bytes) { return static_cast<std::size_t>(std::min(std::ceil(bytes), 1e18)); }

std::size_t predicted_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options) {
  return whole_bytes(RemeshMemory(mesh, options).most());
}

std::size_t least_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options) {
  return whole_bytes(RemeshMemory(mesh, options).least());
}

}  // namespace croquis::remeshing
