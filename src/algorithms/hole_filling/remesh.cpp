// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "algorithms/hole_filling/remesh_attributes.h"
#include "algorithms/hole_filling/remesh_cuts.h"
#include "algorithms/hole_filling/remesh_field.h"
#include "algorithms/hole_filling/remesh_findings.h"
#include "algorithms/hole_filling/remesh_improvement.h"
#include "algorithms/hole_filling/remesh_openings.h"
#include "algorithms/hole_filling/remesh_pieces.h"
#include "algorithms/hole_filling/remesh_plan.h"
#include "algorithms/hole_filling/remesh_points.h"
#include "algorithms/hole_filling/remesh_trimming.h"
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

/// What came out for one piece.
struct PieceSurface {
  PolyMesh mesh;
  Openings openings;
  std::size_t repaired = 0;
  std::size_t cuts = 0;
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
    for (const RemeshPiece& piece : pieces_.pieces) {
      const double share = static_cast<double>(piece.triangles.size()) / static_cast<double>(view().triangles.size());
      Progress part = making.step("make pieces", share);
      make_piece(piece, part);
    }
    Progress finishing = progress.step("verify", 0.1);
    finish(finishing);
    progress.report(1);
    return std::move(result_);
  }

 private:
  const SurfaceView& view() const { return result_.analysis.view; }
  int threads() const { return options_.fill.threads; }

  void prepare(Progress& progress) {
    edge_ = typical_edge(mesh_, view());
    cell_ = options_.cell * edge_;
    pieces_ = make_pieces(mesh_, result_.analysis, choice_, options_);
    fans_ = TriangleFans(mesh_.vertex_count(), flat(view().triangles));
    normals_ = vertex_normals(mesh_, result_.analysis, fans_, pieces_, threads(), progress);
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

  void make_piece(const RemeshPiece& piece, Progress& progress) {
    const RemeshPoints points = points_of(mesh_, result_.analysis, piece, normals_, edge_);
    PieceSurface surface;
    const bool has_boxes = !piece.groups.empty() && options_.fill.preset != Preset::Paper;
    for (std::size_t attempt = 0; attempt < growths.size(); ++attempt) {
      Progress trying = progress.step("make surface", attempt == 0 ? 0.9 : 0.02);
      surface = attempt_piece(piece, points, growths[attempt], attempt + 1 == growths.size() || !has_boxes, trying);
      if (surface.openings.none() || !has_boxes) break;
    }
    if (!surface.openings.none()) {
      Progress patching = progress.step("close openings by patches", 0.02);
      tell_patched(surface.openings);
      surface.repaired = close_by_patches(surface.mesh, surface.openings, options_.fill, patching);
    }
    Progress comparing = progress.step("look for lost detail", 0.02);
    result_.checks.lost_points += count_far(surface.mesh, points.positions, lost_beyond * cell_, threads(), comparing);
    Progress transferring = progress.step("carry over attributes", 0.02);
    take(piece, points, std::move(surface), transferring);
  }

  PieceSurface attempt_piece(const RemeshPiece& piece, const RemeshPoints& points, double growth, bool is_last,
                             Progress& progress) {
    PieceSurface surface;
    Progress fitting = progress.step("fit functions", 0.5);
    std::vector<implicit::ExtraDomain> holes =
        hole_domains(mesh_, result_.analysis, piece, normals_, options_, growth, fitting);
    std::vector<implicit::Box> boxes;
    for (const implicit::ExtraDomain& hole : holes) boxes.push_back(hole.box);
    const implicit::PartitionOfUnity field(points.positions, points.normals, std::move(holes),
                                           domain_options(options_, edge_), fitting);
    Progress polygonizing = progress.step("polygonize", 0.25);
    surface.mesh = polygons(piece, points, boxes, field, polygonizing);
    Progress looking = progress.step("look for openings", 0.05);
    surface.openings = find_openings(surface.mesh, mesh_, piece, pieces_.rims, threads(), looking);
    if (!surface.openings.none() && !is_last) return surface;
    count_domains(field.report());
    Progress improving = progress.step("improve", 0.2);
    surface.cuts = improve(surface.mesh, field.projection_field(), points.positions, improvement(), improving);
    return surface;
  }

  ImprovementOptions improvement() const {
    return {cell_,          options_.smoothing,    options_.refine,
            options_.chord, options_.snap * cell_, options_.fill.precision,
            threads()};
  }

  PolyMesh polygons(const RemeshPiece& piece, const RemeshPoints& points, const std::vector<implicit::Box>& boxes,
                    const implicit::PartitionOfUnity& field, Progress& progress) {
    implicit::PolygonizerOptions cubes;
    cubes.cell = cell_;
    cubes.bounds = implicit::bounds(points.positions);
    for (const implicit::Box& box : boxes) {
      cubes.bounds.low = cubes.bounds.low.cwiseMin(box.low);
      cubes.bounds.high = cubes.bounds.high.cwiseMax(box.high);
    }
    cubes.origin = cubes.bounds.low;
    const Vec3 margin = Vec3::Constant(std::max(room * cubes.bounds.size().maxCoeff(), 4 * cell_));
    cubes.bounds = {cubes.bounds.low - margin, cubes.bounds.high + margin};
    const double faces = std::pow(cubes.bounds.size().maxCoeff() / cell_, 2);
    cubes.max_cells = static_cast<std::size_t>(
        std::min(1e6 + cells_to_expect * faces + 20.0 * static_cast<double>(points.positions.size()), 5e8));
    cubes.threads = threads();
    std::unique_ptr<OpenBorders> borders;
    if (piece.stays_open) {
      borders = std::make_unique<OpenBorders>(piece, points, pieces_.rims, boxes, cell_, edge_, threads());
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

  void tell_patched(const Openings& openings) {
    for (const Index hole : openings.holes) {
      if (hole == no_index) continue;
      result_.outcomes[hole].method = "remesh-patched";
      result_.outcomes[hole].reason = "the field left an opening there";
    }
  }

  /// Appends a piece's surface to the result.
  void take(const RemeshPiece& piece, const RemeshPoints& points, PieceSurface surface, Progress& progress) {
    if (surface.mesh.face_count() == 0) ++lost_;
    for (const Index hole : surface.openings.holes) fail(hole);
    RemeshChecks& checks = result_.checks;
    checks.failed_loops += surface.openings.loops.size();
    checks.repaired_loops += surface.repaired;
    checks.self_intersections += surface.cuts;
    const bool is_wanted = !result_.mesh.channels.empty() || !piece.groups.empty();
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
    Progress computing = progress.step("normals", 0.1);
    compute_normals(result_.mesh, threads(), computing);
    mark();
    Progress checking = progress.step("verify", 0.9);
    check(checking);
    result_.warnings = remesh_findings(mesh_, result_, lost_, pieces_.left_out);
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
    for (std::size_t f = 0; f < patches.size(); ++f) {
      const auto face = mesh.face(f);
      const auto in_hole = std::count_if(face.begin(), face.end(), [&](Index v) { return marks_.hole[v] != no_index; });
      if (in_hole < 2) continue;
      const Index hole = std::min({marks_.hole[face[0]], marks_.hole[face[1]], marks_.hole[face[2]]});
      patches[f] = static_cast<std::int32_t>(patch_of_[hole]);
      ++first_of_patch(hole).new_faces;
    }
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
    if (pieces_.pieces.size() < 2 && checks.repaired_loops == 0) return;
    Progress cutting = progress.step("look for cuts", 0.8);
    checks.self_intersections = find_cuts(mesh, threads(), cutting).size();
  }

  const PolyMesh& mesh_;
  const RemeshOptions& options_;
  HoleChoice choice_;
  RemeshPieces pieces_;
  TriangleFans fans_ = TriangleFans(0, {});
  std::vector<Vec3> normals_;    // of the view's vertices
  std::vector<Index> patch_of_;  // per hole
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
