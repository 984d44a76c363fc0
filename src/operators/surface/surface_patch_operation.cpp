// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/attribute_surface/rim_patch.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/operators/hole_requests.h"
#include "operators/operations.h"

namespace croquis {
namespace {

using hole_filling::Hole;

Finding refused(const std::string& parameter, const std::string& sentence) {
  return make_error(Category::Usage, "E_PARAMETER", sentence, {{SubjectKind::Parameter, parameter, {}, {}, {}}});
}

struct SurfacePatchSettings {
  RimPatchOptions options;
  std::vector<Index> only;   ///< ids of holes; empty for all
  std::int64_t vertex = -1;  ///< of the rims of all holes that are closed; -1: any
};

std::optional<double> fullness_of_patch(const std::string& text) {
  if (text == "auto" || text.empty()) return std::nullopt;
  double value = 0;
  if (read_number(text, value) && value >= -1 && value <= 2) return value;
  throw Error(refused_value("fullness", text, "auto or a number from -1 to 2"));
}

void list_surface_patch_parameters(SurfacePatchSettings& settings, ParameterList& list) {
  RimPatchOptions& options = settings.options;
  list.list("only", "Numbers of the holes to close, as the list of fill shows them: 0,3-5; empty for all.",
            [&](const std::string& ids) { settings.only = parse_hole_ids(ids); })
      .titled("Holes, such as 0,3-5")
      .at(ParameterPlace::Expert);
  list.integer("vertex", settings.vertex, -1, 4e9, "",
               "Closes the holes that have this vertex in their rims, counted from 0; -1 for none.")
      .titled("Hole at vertex")
      .at(ParameterPlace::Expert);
  list.choice_of("join", 0, {"smooth", "crease"}, "smooth continues the faces around, crease meets them at an angle.",
                 [&](std::size_t chosen) { options.smooth = chosen == 0; })
      .titled("Meets the faces around", {"smoothly", "at an angle"});
  list.angle("corner", options.corner, 0, 180, "Rims that turn more have a corner between two sides there.")
      .titled("Corner above");
  list.integer("sides", options.sides, 0, 12, "",
               "Sides that a rim is divided into, 3 to 12; 0 for as many as it has corners.")
      .titled("Sides")
      .or_else("auto");
  list.text("fullness", "auto",
            "How far slopes at the rim reach into the patch, -1 to 2; auto finds the height that the rim lets expect.",
            [&](const std::string& text) { options.fullness = fullness_of_patch(text); })
      .at(ParameterPlace::Expert);
  list.number("density", options.density, 0.1, 10, {"× mean edge of the rim", ParameterLength::Inner},
              "Edges inside the patch: smaller is finer.")
      .titled("Edges", {"fine", "coarse"});
}

/// The holes that are to be closed, in their order.
std::vector<const Hole*> chosen_holes(const std::vector<Hole>& holes, const SurfacePatchSettings& settings) {
  const auto& [options, ids, vertex] = settings;
  Findings findings;
  for (const Index id : ids) {
    if (id < holes.size()) continue;
    findings.push_back(refused("only", "There is no hole " + std::to_string(id) + ": the mesh has " +
                                           std::to_string(holes.size()) + "; see the list of fill."));
  }
  std::vector<const Hole*> chosen;
  for (const Hole& hole : holes) {
    const bool named = ids.empty() || std::ranges::binary_search(ids, hole.id);
    const bool has_vertex = vertex < 0 || std::ranges::count(hole.vertices, static_cast<Index>(vertex)) > 0;
    if (named && has_vertex) chosen.push_back(&hole);
  }
  if (findings.empty() && vertex >= 0 && chosen.empty())
    findings.push_back(refused("vertex", "Vertex " + std::to_string(vertex) + " is in the rim of no hole."));
  if (!findings.empty()) throw Error(std::move(findings));
  return chosen;
}

Finding left_open(const Hole& hole, const std::string& reason) {
  return make_warning(
      Category::Geometry, "HOLE_LEFT_OPEN",
      "Hole " + std::to_string(hole.id) + " is left open: " + reason +
          "; divide it otherwise (sides, corner), or use fill.",
      {numbered_subject(SubjectKind::Hole, hole.id, {hole.centre.x(), hole.centre.y(), hole.centre.z()})});
}

OperationResult compute_surface_patch(const Values& inputs, SurfacePatchSettings settings, Context& context) {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  if (settings.options.sides == 1 || settings.options.sides == 2)
    throw Error(refused("sides", "A patch has 3 to 12 sides; 0 takes as many as the rim has corners."));
  Progress finding = context.progress.step("find holes", 0.2);
  const hole_filling::HoleAnalysis analysis = hole_filling::analyse_holes(mesh, finding);
  const std::vector<const Hole*> holes = chosen_holes(analysis.holes, settings);
  std::vector<std::vector<Index>> rims;
  for (const Hole* hole : holes) rims.push_back(hole->vertices);
  Progress patching = context.progress.step("patch", 0.8);
  RimPatches patches = patch_rims(mesh, rims, settings.options, patching);
  OperationResult result;
  result.warnings = analysis.warnings;
  Report list = Report::array();
  std::size_t closed = 0;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const RimOutcome& outcome = patches.outcomes[h];
    list.push(to_report(fields(named("id", holes[h]->id), named("boundary_edges", holes[h]->vertices.size()),
                               named("action", outcome.closed ? "fill" : "failed"),
                               named("reason", outcome.reason.empty() ? Report() : Report(outcome.reason)),
                               named("sides", outcome.sides), named("faces", outcome.face_count),
                               named("curve_distance", outcome.curve_distance))));
    closed += outcome.closed ? 1 : 0;
    if (!outcome.closed) result.warnings.push_back(left_open(*holes[h], outcome.reason));
  }
  result.outputs["details"] = std::make_shared<const Report>(to_report(
      fields(named("summary", std::to_string(closed) + " of " + counted(holes.size(), "hole", "holes") + " closed."),
             named("holes", list), named("new_vertices", patches.mesh.vertex_count() - mesh.vertex_count()),
             named("new_faces", patches.mesh.face_count() - mesh.face_count()))));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(patches.mesh));
  return result;
}

}  // namespace

std::unique_ptr<const Operation> surface_patch_operation() {
  return operation_of(
      {"surface_patch",
       1,
       "Patch by Curves",
       "Closes holes of a mesh exactly along their rims by attribute surfaces that continue the faces around.",
       {{"mesh", ValueType::Mesh, "A mesh whose faces agree in direction; it isn't changed."}},
       {{"mesh", ValueType::Mesh, "The vertices and faces given, then those of the patches."},
        {"details", ValueType::Report, "Every chosen hole and what became of it."}}},
      list_surface_patch_parameters, compute_surface_patch);
}

}  // namespace croquis
