// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/remeshing/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "algorithms/remeshing/remesh_attributes.h"
#include "algorithms/remeshing/remesh_backing.h"
#include "algorithms/remeshing/remesh_findings.h"
#include "algorithms/remeshing/remesh_pieces.h"
#include "algorithms/remeshing/remesh_plan.h"
#include "algorithms/remeshing/remesh_points.h"
#include "algorithms/remeshing/remesh_shape.h"
#include "algorithms/remeshing/remesh_topology.h"
#include "algorithms/remeshing/remesh_trimming.h"
#include "algorithms/remeshing/simplification/flat_faces.h"
#include "algorithms/remeshing/solids/remesh_union.h"
#include "algorithms/remeshing/solids/union_check.h"
#include "croquis/hole_filling/channel_names.h"
#include "croquis/hole_filling/fill_findings.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

/// The corners of triangles behind one another.
std::span<const Index> flat_corners(const std::vector<std::array<Index, 3>>& triangles) {
  static_assert(sizeof(std::array<Index, 3>) == 3 * sizeof(Index));
  return {reinterpret_cast<const Index*>(triangles.data()), 3 * triangles.size()};
}

/// The mesh with the faces of some components turned over.
PolyMesh with_turned(PolyMesh mesh, const SurfaceView& view, const std::vector<Index>& components) {
  std::vector<std::uint8_t> is_done(mesh.face_count(), 0);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const Index face = view.face[t];
    if (is_done[face] != 0 || !std::ranges::binary_search(components, view.component[t])) continue;
    is_done[face] = 1;
    std::reverse(mesh.corners.begin() + mesh.face_offsets[face], mesh.corners.begin() + mesh.face_offsets[face + 1]);
  }
  return mesh;
}

class Remeshing {
 public:
  Remeshing(const PolyMesh& mesh, const RemeshOptions& options)
      : given_(mesh), options_(options), memory_(mesh, options) {}

  RemeshResult run(Progress& progress) {
    require_options(options_);
    require_memory(memory_, options_.memory_limit);
    result_.predicted_bytes = whole_bytes(memory_.most());
    result_.predicted_faces = whole_bytes(memory_.faces());
    result_.coarsening = memory_.coarsening();
    Progress analysing = progress.step("analyse holes", 0.06);
    result_.analysis = analyse_holes(given_, analysing, options_.fill.analysis);
    find_seams(analysing);
    choice_ = choose_holes(result_.analysis.holes, options_.fill);
    Progress preparing = progress.step("normals", 0.04);
    prepare(preparing);
    Progress making = progress.step("make about " + std::to_string(result_.predicted_faces) + " faces", 0.8);
    make_pieces_anew(making);
    Progress finishing = progress.step("verify", 0.1);
    finish(finishing);
    progress.report(1);
    return std::move(result_);
  }

 private:
  const SurfaceView& view() const { return result_.analysis.view; }
  int threads() const { return options_.fill.threads; }
  double cell() const { return options_.cell * edge_ * memory_.coarsening(); }

  /// The mesh given, or that with the views turned over that didn't agree with the others.
  const PolyMesh& mesh() const { return turned_ ? *turned_ : given_; }

  void find_seams(Progress& progress) {
    edge_ = typical_edge(mesh(), view());
    if (options_.fill.preset == Preset::Paper) return;
    seams_ = find_view_seams(mesh(), result_.analysis, options_.fill.requests, edge_);
    if (seams_.turned.empty()) return;
    result_.checks.turned_views = seams_.turned.size();
    turned_ = with_turned(given_, view(), seams_.turned);
    result_.analysis = analyse_holes(*turned_, progress, options_.fill.analysis);
    seams_ = find_view_seams(*turned_, result_.analysis, options_.fill.requests, edge_);
  }

  void prepare(Progress& progress) {
    choose_seams();
    pieces_ = make_pieces(mesh(), result_.analysis, choice_, seams_, options_);
    fans_ = TriangleFans(mesh().vertex_count(), flat_corners(view().triangles));
    normals_ = vertex_normals(mesh(), result_.analysis, fans_, pieces_, threads(), progress);
    links_ = fans_.links(threads(), progress);
    result_.mesh.channels = channels_like(mesh());
    number_groups();
    report_choice();
  }

  /// Borders of views that go on in others aren't what the selection leaves open: what all of them leave open is.
  void choose_seams() {
    const FillOptions& fill = options_.fill;
    if (fill.selection != Selection::Inner || !fill.only.empty()) return;
    for (const Hole& hole : result_.analysis.holes)
      if (hole.kind == HoleClass::Outer && seams_.are_along(hole.id)) choice_.is_chosen[hole.id] = true;
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
      for (const Index hole : piece.seams) patch_of_[hole] = number++;
    }
  }

  void report_choice() {
    result_.outcomes.resize(result_.analysis.holes.size());
    for (std::size_t h = 0; h < result_.outcomes.size(); ++h) {
      HoleOutcome& outcome = result_.outcomes[h];
      outcome.reason = choice_.reason[h];
      if (!choice_.is_chosen[h]) continue;
      outcome.action = patch_of_[h] == no_index ? FillAction::Failed : FillAction::Fill;
      outcome.reason = patch_of_[h] == no_index ? piece_left_out : "";
      outcome.method = patch_of_[h] == no_index ? "" : "remesh";
      outcome.patch = patch_of_[h];
      outcome.confidence = 1;
    }
  }

  void make_pieces_anew(Progress& progress) {
    const RemeshModel model{mesh(), result_.analysis, options_, pieces_, normals_,
                            fans_,  links_,           edge_,    cell(),  memory_};
    const double whole = options_.adaptive > 0 ? 0.7 : 1;
    std::vector<PieceShape> shapes;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      Progress part = progress.step("make pieces", whole * 0.9 * model.share_of(pieces_.pieces[p]));
      shapes.push_back(make_shape(model, p, part));
      if (shapes.back().mesh.face_count() > 0 && shapes.back().lost_share > most_lost) refuse(p, shapes.back());
      result_.slabs = std::max(result_.slabs, shapes.back().slabs);
      tell(p, shapes.back());
    }
    std::vector<PieceShape> known;  // without their meshes, which joining takes
    for (const PieceShape& shape : shapes) {
      PieceShape& kept = known.emplace_back();
      kept.topology = shape.topology;
      kept.implied = shape.refused ? std::nullopt : shape.implied;
      kept.volume = shape.volume;
    }
    Progress joining = progress.step("join pieces", whole * 0.07);
    JoinedShapes joined = join_shapes(model, shapes, joining);
    for (const CrossingPiece& left : joined.left_out) refuse({left.piece, 0, left.other, left.at});
    std::vector<AttributeChannel> channels = std::move(result_.mesh.channels);
    result_.mesh = std::move(joined.mesh);
    result_.mesh.channels = std::move(channels);
    result_.checks.self_intersections = joined.cuts;
    result_.checks.piece_crossings = joined.crossings;
    result_.checks.united_pieces = joined.united;
    make_room(result_.mesh.vertex_count(), result_.mesh.channels, marks_);
    Progress transferring = progress.step("carry over attributes", whole * 0.03);
    for (const RemeshPart& part : joined.parts) {
      tell_losses(part);
      tell_differences(part, known, transferring);
      transfer_to(part, transferring);
    }
    if (result_.mesh.face_count() == 0) return;  // refused in the end
    compute_normals(result_.mesh, threads(), transferring);
    label_faces();
    result_.full_faces = result_.mesh.face_count();
    if (options_.adaptive > 0) merge(model, joined.parts, shapes, progress);
  }

  void merge(const RemeshModel& model, const std::vector<RemeshPart>& parts, const std::vector<PieceShape>& shapes,
             Progress& progress) {
    Progress merging = progress.step("merge flat faces", 0.3);
    MergedFaces merged = merge_flat_faces(model, result_.mesh, parts, shapes, labels_, merging);
    keep_values(merged.vertex_of, merged.face_of, result_.mesh.channels, marks_, labels_);
    merged.mesh.channels = std::move(result_.mesh.channels);
    result_.mesh = std::move(merged.mesh);
  }

  /// The result for a piece doesn't represent it: the piece is left out.
  void refuse(std::size_t piece, PieceShape& shape) {
    const RemeshPiece& given = pieces_.pieces[piece];
    const Index at = given.vertices[shape.lost.empty() ? 0 : shape.lost.front()];
    refuse({piece, shape.lost_share, RefusedPiece::no_piece, mesh().positions[at]});
    shape = {};
    shape.refused = true;
  }

  void refuse(const RefusedPiece& refused) {
    refused_.push_back(refused);
    const RemeshPiece& piece = pieces_.pieces[refused.piece];
    for (const Index hole : piece.caps) fail(hole, piece_left_out);
    for (const Index hole : piece.seams) fail(hole, piece_left_out);
    for (const std::vector<Index>& group : piece.groups)
      for (const Index hole : group) fail(hole, piece_left_out);
  }

  /// Counts add up over pieces; the median is that of the piece with most domains.
  void count_domains(const implicit::DomainReport& report) {
    const std::size_t domains = report.data_domains + report.extra_domains;
    hole_filling::DomainPointCounts& counts = result_.points_per_domain;
    counts.min = result_.domains == 0 ? report.min_centres : std::min(counts.min, report.min_centres);
    counts.max = std::max(counts.max, report.max_centres);
    if (domains >= most_domains_) counts.median = report.median_centres;
    most_domains_ = std::max(most_domains_, domains);
    result_.domains += domains;
  }

  void tell_patched(const PatchedHole& patched) {
    if (patched.hole == no_index) return;
    HoleOutcome& outcome = result_.outcomes[patched.hole];
    const bool is_meant = patched.fate == RimFate::Patch || patched.fate == RimFate::Left;
    outcome.method = is_meant ? patched.outcome.method : "remesh-patched";
    if (patched.fate == RimFate::Field) outcome.reason = "the new surface left an opening there";
    outcome.confidence = std::min(outcome.confidence, patched.outcome.confidence);
  }

  /// What became of a piece and its holes.
  void tell(std::size_t piece, const PieceShape& shape) {
    if (shape.refused) return;
    if (shape.mesh.face_count() == 0) ++lost_;
    for (const Index hole : shape.openings.holes) fail(hole, "neither the field nor a patch closes it");
    for (const Index hole : shape.openings.left) leave_open(hole, FillAction::Leave, "the border of the joined views");
    const RemeshPiece& joined = pieces_.pieces[piece];
    if (joined.views > joined.islands + 1) result_.checks.joined_views += joined.views - joined.islands;
    for (const PatchedHole& patched : shape.patched.loops) tell_patched(patched);
    for (const Index hole : shape.left_to_patches) {  // small ones are closed by what reaches over their rims
      HoleOutcome& outcome = result_.outcomes[hole];
      if (outcome.action == FillAction::Fill && outcome.method != "remesh")
        outcome.reason = "the new surface leads far from the scan there";
    }
    if (shape.domains.fitted > 0) count_domains(shape.domains);
    RemeshChecks& checks = result_.checks;
    checks.failed_loops += shape.openings.loops.size();
    for (const PatchedHole& patched : shape.patched.loops)
      checks.repaired_loops += patched.fate == RimFate::Field ? 1U : 0U;
    tell_losses(piece, shape);
  }

  /// Whether a piece isn't what it should be, and where.
  void tell_losses(std::size_t piece, const PieceShape& shape) {
    if (shape.mesh.face_count() == 0) return;  // reported as lost
    result_.checks.lost_points += shape.lost.size();
    const bool differs = shape.wanted && difference(shape.topology, *shape.wanted) > 0;
    result_.checks.loose_points += shape.loose.size();
    if (shape.lost.empty() && !differs && shape.loose.empty() && !shape.room.any()) return;
    PieceLosses losses;
    losses.piece = piece;
    losses.retried = shape.retried;
    losses.lost_points = shape.lost.size();
    if (differs) losses.wanted = shape.wanted;
    losses.made = shape.topology;
    losses.loose = shape.loose.size();
    losses.room = shape.room;
    if (!shape.loose.empty()) losses.loose_at = shape.mesh.positions[shape.loose.front().vertex];
    losses.at = shape.lost.empty() ? place_of_smallest_part(shape.mesh)
                                   : mesh().positions[pieces_.pieces[piece].vertices[shape.lost.front()]];
    losses_.push_back(losses);
  }

  /// What a solid of several pieces lost on top of that.
  void tell_losses(const RemeshPart& part) {
    if (part.lost == 0) return;
    result_.checks.lost_points += part.lost;
    PieceLosses losses;
    losses.piece = part.pieces.front();
    losses.retried = true;
    losses.lost_points = part.lost;
    losses.at = part.lost_at;
    losses_.push_back(losses);
  }

  /// Whether what came out in the end has parts, handles or a volume that its pieces don't explain.
  void tell_differences(const RemeshPart& part, const std::vector<PieceShape>& known, Progress& progress) {
    if (part.pieces.empty() || part.vertex_count == 0) return;
    PieceLosses losses;
    losses.piece = part.pieces.front();
    losses.together = part.pieces.size();
    losses.made = known[losses.piece].topology;
    losses.at = result_.mesh.positions[part.first_vertex];
    if (part.is_solid) {
      const PolyMesh solid = surface_of(part, result_.mesh);
      Progress counting = progress.step("count parts and handles", 0.01);
      losses.made = topology_of(solid, threads(), counting);
      std::vector<std::optional<double>> volumes;
      for (const std::size_t piece : part.pieces) volumes.push_back(known[piece].volume);
      losses.room = change_of_solid(volumes, solid, cell());
    }
    const std::optional<SurfaceTopology>& implied = known[losses.piece].implied;
    if (losses.together == 1 && implied && difference(losses.made, *implied) > 0) losses.implied = implied;
    if (losses.implied || losses.room.any()) losses_.push_back(losses);
  }

  /// Values of vertices, and which of them lie in holes.
  void transfer_to(const RemeshPart& part, Progress& progress) {
    patched_faces_.insert(patched_faces_.end(), part.patched.begin(), part.patched.end());
    const double share = static_cast<double>(part.vertex_count) / static_cast<double>(result_.mesh.vertex_count() + 1);
    for (const std::size_t number : part.pieces) {
      const RemeshPiece& piece = pieces_.pieces[number];
      Progress transferring = progress.step("carry over attributes", share / static_cast<double>(part.pieces.size()));
      const bool has_holes = !piece.groups.empty() || !piece.caps.empty() || !piece.seams.empty();
      if (result_.mesh.channels.empty() && !has_holes) continue;
      const RemeshPoints points = points_of(mesh(), result_.analysis, piece, normals_, edge_);
      const NearestSurface nearest(mesh(), view(), fans_, piece, points, threads());
      const NewVertices vertices{part.first_vertex, part.vertex_count, part.piece_at, static_cast<Index>(number)};
      transfer(result_.mesh, vertices, nearest, mesh(), result_.analysis, piece, pieces_.rims, cell(), threads(),
               marks_, transferring);
    }
  }

  void fail(Index hole, const char* reason) {
    if (hole != no_index) leave_open(hole, FillAction::Failed, reason);
  }

  void leave_open(Index hole, FillAction action, const char* reason) {
    HoleOutcome& outcome = result_.outcomes[hole];
    outcome.action = action;
    outcome.reason = reason;
    outcome.method.clear();
    outcome.confidence = 0;
  }

  void finish(Progress& progress) {
    fans_ = TriangleFans(0, {});
    normals_ = {};
    links_ = {};
    RemeshLosses losses{lost_, pieces_.left_out, options_.cell, losses_, refused_, {}, {}};
    require_faces(result_.mesh, losses);
    mark();
    Progress checking = progress.step("verify", 0.9);
    check(checking);
    Progress comparing = progress.step("compare with the scan", 0.1);
    find_far(losses, comparing);
    result_.warnings = remesh_findings(mesh(), result_, losses);
  }

  /// The patch of every face, and the least confidence of every hole's vertices.
  void label_faces() {
    const PolyMesh& mesh = result_.mesh;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      if (marks_.hole[v] == no_index) continue;
      HoleOutcome& outcome = result_.outcomes[marks_.hole[v]];
      outcome.confidence = std::min(outcome.confidence, static_cast<double>(marks_.confidence[v]));
    }
    labels_.assign(mesh.face_count(), -1);
    const auto put = [&](std::size_t face, Index hole) { labels_[face] = static_cast<std::int32_t>(patch_of_[hole]); };
    for (const auto& [face, hole] : patched_faces_) put(face, hole);
    for (std::size_t f = 0; f < labels_.size(); ++f) {
      const auto face = mesh.face(f);
      const auto in_hole = std::count_if(face.begin(), face.end(), [&](Index v) { return marks_.hole[v] != no_index; });
      if (in_hole < 2 || labels_[f] >= 0) continue;
      put(f, std::min({marks_.hole[face[0]], marks_.hole[face[1]], marks_.hole[face[2]]}));
    }
  }

  /// Channels "confidence" and "patch_id", and the patches' values in outcomes.
  void mark() {
    PolyMesh& mesh = result_.mesh;
    for (const Index hole : marks_.hole)
      if (hole != no_index) ++first_of_patch(patch_of_[hole]).new_vertices;
    for (const std::int32_t label : labels_)
      if (label >= 0) ++first_of_patch(static_cast<Index>(label)).new_faces;
    measure_patches(mesh, labels_, patch_of_, result_.outcomes);
    if (!options_.fill.mark_patches) return;
    mesh.channels.push_back({"confidence", Domain::Vertex, 1, std::move(marks_.confidence), {}});
    mesh.channels.push_back({patch_channel, Domain::Face, 1, std::move(labels_), {}});
  }

  HoleOutcome& first_of_patch(Index patch) {
    const auto first = std::find(patch_of_.begin(), patch_of_.end(), patch);
    return result_.outcomes[static_cast<std::size_t>(first - patch_of_.begin())];
  }

  void check(Progress& progress) {
    const PolyMesh& mesh = result_.mesh;
    RemeshChecks& checks = result_.checks;
    const TriangleFans fans(mesh.vertex_count(), mesh.corners);
    Progress linking = progress.step("verify", 0.9);
    const std::vector<TriangleFans::Link> links = fans.links(threads(), linking);
    using Link = TriangleFans::Link;
    checks.manifold = std::none_of(links.begin(), links.end(), [](Link link) { return link == Link::Broken; });
    checks.components = part_count(mesh);
    checks.open_loops = open_loop_count(fans, links);
  }

  /// What of the result has no scan near to it.
  void find_far(RemeshLosses& losses, Progress& progress) {
    constexpr double far_share = 0.05;  // of the model's diagonal
    const double diagonal = implicit::bounds(mesh().positions).size().norm();
    const std::vector<Index> far =
        far_from_scan(result_.mesh, mesh(), view(), far_share * diagonal, threads(), progress);
    if (far.empty()) return;
    result_.checks.far_points = far.size();
    result_.checks.far_share = share_of_faces_at(result_.mesh, far);
    losses.far_at = result_.mesh.positions[far.front()];
    for (const Index v : far)
      if (marks_.hole[v] != no_index) losses.far_holes.push_back(marks_.hole[v]);
    std::ranges::sort(losses.far_holes);
    const auto repeated = std::ranges::unique(losses.far_holes);
    losses.far_holes.erase(repeated.begin(), repeated.end());
  }

  const PolyMesh& given_;
  std::optional<PolyMesh> turned_;
  const RemeshOptions& options_;
  RemeshMemory memory_;
  HoleChoice choice_;
  ViewSeams seams_;
  RemeshPieces pieces_;
  TriangleFans fans_ = TriangleFans(0, {});
  std::vector<Vec3> normals_;  // of the view's vertices
  std::vector<TriangleFans::Link> links_;
  std::vector<Index> patch_of_;                               // per hole
  std::vector<std::pair<std::size_t, Index>> patched_faces_;  // of the result, and their holes
  std::vector<std::int32_t> labels_;                          // patches of the result's faces, -1: none
  std::vector<PieceLosses> losses_;
  std::vector<RefusedPiece> refused_;
  double edge_ = 0;
  HoleMarks marks_;
  std::size_t lost_ = 0, most_domains_ = 0;
  RemeshResult result_;
};

}  // namespace

RemeshResult remesh_surface(const PolyMesh& mesh, const RemeshOptions& options, Progress& progress) {
  return Remeshing(mesh, options).run(progress);
}

}  // namespace croquis::remeshing
