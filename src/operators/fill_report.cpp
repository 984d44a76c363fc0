// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace croquis {
namespace {

using namespace hole_filling;
using namespace remeshing;

constexpr double degrees = 180 / std::numbers::pi;

Report text_or_null(const std::string& text) { return text.empty() ? Report() : Report(text); }

Report triple(const Vec3& vector) { return Report::list(std::array{vector.x(), vector.y(), vector.z()}); }

Report hole_entry(const Hole& hole, const HoleOutcome& outcome) {
  const bool has_patch = outcome.patch != no_index;
  Report entry;
  entry.set("id", hole.id)
      .set("class", to_string(hole.kind))
      .set("boundary_edges", hole.vertices.size())
      .set("perimeter", hole.perimeter)
      .set("diameter", hole.diameter)
      .set("area", hole.area)
      .set("action", to_string(outcome.action))
      .set("method", text_or_null(outcome.method))
      .set("reason", text_or_null(outcome.reason))
      .set("max_normal_jump",
           has_patch && !std::isnan(outcome.max_normal_jump) ? Report(outcome.max_normal_jump * degrees) : Report())
      .set("confidence", has_patch ? Report(outcome.confidence) : Report())
      .set("at", triple(hole.centre))
      .set("normal", triple(hole.normal))
      .set("companions", Report::list(hole.companions))
      .set("patch", outcome.patch == no_index ? Report() : Report(outcome.patch))
      .set("error_estimate", std::isnan(outcome.expected_error) ? Report() : Report(outcome.expected_error));
  return entry;
}

std::size_t count_of(std::span<const HoleOutcome> outcomes, FillAction action) {
  return static_cast<std::size_t>(std::count_if(
      outcomes.begin(), outcomes.end(), [action](const HoleOutcome& outcome) { return outcome.action == action; }));
}

std::string counted(std::size_t count, const char* what) { return std::to_string(count) + " " + what; }

/// "7 holes: 5 to be filled, 2 left open."
std::string sentence(std::span<const HoleOutcome> outcomes, const char* fill_word) {
  if (outcomes.empty()) return "No holes.";
  const auto count = [&](FillAction action) { return count_of(outcomes, action); };
  std::string text = outcomes.size() == 1 ? "1 hole: " : counted(outcomes.size(), "holes: ");
  text += counted(count(FillAction::Fill), fill_word) + ", " + counted(count(FillAction::Leave), "left open");
  if (count(FillAction::Failed) > 0) text += ", " + counted(count(FillAction::Failed), "that can't be filled");
  return text + ".";
}

Report details_of(std::span<const Hole> holes, std::span<const HoleOutcome> outcomes, const std::string& summary) {
  Report list = Report::array();
  for (const Hole& hole : holes) list.push(hole_entry(hole, outcomes[hole.id]));
  Report details;
  // Domains are those of one field for the whole model; patches have fits of their own.
  details.set("summary", summary)
      .set("holes", std::move(list))
      .set("domains", Report())
      .set("points_per_domain", Report());
  return details;
}

Report checks_of(const FillResult& result) {
  Report checks;
  return std::move(checks.set("outside_unchanged", result.outside_unchanged));
}

}  // namespace

Report fill_details(const PolyMesh& scan, const FillResult& result) {
  Report details = details_of(result.analysis.holes, result.outcomes, sentence(result.outcomes, "filled"));
  return std::move(details.set("new_vertices", result.new_vertices)
                       .set("new_faces", result.new_faces)
                       .set("untouched_vertices", scan.vertex_count() - result.removed_vertices)
                       .set("removed_faces", result.removed_faces)
                       .set("closed_rims", count_of(result.outcomes, FillAction::Fill))
                       .set("checks", checks_of(result)));
}

Report remesh_details(const RemeshResult& result) {
  const RemeshChecks& made = result.checks;
  const DomainPointCounts& counts = result.points_per_domain;
  Report points, checks;
  points.set("min", counts.min).set("median", counts.median).set("max", counts.max);
  checks.set("manifold", made.manifold)
      .set("components", made.components)
      .set("open_loops", made.open_loops)
      .set("failed_loops", made.failed_loops)
      .set("repaired_loops", made.repaired_loops)
      .set("self_intersections", made.self_intersections);
  Report details = details_of(result.analysis.holes, result.outcomes, sentence(result.outcomes, "filled"));
  return std::move(details.set("domains", result.domains)
                       .set("points_per_domain", std::move(points))
                       .set("new_vertices", result.mesh.vertex_count())
                       .set("new_faces", result.mesh.face_count())
                       .set("untouched_vertices", 0)
                       .set("removed_faces", 0)
                       .set("closed_rims", count_of(result.outcomes, FillAction::Fill))
                       .set("predicted_bytes", result.predicted_bytes)
                       .set("checks", std::move(checks)));
}

Report list_details(const PolyMesh& scan, std::span<const Hole> holes, const HoleChoice& choice) {
  std::vector<HoleOutcome> outcomes(holes.size());
  for (std::size_t i = 0; i < holes.size(); ++i) {
    outcomes[i].action = choice.is_chosen[i] ? FillAction::Fill : FillAction::Leave;
    outcomes[i].reason = choice.reason[i];
  }
  Report details = details_of(holes, outcomes, sentence(outcomes, "to be filled"));
  return std::move(details.set("new_vertices", 0)
                       .set("new_faces", 0)
                       .set("untouched_vertices", scan.vertex_count())
                       .set("removed_faces", 0)
                       .set("closed_rims", 0));
}

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
