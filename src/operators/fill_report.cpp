// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace croquis {
namespace {

using hole_filling::DomainPointCounts;
using hole_filling::FillAction;
using hole_filling::Hole;
using hole_filling::HoleChoice;
using hole_filling::HoleOutcome;
using remeshing::RemeshChecks;
using remeshing::RemeshResult;

constexpr double degrees = 180 / std::numbers::pi;

Report text_or_null(const std::string& text) { return text.empty() ? Report() : Report(text); }

Report triple(const Vec3& vector) { return Report::list(std::array{vector.x(), vector.y(), vector.z()}); }

const char* action_word(HoleState state) {
  switch (state) {
    case HoleState::Open: return to_string(FillAction::Leave);
    case HoleState::Filled: return to_string(FillAction::Fill);
    case HoleState::Failed: return to_string(FillAction::Failed);
  }
  return "";
}

HoleState state_of(FillAction action) {
  switch (action) {
    case FillAction::Leave: return HoleState::Open;
    case FillAction::Fill: return HoleState::Filled;
    case FillAction::Failed: return HoleState::Failed;
  }
  return HoleState::Open;
}

std::optional<double> known(double number) { return std::isnan(number) ? std::nullopt : std::optional(number); }

Report number_or_null(const std::optional<double>& number) { return number ? Report(*number) : Report(); }

HoleRow row_of(const Hole& hole, const HoleOutcome& outcome) {
  HoleRow row;
  row.id = hole.id;
  row.kind = hole.kind;
  row.edges = hole.vertices.size();
  row.perimeter = hole.perimeter;
  row.diameter = hole.diameter;
  row.area = hole.area;
  row.state = state_of(outcome.action);
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

Report hole_entry(const HoleRow& hole) {
  Report entry;
  entry.set("id", hole.id)
      .set("class", to_string(hole.kind))
      .set("boundary_edges", hole.edges)
      .set("perimeter", hole.perimeter)
      .set("diameter", hole.diameter)
      .set("area", hole.area)
      .set("action", action_word(hole.state))
      .set("method", text_or_null(hole.method))
      .set("reason", text_or_null(hole.reason))
      .set("max_normal_jump", hole.angle ? Report(*hole.angle * degrees) : Report())
      .set("confidence", number_or_null(hole.confidence))
      .set("at", triple(hole.at))
      .set("normal", triple(hole.normal))
      .set("companions", Report::list(hole.companions))
      .set("patch", hole.patch ? Report(*hole.patch) : Report())
      .set("error_estimate", number_or_null(hole.expected_error));
  return entry;
}

std::size_t count_of(std::span<const HoleRow> holes, HoleState state) {
  return static_cast<std::size_t>(std::ranges::count(holes, state, &HoleRow::state));
}

std::string counted(std::size_t count, const char* what) { return std::to_string(count) + " " + what; }

/// "7 holes: 5 to be filled, 2 left open."
std::string sentence(const FillResult& result) {
  if (result.holes.empty()) return "No holes.";
  const auto count = [&](HoleState state) { return count_of(result.holes, state); };
  std::string text = result.holes.size() == 1 ? "1 hole: " : counted(result.holes.size(), "holes: ");
  text += counted(count(HoleState::Filled), result.listed ? "to be filled" : "filled") + ", " +
          counted(count(HoleState::Open), "left open");
  if (count(HoleState::Failed) > 0) text += ", " + counted(count(HoleState::Failed), "that can't be filled");
  return text + ".";
}

Report points_entry(const DomainPointCounts& counts) {
  Report points;
  return std::move(points.set("min", counts.min).set("median", counts.median).set("max", counts.max));
}

Report checks_of(const RemeshChecks& made) {
  Report checks;
  return std::move(checks.set("manifold", made.manifold)
                       .set("components", made.components)
                       .set("open_loops", made.open_loops)
                       .set("failed_loops", made.failed_loops)
                       .set("repaired_loops", made.repaired_loops)
                       .set("self_intersections", made.self_intersections)
                       .set("far_from_scan", made.far_share));
}

Report checks_of(const FillResult& result) {
  if (result.remeshed) return checks_of(result.remeshed->checks);
  Report checks;
  return std::move(checks.set("outside_unchanged", result.outside_unchanged));
}

}  // namespace

FillResult result_of_filling(std::shared_ptr<const PolyMesh> scan, const hole_filling::FillResult& filled) {
  FillResult result;
  result.holes = rows_of(filled.analysis.holes, filled.outcomes);
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
  result.scan = std::move(scan);
  result.holes = rows_of(made.analysis.holes, made.outcomes);
  result.new_vertices = made.mesh.vertex_count();
  result.new_faces = made.mesh.face_count();
  result.domains = made.domains;
  result.points_per_domain = made.points_per_domain;
  result.remeshed = RemeshFigures{made.predicted_bytes, made.predicted_faces, made.full_faces, made.checks};
  return result;
}

FillResult result_of_listing(std::shared_ptr<const PolyMesh> scan, std::span<const Hole> holes,
                             const HoleChoice& choice) {
  FillResult result;
  result.listed = true;
  result.untouched_vertices = scan->vertex_count();
  result.scan = std::move(scan);
  for (const Hole& hole : holes) {
    HoleOutcome outcome;
    outcome.action = choice.is_chosen[hole.id] ? FillAction::Fill : FillAction::Leave;
    outcome.reason = choice.reason[hole.id];
    result.holes.push_back(row_of(hole, outcome));
  }
  return result;
}

Report to_report(const FillResult& result) {
  const auto& remeshed = result.remeshed;
  Report list = Report::array();
  for (const HoleRow& hole : result.holes) list.push(hole_entry(hole));
  Report details;
  details.set("summary", sentence(result))
      .set("holes", std::move(list))
      .set("domains", result.listed ? Report() : Report(result.domains))
      .set("points_per_domain", result.domains > 0 ? points_entry(result.points_per_domain) : Report())
      .set("new_vertices", result.new_vertices)
      .set("new_faces", result.new_faces)
      .set("untouched_vertices", result.untouched_vertices)
      .set("removed_faces", result.removed_faces)
      .set("closed_rims", result.listed ? std::size_t{0} : count_of(result.holes, HoleState::Filled));
  if (remeshed)
    details.set("predicted_bytes", remeshed->predicted_bytes)
        .set("predicted_faces", remeshed->predicted_faces)
        .set("full_faces", remeshed->full_faces);
  if (!result.listed) details.set("checks", checks_of(result));
  return details;
}

std::size_t byte_size(const FillResult& result) {
  std::size_t bytes = sizeof(FillResult) + result.holes.capacity() * sizeof(HoleRow);
  for (const HoleRow& hole : result.holes) {
    bytes += hole.method.capacity() + hole.reason.capacity() + hole.companions.capacity() * sizeof(Index);
  }
  return bytes;
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
