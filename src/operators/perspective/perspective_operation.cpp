// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <utility>

#include "operators/memo_stage_cache.h"
#include "operators/operations.h"
#include "operators/perspective/perspective_report.h"
#include "operators/perspective/perspective_settings.h"

namespace croquis {
namespace {

void append_findings(Findings& all, const Findings& more) { all.insert(all.end(), more.begin(), more.end()); }

/// The first change that ends a contradiction is made where that is asked for.
ReconstructedNetwork reconstruct(PerspectiveDrawing& drawing, const PerspectiveSettings& settings, Progress& progress) {
  Progress first = progress.step("find the curves", settings.fix ? 0.5 : 1);
  ReconstructedNetwork network = reconstruct_network(drawing, settings.network, first);
  if (!settings.fix) return network;
  const std::vector<ProposedFix> fixes = proposed_fixes(drawing, network.coordinates.contradictions);
  if (fixes.empty()) return network;
  drawing = with_fix(std::move(drawing), fixes.front());
  Progress second = progress.step("find the curves", 0.5);
  return reconstruct_network(drawing, settings.network, second);
}

/// Strokes that parameters leave out are still strokes of the drawing.
void add_ignored(const PerspectiveDrawing& given, const PerspectiveDrawing& solved, Findings& findings) {
  for (const PerspectiveStroke& stroke : given.strokes) {
    if (std::ranges::find(solved.strokes, stroke.id, &PerspectiveStroke::id) != solved.strokes.end()) continue;
    findings.push_back(make_warning(Category::Usage, "STROKE_IGNORED",
                                    "Stroke " + stroke.id + " is left out, as the parameter ignore says.",
                                    {{SubjectKind::Stroke, stroke.id, {}, stroke.line, {}}}));
  }
}

/// In the order of the drawing as given.
void list_all_strokes(const PerspectiveDrawing& given, PerspectiveResult& result) {
  std::vector<PerspectiveStrokeResult> all;
  for (const PerspectiveStroke& stroke : given.strokes) {
    const auto found = std::ranges::find(result.strokes, stroke.id, &PerspectiveStrokeResult::id);
    all.push_back(found != result.strokes.end() ? *found : PerspectiveStrokeResult{stroke.id, false, stroke.group, {}});
  }
  result.strokes = std::move(all);
}

OperationResult compute_perspective(const Values& inputs, PerspectiveSettings settings, Context& context) {
  const auto& given = inputs.at("drawing").get<PerspectiveDrawing>();
  PerspectiveDrawing drawing = with_settings(given, settings);
  settings.network.continuity.angle = settings.solid.continuity.angle = settings.smooth_angle;
  MemoStageCache cache(context.memo);
  if (context.memo != nullptr) settings.network.cache = &cache;

  Progress lifting = context.progress.step("lift", 0.4);
  const ReconstructedNetwork network = reconstruct(drawing, settings, lifting);
  Progress finding = context.progress.step("find the faces", 0.4);
  const FaceFindingResult faces = find_faces(network.curves.network, finding, settings.faces);
  Progress building = context.progress.step("build the solid", 0.2);
  Solid solid = make_solid(network.curves.network, network.fitted, faces.best, building, settings.solid);

  OperationResult result;
  append_findings(result.warnings, network.warnings);
  for (const Findings& found : {faces.warnings, solid.warnings})
    append_findings(result.warnings, findings_of_strokes(found, drawing, network.curves));
  add_ignored(given, drawing, result.warnings);
  PerspectiveResult details = result_of_perspective(drawing, network, faces, solid, result.warnings);
  list_all_strokes(given, details);
  attach_fixes(details.fixes, result.warnings);
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(solid.tessellation.mesh));
  result.outputs["curves"] = std::make_shared<const CurveNetwork>(details.network);
  result.outputs["camera"] = std::make_shared<const Camera>(details.camera);
  std::vector<std::string> stroke_of_curve;
  for (const Index stroke : network.curves.stroke) stroke_of_curve.push_back(drawing.strokes[stroke].id);
  result.outputs["patches"] = std::make_shared<const Report>(patch_report(solid.brep, details.faces, stroke_of_curve));
  result.outputs["solid"] = std::make_shared<const Brep>(std::move(solid.brep));
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.details = std::move(details);
  return result;
}

}  // namespace

std::unique_ptr<const Operation> perspective_operation() {
  PortDescription mesh{"mesh", ValueType::Mesh,
                       "The solid as triangles: along planes and smooth patches, watertight where all edges have two "
                       "faces."};
  mesh.is_closed = true;
  return operation_of(
      {"perspective",
       1,
       "Solid from Perspective",
       "Turns one perspective drawing into a solid: finds the eye, lifts every stroke into space, finds the faces.",
       {{"drawing", ValueType::PerspectiveDrawing, "Strokes with the axis or the plane that each lies along."}},
       {std::move(mesh),
        {"curves", ValueType::CurveNetwork, "Every edge in space."},
        {"camera", ValueType::Camera, "The eye that the drawing was seen from."},
        {"solid", ValueType::Brep, "Faces, edges and vertices with their exact curves and patches."},
        {"patches", ValueType::Report, "The surfaces: planes with loops, Gregory patches with control points."},
        {"details", ValueType::Report, "The camera, every stroke, corners and faces."}}},
      list_perspective_parameters, compute_perspective);
}

}  // namespace croquis
