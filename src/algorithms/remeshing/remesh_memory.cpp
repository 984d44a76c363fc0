// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_points.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Bytes, measured: see "Remeshing the whole model" in docs/algorithms/hole_filling.md.
constexpr double per_triangle = 80;       // the view and its neighbours
constexpr double per_point = 180;         // points, trees, domains
constexpr double per_point_fit = 200;     // what is there for slabs under way: fits,
constexpr double per_made_cubes = 60;     // lattice, and vertices that are smoothed
constexpr double per_made = 90;           // a new triangle, while it is improved and checked
constexpr double per_joined = 40;         // a new triangle in the joined mesh
constexpr double per_united = 260;        // the same as part of a solid: tree, sides, and the triangles made of it
constexpr double per_merged = 220;        // the same while flat faces are merged: sides, edges, trees, what is left
constexpr double per_given = 130;         // a triangle given meanwhile: a tree of them
constexpr double fixed_bytes = 64e6;      // of hole boxes' fits and buffers that are there for any mesh
constexpr double bytes_per_thread = 6e6;  // of fits under way
constexpr double slabs_at_a_time = 2.5;   // the one searched, the one before, and what is smoothed behind them
constexpr double retry_fits = 3;          // domains of retries have that many more points
constexpr double triangles_per_cube_face = 3.3;  // new triangles per area of one cube's face
constexpr double usual_slab = 50'000;            // thinner ones save little more and keep few threads busy
constexpr double thinnest_slab = 2'000;          // less than what is held beside it, for all but small meshes
constexpr double retry_bytes = 1.5e9;            // for what may be tried, when no limit is given
constexpr int cell_halvings = 2;
constexpr double most_growth = 8;         // × the triangles given, unless smaller cells are asked for
constexpr double small_result = 100'000;  // triangles that any model may have

/// Triangles, area and edges, polygons taken as fans.
struct PieceExtent {
  double triangles = 0, area = 0, edges = 0;
  Eigen::AlignedBox3d box;

  double typical_edge() const {
    return triangles > 0 ? std::min(edges / (3 * triangles), longest_typical_edge * box.diagonal().norm()) : 0;
  }
};

template <typename Visit>
bool for_each_triangle(const PolyMesh& mesh, Visit&& visit) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const Index v : face)
      if (v >= mesh.vertex_count()) return false;
    for (std::size_t i = 2; i < face.size(); ++i)
      visit(mesh.positions[face[0]], mesh.positions[face[i - 1]], mesh.positions[face[i]]);
  }
  return true;
}

PieceExtent extent_of(const PolyMesh& mesh) {
  PieceExtent extent;
  const bool is_sound = for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& p : {a, b, c}) extent.box.extend(p);
    extent.area += 0.5 * (b - a).cross(c - a).norm();
    extent.edges += (b - a).norm() + (c - a).norm() + (c - b).norm();
    extent.triangles += 1;
  });
  return is_sound ? extent : PieceExtent();  // else the analysis reports it
}

double most_faces(double triangles) { return std::max(most_growth * triangles, small_result); }

/// What cells of one edge must be larger by: where triangles are of many sizes their mean edge is that of the small.
double coarsening_of(const PieceExtent& extent, double edge) {
  if (!(edge > 0)) return 1;
  const double faces = triangles_per_cube_face * extent.area / (edge * edge);
  return std::sqrt(std::max(faces / most_faces(extent.triangles), 1.0));
}

/// Points that large triangles get in their middle, at most.
double samples(const PolyMesh& mesh, double edge) {
  double count = 0;
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const double around = (b - a).norm() + (c - a).norm() + (c - b).norm();
    const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
    if (longest <= longest_edge * edge) return;
    const double spacing = sample_spacing * edge;
    count += 0.5 * (b - a).cross(c - a).norm() / (spacing * spacing) + 1.5 * around / spacing;
  });
  return count;
}

}  // namespace

RemeshMemory::RemeshMemory(const PolyMesh& mesh, const RemeshOptions& options) : options_(options) {
  const PieceExtent extent = extent_of(mesh);
  const double edge = extent.typical_edge();
  coarsening_ = coarsening_of(extent, edge);
  const double cell = options.cell * edge * coarsening_;
  triangles_ = extent.triangles;
  vertices_ = static_cast<double>(mesh.vertex_count());
  if (!(cell > 0)) return;
  points_ = vertices_ + samples(mesh, edge);
  made_ = triangles_per_cube_face * extent.area / (cell * cell) * std::pow(4, options.refine);
}

/// All that is under way.
double RemeshMemory::held() const {
  const int threads =
      options_.fill.threads > 0 ? options_.fill.threads : static_cast<int>(std::thread::hardware_concurrency());
  return fixed_bytes + bytes_per_thread * std::max(threads, 1) + per_triangle * triangles_;
}

/// Share of the model that slabs under way hold.
double RemeshMemory::under_way(double slab_points) const {
  return points_ > 0 ? std::min(slabs_at_a_time * slab_points / points_, 1.0) : 0;
}

double RemeshMemory::making(double slab_points) const {
  return held() + per_point * points_ + per_made * made_ +
         under_way(slab_points) * (per_point_fit * points_ + per_made_cubes * made_);
}

double RemeshMemory::least() const {
  return std::max(making(options_.slab_points > 0 ? static_cast<double>(options_.slab_points) : thinnest_slab),
                  merging());
}

double RemeshMemory::halving(double share, int times) const {
  const double finer = std::pow(4, times), slabs = under_way(usual_slab / std::max(share, 1e-9));
  const double each = options_.adaptive > 0 ? std::max(per_made, per_joined + per_merged) : per_made;
  return share * ((finer * each - per_made + per_joined) * made_ +
                  slabs * ((retry_fits - 1) * per_point_fit * points_ + (finer - 1) * per_made_cubes * made_));
}

double RemeshMemory::uniting(double share) const { return held() + (2 * per_joined + share * per_united) * made_; }

/// While flat faces are merged, if they are.
double RemeshMemory::merging() const {
  if (!(options_.adaptive > 0)) return 0;
  return held() + per_given * triangles_ + per_point * points_ + (per_joined + per_merged) * made_;
}

double RemeshMemory::most() const {
  double tried = std::max(making(std::numeric_limits<double>::infinity()), merging());
  if (options_.fill.preset != Preset::Paper)
    tried = std::max(tried, uniting(1)) + std::min(halving(1, cell_halvings), retry_bytes);
  if (options_.memory_limit == 0) return tried;
  return std::clamp(static_cast<double>(options_.memory_limit), least(), std::max(least(), tried));
}

bool RemeshMemory::may_halve(double share, int times) const {
  if (options_.fill.preset == Preset::Paper) return false;
  if (share * std::pow(4, times) * made_ > most_faces(share * triangles_)) return false;
  const double more = halving(share, times);
  return options_.memory_limit == 0
             ? more <= retry_bytes
             : making(static_cast<double>(slabs().open)) + more <= static_cast<double>(options_.memory_limit);
}

bool RemeshMemory::may_unite(double share) const {
  return options_.memory_limit == 0 || uniting(share) <= static_cast<double>(options_.memory_limit);
}

SlabPoints RemeshMemory::slabs() const {
  constexpr auto all = std::numeric_limits<std::size_t>::max();
  if (options_.slab_points > 0) return {options_.slab_points, options_.slab_points};
  const auto limit = static_cast<double>(options_.memory_limit);
  double points = usual_slab;
  while (limit > 0 && points > thinnest_slab && making(points) > limit) points = std::max(points / 2, thinnest_slab);
  const auto thin = static_cast<std::size_t>(points);
  return {thin, limit == 0 || making(std::numeric_limits<double>::infinity()) <= limit ? all : thin};
}

double RemeshMemory::fitting_cell() const {
  const double of_cells =  // at most
      std::max(per_made + per_made_cubes, options_.adaptive > 0 ? per_joined + per_merged : 0) * made_;
  const double room = static_cast<double>(options_.memory_limit) - (least() - of_cells);
  return room > of_cells / (most_cell * most_cell) ? options_.cell * std::sqrt(of_cells / room) : most_cell + 1;
}

}  // namespace croquis::remeshing
