// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/text.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis {
namespace {

using hole_filling::Hole;
using hole_filling::HoleAnalysis;
using hole_filling::HoleChoice;
using hole_filling::HoleOutcome;
using remeshing::RemeshResult;

std::optional<double> known(double number) { return std::isnan(number) ? std::nullopt : std::optional(number); }

HoleRow row_of(const Hole& hole, const HoleOutcome& outcome) {
  HoleRow row;
  row.id = hole.id;
  row.kind = hole.kind;
  row.edges = hole.vertices.size();
  row.perimeter = hole.perimeter;
  row.diameter = hole.diameter;
  row.area = hole.area;
  row.state = outcome.action;
  row.method = outcome.method;
  row.reason = outcome.reason;
  row.at = hole.centre;
  row.normal = hole.normal;
  row.companions = hole.companions;
  row.expected_error = known(outcome.expected_error);
  if (outcome.patch == no_index) return row;
  row.patch = outcome.patch;
  row.angle = known(outcome.max_normal_jump);
  row.confidence = outcome.confidence;
  return row;
}

std::vector<HoleRow> rows_of(std::span<const Hole> holes, std::span<const HoleOutcome> outcomes) {
  std::vector<HoleRow> rows;
  for (const Hole& hole : holes) rows.push_back(row_of(hole, outcomes[hole.id]));
  return rows;
}

std::size_t count_of(std::span<const HoleRow> holes, FillAction state) {
  return static_cast<std::size_t>(std::ranges::count(holes, state, &HoleRow::state));
}

OpenEdges edges_before(const PolyMesh& scan, const HoleAnalysis& analysis) {
  OpenEdges edges;
  edges.before = edges.after = edges.loose = analysis.view.rim_corners.size();
  for (const Hole& hole : analysis.holes) edges.loose -= hole.vertices.size();
  edges.seams = count_seam_edges(scan, analysis.view);
  return edges;
}

/// "7 holes: 5 to be filled, 2 left open."
std::string hole_sentence(const FillResult& result) {
  if (result.holes.empty()) return "No holes.";
  const std::size_t filled = count_of(result.holes, FillAction::Fill);
  const std::size_t failed = count_of(result.holes, FillAction::Failed);
  return counted(result.holes.size(), "hole: ", "holes: ") + std::to_string(filled) +
         (result.listed ? " to be filled, " : " filled, ") + std::to_string(result.holes.size() - filled) +
         " left open" + (failed > 0 ? ", " + std::to_string(failed) + " of them since no patch is sound." : ".");
}

/// What stays open, whatever it is of, and what only looks open.
std::string edge_sentences(const FillResult& result) {
  const OpenEdges& edges = result.open_edges;
  std::string text;
  if (edges.after > 0 && !result.listed) text += " " + counted(edges.after, "edge stays open.", "edges stay open.");
  if (edges.loose > 0 && !result.remeshed)
    text += " " + counted(edges.loose, "open edge belongs", "open edges belong") +
            " to no hole: the rims end at edges of more than two faces.";
  if (edges.seams > 0)
    text += " " + counted(edges.seams, "edge of a seam counts", "edges of seams count") +
            " as closed: vertices of both sides lie at one place.";
  return text;
}

/// Of a mesh without seams.
std::size_t open_edges_of(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::size_t open = 0;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) open += topology.edge_corners(edge).size() == 1 ? 1U : 0U;
  return open;
}

Report checks_of(const FillResult& result) {
  if (!result.remeshed) return to_report(fields(named("outside_unchanged", result.outside_unchanged)));
  const remeshing::RemeshChecks& made = result.remeshed->checks;
  return to_report(fields(
      named("manifold", made.manifold), named("components", made.components), named("open_loops", made.open_loops),
      named("failed_loops", made.failed_loops), named("repaired_loops", made.repaired_loops),
      named("self_intersections", made.self_intersections), named("far_from_scan", made.far_share)));
}

}  // namespace

FillResult result_of_filling(std::shared_ptr<const PolyMesh> scan, const hole_filling::FillResult& filled) {
  FillResult result;
  result.holes = rows_of(filled.analysis.holes, filled.outcomes);
  result.open_edges = edges_before(*scan, filled.analysis);
  result.open_edges.after = filled.open_edges;
  result.new_vertices = filled.new_vertices;
  result.new_faces = filled.new_faces;
  result.untouched_vertices = scan->vertex_count() - filled.removed_vertices;
  result.removed_faces = filled.removed_faces;
  result.domains = filled.domains;
  result.points_per_domain = filled.points_per_domain;
  result.outside_unchanged = filled.outside_unchanged;
  result.scan = std::move(scan);
  return result;
}

FillResult result_of_remeshing(std::shared_ptr<const PolyMesh> scan, const RemeshResult& made) {
  FillResult result;
  result.holes = rows_of(made.analysis.holes, made.outcomes);
  result.open_edges = edges_before(*scan, made.analysis);
  result.open_edges.after = open_edges_of(made.mesh);
  result.scan = std::move(scan);
  result.new_vertices = made.mesh.vertex_count();
  result.new_faces = made.mesh.face_count();
  result.domains = made.domains;
  result.points_per_domain = made.points_per_domain;
  result.remeshed = RemeshFigures{made.predicted_bytes, made.predicted_faces, made.full_faces, made.checks};
  return result;
}

FillResult result_of_listing(std::shared_ptr<const PolyMesh> scan, const HoleAnalysis& analysis,
                             const HoleChoice& choice) {
  FillResult result;
  result.listed = true;
  result.untouched_vertices = scan->vertex_count();
  result.open_edges = edges_before(*scan, analysis);
  result.scan = std::move(scan);
  for (const Hole& hole : analysis.holes) {
    HoleOutcome outcome;
    outcome.action = choice.is_chosen[hole.id] ? FillAction::Fill : FillAction::Leave;
    outcome.reason = choice.reason[hole.id];
    result.holes.push_back(row_of(hole, outcome));
  }
  return result;
}

Report to_report(const FillResult& result) {
  const hole_filling::DomainPointCounts& points = result.points_per_domain;
  Report details = to_report(fields(
      named("summary", hole_sentence(result) + edge_sentences(result)), named("holes", result.holes),
      named("open_edges", result.open_edges), named("domains", result.listed ? Report() : Report(result.domains)),
      named("points_per_domain",
            result.domains > 0
                ? to_report(fields(named("min", points.min), named("median", points.median), named("max", points.max)))
                : Report()),
      named("new_vertices", result.new_vertices), named("new_faces", result.new_faces),
      named("untouched_vertices", result.untouched_vertices), named("removed_faces", result.removed_faces),
      named("closed_rims", result.listed ? std::size_t{0} : count_of(result.holes, FillAction::Fill))));
  if (const auto& remeshed = result.remeshed)
    details.set("predicted_bytes", remeshed->predicted_bytes)
        .set("predicted_faces", remeshed->predicted_faces)
        .set("full_faces", remeshed->full_faces);
  if (!result.listed) details.set("checks", checks_of(result));
  return details;
}

std::size_t byte_size(const FillResult& result) { return sizeof result + heap_size(result.holes); }

PolyMesh rim_lines(const PolyMesh& scan, std::span<const Hole> holes) {
  PolyMesh rims;
  std::vector<Index> line;
  for (const Hole& hole : holes) {
    line.clear();
    for (const Index vertex : hole.vertices) {
      line.push_back(static_cast<Index>(rims.vertex_count()));
      rims.positions.push_back(scan.positions[vertex]);
    }
    line.push_back(line.front());
    rims.add_line(line);
  }
  return rims;
}

}  // namespace croquis
