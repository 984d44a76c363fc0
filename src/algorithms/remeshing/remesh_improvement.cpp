// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_improvement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_cuts.h"
#include "algorithms/remeshing/remesh_smoothing.h"
#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/error.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/implicit/point_tree.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t chunk = 65536;                      // vertices between two reports
constexpr std::size_t most_intersecting_pairs = 1000000;  // of intersecting triangles that are looked at in a round

/// Rings about faces that intersect that go back, round by round; then everything does.
constexpr std::array undo_rings = {0, 1, 2, 3, 4, 5, 10, 20};
constexpr double most_vertex_drift = 2;  // × cell: no vertex moves so far
constexpr double least_turn = 0.5;       // cosine: a vertex doesn't snap when that turns a triangle further

class Snapping {
 public:
  Snapping(PolyMesh& mesh, const ImprovementOptions& options) : mesh_(mesh), options_(options) {}

  void run(std::span<const Vec3> points, Progress& progress);

 private:
  bool is_turned(std::size_t face, const std::vector<Vec3>& before) const {
    const auto f = mesh_.face(face);
    const auto normal = [&](const std::vector<Vec3>& p) { return Vec3((p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]])); };
    const Vec3 was = normal(before), is = normal(mesh_.positions);
    return !(is.dot(was) > least_turn * is.norm() * was.norm());
  }

  PolyMesh& mesh_;
  const ImprovementOptions& options_;
};

/// Each point takes the vertex nearest to it among those that have it as their nearest point.
void Snapping::run(std::span<const Vec3> points, Progress& progress) {
  const implicit::PointTree tree(points);
  const std::vector<Vec3> before = mesh_.positions;
  std::vector<Index> nearest(before.size());
  for_each_part(nearest.size(), vertices_per_part, options_.threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) nearest[v] = tree.nearest(before[v]);
  });
  const auto distance = [&](Index v) { return (before[v] - points[nearest[v]]).squaredNorm(); };
  std::vector<Index> taker(points.size(), no_index);
  for (Index v = 0; v < nearest.size(); ++v) {
    Index& best = taker[nearest[v]];
    if (distance(v) <= options_.snap * options_.snap && (best == no_index || distance(v) < distance(best))) best = v;
  }
  for (std::size_t p = 0; p < points.size(); ++p)
    if (taker[p] != no_index) mesh_.positions[taker[p]] = points[p];
  for (bool settled = false; !settled;) {
    progress.check();
    settled = true;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      if (!is_turned(f, before)) continue;
      for (const Index v : mesh_.face(f)) {
        settled = settled && mesh_.positions[v] == before[v];
        mesh_.positions[v] = before[v];
      }
    }
  }
}

/// One ring more around the marked vertices.
void grow(const PolyMesh& mesh, std::vector<std::uint8_t>& marked) {
  const std::vector<std::uint8_t> inner = marked;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    if (inner[mesh.corners[c]] == 0) continue;
    for (const Index v : mesh.face(c / 3)) marked[v] = 1;
  }
}

std::vector<Index> faces_at(const PolyMesh& mesh, const std::vector<std::uint8_t>& marked) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (std::any_of(face.begin(), face.end(), [&](Index v) { return marked[v] != 0; })) faces.push_back(f);
  }
  return faces;
}

void as_stored(std::vector<Vec3>& positions, Precision precision) {
  if (precision == Precision::Single) round_to_single(positions);
}

using FacePairs = std::vector<std::array<Index, 2>>;

FacePairs cuts_at(const PolyMesh& mesh, const std::vector<std::uint8_t>& marked, Progress& progress) {
  return find_intersections_of(mesh, faces_at(mesh, marked), progress, {.max_pairs = most_intersecting_pairs}).pairs;
}

/// @param pairs that intersect
std::size_t undo(PolyMesh& mesh, const std::vector<Vec3>& before, FacePairs pairs, Progress& progress) {
  for (std::size_t round = 0; round <= undo_rings.size() && !pairs.empty(); ++round) {
    const bool is_last = round == undo_rings.size();
    std::vector<std::uint8_t> marked(mesh.vertex_count(), is_last ? 1 : 0);
    for (const auto& pair : pairs) {
      for (const Index f : pair)
        for (const Index v : mesh.face(f)) marked[v] = 1;
    }
    for (int ring = 0; !is_last && ring < undo_rings[round]; ++ring) grow(mesh, marked);
    for (std::size_t v = 0; v < marked.size(); ++v)
      if (marked[v] != 0) mesh.positions[v] = before[v];
    Progress again = progress.step("look for cuts", 0.1 / static_cast<double>(undo_rings.size() + 1));
    pairs = cuts_at(mesh, marked, again);
  }
  return pairs.size();
}

}  // namespace

std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, int threads, Progress& progress) {
  Progress first = progress.step("look for cuts", 0.9);
  return undo(mesh, before, find_cuts(mesh, threads, first), progress);
}

std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, std::span<const Index> moved,
                           Progress& progress) {
  std::vector<std::uint8_t> marked(mesh.vertex_count(), 0);
  for (const Index v : moved) marked[v] = 1;
  Progress first = progress.step("look for cuts", 0.9);
  return undo(mesh, before, cuts_at(mesh, marked, first), progress);
}

double onto_surface(std::span<Vec3> points, std::span<const std::uint8_t> fixed, const ImprovedField& field,
                    const ImprovementOptions& options, Progress& progress) {
  const implicit::Field asked = [&](std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients) {
    if (progress.cancelled()) throw Cancelled();
    field.field(places, values, gradients);
  };
  implicit::ProjectionOptions projection;
  projection.cell = options.cell;
  projection.threads = options.threads;
  double largest = 0;
  for (std::size_t begin = 0; begin < points.size(); begin += chunk) {
    const std::size_t count = std::min(chunk, points.size() - begin);
    const auto marks = fixed.empty() ? fixed : fixed.subspan(begin, count);
    largest = std::max(largest, implicit::project(points.subspan(begin, count), marks, asked, projection).largest_move);
    progress.report(static_cast<double>(begin + count) / static_cast<double>(points.size()));
  }
  return largest;
}

namespace {

/// Points that come along the field's axis, about.
double sweep_onto_surface(std::span<Vec3> points, const ImprovedField& field, const ImprovementOptions& options,
                          Progress& progress) {
  std::vector<double> lowest(points.size() / chunk + 2, std::numeric_limits<double>::infinity());
  for (std::size_t i = points.size(); i-- > 0;) {
    double& here = lowest[i / chunk];
    here = std::min({here, lowest[i / chunk + 1], points[i][field.axis]});
  }
  double largest = 0;
  for (std::size_t begin = 0; begin < points.size(); begin += chunk) {
    const std::size_t count = std::min(chunk, points.size() - begin);
    if (field.forget_below) field.forget_below(lowest[begin / chunk] - most_vertex_drift * options.cell);
    Progress projecting = progress.step("project " + std::to_string(count) + " vertices",
                                        static_cast<double>(count) / static_cast<double>(points.size()));
    largest = std::max(largest, onto_surface(points.subspan(begin, count), {}, field, options, projecting));
  }
  return largest;
}

/// Cuts every triangle in four. @return false when that is enough
bool refine(PolyMesh& mesh, std::size_t& cuts, const ImprovedField& field, const ImprovementOptions& options,
            Progress& progress) {
  const std::size_t known = mesh.vertex_count();
  progress.check();
  PolyMesh coarse = std::move(mesh);
  mesh = implicit::split_in_four(coarse);
  as_stored(mesh.positions, options.precision);
  const std::vector<Vec3> before = mesh.positions;
  Progress projecting = progress.step("project vertices", 0.7);
  const double largest = sweep_onto_surface(std::span(mesh.positions).subspan(known), field, options, projecting);
  as_stored(mesh.positions, options.precision);
  Progress looking = progress.step("look for cuts", 0.3);
  const std::size_t left = undo_where_cut(mesh, before, options.threads, looking);
  if (left > cuts) {  // rounding alone can do that
    mesh = std::move(coarse);
    return false;
  }
  cuts = left;
  return !(largest < options.chord);
}

}  // namespace

std::size_t improve(PolyMesh& mesh, const ImprovedField& field, std::span<const Vec3> points,
                    const ImprovementOptions& options, Progress& progress) {
  as_stored(mesh.positions, options.precision);
  Progress smoothing = progress.step("smooth", options.refine > 0 ? 0.2 : 0.6);
  SweptSmoothing sweep(field, options);
  sweep.run(mesh.positions, mesh.corners, smoothing);
  return improve_smoothed(mesh, sweep.take(), field, points, options, progress);
}

std::size_t improve_smoothed(PolyMesh& mesh, std::vector<Vec3> smooth, const ImprovedField& field,
                             std::span<const Vec3> points, const ImprovementOptions& options, Progress& progress) {
  std::vector<Vec3> before = std::exchange(mesh.positions, std::move(smooth));
  if (options.snap > 0) {
    Progress snapping = progress.step("snap", 0.05);
    Snapping(mesh, options).run(points, snapping);
  }
  as_stored(mesh.positions, options.precision);
  Progress checking = progress.step("look for cuts", options.refine > 0 ? 0.1 : 0.35);
  std::size_t cuts = undo_where_cut(mesh, before, options.threads, checking);
  before = {};
  for (int round = 0; round < options.refine; ++round) {
    Progress refining = progress.step("refine", 0.65 / options.refine);
    if (!refine(mesh, cuts, field, options, refining)) break;
  }
  return cuts;
}

}  // namespace croquis::remeshing
