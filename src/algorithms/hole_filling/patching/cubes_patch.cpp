// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "algorithms/hole_filling/patching/sheet_loops.h"
#include "croquis/implicit/marching_cubes.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::hole_filling {
namespace {

constexpr double seed_distance = 0.9;  // beyond the rim, × cell: the first that isn't covered
constexpr double most_cells = 40;      // × area to be expected / cell²
constexpr double triangles_per_square_cell = 3.2;
constexpr double wall_share = 0.4;                 // the greatest cell between two skins, × their distance
constexpr double farthest_wall = 3;                // × edge: beyond, two skins don't affect each other
constexpr double least_cell = 0.2;                 // × edge
constexpr double finer[] = {1, 0.5, 0.25};         // cells that are tried, × the first
constexpr int most_runaways = 2;                   // of a field: where the second does, too, it doesn't close
constexpr double crossed_strip = 2;                // × cell: what cubes may step over
constexpr std::size_t most_cubes = 64000;          // for all tries on one field together, but the first
constexpr std::size_t most_after_runaway = 20000;  // of the try after one that ran away, which mostly does so again
constexpr std::size_t growth_when_finer = 4;       // of the number of cubes
constexpr double calmer = 3;           // factor of the smoothing, by r³, between skins and where r⁵ runs away
constexpr std::size_t least_rim = 11;  // edges; cubes don't fit into smaller holes
constexpr double least_rim_area =
    1e-3;  // × squared size of the rims, of what they go round: else it shows no direction

/// A frame that turns with a site's rims, so that a lattice in it gives the same patch however the mesh lies in space:
/// z along the sum of the areas that the rims go round, x towards the vertex farthest from their middle beside that.
struct RimFrame {
  Vec3 middle = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows

  std::vector<Vec3> into(std::span<const Vec3> places) const {
    std::vector<Vec3> turned;
    for (const Vec3& place : places) turned.emplace_back(axes * (place - middle));
    return turned;
  }

  std::vector<Vec3> out_of(std::span<const Vec3> places) const {
    std::vector<Vec3> turned;
    for (const Vec3& place : places) turned.emplace_back(middle + axes.transpose() * place);
    return turned;
  }
};

/// Of the points, without the part along an axis the longest way from the middle; the first of equals.
Vec3 farthest_aside(const std::vector<Vec3>& points, const Vec3& middle, const Vec3& axis) {
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& point : points) {
    const Vec3 away = point - middle, aside = away - away.dot(axis) * axis;
    if (aside.squaredNorm() > (1 + 1e-9) * farthest.squaredNorm()) farthest = aside;
  }
  return farthest;
}

RimFrame frame_of(const HoleSite& site) {
  const std::vector<Vec3>& points = site.polygon.points;
  RimFrame frame;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point - points.front();
  frame.middle = points.front() + sum / static_cast<double>(points.size());
  Vec3 area = Vec3::Zero();
  double size = 0;
  for (Index i = 0; i < points.size(); ++i) {
    area += 0.5 * (points[i] - frame.middle).cross(points[site.polygon.next(i)] - frame.middle);
    size = std::max(size, (points[i] - frame.middle).squaredNorm());
  }
  if (!(area.norm() > least_rim_area * size)) area = farthest_aside(points, frame.middle, Vec3::Zero());
  if (!(area.norm() > 0)) return frame;
  const Vec3 z = area.normalized();
  const Vec3 aside = farthest_aside(points, frame.middle, z);
  const Vec3 x = aside.norm() > 0 ? Vec3(aside.normalized()) : Vec3(z.unitOrthogonal());
  frame.axes << x.transpose(), z.cross(x).transpose(), z.transpose();
  return frame;
}

/// A box around rims and places, in the rims' frame: a patch that leaves it is given up.
implicit::Box box_around(const HoleSite& site, const RimFrame& frame) {
  std::vector<Vec3> places = site.polygon.points;
  places.insert(places.end(), site.settings.through.begin(), site.settings.through.end());
  implicit::Box box = implicit::bounds(frame.into(places));
  const Vec3 size = Vec3::Constant(widest_diameter(site));
  return {box.low - size, box.high + size};
}

/// A box of the frame lies in this one.
implicit::Box box_out_of(const RimFrame& frame, const implicit::Box& box) {
  std::vector<Vec3> corners;
  for (const double x : {box.low.x(), box.high.x()})
    for (const double y : {box.low.y(), box.high.y()})
      for (const double z : {box.low.z(), box.high.z()}) corners.emplace_back(x, y, z);
  return implicit::bounds(frame.out_of(corners));
}

/// What all tries for a site have in common.
struct CubeSite {
  const HoleSite& site;
  RimFrame frame = frame_of(site);
  implicit::Box box = box_around(site, frame);  ///< in the frame
  Covering covering;
  double edge = mean_rim_edge(site);
  double area = 0;  ///< to be expected

  CubeSite(const HoleSite& where, const Progress& progress)
      : site(where), covering(where, box_out_of(frame, box), progress) {
    for (const Index id : site.holes) area += site.analysis->holes[id].area;
    area = std::max(area, edge * rim_length(site));  // of slits and of bands between rims
  }
};

/// Places beyond the rims, on the field's zero set.
std::vector<Vec3> seeds(const HoleSite& site, const implicit::Field& field, double cell) {
  const SurfaceView& view = site.analysis->view;
  const std::vector<Vec3>& positions = site.mesh->positions;
  std::vector<Vec3> places;
  for (const Index id : site.holes) {
    for (const Index corner : site.analysis->holes[id].corners) {
      const Vec3 normal = triangle_normal(site, corner / 3);
      const Vec3 &from = positions[view.origin(corner)], &to = positions[view.target(corner)];
      places.push_back(0.5 * (from + to) + seed_distance * cell * (to - from).cross(normal).normalized());
    }
  }
  std::erase_if(places, [](const Vec3& place) { return !place.allFinite(); });
  implicit::ProjectionOptions projection;
  projection.cell = cell;
  projection.threads = 1;
  implicit::project(places, {}, field, projection);
  return places;
}

/// The zero set of the field as far as it isn't covered, where it closes.
implicit::Polygonized continued(const CubeSite& at, const implicit::Field& field, double cell, std::size_t most,
                                Progress& progress) {
  const RimFrame& frame = at.frame;
  implicit::PolygonizerOptions options;
  options.cell = cell;
  options.origin = at.box.low;
  options.bounds = at.box;
  options.only_complete = true;
  options.max_cells = std::min(most, static_cast<std::size_t>(most_cells * at.area / (cell * cell)) + 1);
  options.covered = [&](std::span<const Vec3> places, std::span<std::uint8_t> covered) {
    at.covering.mark(field, cell, frame.out_of(places), covered);
  };
  options.threads = 1;
  const implicit::Field turned = [&](std::span<const Vec3> places, std::span<double> values,
                                     std::span<Vec3> gradients) {
    field(frame.out_of(places), values, gradients);
    for (Vec3& gradient : gradients) gradient = frame.axes * gradient;
  };
  Progress silent = progress.step("polygonise", 0);
  implicit::Polygonized cubes = implicit::polygonize(turned, frame.into(seeds(at.site, field, cell)), options, silent);
  cubes.mesh.positions = frame.out_of(cubes.mesh.positions);
  return cubes;
}

/// Whether only a strip of surface lies between the site's rims and another one, so that cubes of this size may have
/// stepped over it and gone on where nothing is.
bool crosses_strip(const HoleSite& site, double cell) {
  const std::vector<Vec3>& positions = site.mesh->positions;
  const double widest_strip = crossed_strip * cell;
  return std::ranges::any_of(site.analysis->holes, [&](const Hole& other) {
    if (std::ranges::binary_search(site.holes, other.id)) return false;
    return std::ranges::any_of(site.polygon.points, [&](const Vec3& place) {
      return (place - other.centre).norm() <= other.diameter + widest_strip &&
             std::ranges::any_of(other.vertices,
                                 [&](Index v) { return (positions[v] - place).norm() <= widest_strip; });
    });
  });
}

std::vector<Vec3> normals_at(const implicit::Field& field, const std::vector<Vec3>& places) {
  std::vector<double> values(places.size());
  std::vector<Vec3> normals(places.size());
  field(places, values, normals);
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

/// The sheet with a strip from each of its borders to the rim that it belongs to.
std::optional<HolePatch> joined_to_rims(const HoleSite& site, const implicit::Field& field, const MatchedSheet& matched,
                                        Progress& progress) {
  const auto given = static_cast<Index>(site.mesh->vertex_count());
  HolePatch patch{site.holes, matched.sheet.positions, {}};
  for (std::size_t f = 0; f < matched.sheet.face_count(); ++f) {
    const auto face = matched.sheet.face(f);
    patch.triangles.push_back({given + face[0], given + face[1], given + face[2]});
  }
  Index begin = 0;
  for (std::size_t i = 0; i < matched.loops.size(); ++i) {
    const Index end = site.polygon.loop_ends[i];
    const std::vector<Index>& loop = matched.loops[i];
    ZipSides sides;
    sides.left.assign(site.polygon.points.begin() + begin, site.polygon.points.begin() + end);
    for (const Index v : loop) sides.right.push_back(matched.sheet.positions[v]);
    sides.left_normals = normals_at(field, sides.left);
    sides.right_normals = normals_at(field, sides.right);
    const auto strip = zip(sides, progress);
    if (!strip) return std::nullopt;
    const auto number = [&](Index v) {
      return v < end - begin ? site.vertices[begin + v] : given + loop[v - (end - begin)];
    };
    for (const auto& [a, b, c] : *strip) patch.triangles.push_back({number(a), number(b), number(c)});
    begin = end;
  }
  return patch;
}

/// The continuation beside the hole, joined to the rims; or only the further rims that it arrives at.
std::optional<HolePatch> start_of(const HoleSite& site, const implicit::Field& field,
                                  const implicit::Polygonized& cubes, double cell, Progress& progress) {
  const auto matched = match_loops(site, open_sheet(cubes.mesh, cubes.covered), cell, progress);
  if (!matched) return std::nullopt;
  if (matched->arrives_at.empty()) return joined_to_rims(site, field, *matched, progress);
  HolePatch arrival{site.holes, {}, {}};
  arrival.arrives_at = matched->arrives_at;
  return arrival;
}

/// On one fit, with finer and finer cubes.
std::optional<HolePatch> on_field(const CubeSite& at, const RimFitOptions& how, double widest, Progress& progress) {
  progress.check();
  const auto surface = fitted_once(at.site, how);
  if (!surface) return std::nullopt;
  const implicit::Field field = surface->field();
  int runaways = 0;
  std::size_t taken = 0, expected = 0;
  for (const double share : finer) {
    progress.check();
    if (taken + expected > most_cubes || (runaways > 0 && expected > most_after_runaway)) return std::nullopt;
    const std::size_t left = taken == 0 ? std::numeric_limits<std::size_t>::max() : most_cubes - taken;
    const implicit::Polygonized cubes = continued(at, field, share * widest, left, progress);
    taken += cubes.cells;
    expected = growth_when_finer * cubes.cells;
    if (!cubes.complete()) {
      const int most = crosses_strip(at.site, share * widest) ? most_runaways + 1 : most_runaways;
      if (++runaways == most) return std::nullopt;
      continue;
    }
    const auto start = start_of(at.site, field, cubes, share * widest, progress);
    if (!start) continue;
    if (!start->arrives_at.empty()) return start;
    auto patch = lay_onto(at.site, *surface, *start, most_rounds, progress);
    if (patch) untangle(at.site, *patch, progress);
    return patch;
  }
  return std::nullopt;
}

}  // namespace

/// Needs no triangulation of the rims, so several, huge or crooked rims make no difference.
std::optional<HolePatch> cubes_patch(const HoleSite& site, bool careful, Progress& progress) {
  if (site.vertices.size() < least_rim) return std::nullopt;
  const CubeSite at(site, progress);
  const double wall = at.covering.wall(farthest_wall * at.edge);
  const double most = static_cast<double>(std::max<std::size_t>(1, site.most_triangles));
  const double few_enough = std::sqrt(triangles_per_square_cell * at.area / most);
  const double widest = std::max({std::min(at.edge, wall_share * wall), least_cell * at.edge, few_enough});
  const RimFitOptions clear_of_others = {.stiffness = calmer, .other_sheets = true};
  if (careful) return on_field(at, clear_of_others, widest, progress);
  auto patch = on_field(at, {.every_normal = true}, widest, progress);
  const bool is_thin = wall < farthest_wall * at.edge;
  if (patch || !(is_thin || continues_curvature(site))) return patch;
  return on_field(at, clear_of_others, widest, progress);
}

}  // namespace croquis::hole_filling
