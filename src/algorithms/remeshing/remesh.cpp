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

/// A model that is remeshed, and what is known of it so far.
struct Remeshing {
  const PolyMesh& given;
  const RemeshOptions& options;
  RemeshMemory memory{given, options};
  std::optional<PolyMesh> turned = {};  ///< the mesh given with some views turned over, so that all agree
  HoleChoice choice = {};
  ViewSeams seams = {};
  RemeshPieces pieces = {};
  std::vector<Index> patch_of = {};       ///< per hole
  std::vector<std::int32_t> labels = {};  ///< patches of the result's faces, -1: none
  RemeshLosses losses = {};
  HoleMarks marks = {};
  double edge = 0;
  std::size_t most_domains = 0;
  RemeshResult result = {};

  const PolyMesh& mesh() const { return turned ? *turned : given; }
  const SurfaceView& view() const { return result.analysis.view; }
  int threads() const { return options.fill.threads; }
  double cell() const { return options.cell * edge * memory.coarsening(); }
};

/// Of the holes and of the views; those that look the other way are turned over first.
void analyse(Remeshing& work, Progress progress) {
  work.result.analysis = analyse_holes(work.given, progress, work.options.fill.analysis);
  work.edge = typical_edge(work.given, work.view());
  if (work.options.fill.preset == Preset::Paper) return;
  work.seams = find_view_seams(work.given, work.result.analysis, work.options.fill.requests, work.edge);
  if (work.seams.turned.empty()) return;
  work.result.checks.turned_views = work.seams.turned.size();
  work.turned = with_turned(work.given, work.view(), work.seams.turned);
  work.result.analysis = analyse_holes(*work.turned, progress, work.options.fill.analysis);
  work.seams = find_view_seams(*work.turned, work.result.analysis, work.options.fill.requests, work.edge);
}

/// Holes that one sheet closes have one patch.
void number_patches(Remeshing& work) {
  work.patch_of.assign(work.result.analysis.holes.size(), no_index);
  Index number = 0;
  for (const RemeshPiece& piece : work.pieces.pieces) {
    for (const std::vector<Index>& group : piece.groups) {
      for (const Index hole : group) work.patch_of[hole] = number;
      ++number;
    }
    for (const Index hole : piece.caps) work.patch_of[hole] = number++;
    for (const Index hole : piece.seams) work.patch_of[hole] = number++;
  }
}

/// Borders of views that go on in others aren't what the selection leaves open: what all of them leave open is.
void choose(Remeshing& work) {
  const FillOptions& fill = work.options.fill;
  const std::vector<Hole>& holes = work.result.analysis.holes;
  work.choice = choose_holes(holes, fill);
  if (fill.selection == Selection::Inner && fill.only.empty()) {
    for (const Hole& hole : holes)
      if (hole.kind == HoleClass::Outer && work.seams.are_along(hole.id)) work.choice.is_chosen[hole.id] = true;
  }
  work.pieces = make_pieces(work.mesh(), work.result.analysis, work.choice, work.seams, work.options);
  number_patches(work);
  work.result.outcomes.resize(holes.size());
  for (std::size_t h = 0; h < holes.size(); ++h) {
    HoleOutcome& outcome = work.result.outcomes[h];
    outcome.reason = work.choice.reason[h];
    if (!work.choice.is_chosen[h]) continue;
    outcome.action = work.patch_of[h] == no_index ? FillAction::Failed : FillAction::Fill;
    outcome.reason = work.patch_of[h] == no_index ? piece_left_out : "";
    outcome.method = work.patch_of[h] == no_index ? "" : "remesh";
    outcome.patch = work.patch_of[h];
    outcome.confidence = 1;
  }
}

void leave_open(Remeshing& work, Index hole, FillAction action, const char* reason) {
  if (hole == no_index) return;
  HoleOutcome& outcome = work.result.outcomes[hole];
  outcome.action = action;
  outcome.reason = reason;
  outcome.method.clear();
  outcome.confidence = 0;
}

void refuse(Remeshing& work, const RefusedPiece& refused) {
  work.losses.refused.push_back(refused);
  for (const Index hole : work.pieces.pieces[refused.piece].chosen_holes())
    leave_open(work, hole, FillAction::Failed, piece_left_out);
}

/// Counts add up over pieces; the median is that of the piece with most domains.
void count_domains(Remeshing& work, const implicit::DomainReport& report) {
  const std::size_t domains = report.data_domains + report.extra_domains;
  DomainPointCounts& counts = work.result.points_per_domain;
  counts.min = work.result.domains == 0 ? report.min_centres : std::min(counts.min, report.min_centres);
  counts.max = std::max(counts.max, report.max_centres);
  if (domains >= work.most_domains) counts.median = report.median_centres;
  work.most_domains = std::max(work.most_domains, domains);
  work.result.domains += domains;
}

/// What became of a piece's holes, and of its views.
void note_holes(Remeshing& work, std::size_t piece, const PieceShape& shape) {
  for (const Opening& opening : shape.openings.loops)
    leave_open(work, opening.hole, FillAction::Failed, "neither the field nor a patch closes it");
  for (const Index hole : shape.openings.left)
    leave_open(work, hole, FillAction::Leave, "the border of the joined views");
  for (const auto& [opening, patch] : shape.patched.closed) {
    const bool is_of_field = opening.rule == RimRule::Field;
    if (is_of_field) ++work.result.checks.repaired_loops;
    if (opening.hole == no_index) continue;
    HoleOutcome& outcome = work.result.outcomes[opening.hole];
    const bool is_meant = opening.rule == RimRule::Patch || opening.rule == RimRule::Left;
    outcome.method = is_meant ? patch.method : "remesh-patched";
    if (is_of_field) outcome.reason = "the new surface left an opening there";
    outcome.confidence = std::min(outcome.confidence, patch.confidence);
  }
  for (const Index hole : shape.left_to_patches) {  // small ones are closed by what reaches over their rims
    HoleOutcome& outcome = work.result.outcomes[hole];
    if (outcome.action == FillAction::Fill && outcome.method != "remesh")
      outcome.reason = "the new surface leads far from the scan there";
  }
  work.result.checks.failed_loops += shape.openings.loops.size();
  const RemeshPiece& joined = work.pieces.pieces[piece];
  if (joined.views > joined.islands + 1) work.result.checks.joined_views += joined.views - joined.islands;
}

/// Whether a piece isn't what it should be, and where.
void note_faults(Remeshing& work, std::size_t piece, const PieceShape& shape) {
  work.result.checks.lost_points += shape.lost.size();
  work.result.checks.loose_points += shape.loose.size();
  if (shape.lost.empty() && !shape.differs(true) && shape.loose.empty() && !shape.change.any()) return;
  PieceFaults& faults = work.losses.faults.emplace_back();
  faults.piece = piece;
  faults.retried = shape.retried;
  faults.lost_points = shape.lost.size();
  faults.loose_vertices = shape.loose.size();
  faults.made = shape.topology;
  if (shape.differs(true)) faults.expected = shape.expected;
  faults.change = shape.change;
  faults.at = shape.lost.empty() ? place_of_smallest_part(shape.mesh)
                                 : work.mesh().positions[work.pieces.pieces[piece].vertices[shape.lost.front()]];
}

/// What a solid of several pieces lost on top of that; and whether what came out in the end has parts, handles or a
/// volume that its pieces don't explain.
void note_faults(Remeshing& work, const RemeshPart& part, const std::vector<PieceShape>& shapes, Progress& progress) {
  const std::size_t first = part.pieces.front();
  if (part.lost > 0) {
    work.result.checks.lost_points += part.lost;
    PieceFaults& lost = work.losses.faults.emplace_back();
    lost.piece = first;
    lost.at = part.lost_at;
    lost.retried = true;
    lost.lost_points = part.lost;
  }
  if (part.vertex_count == 0) return;
  PieceFaults faults;
  faults.piece = first;
  faults.at = work.result.mesh.positions[part.first_vertex];
  faults.together = part.pieces.size();
  faults.made = shapes[first].topology;
  if (part.is_solid) {
    const PolyMesh solid = surface_of(part, work.result.mesh);
    faults.made = topology_of(solid, work.threads(), progress.silent());
    std::vector<std::optional<double>> volumes;
    for (const std::size_t piece : part.pieces) volumes.push_back(shapes[piece].volume);
    faults.change = change_of_solid(volumes, solid, work.cell());
  }
  const std::optional<ExpectedTopology>& expected = shapes[first].expected;
  if (part.pieces.size() == 1 && expected && !expected->is_clear && difference(faults.made, expected->topology) > 0)
    faults.expected = expected;
  if (faults.expected || faults.change.any()) work.losses.faults.push_back(faults);
}

/// Pieces whose surface doesn't represent them are left out.
std::vector<PieceShape> make_shapes(Remeshing& work, const RemeshModel& model, Progress& progress) {
  std::vector<PieceShape> shapes;
  for (std::size_t p = 0; p < work.pieces.pieces.size(); ++p) {
    const RemeshPiece& piece = work.pieces.pieces[p];
    PieceShape& shape = shapes.emplace_back(make_shape(model, p, progress.step("make pieces", model.share_of(piece))));
    work.result.slabs = std::max(work.result.slabs, shape.slabs);
    if (shape.mesh.face_count() > 0 && shape.lost_share > most_lost) {
      const Index at = piece.vertices[shape.lost.empty() ? 0 : shape.lost.front()];
      refuse(work, {p, shape.lost_share, RefusedPiece::no_piece, work.mesh().positions[at]});
      shape = {};
      continue;
    }
    note_holes(work, p, shape);
    if (shape.mesh.face_count() > 0)
      note_faults(work, p, shape);
    else
      ++work.losses.pieces;
    if (shape.domains.fitted > 0) count_domains(work, shape.domains);
  }
  return shapes;
}

/// Values of vertices, and which of them lie in holes.
void transfer_to(Remeshing& work, const RemeshModel& model, const RemeshPart& part, Progress& progress) {
  const double share =
      static_cast<double>(part.vertex_count) / static_cast<double>(work.result.mesh.vertex_count() + 1);
  for (const std::size_t number : part.pieces) {
    const RemeshPiece& piece = work.pieces.pieces[number];
    Progress transferring = progress.step("carry over attributes", share / static_cast<double>(part.pieces.size()));
    if (work.result.mesh.channels.empty() && piece.chosen_holes().empty()) continue;
    const RemeshPoints points = model.points_of(piece);
    const NearestScan nearest(work.mesh(), work.view(), model.fans, piece, points, work.threads());
    transfer(work.result.mesh, part, number, nearest, work.result.analysis, work.pieces, work.cell(), work.marks,
             transferring);
  }
}

/// The patch of every face, and the least confidence of every hole's vertices.
void label_faces(Remeshing& work, const std::vector<RemeshPart>& parts) {
  const PolyMesh& made = work.result.mesh;
  for (std::size_t v = 0; v < made.vertex_count(); ++v) {
    if (work.marks.hole[v] == no_index) continue;
    HoleOutcome& outcome = work.result.outcomes[work.marks.hole[v]];
    outcome.confidence = std::min(outcome.confidence, static_cast<double>(work.marks.confidence[v]));
  }
  work.labels.assign(made.face_count(), -1);
  const auto put = [&](std::size_t face, Index hole) {
    work.labels[face] = static_cast<std::int32_t>(work.patch_of[hole]);
  };
  for (const RemeshPart& part : parts)
    for (const auto& [face, hole] : part.patched) put(face, hole);
  for (std::size_t f = 0; f < work.labels.size(); ++f) {
    const auto face = made.face(f);
    const auto in_hole = std::ranges::count_if(face, [&](Index v) { return work.marks.hole[v] != no_index; });
    if (in_hole < 2 || work.labels[f] >= 0) continue;
    put(f, std::min({work.marks.hole[face[0]], work.marks.hole[face[1]], work.marks.hole[face[2]]}));
  }
}

/// Values of vertices and faces of the joined mesh, and what is wrong with its parts.
void take_result(Remeshing& work, const RemeshModel& model, const std::vector<RemeshPart>& parts,
                 const std::vector<PieceShape>& shapes, Progress progress) {
  const std::size_t vertices = work.result.mesh.vertex_count();
  work.result.mesh.channels = channels_like(work.mesh(), vertices);
  work.marks.hole.assign(vertices, no_index);
  work.marks.confidence.assign(vertices, 1);
  for (const RemeshPart& part : parts) {
    note_faults(work, part, shapes, progress);
    transfer_to(work, model, part, progress);
  }
  if (work.result.mesh.face_count() == 0) return;  // refused in the end
  compute_normals(work.result.mesh, work.threads(), progress);
  label_faces(work, parts);
}

/// The surfaces of all pieces as one mesh, with its attributes, and with fewer faces where it is flat.
void make_mesh(Remeshing& work, Progress& progress) {
  Progress preparing = progress.step("normals", 0.04);
  const TriangleFans fans(work.mesh().vertex_count(), flat_corners(work.view().triangles));
  const std::vector<Vec3> normals =
      vertex_normals(work.mesh(), work.result.analysis, fans, work.pieces, work.threads(), preparing);
  const std::vector<TriangleFans::Link> links = fans.links(work.threads(), preparing);
  const RemeshModel model{work.mesh(), work.result.analysis, work.options, work.pieces, normals, fans, links,
                          work.edge,   work.cell(),          work.memory};
  Progress making = progress.step("make about " + std::to_string(work.result.predicted_faces) + " faces", 0.8);
  const double whole = work.options.adaptive > 0 ? 0.7 : 1;
  Progress shaping = making.step("make pieces", whole * 0.9);
  std::vector<PieceShape> shapes = make_shapes(work, model, shaping);
  JoinedShapes joined = join_shapes(model, shapes, making.step("join pieces", whole * 0.07));
  for (const RefusedPiece& left : joined.left_out) refuse(work, left);
  work.result.mesh = std::move(joined.mesh);
  work.result.checks.self_intersections = joined.cuts;
  work.result.checks.piece_crossings = joined.crossings;
  work.result.checks.united_pieces = joined.united;
  take_result(work, model, joined.parts, shapes, making.step("carry over attributes", whole * 0.03));
  work.result.full_faces = work.result.mesh.face_count();
  if (work.options.adaptive > 0 && work.result.full_faces > 0) {
    MergedFaces merged = merge_flat_faces(model, work.result.mesh, joined.parts, shapes, work.labels,
                                          making.step("merge flat faces", 0.3));
    keep_values(merged.vertex_of, merged.face_of, work.result.mesh.channels, work.marks, work.labels);
    merged.mesh.channels = std::move(work.result.mesh.channels);
    work.result.mesh = std::move(merged.mesh);
  }
}

/// Channels "confidence" and "patch_id", and the patches' values in outcomes.
void mark(Remeshing& work) {
  const auto first_of_patch = [&](Index patch) -> HoleOutcome& {
    return work.result
        .outcomes[static_cast<std::size_t>(std::ranges::find(work.patch_of, patch) - work.patch_of.begin())];
  };
  PolyMesh& made = work.result.mesh;
  for (const Index hole : work.marks.hole)
    if (hole != no_index) ++first_of_patch(work.patch_of[hole]).new_vertices;
  for (const std::int32_t label : work.labels)
    if (label >= 0) ++first_of_patch(static_cast<Index>(label)).new_faces;
  measure_patches(made, work.labels, work.patch_of, work.result.outcomes);
  if (!work.options.fill.mark_patches) return;
  made.channels.push_back({"confidence", Domain::Vertex, 1, std::move(work.marks.confidence), {}});
  made.channels.push_back({patch_channel, Domain::Face, 1, std::move(work.labels), {}});
}

void check(Remeshing& work, Progress progress) {
  const PolyMesh& made = work.result.mesh;
  const TriangleFans fans(made.vertex_count(), made.corners);
  const std::vector<TriangleFans::Link> links = fans.links(work.threads(), progress);
  work.result.checks.manifold = std::ranges::find(links, TriangleFans::Link::Broken) == links.end();
  work.result.checks.components = part_count(made);
  work.result.checks.open_loops = open_loop_count(fans, links);
}

/// What of the result has no scan near to it.
void find_far(Remeshing& work, Progress progress) {
  const double distance = far_from_all * implicit::bounds(work.mesh().positions).size().norm();
  const std::vector<Index> far =
      far_from_scan(work.result.mesh, work.mesh(), work.view(), distance, work.threads(), progress);
  if (far.empty()) return;
  work.result.checks.far_points = far.size();
  work.result.checks.far_share = share_of_faces_at(work.result.mesh, far);
  work.losses.far_at = work.result.mesh.positions[far.front()];
  std::vector<Index>& holes = work.losses.far_holes;
  for (const Index v : far)
    if (work.marks.hole[v] != no_index) holes.push_back(work.marks.hole[v]);
  std::ranges::sort(holes);
  holes.erase(std::unique(holes.begin(), holes.end()), holes.end());
}

}  // namespace

RemeshResult remesh_surface(const PolyMesh& mesh, const RemeshOptions& options, Progress& progress) {
  Remeshing work{mesh, options};
  require_options(work.options);
  work.memory.require_limit();
  work.result.predicted_bytes = whole_bytes(work.memory.most());
  work.result.predicted_faces = whole_bytes(work.memory.faces());
  work.result.coarsening = work.memory.coarsening();
  analyse(work, progress.step("analyse holes", 0.06));
  choose(work);
  make_mesh(work, progress);
  work.losses.left_out = work.pieces.left_out;
  work.losses.cell = work.options.cell;
  require_faces(work.result.mesh, work.losses);
  mark(work);
  check(work, progress.step("verify", 0.09));
  find_far(work, progress.step("compare with the scan", 0.01));
  work.result.warnings = remesh_findings(work.mesh(), work.result, work.losses);
  progress.report(1);
  return std::move(work.result);
}

}  // namespace croquis::remeshing
