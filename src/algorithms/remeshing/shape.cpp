// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "algorithms/remeshing/field.h"
#include "algorithms/remeshing/improvement.h"
#include "algorithms/remeshing/surface_parts.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/implicit/slab_polygonizer.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Of holes' boxes, × diameter. The first; the others are tried when the one before leaves an opening and something was
// asked about holes: the surface may bulge out of its box.
constexpr std::array growths = {0.35, 0.7, 1.4};

constexpr double field_margin = 0.2;        // around points and holes' boxes, × the longest side; fields reach 0.25
constexpr double cells_per_cube_face = 20;  // per cube face of a sphere around everything
constexpr int farthest_seeds = 2;           // cubes around a point that are looked at, when its own has no surface
constexpr double far_from_data = 1.5;       // × cell or mean edge, whichever is longer: there open surfaces end
constexpr double reach_over_rim = 0.5;      // × cell

constexpr double backed_within = 2;  // × cell or mean edge, whichever is longer: farther from data is invented
constexpr double near_within = 0.5;  // × cell as asked for or mean edge: what is farther off the scan is reported
constexpr double beyond_all = std::numeric_limits<double>::infinity();

constexpr int retries = 2;             // of pieces that come out torn or grown together, each with cells of half size
constexpr double retry_overlap = 0.6;  // domains of thin walls have to see both sides, and much of them
constexpr std::size_t retry_points = 100;

/// A piece to be made, and what is known of it.
struct PieceTask {
  const RemeshModel& model;
  std::size_t number = 0;
  const RemeshPiece& piece;
  std::optional<ExpectedTopology> expected;
  PieceExtent extent;
};

/// How one piece is tried.
struct Trial {
  RemeshOptions options;
  int retry = 0;
  double cell = 0;  ///< model units
  RemeshPoints points;
};

/// As asked for at first; retries have cells of half the size, and fits that reach farther.
Trial trial_of(const PieceTask& task, int retry) {
  const RemeshOptions& asked = task.model.options;
  Trial trial{asked, retry, std::ldexp(task.model.cell, -retry), task.model.points_of(task.piece)};
  if (retry > 0) {
    trial.options.overlap = std::max(asked.overlap, retry_overlap);
    trial.options.min_points = std::max(asked.min_points, retry_points);
    trial.options.max_points = std::max(asked.max_points, retry_points);
  }
  return trial;
}

/// Where the surface of a piece with open rims ends: beyond 1.5 cells from all data, unless in the box of a hole that
/// is filled, and half a cell beyond a rim that stays open or gets a patch.
implicit::Covered ends_of(const PieceTask& task, const Trial& trial, const std::vector<implicit::Box>& holes) {
  std::vector<Vec3> outwards;                                          // per place on such a rim
  std::vector<Index> rim_of(trial.points.positions.size(), no_index);  // of a point, into these
  task.model.pieces.for_each_rim(task.piece, [&](Index own, const RimPlace& rim) {
    if (rim.rule < RimRule::Left) return;
    rim_of[own] = static_cast<Index>(outwards.size());
    outwards.push_back(rim.outwards);
  });
  const double far = far_from_data * std::max(trial.cell, task.model.edge), over = reach_over_rim * trial.cell;
  const auto tree = std::make_shared<const implicit::PointTree>(trial.points.positions, task.model.threads());
  return [&points = trial.points.positions, tree, out = std::move(outwards), rim_at = std::move(rim_of), holes, far,
          over](std::span<const Vec3> places, std::span<std::uint8_t> beyond) {
    const auto is_beyond = [&](const Vec3& place) {
      const Index nearest = tree->nearest(place);
      const Vec3 away = place - points[nearest];
      if (rim_at[nearest] != no_index && away.dot(out[rim_at[nearest]]) > over) return true;
      if (away.squaredNorm() <= far * far) return false;
      return std::ranges::none_of(holes, [&](const implicit::Box& box) { return box.contains(place); });
    };
    for (std::size_t i = 0; i < places.size(); ++i) beyond[i] = is_beyond(places[i]) ? 1 : 0;
  };
}

implicit::PolygonizerOptions cubes_of(const PieceTask& task, const Trial& trial,
                                      const std::vector<implicit::Box>& holes) {
  implicit::PolygonizerOptions cubes;
  cubes.cell = trial.cell;
  cubes.bounds = implicit::bounds(trial.points.positions);
  for (const implicit::Box& box : holes) {
    cubes.bounds.low = cubes.bounds.low.cwiseMin(box.low);
    cubes.bounds.high = cubes.bounds.high.cwiseMax(box.high);
  }
  cubes.origin = cubes.bounds.low;
  const Vec3 margin = Vec3::Constant(std::max(field_margin * cubes.bounds.size().maxCoeff(), 4 * trial.cell));
  cubes.bounds = {cubes.bounds.low - margin, cubes.bounds.high + margin};
  const double faces = std::pow(cubes.bounds.size().maxCoeff() / trial.cell, 2);
  cubes.max_cells = static_cast<std::size_t>(
      std::min(1e6 + cells_per_cube_face * faces + 20.0 * static_cast<double>(trial.points.positions.size()), 5e8));
  cubes.threads = task.model.threads();
  if (task.piece.ends) cubes.covered = ends_of(task, trial, holes);
  return cubes;
}

/// The axis along which points extend most: slabs follow each other along it.
int longest_axis(std::span<const Vec3> points) {
  Eigen::Index axis = 0;
  implicit::bounds(points).size().maxCoeff(&axis);
  return static_cast<int>(axis);
}

/// The zero set of a field, slab by slab: the search goes on from the last layer, or from one slab before it at most.
/// @param slabs is given their number
PolyMesh polygons(const PieceTask& task, const Trial& trial, implicit::PolygonizerOptions cubes,
                  implicit::PartitionOfUnity& field, std::size_t& slabs, Progress progress) {
  const std::vector<Vec3>& points = trial.points.positions;
  const implicit::SlabOptions options{longest_axis(points), task.model.memory.slab_points(trial.retry)};
  implicit::SlabEvents events;
  events.enter = [&](double low, double high, Progress& part) { field.fit_between(options.axis, low, high, part); };
  events.finished = [&](implicit::LayeredMesh& made, Progress&) {
    if (points.size() <= options.seeds_per_slab) return;
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t v = made.first_vertices.back(); v < made.positions.size(); ++v)
      lowest = std::min(lowest, made.positions[v][options.axis]);
    if (std::isfinite(lowest)) field.forget_below(options.axis, lowest - trial.cell);
  };
  events.begun_anew = [] {};
  PolyMesh mesh;
  std::vector<std::uint8_t> beyond;
  for (cubes.seed_reach = 0; cubes.seed_reach <= farthest_seeds && mesh.face_count() == 0; ++cubes.seed_reach) {
    Progress searching = progress.step("polygonize", cubes.seed_reach == 0 ? 0.9 : 0.02);
    implicit::SlabPolygonized found =
        implicit::polygonize_by_slabs(field.field(), points, cubes, options, events, searching);
    slabs = found.slabs;
    mesh.positions = std::move(found.made.positions);
    mesh.corners = std::move(found.made.corners);
    beyond = std::move(found.made.covered);
    set_triangle_offsets(mesh);
  }
  if (task.piece.ends) mesh = trimmed(mesh, beyond);
  drop_detached(mesh, points, task.model.threads(), progress.step("drop detached sheets", 0.04));
  return mesh;
}

/// Fits functions, follows their zero set by cubes, and improves it; of what isn't the last attempt nothing is improved
/// that leaves openings. @param growth of holes' boxes
PieceShape attempt(const PieceTask& task, const Trial& trial, double growth, bool is_last, Progress progress) {
  const RemeshModel& model = task.model;
  const std::vector<Vec3>& points = trial.points.positions;
  PieceShape shape;
  shape.cell = trial.cell;
  Progress fitting = progress.step("fit functions", 0.1);
  std::vector<implicit::ExtraDomain> holes =
      hole_domains(model.mesh, model.analysis, task.piece, model.normals, model.options, growth, fitting);
  std::vector<implicit::Box> boxes;
  for (const implicit::ExtraDomain& hole : holes) boxes.push_back(hole.box);
  implicit::PartitionOfUnity field(points, trial.points.normals, std::move(holes),
                                   domain_options(trial.options, model.edge), fitting);
  shape.mesh =
      polygons(task, trial, cubes_of(task, trial, boxes), field, shape.slabs, progress.step("polygonize", 0.7));
  shape.openings = find_openings(shape.mesh, model.mesh, task.piece, model.pieces, model.options.fill,
                                 progress.step("look for openings", 0.05));
  if (shape.openings.any_of_field() && !is_last) return shape;
  shape.domains = field.report();
  ImprovedField onto{field.projection_field(), longest_axis(points), {}};
  if (shape.slabs > 1) onto.forget_below = [&](double place) { field.forget_below(onto.axis, place); };
  shape.cuts = improve(shape.mesh, onto, points, model.options, trial.cell, progress.step("improve", 0.15));
  return shape;
}

/// Larger boxes seldom help, and cost all of the model's fits and cubes each time: patches close what the field left
/// open, but where something was asked about holes, which they know nothing of. The second time all holes are left.
void leave_open_ones(const PieceTask& task, const Openings& openings, std::vector<Index>& left) {
  const std::vector<Index> holes = openings.holes();
  const auto is_open = [&](const std::vector<Index>& group) {
    return std::ranges::find_first_of(group, holes) != group.end();
  };
  const bool is_known = left.empty() && std::ranges::any_of(task.piece.groups, is_open);
  const auto is_left = [&](const std::vector<Index>& group) { return !is_known || is_open(group); };
  for (const std::vector<Index>& group : task.piece.groups)
    if (is_left(group)) left.insert(left.end(), group.begin(), group.end());
  leave_to_patches(task.model.pieces, task.number, is_left);
}

/// What the scan doesn't back goes, what is a little off it is brought near.
void keep_near(const PieceTask& task, const Trial& trial, UnbackedVertices unbacked, PieceShape& shape,
               Progress& progress) {
  const RemeshModel& model = task.model;
  const auto look_again = [&] {
    unbacked = unbacked_in(model, task.piece, trial.points, shape.mesh, task.piece.caps,
                           progress.step("compare with the scan", 0.3));
  };
  const bool is_cut = unbacked.far_count > 0;
  if (is_cut) {
    shape.mesh = trimmed(shape.mesh, unbacked.is_far);
    look_again();
  }
  const bool is_trimmed = task.piece.ends && trim_loose(shape.mesh, unbacked.loose, model.threads(), progress);
  if (is_trimmed) look_again();
  if (!unbacked.loose.empty())
    bring_near(shape.mesh, unbacked.loose, near_of(model), model.options.fill.precision, progress);
  shape.loose = std::move(unbacked.loose);
  if (is_cut || is_trimmed)
    shape.openings = find_openings(shape.mesh, model.mesh, task.piece, model.pieces, model.options.fill,
                                   progress.step("look for openings", 0.3));
}

/// Nothing closes the holes that are left: what leads over their rims is off the scan.
void look_beside_openings(const PieceTask& task, const Trial& trial, PieceShape& shape, Progress progress) {
  UnbackedVertices unbacked = unbacked_in(task.model, task.piece, trial.points, shape.mesh, shape.openings.holes(),
                                          progress.step("compare with the scan", 0.5));
  if (!unbacked.loose.empty())
    bring_near(shape.mesh, unbacked.loose, near_of(task.model), task.model.options.fill.precision, progress);
  shape.loose = std::move(unbacked.loose);
  for (Index v = 0; unbacked.far_count > 0 && v < unbacked.is_far.size(); ++v)
    if (unbacked.is_far[v] != 0) shape.loose.push_back({v, shape.mesh.positions[v], beyond_all});
}

/// What of the piece is there, in how many parts, and of what extent.
void compare(const PieceTask& task, const Trial& trial, PieceShape& shape, Progress& progress) {
  const RemeshModel& model = task.model;
  shape.lost = lost_points(shape.mesh, trial.points.positions, model.cell, model.threads(),
                           progress.step("look for lost detail", 0.02));
  shape.lost_share = lost_share(model.mesh, model.analysis.view, task.piece, trial.points, shape.lost);
  std::erase_if(shape.lost, [&](Index point) { return point >= task.piece.vertices.size(); });
  shape.topology = topology_of(shape.mesh, model.threads(), progress.step("count parts and handles", 0.01));
  if (model.is_paper()) return;
  const bool is_clear = task.expected && task.expected->is_clear;
  shape.expected = is_clear ? task.expected : expected_topology(model.analysis, task.piece, model.links);
  if (shape.mesh.face_count() == 0) return;
  const PieceExtent made = extent_of_surface(shape.mesh, shape.is_closed());
  shape.volume = made.volume;
  shape.given = task.extent;
  shape.change = change_of(task.extent, made, model.analysis, task.piece, model.cell);
}

/// Where nothing in the mesh backs what came out, holes are left to patches: the field ends at their rims then.
PieceShape make_surface(const PieceTask& task, const Trial& trial, Progress progress) {
  const RemeshModel& model = task.model;
  const bool is_asked = !model.options.fill.requests.empty();
  PieceShape shape;
  std::vector<Index> left;
  for (std::size_t i = 0;; ++i) {
    const bool has_boxes = !task.piece.groups.empty() && !model.is_paper();
    const bool is_last = !has_boxes || (is_asked && i + 1 >= growths.size());
    shape = {};
    shape = attempt(task, trial, growths[is_asked ? std::min(i, growths.size() - 1) : 0], is_last,
                    progress.step("make surface", i == 0 ? 0.9 : 0.02));
    if (!is_last && shape.openings.any_of_field()) {
      if (!is_asked) leave_open_ones(task, shape.openings, left);
      continue;
    }
    Progress looking = progress.step("compare with the scan", 0.02);
    UnbackedVertices unbacked = unbacked_in(model, task.piece, trial.points, shape.mesh, task.piece.caps,
                                            looking.step("compare with the scan", 0.3));
    if (has_boxes && unbacked.far_count > 0) {
      for (const std::vector<Index>& group : task.piece.groups) left.insert(left.end(), group.begin(), group.end());
      leave_to_patches(model.pieces, task.number, [](const std::vector<Index>&) { return true; });
      continue;
    }
    keep_near(task, trial, std::move(unbacked), shape, looking);
    break;
  }
  shape.left_to_patches = std::move(left);
  if (!shape.openings.loops.empty())
    shape.patched = close_by_patches(shape.mesh, shape.openings, model.options.fill,
                                     progress.step("close openings by patches", 0.02));
  if (!shape.openings.loops.empty())
    look_beside_openings(task, trial, shape, progress.step("compare with the scan", 0.01));
  compare(task, trial, shape, progress);
  return shape;
}

/// A wide hole of one rim about which nothing was asked. Its domain would have a say as far as other holes, where it
/// knows nothing; patches follow its own surroundings alone.
bool is_wide_alone(const RemeshModel& model, const std::vector<Index>& group) {
  const auto is_named = [&](const HoleRequest& request) {
    return std::ranges::find(request.holes, group.front()) != request.holes.end();
  };
  return !model.is_paper() && group.size() == 1 && is_wide(model.analysis, group.front()) &&
         std::ranges::none_of(model.options.fill.requests, is_named);
}

}  // namespace

PieceShape make_shape(const RemeshModel& model, std::size_t number, Progress progress) {
  PieceTask task{model, number, model.pieces.pieces[number], {}, {}};
  if (!model.is_paper()) {
    task.expected = expected_topology(model.analysis, task.piece, model.links);
    task.extent = extent_of_scan(model.mesh, model.analysis, task.piece);
    if (!task.expected || !task.expected->is_clear) task.extent.volume.reset();
  }
  leave_to_patches(model.pieces, number, [&](const std::vector<Index>& group) { return is_wide_alone(model, group); });
  PieceShape best = make_surface(task, trial_of(task, 0), progress.step("make surface", 0.9));
  bool retried = false;
  for (int retry = 1; retry <= retries; ++retry) {
    if (best.torn() == 0 && are_few(best.lost.size(), task.piece.vertices.size())) break;
    if (!model.memory.may_halve(model.share_of(task.piece), retry)) break;
    retried = true;
    PieceShape other =
        make_surface(task, trial_of(task, retry), progress.step("make surface with smaller cells", 0.08 / retries));
    if (other.left_to_patches.empty()) other.left_to_patches = best.left_to_patches;
    if (std::pair(other.torn(), other.lost.size()) >= std::pair(best.torn(), best.lost.size())) break;
    best = std::move(other);
  }
  best.retried = retried;
  return best;
}

double near_of(const RemeshModel& model) { return near_within * std::max(model.options.cell, 1.0) * model.edge; }

UnbackedVertices unbacked_in(const RemeshModel& model, const RemeshPiece& piece, const RemeshPoints& points,
                             const PolyMesh& surface, std::span<const Index> open, Progress progress) {
  const NearestScan given(model.mesh, model.analysis.view, model.fans, piece, points, model.threads());
  const HoleReach holes(model.mesh, model.analysis, piece, model.pieces, model.options.fill.requests, model.edge, open);
  return find_unbacked(surface, given, holes, near_of(model), backed_within * std::max(model.cell, model.edge),
                       std::move(progress));
}

}  // namespace croquis::remeshing
