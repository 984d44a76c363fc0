// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/surface_patch_operation.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/attribute_surface/rim_patch.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "operators/hole_ids.h"

namespace croquis {
namespace {

using hole_filling::Hole;

std::vector<ParameterDescription> patch_parameters() {
  return {
      list_parameter("only", "Numbers of the holes to close, as the list of fill shows them: 0,3-5; empty for all.")
          .titled("Holes, such as 0,3-5")
          .at(ParameterPlace::Expert),
      integer_parameter("vertex", -1, -1, 4e9, "",
                        "Closes the holes that have this vertex in their rims, counted from 0; -1 for none.")
          .titled("Hole at vertex")
          .at(ParameterPlace::Expert),
      choice_parameter("join", {"smooth", "crease"},
                       "smooth continues the faces around, crease meets them at an angle.")
          .titled("Meets the faces around", {"smoothly", "at an angle"}),
      number_parameter("corner", 40, 0, 180, "degrees", "Rims that turn more have a corner between two sides there.")
          .titled("Corner above"),
      integer_parameter("sides", 0, 0, 12, "",
                        "Sides that a rim is divided into, 3 to 12; 0 for as many as it has corners.")
          .titled("Sides"),
      text_parameter("fullness", "auto",
                     "How far slopes at the rim reach into the patch, -1 to 2; auto finds the height that the rim "
                     "lets expect.")
          .at(ParameterPlace::Expert),
      number_parameter("density", 1, 0.1, 10, "× mean edge of the rim", "Edges inside the patch: smaller is finer.")
          .titled("Edges")};
}

Finding refused(const std::string& parameter, const std::string& sentence) {
  return make_error(Category::Usage, "E_PARAMETER", sentence, {{SubjectKind::Parameter, parameter, {}, {}, {}}});
}

std::optional<double> fullness_of_patch(const std::string& text) {
  if (text == "auto" || text.empty()) return std::nullopt;
  double value = 0;
  if (read_number(text, value) && value >= -1 && value <= 2) return value;
  throw Error(refused("fullness", "'" + text + "' is no value for fullness: it takes auto or a number from -1 to 2."));
}

RimPatchOptions read_options(const ParameterValues& parameters) {
  RimPatchOptions options;
  options.corner = number_of(parameters, "corner") * std::numbers::pi / 180;
  options.sides = static_cast<std::size_t>(integer_of(parameters, "sides"));
  options.smooth = text_of(parameters, "join") == "smooth";
  options.fullness = fullness_of_patch(text_of(parameters, "fullness"));
  options.density = number_of(parameters, "density");
  if (options.sides == 1 || options.sides == 2)
    throw Error(refused("sides", "A patch has 3 to 12 sides; 0 takes as many as the rim has corners."));
  return options;
}

/// The holes that are to be closed, in their order.
std::vector<const Hole*> chosen_holes(const std::vector<Hole>& holes, const ParameterValues& parameters) {
  const std::vector<Index> ids = parse_hole_ids(text_of(parameters, "only"));
  const std::int64_t vertex = integer_of(parameters, "vertex");
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

Report entry_of(const Hole& hole, const RimOutcome& outcome) {
  Report entry;
  entry.set("id", hole.id)
      .set("boundary_edges", hole.vertices.size())
      .set("action", outcome.closed ? "fill" : "failed")
      .set("reason", outcome.reason.empty() ? Report() : Report(outcome.reason))
      .set("sides", outcome.sides)
      .set("faces", outcome.face_count)
      .set("curve_distance", outcome.curve_distance);
  return entry;
}

}  // namespace

OperationDescription SurfacePatchOperation::describe() const {
  return {"surface_patch",
          1,
          "Patch by Curves",
          "Closes holes of a mesh exactly along their rims by attribute surfaces that continue the faces around.",
          {{"mesh", ValueType::Mesh, "A mesh whose faces agree in direction; it isn't changed."}},
          {{"mesh", ValueType::Mesh, "The vertices and faces given, then those of the patches."},
           {"details", ValueType::Report, "Every chosen hole and what became of it."}},
          patch_parameters()};
}

OperationResult SurfacePatchOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                               Context& context) const {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  const RimPatchOptions options = read_options(parameters);
  Progress finding = context.progress.step("find holes", 0.2);
  const hole_filling::HoleAnalysis analysis = hole_filling::analyse_holes(mesh, finding);
  const std::vector<const Hole*> holes = chosen_holes(analysis.holes, parameters);
  std::vector<std::vector<Index>> rims;
  for (const Hole* hole : holes) rims.push_back(hole->vertices);
  Progress patching = context.progress.step("patch", 0.8);
  RimPatches patches = patch_rims(mesh, rims, options, patching);
  OperationResult result;
  result.warnings = analysis.warnings;
  Report list = Report::array();
  std::size_t closed = 0;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const RimOutcome& outcome = patches.outcomes[h];
    list.push(entry_of(*holes[h], outcome));
    closed += outcome.closed ? 1 : 0;
    if (!outcome.closed) result.warnings.push_back(left_open(*holes[h], outcome.reason));
  }
  Report details;
  details.set("summary", std::to_string(closed) + " of " + counted(holes.size(), "hole", "holes") + " closed.")
      .set("holes", std::move(list))
      .set("new_vertices", patches.mesh.vertex_count() - mesh.vertex_count())
      .set("new_faces", patches.mesh.face_count() - mesh.face_count());
  result.outputs["details"] = std::make_shared<const Report>(std::move(details));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(patches.mesh));
  return result;
}

}  // namespace croquis
