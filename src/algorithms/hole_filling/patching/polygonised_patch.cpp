// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/continuation/rim_frame.h"
#include "algorithms/hole_filling/patching/covering.h"
#include "algorithms/hole_filling/patching/implicit_patch.h"
#include "algorithms/hole_filling/patching/open_sheet.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/patching/rim_loops.h"
#include "algorithms/hole_filling/patching/rim_zip.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "algorithms/hole_filling/patching/untangling.h"
#include "croquis/implicit/marching_cubes.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::hole_filling {
namespace {

using Triangle = std::array<Index, 3>;

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
constexpr std::size_t least_rim = 11;  // edges; there is no room for cubes in smaller holes

/// A box around rims and places, in the rims' frame: a patch that leaves it is given up.
implicit::Box box_around(const HoleSite& site, const RimFrame& frame, double size) {
  std::vector<Vec3> places = site.polygon.points;
  places.insert(places.end(), site.wish.through.begin(), site.wish.through.end());
  implicit::Box box = implicit::bounds(frame.into(places));
  box.low -= Vec3::Constant(size);
  box.high += Vec3::Constant(size);
  return box;
}

class PolygonisedPatch {
 public:
  PolygonisedPatch(const HoleSite& site, const ImplicitOptions& options, std::size_t most_triangles)
      : site_(site), options_(options), most_triangles_(most_triangles), frame_(site) {
    for (const Index id : site.holes) area_ += site.analysis->holes[id].area;
    size_ = widest_diameter(site);
    edge_ = mean_rim_edge(site);
    area_ = std::max(area_, edge_ * rim_length(site));  // of slits and of bands between rims
    box_ = box_around(site, frame_, size_);
  }

  std::optional<HolePatch> run(bool careful, Progress& progress) {
    const Covering covering(site_, frame_.around(box_), progress);
    const double wall = covering.wall(farthest_wall * edge_);
    const double few_enough =
        std::sqrt(triangles_per_square_cell * area_ / static_cast<double>(std::max<std::size_t>(1, most_triangles_)));
    const double widest = std::max({std::min(edge_, wall_share * wall), least_cell * edge_, few_enough});
    const RimFitOptions clear_of_others = {.stiffness = calmer, .other_sheets = true};
    if (careful) return on_field(covering, clear_of_others, widest, progress);
    auto patch = on_field(covering, {.every_normal = true}, widest, progress);
    const bool is_thin = wall < farthest_wall * edge_;
    if (patch || !(is_thin || continues_curvature(site_, options_))) return patch;
    return on_field(covering, clear_of_others, widest, progress);
  }

 private:
  std::optional<HolePatch> on_field(const Covering& covering, const RimFitOptions& how, double widest,
                                    Progress& progress) {
    progress.check();
    const auto surface = fitted_once(site_, options_, how);
    if (!surface) return std::nullopt;
    field_ = surface->field();
    int runaways = 0;
    std::size_t taken = 0, expected = 0;
    for (const double share : finer) {
      progress.check();
      if (taken + expected > most_cubes || (runaways > 0 && expected > most_after_runaway)) return std::nullopt;
      const std::size_t left = taken == 0 ? std::numeric_limits<std::size_t>::max() : most_cubes - taken;
      const implicit::Polygonized cubes = continued(covering, share * widest, left, progress);
      taken += cubes.cells;
      expected = growth_when_finer * cubes.cells;
      if (!cubes.complete()) {
        const int most = crosses_strip(share * widest) ? most_runaways + 1 : most_runaways;
        if (++runaways == most) return std::nullopt;
        continue;
      }
      const auto start = zipped(cubes, share * widest, progress);
      if (!start) continue;
      if (!start->arrives_at.empty()) return start;
      auto patch = lay_onto(site_, *surface, *start, most_triangles_, progress);
      if (patch) untangle(site_, *patch, progress);
      return patch;
    }
    return std::nullopt;
  }

  /// Whether only a strip of surface lies between the site's rims and another one, so that cubes of this size may have
  /// stepped over it and gone on where nothing is.
  bool crosses_strip(double cell) const {
    const std::vector<Vec3>& positions = site_.mesh->positions;
    const double widest_strip = crossed_strip * cell;
    return std::ranges::any_of(site_.analysis->holes, [&](const Hole& other) {
      if (std::ranges::binary_search(site_.holes, other.id)) return false;
      return std::ranges::any_of(site_.polygon.points, [&](const Vec3& place) {
        return (place - other.centre).norm() <= other.diameter + widest_strip &&
               std::ranges::any_of(other.vertices,
                                   [&](Index v) { return (positions[v] - place).norm() <= widest_strip; });
      });
    });
  }

  /// The continuation beside the hole, joined to the rims.
  std::optional<HolePatch> zipped(const implicit::Polygonized& cubes, double cell, Progress& progress) const {
    const auto matched = match_loops(site_, open_sheet(cubes.mesh, cubes.covered), cell, progress);
    if (!matched) return std::nullopt;
    if (matched->arrives_at.empty()) return joined(*matched, progress);
    HolePatch arrival{site_.holes, {}, {}};
    arrival.arrives_at = matched->arrives_at;
    return arrival;
  }

  /// The zero set of the field as far as it isn't covered, where it closes.
  implicit::Polygonized continued(const Covering& covering, double cell, std::size_t most, Progress& progress) const {
    implicit::PolygonizerOptions options;
    options.cell = cell;
    options.origin = box_.low;
    options.bounds = box_;
    options.only_complete = true;
    options.max_cells = std::min(most, static_cast<std::size_t>(most_cells * area_ / (cell * cell)) + 1);
    options.covered = [&](std::span<const Vec3> places, std::span<std::uint8_t> covered) {
      covering.mark(field_, cell, frame_.out_of(places), covered);
    };
    options.threads = 1;
    Progress silent = progress.step("polygonise", 0);
    implicit::Polygonized cubes = implicit::polygonize(frame_.seen(field_), frame_.into(seeds(cell)), options, silent);
    cubes.mesh.positions = frame_.out_of(cubes.mesh.positions);
    return cubes;
  }

  std::vector<Vec3> seeds(double cell) const {
    const SurfaceView& view = site_.analysis->view;
    const std::vector<Vec3>& positions = site_.mesh->positions;
    std::vector<Vec3> places;
    for (const Index id : site_.holes) {
      for (const Index corner : site_.analysis->holes[id].corners) {
        const auto& [a, b, c] = view.triangles[corner / 3];
        const Vec3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
        const Vec3 &from = positions[view.origin(corner)], &to = positions[view.target(corner)];
        places.push_back(0.5 * (from + to) + seed_distance * cell * (to - from).cross(normal).normalized());
      }
    }
    std::erase_if(places, [](const Vec3& place) { return !place.allFinite(); });
    implicit::ProjectionOptions projection;
    projection.cell = cell;
    projection.threads = 1;
    implicit::project(places, {}, field_, projection);
    return places;
  }

  std::optional<HolePatch> joined(const MatchedSheet& matched, Progress& progress) const {
    const auto given = static_cast<Index>(site_.mesh->vertex_count());
    HolePatch patch{site_.holes, matched.sheet.positions, {}};
    const auto add = [&](Index a, Index b, Index c) { patch.triangles.push_back({a, b, c}); };
    for (std::size_t f = 0; f < matched.sheet.face_count(); ++f) {
      const auto face = matched.sheet.face(f);
      add(given + face[0], given + face[1], given + face[2]);
    }
    Index begin = 0;
    for (std::size_t i = 0; i < matched.loops.size(); ++i) {
      const Index end = site_.polygon.loop_ends[i];
      const std::vector<Index>& loop = matched.loops[i];
      const auto strip = zip(sides_between(begin, end, matched.sheet, loop), progress);
      if (!strip) return std::nullopt;
      const auto number = [&](Index v) {
        return v < end - begin ? site_.vertices[begin + v] : given + loop[v - (end - begin)];
      };
      for (const auto& [a, b, c] : *strip) add(number(a), number(b), number(c));
      begin = end;
    }
    return patch;
  }

  ZipSides sides_between(Index begin, Index end, const PolyMesh& sheet, const std::vector<Index>& loop) const {
    ZipSides sides;
    sides.left.assign(site_.polygon.points.begin() + begin, site_.polygon.points.begin() + end);
    for (const Index v : loop) sides.right.push_back(sheet.positions[v]);
    sides.left_normals = normals_at(sides.left);
    sides.right_normals = normals_at(sides.right);
    return sides;
  }

  std::vector<Vec3> normals_at(const std::vector<Vec3>& places) const {
    std::vector<double> values(places.size());
    std::vector<Vec3> normals(places.size());
    field_(places, values, normals);
    for (Vec3& normal : normals) normal.normalize();
    return normals;
  }

  const HoleSite& site_;
  const ImplicitOptions& options_;
  std::size_t most_triangles_;
  double edge_ = 0, size_ = 0, area_ = 0;
  RimFrame frame_;
  implicit::Box box_;  // in the frame
  implicit::Field field_;
};

class PolygonisedPatcher : public Patcher {
 public:
  PolygonisedPatcher(const ImplicitOptions& options, std::size_t most_triangles, bool careful)
      : options_(options), most_triangles_(most_triangles), careful_(careful) {}

  const char* method() const override { return careful_ ? "implicit-cubes-careful" : "implicit-cubes"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    if (site.vertices.size() < least_rim) return std::nullopt;
    return PolygonisedPatch(site, options_, most_triangles_).run(careful_, progress);
  }

 private:
  ImplicitOptions options_;
  std::size_t most_triangles_;
  bool careful_;
};

}  // namespace

std::shared_ptr<const Patcher> polygonised_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                                   bool careful) {
  return std::make_shared<PolygonisedPatcher>(options, most_triangles, careful);
}

}  // namespace croquis::hole_filling
