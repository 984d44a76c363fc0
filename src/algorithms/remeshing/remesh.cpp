// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/remeshing/remesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "algorithms/remeshing/attributes.h"
#include "algorithms/remeshing/field.h"
#include "algorithms/remeshing/findings.h"
#include "algorithms/remeshing/flat_faces.h"
#include "algorithms/remeshing/memory.h"
#include "algorithms/remeshing/shape.h"
#include "algorithms/remeshing/surface_parts.h"
#include "algorithms/remeshing/union.h"
#include "algorithms/remeshing/united_solid.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double far_from_all = 0.05;  // of the model's diagonal

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
    memory_.require_limit();
    result_.predicted_bytes = whole_bytes(memory_.most());
    result_.predicted_faces = whole_bytes(memory_.faces());
    result_.coarsening = memory_.coarsening();
    analyse(progress.step("analyse holes", 0.06));
    choose();
    {
      Progress preparing = progress.step("normals", 0.04);
      const TriangleFans fans(mesh().vertex_count(), flat_corners(view().triangles));
      const std::vector<Vec3> normals = vertex_normals(mesh(), result_.analysis, fans, pieces_, threads(), preparing);
      const std::vector<TriangleFans::Link> links = fans.links(threads(), preparing);
      const RemeshModel model{mesh(), result_.analysis, options_, pieces_, normals, fans, links,
                              edge_,  cell(),           memory_};
      Progress making = progress.step("make about " + std::to_string(result_.predicted_faces) + " faces", 0.8);
      const double whole = options_.adaptive > 0 ? 0.7 : 1;
      Progress shaping = making.step("make pieces", whole * 0.9);
      std::vector<PieceShape> shapes = make_shapes(model, shaping);
      JoinedShapes joined = join_shapes(model, shapes, making.step("join pieces", whole * 0.07));
      for (const RefusedPiece& left : joined.left_out) refuse(left);
      result_.mesh = std::move(joined.mesh);
      result_.checks.self_intersections = joined.cuts;
      result_.checks.piece_crossings = joined.crossings;
      result_.checks.united_pieces = joined.united;
      take_result(model, joined.parts, shapes, making.step("carry over attributes", whole * 0.03));
      result_.full_faces = result_.mesh.face_count();
      if (options_.adaptive > 0 && result_.full_faces > 0) {
        MergedFaces merged =
            merge_flat_faces(model, result_.mesh, joined.parts, shapes, labels_, making.step("merge flat faces", 0.3));
        keep_values(merged.vertex_of, merged.face_of, result_.mesh.channels, marks_, labels_);
        merged.mesh.channels = std::move(result_.mesh.channels);
        result_.mesh = std::move(merged.mesh);
      }
    }
    losses_.left_out = pieces_.left_out;
    losses_.cell = options_.cell;
    require_faces(result_.mesh, losses_);
    mark();
    check(progress.step("verify", 0.09));
    find_far(progress.step("compare with the scan", 0.01));
    result_.warnings = remesh_findings(mesh(), result_, losses_);
    progress.report(1);
    return std::move(result_);
  }

 private:
  /// Of the holes and of the views; those that look the other way are turned over first.
  void analyse(Progress progress) {
    result_.analysis = analyse_holes(given_, progress, options_.fill.analysis);
    edge_ = typical_edge(given_, view());
    if (options_.fill.preset == Preset::Paper) return;
    seams_ = find_view_seams(given_, result_.analysis, options_.fill.requests, edge_);
    if (seams_.turned.empty()) return;
    result_.checks.turned_views = seams_.turned.size();
    turned_ = with_turned(given_, view(), seams_.turned);
    result_.analysis = analyse_holes(*turned_, progress, options_.fill.analysis);
    seams_ = find_view_seams(*turned_, result_.analysis, options_.fill.requests, edge_);
  }

  /// Borders of views that go on in others aren't what the selection leaves open: what all of them leave open is.
  void choose() {
    const FillOptions& fill = options_.fill;
    const std::vector<Hole>& holes = result_.analysis.holes;
    choice_ = choose_holes(holes, fill);
    if (fill.selection == Selection::Inner && fill.only.empty()) {
      for (const Hole& hole : holes)
        if (hole.kind == HoleClass::Outer && seams_.are_along(hole.id)) choice_.is_chosen[hole.id] = true;
    }
    pieces_ = make_pieces(mesh(), result_.analysis, choice_, seams_, options_);
    number_patches();
    result_.outcomes.resize(holes.size());
    for (std::size_t h = 0; h < holes.size(); ++h) {
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

  /// Holes that one sheet closes have one patch.
  void number_patches() {
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

  /// Pieces whose surface doesn't represent them are left out.
  std::vector<PieceShape> make_shapes(const RemeshModel& model, Progress& progress) {
    std::vector<PieceShape> shapes;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      const RemeshPiece& piece = pieces_.pieces[p];
      PieceShape& shape =
          shapes.emplace_back(make_shape(model, p, progress.step("make pieces", model.share_of(piece))));
      result_.slabs = std::max(result_.slabs, shape.slabs);
      if (shape.mesh.face_count() > 0 && shape.lost_share > most_lost) {
        const Index at = piece.vertices[shape.lost.empty() ? 0 : shape.lost.front()];
        refuse({p, shape.lost_share, RefusedPiece::no_piece, mesh().positions[at]});
        shape = {};
        continue;
      }
      note_holes(p, shape);
      if (shape.mesh.face_count() > 0)
        note_faults(p, shape);
      else
        ++losses_.pieces;
      if (shape.domains.fitted > 0) count_domains(shape.domains);
    }
    return shapes;
  }

  void refuse(const RefusedPiece& refused) {
    losses_.refused.push_back(refused);
    for (const Index hole : pieces_.pieces[refused.piece].chosen_holes())
      leave_open(hole, FillAction::Failed, piece_left_out);
  }

  void leave_open(Index hole, FillAction action, const char* reason) {
    if (hole == no_index) return;
    HoleOutcome& outcome = result_.outcomes[hole];
    outcome.action = action;
    outcome.reason = reason;
    outcome.method.clear();
    outcome.confidence = 0;
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

  /// What became of a piece's holes, and of its views.
  void note_holes(std::size_t piece, const PieceShape& shape) {
    for (const Opening& opening : shape.openings.loops)
      leave_open(opening.hole, FillAction::Failed, "neither the field nor a patch closes it");
    for (const Index hole : shape.openings.left) leave_open(hole, FillAction::Leave, "the border of the joined views");
    for (const auto& [opening, patch] : shape.patched.closed) {
      const bool is_of_field = opening.rule == RimRule::Field;
      if (is_of_field) ++result_.checks.repaired_loops;
      if (opening.hole == no_index) continue;
      HoleOutcome& outcome = result_.outcomes[opening.hole];
      const bool is_meant = opening.rule == RimRule::Patch || opening.rule == RimRule::Left;
      outcome.method = is_meant ? patch.method : "remesh-patched";
      if (is_of_field) outcome.reason = "the new surface left an opening there";
      outcome.confidence = std::min(outcome.confidence, patch.confidence);
    }
    for (const Index hole : shape.left_to_patches) {  // small ones are closed by what reaches over their rims
      HoleOutcome& outcome = result_.outcomes[hole];
      if (outcome.action == FillAction::Fill && outcome.method != "remesh")
        outcome.reason = "the new surface leads far from the scan there";
    }
    result_.checks.failed_loops += shape.openings.loops.size();
    const RemeshPiece& joined = pieces_.pieces[piece];
    if (joined.views > joined.islands + 1) result_.checks.joined_views += joined.views - joined.islands;
  }

  /// Whether a piece isn't what it should be, and where.
  void note_faults(std::size_t piece, const PieceShape& shape) {
    result_.checks.lost_points += shape.lost.size();
    result_.checks.loose_points += shape.loose.size();
    if (shape.lost.empty() && !shape.differs(true) && shape.loose.empty() && !shape.change.any()) return;
    PieceFaults& faults = losses_.faults.emplace_back();
    faults.piece = piece;
    faults.retried = shape.retried;
    faults.lost_points = shape.lost.size();
    faults.loose_vertices = shape.loose.size();
    faults.made = shape.topology;
    if (shape.differs(true)) faults.expected = shape.expected;
    faults.change = shape.change;
    faults.at = shape.lost.empty() ? place_of_smallest_part(shape.mesh)
                                   : mesh().positions[pieces_.pieces[piece].vertices[shape.lost.front()]];
  }

  /// What a solid of several pieces lost on top of that; and whether what came out in the end has parts, handles or a
  /// volume that its pieces don't explain.
  void note_faults(const RemeshPart& part, const std::vector<PieceShape>& shapes, Progress& progress) {
    const std::size_t first = part.pieces.front();
    if (part.lost > 0) {
      result_.checks.lost_points += part.lost;
      PieceFaults& lost = losses_.faults.emplace_back();
      lost.piece = first;
      lost.at = part.lost_at;
      lost.retried = true;
      lost.lost_points = part.lost;
    }
    if (part.vertex_count == 0) return;
    PieceFaults faults;
    faults.piece = first;
    faults.at = result_.mesh.positions[part.first_vertex];
    faults.together = part.pieces.size();
    faults.made = shapes[first].topology;
    if (part.is_solid) {
      const PolyMesh solid = surface_of(part, result_.mesh);
      faults.made = topology_of(solid, threads(), progress.silent());
      std::vector<std::optional<double>> volumes;
      for (const std::size_t piece : part.pieces) volumes.push_back(shapes[piece].volume);
      faults.change = change_of_solid(volumes, solid, cell());
    }
    const std::optional<ExpectedTopology>& expected = shapes[first].expected;
    if (part.pieces.size() == 1 && expected && !expected->is_clear && difference(faults.made, expected->topology) > 0)
      faults.expected = expected;
    if (faults.expected || faults.change.any()) losses_.faults.push_back(faults);
  }

  /// Values of vertices and faces of the joined mesh, and what is wrong with its parts.
  void take_result(const RemeshModel& model, const std::vector<RemeshPart>& parts,
                   const std::vector<PieceShape>& shapes, Progress progress) {
    const std::size_t vertices = result_.mesh.vertex_count();
    result_.mesh.channels = channels_like(mesh(), vertices);
    marks_.hole.assign(vertices, no_index);
    marks_.confidence.assign(vertices, 1);
    for (const RemeshPart& part : parts) {
      note_faults(part, shapes, progress);
      transfer_to(model, part, progress);
    }
    if (result_.mesh.face_count() == 0) return;  // refused in the end
    compute_normals(result_.mesh, threads(), progress);
    label_faces(parts);
  }

  /// Values of vertices, and which of them lie in holes.
  void transfer_to(const RemeshModel& model, const RemeshPart& part, Progress& progress) {
    const double share = static_cast<double>(part.vertex_count) / static_cast<double>(result_.mesh.vertex_count() + 1);
    for (const std::size_t number : part.pieces) {
      const RemeshPiece& piece = pieces_.pieces[number];
      Progress transferring = progress.step("carry over attributes", share / static_cast<double>(part.pieces.size()));
      if (result_.mesh.channels.empty() && piece.chosen_holes().empty()) continue;
      const RemeshPoints points = model.points_of(piece);
      const NearestScan nearest(mesh(), view(), model.fans, piece, points, threads());
      transfer(result_.mesh, part, number, nearest, result_.analysis, pieces_, cell(), marks_, transferring);
    }
  }

  /// The patch of every face, and the least confidence of every hole's vertices.
  void label_faces(const std::vector<RemeshPart>& parts) {
    const PolyMesh& made = result_.mesh;
    for (std::size_t v = 0; v < made.vertex_count(); ++v) {
      if (marks_.hole[v] == no_index) continue;
      HoleOutcome& outcome = result_.outcomes[marks_.hole[v]];
      outcome.confidence = std::min(outcome.confidence, static_cast<double>(marks_.confidence[v]));
    }
    labels_.assign(made.face_count(), -1);
    const auto put = [&](std::size_t face, Index hole) { labels_[face] = static_cast<std::int32_t>(patch_of_[hole]); };
    for (const RemeshPart& part : parts)
      for (const auto& [face, hole] : part.patched) put(face, hole);
    for (std::size_t f = 0; f < labels_.size(); ++f) {
      const auto face = made.face(f);
      const auto in_hole = std::ranges::count_if(face, [&](Index v) { return marks_.hole[v] != no_index; });
      if (in_hole < 2 || labels_[f] >= 0) continue;
      put(f, std::min({marks_.hole[face[0]], marks_.hole[face[1]], marks_.hole[face[2]]}));
    }
  }

  /// Channels "confidence" and "patch_id", and the patches' values in outcomes.
  void mark() {
    const auto first_of_patch = [&](Index patch) -> HoleOutcome& {
      return result_.outcomes[static_cast<std::size_t>(std::ranges::find(patch_of_, patch) - patch_of_.begin())];
    };
    PolyMesh& made = result_.mesh;
    for (const Index hole : marks_.hole)
      if (hole != no_index) ++first_of_patch(patch_of_[hole]).new_vertices;
    for (const std::int32_t label : labels_)
      if (label >= 0) ++first_of_patch(static_cast<Index>(label)).new_faces;
    measure_patches(made, labels_, patch_of_, result_.outcomes);
    if (!options_.fill.mark_patches) return;
    made.channels.push_back({"confidence", Domain::Vertex, 1, std::move(marks_.confidence), {}});
    made.channels.push_back({patch_channel, Domain::Face, 1, std::move(labels_), {}});
  }

  void check(Progress progress) {
    const PolyMesh& made = result_.mesh;
    const TriangleFans fans(made.vertex_count(), made.corners);
    const std::vector<TriangleFans::Link> links = fans.links(threads(), progress);
    result_.checks.manifold = std::ranges::find(links, TriangleFans::Link::Broken) == links.end();
    result_.checks.components = part_count(made);
    result_.checks.open_loops = open_loop_count(fans, links);
  }

  /// What of the result has no scan near to it.
  void find_far(Progress progress) {
    const double distance = far_from_all * implicit::bounds(mesh().positions).size().norm();
    const std::vector<Index> far = far_from_scan(result_.mesh, mesh(), view(), distance, threads(), progress);
    if (far.empty()) return;
    result_.checks.far_points = far.size();
    result_.checks.far_share = share_of_faces_at(result_.mesh, far);
    losses_.far_at = result_.mesh.positions[far.front()];
    std::vector<Index>& holes = losses_.far_holes;
    for (const Index v : far)
      if (marks_.hole[v] != no_index) holes.push_back(marks_.hole[v]);
    std::ranges::sort(holes);
    holes.erase(std::unique(holes.begin(), holes.end()), holes.end());
  }

  const SurfaceView& view() const { return result_.analysis.view; }
  int threads() const { return options_.fill.threads; }
  double cell() const { return options_.cell * edge_ * memory_.coarsening(); }

  /// The mesh given, or that with the views turned over that didn't agree with the others.
  const PolyMesh& mesh() const { return turned_ ? *turned_ : given_; }

  const PolyMesh& given_;
  std::optional<PolyMesh> turned_;
  const RemeshOptions& options_;
  RemeshMemory memory_;
  HoleChoice choice_;
  ViewSeams seams_;
  RemeshPieces pieces_;
  std::vector<Index> patch_of_;       // per hole
  std::vector<std::int32_t> labels_;  // patches of the result's faces, -1: none
  RemeshLosses losses_;
  HoleMarks marks_;
  double edge_ = 0;
  std::size_t most_domains_ = 0;
  RemeshResult result_;
};
}  // namespace

RemeshResult remesh_surface(const PolyMesh& mesh, const RemeshOptions& options, Progress& progress) {
  return Remeshing(mesh, options).run(progress);
}

}  // namespace croquis::remeshing
