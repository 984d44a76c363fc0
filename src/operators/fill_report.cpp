// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_report.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace croquis {
namespace {

using namespace hole_filling;

constexpr double degrees = 180 / std::numbers::pi;

Report text_or_null(const std::string& text) { return text.empty() ? Report() : Report(text); }

Report hole_entry(const Hole& hole, const HoleOutcome& outcome) {
  const bool has_patch = !outcome.method.empty();
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
      .set("max_normal_jump", has_patch ? Report(outcome.max_normal_jump * degrees) : Report())
      .set("confidence", has_patch ? Report(outcome.confidence) : Report());
  return entry;
}

std::string counted(std::size_t count, const char* what) { return std::to_string(count) + " " + what; }

/// "7 holes: 5 to be filled, 2 left open."
std::string sentence(std::span<const HoleOutcome> outcomes, const char* fill_word) {
  if (outcomes.empty()) return "No holes.";
  const auto count = [&](FillAction action) {
    return static_cast<std::size_t>(std::count_if(
        outcomes.begin(), outcomes.end(), [action](const HoleOutcome& outcome) { return outcome.action == action; }));
  };
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

}  // namespace

Report fill_details(const PolyMesh& scan, const FillResult& result) {
  Report details = details_of(result.analysis.holes, result.outcomes, sentence(result.outcomes, "filled"));
  return std::move(details.set("new_vertices", result.new_vertices)
                       .set("new_faces", result.new_faces)
                       .set("untouched_vertices", scan.vertex_count()));
}

Report list_details(const PolyMesh& scan, std::span<const Hole> holes, const HoleChoice& choice) {
  std::vector<HoleOutcome> outcomes(holes.size());
  for (std::size_t i = 0; i < holes.size(); ++i) {
    outcomes[i].action = choice.is_chosen[i] ? FillAction::Fill : FillAction::Leave;
    outcomes[i].reason = choice.reason[i];
  }
  Report details = details_of(holes, outcomes, sentence(outcomes, "to be filled"));
  return std::move(details.set("new_vertices", 0).set("new_faces", 0).set("untouched_vertices", scan.vertex_count()));
}

}  // namespace croquis
