// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/improvement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/field.h"
#include "croquis/base/error.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/implicit/point_tree.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t points_per_step = 8192;  // that are projected before fits behind them are forgotten
constexpr double most_drift = 2;         // × cell: no vertex moves so far, and none needs the field farther below
constexpr double least_snap_turn = 0.5;  // cosine: a vertex doesn't snap when that turns a triangle further
constexpr std::size_t most_cut_pairs = 1'000'000;

// Parts of a mesh that are searched for cuts by themselves: each costs a look at every face's box.
constexpr std::size_t faces_per_search = 5000;
constexpr std::size_t most_searches = 16;

/// Rings about faces that intersect that go back, round by round; then everything does.
constexpr std::array undo_rings = {0, 1, 2, 3, 4, 5, 10, 20};

using FacePairs = std::vector<std::array<Index, 2>>;

void as_stored(std::vector<Vec3>& positions, Precision precision) {
  if (precision == Precision::Single) round_to_single(positions);
}

/// Projects points, in parts that can be cancelled, while fits are forgotten behind them. @param fixed per point, or
/// none
/// @return the greatest distance that a point moved
double onto_surface(std::span<Vec3> points, std::span<const std::uint8_t> fixed, const ImprovedField& field,
                    double cell, int threads, Progress progress) {
  std::vector<double> lowest(points.size() / points_per_step + 2, std::numeric_limits<double>::infinity());
  for (std::size_t i = points.size(); i-- > 0;) {  // of all points from each part on
    double& here = lowest[i / points_per_step];
    here = std::min({here, lowest[i / points_per_step + 1], points[i][field.axis]});
  }
  const implicit::Field asked = [&](std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients) {
    if (progress.cancelled()) throw Cancelled();
    field.field(places, values, gradients);
  };
  implicit::ProjectionOptions projection;
  projection.cell = cell;
  projection.threads = threads;
  if (field.forget_below) field.forget_below(std::numeric_limits<double>::infinity());  // those at the other end
  double largest = 0;
  for (std::size_t begin = 0; begin < points.size(); begin += points_per_step) {
    if (field.forget_below) field.forget_below(lowest[begin / points_per_step] - most_drift * cell);
    const std::size_t count = std::min(points_per_step, points.size() - begin);
    const auto marks = fixed.empty() ? fixed : fixed.subspan(begin, count);
    largest = std::max(largest, implicit::project(points.subspan(begin, count), marks, asked, projection).largest_move);
    progress.report(static_cast<double>(begin + count) / static_cast<double>(points.size()));
  }
  return largest;
}

/// Of the triangles' centroids, weighted by area, from the vertex itself for the digits of models far away.
Vec3 centroid_around(std::size_t vertex, const TriangleFans& fans, const std::vector<Vec3>& places) {
  const Vec3& here = places[vertex];
  Vec3 sum = Vec3::Zero();
  double areas = 0;
  for (const Index corner : fans.at(vertex)) {
    const Vec3 b = places[fans.next(corner)] - here, c = places[fans.previous(corner)] - here;
    const double area = b.cross(c).norm();
    sum += area / 3 * (b + c);
    areas += area;
  }
  return areas > 0 ? Vec3(here + sum / areas) : here;
}

/// Rounds of smoothing with projection (Yoo 2005, eq. 9); borders stay.
std::vector<Vec3> smoothed(const PolyMesh& mesh, const ImprovedField& field, const RemeshOptions& options, double cell,
                           Progress progress) {
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  const int rounds = std::max(options.smoothing, 1), threads = options.fill.threads;
  std::vector<std::uint8_t> fixed(mesh.vertex_count());
  std::vector<Vec3> places = mesh.positions;
  for (int round = 0; round < rounds; ++round) {
    Progress smoothing = progress.step("smooth", 0.2 / rounds);
    const std::vector<Vec3> before = places;
    for_each_part(places.size(), vertices_per_part, threads, smoothing, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        fixed[v] = fans.link(v) == TriangleFans::Link::Cycle ? 0 : 1;
        if (fixed[v] == 0 && options.smoothing > 0) places[v] = centroid_around(v, fans, before);
      }
    });
    onto_surface(places, fixed, field, cell, threads,
                 progress.step("project " + std::to_string(places.size()) + " vertices", 0.8 / rounds));
  }
  return places;
}

/// Each point takes the vertex nearest to it among those that have it as their nearest point, unless that turns a
/// triangle.
void snap_to(std::span<const Vec3> points, double distance, PolyMesh& mesh, int threads, Progress progress) {
  const implicit::PointTree tree(points);
  const std::vector<Vec3> before = mesh.positions;
  std::vector<Index> nearest(before.size());
  for_each_part(nearest.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) nearest[v] = tree.nearest(before[v]);
  });
  const auto away = [&](Index v) { return (before[v] - points[nearest[v]]).squaredNorm(); };
  std::vector<Index> taker(points.size(), no_index);
  for (Index v = 0; v < nearest.size(); ++v) {
    Index& best = taker[nearest[v]];
    if (away(v) <= distance * distance && (best == no_index || away(v) < away(best))) best = v;
  }
  for (std::size_t p = 0; p < points.size(); ++p)
    if (taker[p] != no_index) mesh.positions[taker[p]] = points[p];
  const auto is_turned = [&](std::size_t f) {
    const Vec3 was = area_normal(before, mesh.face(f)), is = area_normal(mesh, f);
    return !(is.dot(was) > least_snap_turn * is.norm() * was.norm());
  };
  for (bool settled = false; !settled;) {
    progress.check();
    settled = true;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      if (!is_turned(f)) continue;
      for (const Index v : mesh.face(f)) {
        settled = settled && mesh.positions[v] == before[v];
        mesh.positions[v] = before[v];
      }
    }
  }
}

/// Cuts every triangle in four. @return false when that is enough
bool refine(PolyMesh& mesh, std::size_t& cuts, const ImprovedField& field, const RemeshOptions& options, double cell,
            Progress progress) {
  progress.check();
  PolyMesh coarse = std::move(mesh);
  mesh = implicit::split_in_four(coarse);
  as_stored(mesh.positions, options.fill.precision);
  const std::vector<Vec3> before = mesh.positions;
  const std::span<Vec3> added = std::span(mesh.positions).subspan(coarse.vertex_count());
  const double largest = onto_surface(added, {}, field, cell, options.fill.threads,
                                      progress.step("project " + std::to_string(added.size()) + " vertices", 0.7));
  as_stored(mesh.positions, options.fill.precision);
  const std::size_t left = undo_where_cut(mesh, before, options.fill.threads, progress.step("look for cuts", 0.3));
  if (left > cuts) {  // rounding alone can do that
    mesh = std::move(coarse);
    return false;
  }
  cuts = left;
  return !(largest < options.chord);
}

FacePairs cuts_at(const PolyMesh& mesh, const std::vector<std::uint8_t>& marked, Progress progress) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (std::ranges::any_of(mesh.face(f), [&](Index v) { return marked[v] != 0; })) faces.push_back(f);
  return find_intersections_of(mesh, faces, progress, {.max_pairs = most_cut_pairs}).pairs;
}

/// @param pairs that intersect
std::size_t undo_about(PolyMesh& mesh, const std::vector<Vec3>& before, FacePairs pairs, Progress progress) {
  for (std::size_t round = 0; round <= undo_rings.size() && !pairs.empty(); ++round) {
    const bool is_last = round == undo_rings.size();
    std::vector<std::uint8_t> marked(mesh.vertex_count(), is_last ? 1 : 0);
    for (const auto& pair : pairs) {
      for (const Index f : pair)
        for (const Index v : mesh.face(f)) marked[v] = 1;
    }
    for (int ring = 0; !is_last && ring < undo_rings[round]; ++ring) {
      const std::vector<std::uint8_t> inner = marked;
      for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        if (inner[mesh.corners[c]] == 0) continue;
        for (const Index v : mesh.face(c / 3)) marked[v] = 1;
      }
    }
    for (std::size_t v = 0; v < marked.size(); ++v)
      if (marked[v] != 0) mesh.positions[v] = before[v];
    pairs = cuts_at(mesh, marked, progress.step("look for cuts", 0.1 / static_cast<double>(undo_rings.size() + 1)));
  }
  return pairs.size();
}

}  // namespace

std::size_t improve(PolyMesh& mesh, const ImprovedField& field, std::span<const Vec3> points,
                    const RemeshOptions& options, double cell, Progress progress) {
  const int threads = options.fill.threads;
  const bool is_refined = options.refine > 0;
  as_stored(mesh.positions, options.fill.precision);
  std::vector<Vec3> places = smoothed(mesh, field, options, cell, progress.step("smooth", is_refined ? 0.2 : 0.6));
  std::vector<Vec3> before = std::exchange(mesh.positions, std::move(places));
  if (options.snap > 0) snap_to(points, options.snap * cell, mesh, threads, progress.step("snap", 0.05));
  as_stored(mesh.positions, options.fill.precision);
  std::size_t cuts = undo_where_cut(mesh, before, threads, progress.step("look for cuts", is_refined ? 0.1 : 0.35));
  before = {};
  for (int round = 0; round < options.refine; ++round)
    if (!refine(mesh, cuts, field, options, cell, progress.step("refine", 0.65 / options.refine))) break;
  return cuts;
}

std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, int threads, Progress progress) {
  FacePairs pairs = find_cuts(mesh, threads, progress.step("look for cuts", 0.9));
  return undo_about(mesh, before, std::move(pairs), std::move(progress));
}

std::size_t undo_where_cut(PolyMesh& mesh, const std::vector<Vec3>& before, std::span<const Index> moved,
                           Progress progress) {
  std::vector<std::uint8_t> marked(mesh.vertex_count(), 0);
  for (const Index v : moved) marked[v] = 1;
  FacePairs pairs = cuts_at(mesh, marked, progress.step("look for cuts", 0.9));
  return undo_about(mesh, before, std::move(pairs), std::move(progress));
}

std::vector<std::array<Index, 2>> find_cuts(const PolyMesh& mesh, int threads, Progress progress) {
  const std::size_t count = std::min(mesh.face_count() / faces_per_search, most_searches);
  if (count < 2) return find_self_intersections(mesh, progress, {.max_pairs = most_cut_pairs}).pairs;
  std::vector<FacePairs> found(count);
  for_each_part(count, 1, threads, progress, [&](std::size_t part, std::size_t) {
    const std::size_t begin = part * mesh.face_count() / count, end = (part + 1) * mesh.face_count() / count;
    std::vector<Index> faces(end - begin);
    std::iota(faces.begin(), faces.end(), static_cast<Index>(begin));
    Progress silent = progress.silent();
    found[part] = find_intersections_of(mesh, faces, silent, {.max_pairs = most_cut_pairs}).pairs;
  });
  FacePairs pairs;
  for (const FacePairs& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace croquis::remeshing
