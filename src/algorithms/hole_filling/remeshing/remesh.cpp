// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/hole_filling/remeshing/remesh_attributes.h"
#include "algorithms/hole_filling/remeshing/remesh_cuts.h"
#include "algorithms/hole_filling/remeshing/remesh_field.h"
#include "algorithms/hole_filling/remeshing/remesh_findings.h"
#include "algorithms/hole_filling/remeshing/remesh_improvement.h"
#include "algorithms/hole_filling/remeshing/remesh_openings.h"
#include "algorithms/hole_filling/remeshing/remesh_pieces.h"
#include "algorithms/hole_filling/remeshing/remesh_plan.h"
#include "algorithms/hole_filling/remeshing/remesh_points.h"
#include "algorithms/hole_filling/remeshing/remesh_topology.h"
#include "algorithms/hole_filling/remeshing/remesh_trimming.h"
#include "croquis/implicit/marching_cubes.h"

namespace croquis::hole_filling {
namespace {

// Around a hole, × its diameter. Each is tried when the one before leaves an opening: the surface may bulge out of its
// box.
constexpr std::array growths = {0.35, 0.7, 1.4};

constexpr double room = 0.2;            // around points and holes' boxes, × the longest side; fields reach 0.25
constexpr double cells_to_expect = 20;  // per cube face of a sphere around everything
constexpr int farthest_seeds = 2;       // cubes around a point that are looked at, when its own has no surface
constexpr double lost_beyond = 1.25;    // × cell: a surface has vertices at less than one cell of any of its points
constexpr const char* patch_channel = "patch_id";

constexpr double runs_away_beyond = 0.4;  // × diagonal: no continuation of a surface leads so far out of its box
constexpr int retries = 2;             // of pieces that come out torn or grown together, each with cells of half size
constexpr double retry_overlap = 0.6;  // domains of thin walls have to see both sides, and much of them
constexpr std::size_t retry_points = 100;
constexpr double few_lost = 0.001;     // of the points of a piece: not worth four times the triangles
constexpr double retry_bytes = 1.5e9;  // for the triangles of one retry, when no limit is given

/// What came out for one piece.
struct PieceSurface {
  PolyMesh mesh;
  Openings openings;
  PatchedHoles patched;
  implicit::DomainReport domains;
  SurfaceTopology topology;
  std::vector<Index> lost;  ///< points without a surface
  std::size_t cuts = 0;
  bool runs_away = false;
};

/// How one piece is tried.
struct Trial {
  RemeshOptions options;
  double cell = 0;  ///< model units
  RemeshPoints points;
};

class Remeshing {
 public:
  Remeshing(const PolyMesh& mesh, const RemeshOptions& options) : mesh_(mesh), options_(options) {}

  RemeshResult run(Progress& progress) {
    require_options(options_);
    result_.predicted_bytes = require_memory(mesh_, options_);
    Progress analysing = progress.step("analyse holes", 0.06);
    result_.analysis = analyse_holes(mesh_, analysing, options_.fill.analysis);
    choice_ = choose_holes(result_.analysis.holes, options_.fill);
    Progress preparing = progress.step("normals", 0.04);
    prepare(preparing);
    Progress making = progress.step("make pieces", 0.8);
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      Progress part = making.step("make pieces", share_of(pieces_.pieces[p]));
      make_piece(p, part);
    }
    Progress finishing = progress.step("verify", 0.1);
    finish(finishing);
    progress.report(1);
    return std::move(result_);
  }

 private:
  const SurfaceView& view() const { return result_.analysis.view; }
  int threads() const { return options_.fill.threads; }
  double share_of(const RemeshPiece& piece) const {
    return static_cast<double>(piece.triangles.size()) / static_cast<double>(view().triangles.size());
  }

  void prepare(Progress& progress) {
    edge_ = typical_edge(mesh_, view());
    cell_ = options_.cell * edge_;
    pieces_ = make_pieces(mesh_, result_.analysis, choice_, options_);
    fans_ = TriangleFans(mesh_.vertex_count(), flat(view().triangles));
    normals_ = vertex_normals(mesh_, result_.analysis, fans_, pieces_, threads(), progress);
    links_ = fans_.links(threads(), progress);
    result_.mesh.channels = channels_like(mesh_);
    number_groups();
    report_choice();
  }

  void number_groups() {
    patch_of_.assign(result_.analysis.holes.size(), no_index);
    Index number = 0;
    for (const RemeshPiece& piece : pieces_.pieces) {
      for (const std::vector<Index>& group : piece.groups) {
        for (const Index hole : group) patch_of_[hole] = number;
        ++number;
      }
      for (const Index hole : piece.caps) patch_of_[hole] = number++;
    }
  }

  void report_choice() {
    result_.outcomes.resize(result_.analysis.holes.size());
    for (std::size_t h = 0; h < result_.outcomes.size(); ++h) {
      HoleOutcome& outcome = result_.outcomes[h];
      outcome.reason = choice_.reason[h];
      if (!choice_.is_chosen[h]) continue;
      outcome.action = patch_of_[h] == no_index ? FillAction::Failed : FillAction::Fill;
      outcome.reason = patch_of_[h] == no_index ? "its piece of the mesh was left out" : "";
      outcome.method = patch_of_[h] == no_index ? "" : "remesh";
      outcome.patch = patch_of_[h];
      outcome.confidence = 1;
    }
  }

  void make_piece(std::size_t number, Progress& progress) {
    const RemeshPiece& piece = pieces_.pieces[number];
    const std::optional<SurfaceTopology> wanted =
        options_.fill.preset == Preset::Paper ? std::nullopt : wanted_topology(result_.analysis, piece, links_);
    const auto torn = [&](const PieceSurface& surface) {
      return surface.openings.loops.size() + (wanted ? difference(surface.topology, *wanted) : 0);
    };
    const double few = few_lost * static_cast<double>(piece.vertices.size());
    Progress first = progress.step("make surface", 0.9);
    Trial trial = trial_of(piece, 0);
    PieceSurface best = make_surface(number, trial, first);
    bool retried = false;
    for (int retry = 1; retry <= retries; ++retry) {
      if (torn(best) == 0 && static_cast<double>(best.lost.size()) <= few) break;
      if (!may_retry(piece, retry)) break;
      Progress again = progress.step("make surface with smaller cells", 0.08 / retries);
      retried = true;
      const Trial finer = trial_of(piece, retry);
      PieceSurface other = make_surface(number, finer, again);
      if (std::pair(torn(other), other.lost.size()) >= std::pair(torn(best), best.lost.size())) break;
      best = std::move(other);
    }
    PieceLosses losses;
    losses.piece = number;
    losses.retried = retried;
    tell_losses(losses, trial.points, best, wanted);
    Progress transferring = progress.step("carry over attributes", 0.02);
    take(piece, trial.points, std::move(best), transferring);
  }

  /// As asked for at first; retries have cells of half the size, and fits that reach farther.
  Trial trial_of(const RemeshPiece& piece, int retry) const {
    Trial trial{options_, std::ldexp(cell_, -retry), {}};
    if (retry > 0) {
      trial.options.overlap = std::max(options_.overlap, retry_overlap);
      trial.options.min_points = std::max(options_.min_points, retry_points);
      trial.options.max_points = std::max(options_.max_points, retry_points);
    }
    trial.points = points_of(mesh_, result_.analysis, piece, normals_, edge_);
    return trial;
  }

  /// Whether memory allows cells of half the size, so many times.
  bool may_retry(const RemeshPiece& piece, int retry) const {
    if (options_.fill.preset == Preset::Paper) return false;
    RemeshOptions finer = options_;
    finer.cell = std::ldexp(options_.cell, -retry);
    const double whole = static_cast<double>(result_.predicted_bytes);
    const double more = share_of(piece) * (static_cast<double>(predicted_remesh_bytes(mesh_, finer)) - whole);
    return options_.memory_limit == 0 ? more <= retry_bytes
                                      : whole + more <= static_cast<double>(options_.memory_limit);
  }

  PieceSurface make_surface(std::size_t number, const Trial& trial, Progress& progress) {
    PieceSurface surface;
    for (std::size_t attempt = 0; attempt < growths.size(); ++attempt) {
      const RemeshPiece& piece = pieces_.pieces[number];
      const bool has_boxes = !piece.groups.empty() && options_.fill.preset != Preset::Paper;
      const bool is_last = attempt + 1 == growths.size() || !has_boxes;
      Progress trying = progress.step("make surface", attempt == 0 ? 0.9 : 0.02);
      surface = attempt_piece(piece, trial, growths[attempt], is_last, trying);
      if (surface.runs_away && has_boxes) {
        tell_runaway(piece);
        leave_to_patches(pieces_, number);
      } else if (!surface.openings.any_of_field() || !has_boxes) {
        break;
      }
    }
    if (!surface.openings.none()) {
      Progress patching = progress.step("close openings by patches", 0.02);
      surface.patched = close_by_patches(surface.mesh, surface.openings, options_.fill, patching);
    }
    Progress comparing = progress.step("look for lost detail", 0.02);
    surface.lost =
        far_points(surface.mesh, std::span(trial.points.positions).first(pieces_.pieces[number].vertices.size()),
                   lost_beyond * cell_, threads(), comparing);
    Progress counting = progress.step("count parts and handles", 0.01);
    surface.topology = topology_of(surface.mesh, threads(), counting);
    return surface;
  }

  PieceSurface attempt_piece(const RemeshPiece& piece, const Trial& trial, double growth, bool is_last,
                             Progress& progress) {
    PieceSurface surface;
    Progress fitting = progress.step("fit functions", 0.5);
    std::vector<implicit::ExtraDomain> holes =
        hole_domains(mesh_, result_.analysis, piece, normals_, options_, growth, fitting);
    std::vector<implicit::Box> boxes;
    for (const implicit::ExtraDomain& hole : holes) boxes.push_back(hole.box);
    const implicit::PartitionOfUnity field(trial.points.positions, trial.points.normals, std::move(holes),
                                           domain_options(trial.options, edge_), fitting);
    Progress polygonizing = progress.step("polygonize", 0.25);
    surface.mesh = polygons(piece, trial, boxes, field, polygonizing);
    surface.runs_away = runs_away(surface.mesh, trial.points);
    if (surface.runs_away && !is_last) return surface;
    Progress looking = progress.step("look for openings", 0.05);
    surface.openings = find_openings(surface.mesh, mesh_, piece, pieces_.rims, threads(), looking);
    if (surface.openings.any_of_field() && !is_last) return surface;
    surface.domains = field.report();
    Progress improving = progress.step("improve", 0.2);
    surface.cuts =
        improve(surface.mesh, field.projection_field(), trial.points.positions, improvement(trial.cell), improving);
    return surface;
  }

  static bool runs_away(const PolyMesh& surface, const RemeshPoints& points) {
    if (surface.positions.empty()) return false;
    const implicit::Box made = implicit::bounds(surface.positions), given = implicit::bounds(points.positions);
    const double beyond = std::max((given.low - made.low).maxCoeff(), (made.high - given.high).maxCoeff());
    return beyond > runs_away_beyond * given.size().norm();
  }

  ImprovementOptions improvement(double cell) const {
    return {cell,           options_.smoothing,   options_.refine,
            options_.chord, options_.snap * cell, options_.fill.precision,
            threads()};
  }

  PolyMesh polygons(const RemeshPiece& piece, const Trial& trial, const std::vector<implicit::Box>& boxes,
                    const implicit::PartitionOfUnity& field, Progress& progress) const {
    const RemeshPoints& points = trial.points;
    implicit::PolygonizerOptions cubes;
    cubes.cell = trial.cell;
    cubes.bounds = implicit::bounds(points.positions);
    for (const implicit::Box& box : boxes) {
      cubes.bounds.low = cubes.bounds.low.cwiseMin(box.low);
      cubes.bounds.high = cubes.bounds.high.cwiseMax(box.high);
    }
    cubes.origin = cubes.bounds.low;
    const Vec3 margin = Vec3::Constant(std::max(room * cubes.bounds.size().maxCoeff(), 4 * trial.cell));
    cubes.bounds = {cubes.bounds.low - margin, cubes.bounds.high + margin};
    const double faces = std::pow(cubes.bounds.size().maxCoeff() / trial.cell, 2);
    cubes.max_cells = static_cast<std::size_t>(
        std::min(1e6 + cells_to_expect * faces + 20.0 * static_cast<double>(points.positions.size()), 5e8));
    cubes.threads = threads();
    std::unique_ptr<OpenBorders> borders;
    if (piece.ends) {
      borders = std::make_unique<OpenBorders>(piece, points, pieces_.rims, boxes, trial.cell, edge_, threads());
      cubes.covered = [&](std::span<const Vec3> places, std::span<std::uint8_t> beyond) {
        for (std::size_t i = 0; i < places.size(); ++i) beyond[i] = borders->is_beyond(places[i]) ? 1 : 0;
      };
    }
    implicit::Polygonized found;
    for (cubes.seed_reach = 0; cubes.seed_reach <= farthest_seeds && found.mesh.face_count() == 0; ++cubes.seed_reach) {
      Progress searching = progress.step("polygonize", cubes.seed_reach == 0 ? 0.9 : 0.02);
      found = implicit::polygonize(field.field(), points.positions, cubes, searching);
    }
    if (borders) found.mesh = trimmed(found.mesh, found.covered);
    Progress dropping = progress.step("drop stray sheets", 0.04);
    drop_strays(found.mesh, points.positions, threads(), dropping);
    return std::move(found.mesh);
  }

  /// Counts add up over pieces; the median is that of the piece with most domains.
  void count_domains(const implicit::DomainReport& report) {
    const std::size_t domains = report.data_domains + report.extra_domains;
    DomainPointCounts& counts = result_.points_per_domain;
    counts.min = result_.domains == 0 ? report.min_centres : std::min(counts.min, report.min_centres);
    counts.max = std::max(counts.max, report.max_centres);
    if (domains >= most_domains_) counts.median = report.median_centres;
    most_domains_ = std::max(most_domains_, domains);
    result_.domains += domains;
  }

  void tell_runaway(const RemeshPiece& piece) {
    for (const std::vector<Index>& group : piece.groups)
      for (const Index hole : group) result_.outcomes[hole].reason = "the field leads far out of the model there";
  }

  void tell_patched(const PatchedHole& patched) {
    if (patched.hole == no_index) return;
    HoleOutcome& outcome = result_.outcomes[patched.hole];
    outcome.method = patched.is_cap ? patched.outcome.method : "remesh-patched";
    if (!patched.is_cap) outcome.reason = "the field left an opening there";
    outcome.confidence = std::min(outcome.confidence, patched.outcome.confidence);
  }

  /// Which piece isn't what it should be, and where.
  void tell_losses(PieceLosses losses, const RemeshPoints& points, const PieceSurface& surface,
                   const std::optional<SurfaceTopology>& wanted) {
    if (surface.mesh.face_count() == 0) return;  // told as lost
    result_.checks.lost_points += surface.lost.size();
    const bool differs = wanted && difference(surface.topology, *wanted) > 0;
    if (surface.lost.empty() && !differs) return;
    losses.lost_points = surface.lost.size();
    if (differs) losses.wanted = wanted;
    losses.made = surface.topology;
    losses.at = surface.lost.empty() ? place_of_smallest_part(surface.mesh) : points.positions[surface.lost.front()];
    losses_.push_back(losses);
  }

  /// Appends a piece's surface to the result.
  void take(const RemeshPiece& piece, const RemeshPoints& points, PieceSurface surface, Progress& progress) {
    if (surface.mesh.face_count() == 0) ++lost_;
    for (const Index hole : surface.openings.holes) fail(hole);
    for (const PatchedHole& patched : surface.patched.loops) tell_patched(patched);
    if (surface.domains.fitted > 0) count_domains(surface.domains);
    RemeshChecks& checks = result_.checks;
    checks.failed_loops += surface.openings.loops.size();
    for (const PatchedHole& patched : surface.patched.loops) checks.repaired_loops += patched.is_cap ? 0U : 1U;
    any_patched_ = any_patched_ || !surface.patched.loops.empty();
    for (const auto& [face, hole] : surface.patched.faces)
      if (hole != no_index) patched_faces_.emplace_back(result_.mesh.face_count() + face, hole);
    first_faces_.push_back(result_.mesh.face_count());
    checks.self_intersections += surface.cuts;
    const bool is_wanted = !result_.mesh.channels.empty() || !piece.groups.empty() || !piece.caps.empty();
    if (is_wanted) {
      const NearestSurface nearest(mesh_, view(), fans_, piece, points, threads());
      transfer(surface.mesh, nearest, mesh_, result_.analysis, piece, pieces_.rims, cell_, threads(),
               result_.mesh.channels, marks_, progress);
    }
    const auto first = static_cast<Index>(result_.mesh.vertex_count());
    marks_.hole.resize(first + surface.mesh.vertex_count(), no_index);
    marks_.confidence.resize(first + surface.mesh.vertex_count(), 1);
    append(std::move(surface.mesh));
  }

  void fail(Index hole) {
    if (hole == no_index) return;
    HoleOutcome& outcome = result_.outcomes[hole];
    outcome.action = FillAction::Failed;
    outcome.reason = "neither the field nor a patch closes it";
    outcome.method.clear();
    outcome.confidence = 0;
  }

  void append(PolyMesh&& surface) {
    PolyMesh& mesh = result_.mesh;
    if (mesh.vertex_count() == 0) {
      surface.channels = std::move(mesh.channels);
      mesh = std::move(surface);
      return;
    }
    const auto first = static_cast<Index>(mesh.vertex_count());
    mesh.positions.insert(mesh.positions.end(), surface.positions.begin(), surface.positions.end());
    for (const Index corner : surface.corners) mesh.corners.push_back(first + corner);
    while (mesh.face_offsets.back() < mesh.corners.size()) mesh.face_offsets.push_back(mesh.face_offsets.back() + 3);
  }

  void finish(Progress& progress) {
    fans_ = TriangleFans(0, {});
    normals_ = {};
    links_ = {};
    Progress computing = progress.step("normals", 0.1);
    compute_normals(result_.mesh, threads(), computing);
    mark();
    Progress checking = progress.step("verify", 0.9);
    check(checking);
    result_.warnings = remesh_findings(mesh_, result_, {lost_, pieces_.left_out, options_.cell, losses_});
  }

  /// Channels "confidence" and "patch_id", and what outcomes say of the patches.
  void mark() {
    PolyMesh& mesh = result_.mesh;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      const Index hole = marks_.hole[v];
      if (hole == no_index) continue;
      ++first_of_patch(hole).new_vertices;
      HoleOutcome& outcome = result_.outcomes[hole];
      outcome.confidence = std::min(outcome.confidence, static_cast<double>(marks_.confidence[v]));
    }
    std::vector<std::int32_t> patches(mesh.face_count(), -1);
    const auto put = [&](std::size_t face, Index hole) {
      patches[face] = static_cast<std::int32_t>(patch_of_[hole]);
      ++first_of_patch(hole).new_faces;
    };
    for (const auto& [face, hole] : patched_faces_) put(face, hole);
    for (std::size_t f = 0; f < patches.size(); ++f) {
      const auto face = mesh.face(f);
      const auto in_hole = std::count_if(face.begin(), face.end(), [&](Index v) { return marks_.hole[v] != no_index; });
      if (in_hole < 2 || patches[f] >= 0) continue;
      put(f, std::min({marks_.hole[face[0]], marks_.hole[face[1]], marks_.hole[face[2]]}));
    }
    measure_patches(mesh, patches, patch_of_, result_.outcomes);
    if (!options_.fill.mark_patches) return;
    mesh.channels.push_back({"confidence", Domain::Vertex, 1, std::move(marks_.confidence), {}});
    mesh.channels.push_back({patch_channel, Domain::Face, 1, std::move(patches), {}});
  }

  HoleOutcome& first_of_patch(Index hole) {
    const auto first = std::find(patch_of_.begin(), patch_of_.end(), patch_of_[hole]);
    return result_.outcomes[static_cast<std::size_t>(first - patch_of_.begin())];
  }

  void check(Progress& progress) {
    const PolyMesh& mesh = result_.mesh;
    RemeshChecks& checks = result_.checks;
    const TriangleFans fans(mesh.vertex_count(), mesh.corners);
    Progress linking = progress.step("verify", 0.2);
    const std::vector<TriangleFans::Link> links = fans.links(threads(), linking);
    using Link = TriangleFans::Link;
    checks.manifold = std::none_of(links.begin(), links.end(), [](Link link) { return link == Link::Broken; });
    checks.components = part_count(mesh);
    checks.open_loops = open_loop_count(fans, links);
    // Each piece was looked at alone.
    if (pieces_.pieces.size() < 2 && !any_patched_) return;
    Progress cutting = progress.step("look for cuts", 0.8);
    const auto cuts = find_cuts(mesh, threads(), cutting);
    checks.self_intersections = cuts.size();
    const auto piece_at = [&](std::size_t face) { return std::ranges::upper_bound(first_faces_, face); };
    checks.piece_crossings = static_cast<std::size_t>(
        std::ranges::count_if(cuts, [&](const auto& pair) { return piece_at(pair[0]) != piece_at(pair[1]); }));
  }

  const PolyMesh& mesh_;
  const RemeshOptions& options_;
  HoleChoice choice_;
  RemeshPieces pieces_;
  TriangleFans fans_ = TriangleFans(0, {});
  std::vector<Vec3> normals_;  // of the view's vertices
  std::vector<TriangleFans::Link> links_;
  std::vector<Index> patch_of_;                               // per hole
  std::vector<std::size_t> first_faces_;                      // of the result, per piece
  std::vector<std::pair<std::size_t, Index>> patched_faces_;  // of the result, and their holes
  std::vector<PieceLosses> losses_;
  bool any_patched_ = false;
  double edge_ = 0, cell_ = 0;
  HoleMarks marks_;
  std::size_t lost_ = 0, most_domains_ = 0;
  RemeshResult result_;
};

}  // namespace

RemeshResult remesh_surface(const PolyMesh& mesh, const RemeshOptions& options, Progress& progress) {
  return Remeshing(mesh, options).run(progress);
}

}  // namespace croquis::hole_filling
