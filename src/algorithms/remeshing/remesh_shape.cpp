// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/remeshing/remesh_backing.h"
#include "algorithms/remeshing/remesh_field.h"
#include "algorithms/remeshing/remesh_smoothing.h"
#include "algorithms/remeshing/remesh_trimming.h"
#include "croquis/hole_filling/wide_holes.h"
#include "croquis/implicit/slab_polygonizer.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Around a hole, × its diameter. The first; the others are tried when the one before leaves an opening and something
// was asked about holes: the surface may bulge out of its box.
constexpr std::array growths = {0.35, 0.7, 1.4};

constexpr double room = 0.2;                // around points and holes' boxes, × the longest side; fields reach 0.25
constexpr double cells_per_cube_face = 20;  // per cube face of a sphere around everything
constexpr int farthest_seeds = 2;           // cubes around a point that are looked at, when its own has no surface
constexpr double lost_beyond = 1.25;  // × cell: a surface has vertices at less than one cell of any of its points

constexpr double backed_within = 2;  // × cell or mean edge, whichever is longer: farther from data is invented
constexpr double near_within = 0.5;  // × cell as asked for or mean edge: what is farther off the scan is told
constexpr double beyond_all = std::numeric_limits<double>::infinity();
constexpr double runs_away_beyond = 0.4;  // × diagonal: no continuation of a surface leads so far out of its box
constexpr int retries = 2;             // of pieces that come out torn or grown together, each with cells of half size
constexpr double retry_overlap = 0.6;  // domains of thin walls have to see both sides, and much of them
constexpr std::size_t retry_points = 100;
constexpr double few_lost = 0.001;  // of the points of a piece: not worth four times the triangles

/// How one piece is tried.
struct Trial {
  RemeshOptions options;
  double cell = 0;  ///< model units
  RemeshPoints points;
};

/// What cubes give of a piece.
struct Cubes {
  PolyMesh mesh;
  std::vector<std::uint8_t> covered;  ///< per vertex, or none
  std::vector<Vec3> smooth;           ///< the vertices after smoothing, or none
  std::size_t slabs = 1;
};

/// The axis along which points extend most.
int longest_axis(std::span<const Vec3> points) {
  Eigen::Index axis = 0;
  implicit::bounds(points).size().maxCoeff(&axis);
  return static_cast<int>(axis);
}

/// The search goes on from the last layer, or from one slab before it at most.
void forget_below_last_layer(implicit::PartitionOfUnity& field, const implicit::LayeredMesh& made, int axis,
                             double cell) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t v = made.first_vertices.back(); v < made.positions.size(); ++v)
    lowest = std::min(lowest, made.positions[v][axis]);
  if (std::isfinite(lowest)) field.forget_below(axis, lowest - cell);
}

class Shaping {
 public:
  Shaping(const RemeshModel& model, std::size_t number)
      : model_(model), number_(number), piece_(model.pieces.pieces[number]) {
    if (model.options.fill.preset == Preset::Paper) return;
    wanted_ = wanted_topology(model.analysis, piece_, model.links);
    room_ = room_of_scan(model.mesh, model.analysis, piece_);
    if (!wanted_ || piece_.views > 0) room_.volume.reset();
  }

  PieceShape run(Progress& progress);

 private:
  bool is_wide_alone(const std::vector<Index>& group) const;
  Trial trial_of(int retry) const;
  PieceShape make_surface(const Trial& trial, Progress& progress);
  void keep_near(Strays strays, const Trial& trial, PieceShape& shape, Progress& progress) const;
  void leave_open_ones(const Openings& openings, std::vector<Index>& left);
  void compare(const Trial& trial, PieceShape& shape, Progress& progress) const;
  PieceShape attempt(const Trial& trial, double growth, bool is_last, Progress& progress);
  Cubes polygons(const Trial& trial, const std::vector<implicit::Box>& boxes, implicit::PartitionOfUnity& field,
                 Progress& progress);
  implicit::PolygonizerOptions cubes_of(const Trial& trial, const std::vector<implicit::Box>& boxes) const;
  Cubes swept(const Trial& trial, const implicit::PolygonizerOptions& cubes, implicit::PartitionOfUnity& field,
              Progress& progress) const;
  ImprovedField improved(implicit::PartitionOfUnity& field, int axis) const;

  const RemeshModel& model_;
  std::size_t number_;
  const RemeshPiece& piece_;
  std::optional<SurfaceTopology> wanted_;
  PieceRoom room_;
};

bool runs_away(const PolyMesh& surface, const RemeshPoints& points) {
  if (surface.positions.empty()) return false;
  const implicit::Box made = implicit::bounds(surface.positions), given = implicit::bounds(points.positions);
  const double beyond = std::max((given.low - made.low).maxCoeff(), (made.high - given.high).maxCoeff());
  return beyond > runs_away_beyond * given.size().norm();
}

PieceShape Shaping::run(Progress& progress) {
  leave_to_patches(model_.pieces, number_, [&](const std::vector<Index>& group) { return is_wide_alone(group); });
  Progress first = progress.step("make surface", 0.9);
  PieceShape best = make_surface(trial_of(0), first);
  bool retried = false;
  for (int retry = 1; retry <= retries; ++retry) {
    if (best.torn() == 0 && are_few(best.lost.size(), piece_.vertices.size())) break;
    if (!model_.memory.may_halve(model_.share_of(piece_), retry)) break;
    Progress again = progress.step("make surface with smaller cells", 0.08 / retries);
    retried = true;
    PieceShape other = make_surface(trial_of(retry), again);
    if (other.left_to_patches.empty()) other.left_to_patches = best.left_to_patches;
    if (std::pair(other.torn(), other.lost.size()) >= std::pair(best.torn(), best.lost.size())) break;
    best = std::move(other);
  }
  best.retried = retried;
  return best;
}

/// A wide hole of one rim about which nothing was asked. Its domain would have a say as far as other holes, where it
/// knows nothing; patches follow its own surroundings alone.
bool Shaping::is_wide_alone(const std::vector<Index>& group) const {
  const FillOptions& fill = model_.options.fill;
  const auto is_named = [&](const HoleRequest& request) {
    return std::ranges::find(request.holes, group.front()) != request.holes.end();
  };
  return fill.preset != Preset::Paper && group.size() == 1 && is_wide(model_.analysis, group.front()) &&
         std::ranges::none_of(fill.requests, is_named);
}

/// As asked for at first; retries have cells of half the size, and fits that reach farther.
Trial Shaping::trial_of(int retry) const {
  Trial trial{model_.options, std::ldexp(model_.cell, -retry), {}};
  if (retry > 0) {
    trial.options.overlap = std::max(model_.options.overlap, retry_overlap);
    trial.options.min_points = std::max(model_.options.min_points, retry_points);
    trial.options.max_points = std::max(model_.options.max_points, retry_points);
  }
  trial.points = points_of(model_.mesh, model_.analysis, piece_, model_.normals, model_.edge);
  return trial;
}

/// Where nothing in the mesh backs what came out, holes are left to patches: the field ends at their rims then.
PieceShape Shaping::make_surface(const Trial& trial, Progress& progress) {
  PieceShape shape;
  std::vector<Index> left;
  for (std::size_t i = 0;; ++i) {
    const bool has_boxes = !piece_.groups.empty() && model_.options.fill.preset != Preset::Paper;
    const bool is_asked = !model_.options.fill.requests.empty();
    const bool is_last = !has_boxes || (is_asked && i + 1 >= growths.size());
    Progress trying = progress.step("make surface", i == 0 ? 0.9 : 0.02);
    shape = {};
    shape = attempt(trial, growths[is_asked ? std::min(i, growths.size() - 1) : 0], is_last, trying);
    if (!is_last && !shape.runs_away && shape.openings.any_of_field()) {
      if (!is_asked) leave_open_ones(shape.openings, left);
      continue;
    }
    Progress looking = progress.step("compare with the scan", 0.02);
    Strays strays = strays_of(model_, piece_, trial.points, shape.mesh, piece_.caps, looking);
    if (has_boxes && (shape.runs_away || strays.any())) {
      for (const std::vector<Index>& group : piece_.groups) left.insert(left.end(), group.begin(), group.end());
      leave_to_patches(model_.pieces, number_, [](const std::vector<Index>&) { return true; });
      continue;
    }
    keep_near(std::move(strays), trial, shape, looking);
    break;
  }
  shape.left_to_patches = std::move(left);
  if (!shape.openings.none()) {
    Progress patching = progress.step("close openings by patches", 0.02);
    shape.patched = close_by_patches(shape.mesh, shape.openings, model_.options.fill, patching);
  }
  if (!shape.openings.none()) {  // nothing closes these holes: what leads over their rims is off the scan
    Progress looking = progress.step("compare with the scan", 0.01);
    Strays strays = strays_of(model_, piece_, trial.points, shape.mesh, shape.openings.holes, looking);
    if (!strays.loose.empty())
      bring_near(shape.mesh, strays.loose, near_of(model_), model_.options.fill.precision, looking);
    shape.loose = std::move(strays.loose);
    for (Index v = 0; strays.count > 0 && v < strays.vertices.size(); ++v)
      if (strays.vertices[v] != 0) shape.loose.push_back({v, shape.mesh.positions[v], beyond_all});
  }
  compare(trial, shape, progress);
  return shape;
}

/// What the scan doesn't back goes, what is a little off it is brought near.
void Shaping::keep_near(Strays strays, const Trial& trial, PieceShape& shape, Progress& progress) const {
  bool is_cut = strays.count > 0;
  if (is_cut) {
    shape.mesh = trimmed(shape.mesh, strays.vertices);
    strays = strays_of(model_, piece_, trial.points, shape.mesh, piece_.caps, progress);
  }
  if (piece_.ends && trim_loose(shape.mesh, strays.loose, model_.threads(), progress)) {
    is_cut = true;
    strays = strays_of(model_, piece_, trial.points, shape.mesh, piece_.caps, progress);
  }
  if (!strays.loose.empty())
    bring_near(shape.mesh, strays.loose, near_of(model_), model_.options.fill.precision, progress);
  shape.loose = std::move(strays.loose);
  if (is_cut)
    shape.openings = find_openings(shape.mesh, model_.mesh, piece_, model_.pieces.rims, model_.options.fill, progress);
}

/// What of the piece is there, and in how many parts.
void Shaping::compare(const Trial& trial, PieceShape& shape, Progress& progress) const {
  Progress comparing = progress.step("look for lost detail", 0.02);
  shape.lost = lost_points(shape.mesh, trial.points.positions, model_.cell, model_.threads(), comparing);
  shape.lost_share = lost_share(model_.mesh, model_.analysis.view, piece_, trial.points, shape.lost);
  std::erase_if(shape.lost, [&](Index point) { return point >= piece_.vertices.size(); });
  Progress counting = progress.step("count parts and handles", 0.01);
  shape.topology = topology_of(shape.mesh, model_.threads(), counting);
  shape.wanted = wanted_;
  if (!wanted_ && model_.options.fill.preset != Preset::Paper)
    shape.implied = implied_topology(model_.analysis, piece_);
  if (shape.mesh.face_count() == 0 || model_.options.fill.preset == Preset::Paper) return;
  const PieceRoom made = room_of_surface(shape.mesh, shape.is_closed());
  shape.volume = made.volume;
  shape.given_room = room_;
  shape.room = change_of(room_, made, model_.analysis, piece_, model_.cell);
}

/// Larger boxes seldom help, and cost all of the model's fits and cubes each time: patches close what the field left
/// open, but where something was asked about holes, which they know nothing of. The second time all holes are left.
void Shaping::leave_open_ones(const Openings& openings, std::vector<Index>& left) {
  const auto is_open = [&](const std::vector<Index>& group) {
    return std::ranges::find_first_of(group, openings.holes) != group.end();
  };
  const bool is_known = left.empty() && std::ranges::any_of(piece_.groups, is_open);
  const auto is_left = [&](const std::vector<Index>& group) { return !is_known || is_open(group); };
  for (const std::vector<Index>& group : piece_.groups)
    if (is_left(group)) left.insert(left.end(), group.begin(), group.end());
  leave_to_patches(model_.pieces, number_, is_left);
}

PieceShape Shaping::attempt(const Trial& trial, double growth, bool is_last, Progress& progress) {
  PieceShape shape;
  shape.cell = trial.cell;
  Progress fitting = progress.step("fit functions", 0.1);
  std::vector<implicit::ExtraDomain> holes =
      hole_domains(model_.mesh, model_.analysis, piece_, model_.normals, model_.options, growth, fitting);
  std::vector<implicit::Box> boxes;
  for (const implicit::ExtraDomain& hole : holes) boxes.push_back(hole.box);
  implicit::DomainOptions domains = domain_options(trial.options, model_.edge);
  domains.borrow = true;
  domains.lazy = true;
  implicit::PartitionOfUnity field(trial.points.positions, trial.points.normals, std::move(holes), domains, fitting);
  Progress polygonizing = progress.step("polygonize", 0.7);
  Cubes cubes = polygons(trial, boxes, field, polygonizing);
  shape.mesh = std::move(cubes.mesh);
  shape.slabs = cubes.slabs;
  shape.runs_away = runs_away(shape.mesh, trial.points);
  if (shape.runs_away && !is_last) return shape;
  Progress looking = progress.step("look for openings", 0.05);
  shape.openings = find_openings(shape.mesh, model_.mesh, piece_, model_.pieces.rims, model_.options.fill, looking);
  if (shape.openings.any_of_field() && !is_last) return shape;
  shape.domains = field.report();
  Progress improving = progress.step("improve", 0.15);
  const ImprovementOptions options = improvement_of(model_.options, trial.cell);
  const ImprovedField onto = improved(field, cubes.slabs > 1 ? longest_axis(trial.points.positions) : -1);
  const std::vector<Vec3>& points = trial.points.positions;
  shape.cuts = cubes.smooth.empty()
                   ? improve(shape.mesh, onto, points, options, improving)
                   : improve_smoothed(shape.mesh, std::move(cubes.smooth), onto, points, options, improving);
  return shape;
}

/// @param axis of slabs, -1 without any
ImprovedField Shaping::improved(implicit::PartitionOfUnity& field, int axis) const {
  if (axis < 0) return {field.projection_field(), 0, {}};
  return {field.projection_field(), axis, [&field, axis](double place) { field.forget_below(axis, place); }};
}

implicit::PolygonizerOptions Shaping::cubes_of(const Trial& trial, const std::vector<implicit::Box>& boxes) const {
  implicit::PolygonizerOptions cubes;
  cubes.cell = trial.cell;
  cubes.bounds = implicit::bounds(trial.points.positions);
  for (const implicit::Box& box : boxes) {
    cubes.bounds.low = cubes.bounds.low.cwiseMin(box.low);
    cubes.bounds.high = cubes.bounds.high.cwiseMax(box.high);
  }
  cubes.origin = cubes.bounds.low;
  const Vec3 margin = Vec3::Constant(std::max(room * cubes.bounds.size().maxCoeff(), 4 * trial.cell));
  cubes.bounds = {cubes.bounds.low - margin, cubes.bounds.high + margin};
  const double faces = std::pow(cubes.bounds.size().maxCoeff() / trial.cell, 2);
  cubes.max_cells = static_cast<std::size_t>(
      std::min(1e6 + cells_per_cube_face * faces + 20.0 * static_cast<double>(trial.points.positions.size()), 5e8));
  cubes.threads = model_.threads();
  return cubes;
}

Cubes Shaping::polygons(const Trial& trial, const std::vector<implicit::Box>& boxes, implicit::PartitionOfUnity& field,
                        Progress& progress) {
  implicit::PolygonizerOptions cubes = cubes_of(trial, boxes);
  std::unique_ptr<OpenBorders> borders;
  if (piece_.ends) {
    borders = std::make_unique<OpenBorders>(piece_, trial.points, model_.pieces.rims, boxes, trial.cell, model_.edge,
                                            model_.threads());
    cubes.covered = [&](std::span<const Vec3> places, std::span<std::uint8_t> beyond) {
      for (std::size_t i = 0; i < places.size(); ++i) beyond[i] = borders->is_beyond(places[i]) ? 1 : 0;
    };
  }
  Cubes found;
  for (cubes.seed_reach = 0; cubes.seed_reach <= farthest_seeds && found.mesh.face_count() == 0; ++cubes.seed_reach) {
    Progress searching = progress.step("polygonize", cubes.seed_reach == 0 ? 0.9 : 0.02);
    found = swept(trial, cubes, field, searching);
  }
  if (borders) found.mesh = trimmed(found.mesh, found.covered);
  Progress dropping = progress.step("drop stray sheets", 0.04);
  drop_strays(found.mesh, trial.points.positions, model_.threads(), dropping,
              found.smooth.empty() ? nullptr : &found.smooth);
  return found;
}

/// Slab by slab. Vertices are smoothed at once, while fits are there; but those at open borders can't be, before the
/// borders are trimmed.
Cubes Shaping::swept(const Trial& trial, const implicit::PolygonizerOptions& cubes, implicit::PartitionOfUnity& field,
                     Progress& progress) const {
  implicit::SlabOptions slabs;
  slabs.axis = longest_axis(trial.points.positions);
  slabs.seeds_per_slab = piece_.ends ? model_.memory.slabs().open : model_.memory.slabs().closed;
  const ImprovementOptions options = improvement_of(model_.options, trial.cell);
  const bool is_split = trial.points.positions.size() > slabs.seeds_per_slab;
  const ImprovedField onto = improved(field, is_split ? slabs.axis : -1);
  SweptSmoothing smoothing(onto, options);
  implicit::SlabEvents events;
  events.enter = [&](double low, double high, Progress& part) { field.fit_between(slabs.axis, low, high, part); };
  events.finished = [&](implicit::LayeredMesh& made, Progress& part) {
    if (!piece_.ends)
      smoothing.advance(made, false, part);
    else if (is_split)
      forget_below_last_layer(field, made, slabs.axis, trial.cell);
  };
  events.begun_anew = [&] { smoothing.begin_anew(); };
  Progress polygonizing = progress.step("polygonize", 0.95);
  auto [made, report, count, bytes] =
      implicit::polygonize_by_slabs(field.field(), trial.points.positions, cubes, slabs, events, polygonizing);
  Cubes found;
  Progress finishing = progress.step("smooth", 0.05);
  if (!piece_.ends && !made.positions.empty()) {
    smoothing.advance(made, true, finishing);
    found.smooth = smoothing.take();
  }
  found.slabs = count;
  found.covered = std::move(made.covered);
  found.mesh.positions = std::move(made.positions);
  found.mesh.corners = std::move(made.corners);
  found.mesh.face_offsets.reserve(found.mesh.corners.size() / 3 + 1);
  while (found.mesh.face_offsets.back() < found.mesh.corners.size())
    found.mesh.face_offsets.push_back(found.mesh.face_offsets.back() + 3);
  return found;
}

}  // namespace

PieceShape make_shape(const RemeshModel& model, std::size_t piece, Progress& progress) {
  return Shaping(model, piece).run(progress);
}

double near_of(const RemeshModel& model) { return near_within * std::max(model.options.cell, 1.0) * model.edge; }

Strays strays_of(const RemeshModel& model, const RemeshPiece& piece, const RemeshPoints& points,
                 const PolyMesh& surface, std::span<const Index> open, Progress& progress) {
  const NearestSurface given(model.mesh, model.analysis.view, model.fans, piece, points, model.threads());
  const HoleReach holes(model.mesh, model.analysis, piece, model.pieces.rims, model.options.fill.requests, model.edge,
                        open);
  return find_strays(surface, model.mesh, model.analysis.view, piece, given, holes, near_of(model),
                     backed_within * std::max(model.cell, model.edge), model.threads(), progress);
}

ImprovementOptions improvement_of(const RemeshOptions& options, double cell) {
  return {cell,
          options.smoothing,
          options.refine,
          options.chord,
          options.snap * cell,
          options.fill.precision,
          options.fill.threads};
}

std::vector<Index> lost_points(const PolyMesh& surface, std::span<const Vec3> points, double cell, int threads,
                               Progress& progress) {
  return far_points(surface, points, lost_beyond * cell, threads, progress);
}

bool are_few(std::size_t lost, std::size_t points) {
  return static_cast<double>(lost) <= few_lost * static_cast<double>(points);
}

}  // namespace croquis::remeshing
