// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/inflate_operation.h"

#include <array>
#include <numeric>
#include <utility>

#include "croquis/geometry/affine3.h"
#include "croquis/operators/attach_text.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"
#include "operators/choice_parameter.h"
#include "operators/inflate_report.h"
#include "operators/memo_stage_cache.h"

namespace croquis {
namespace {

using silhouette::Options;
using silhouette::Preset;

constexpr std::array<const char*, 2> crossings_names = {"front", "refuse"};  // in the order of silhouette::Crossings

constexpr std::array<const char*, 3> detail_names = {"lines", "groove", "ridge"};  // as silhouette::DetailShape

constexpr std::array<const char*, 3> preset_names = {"auto", "clean", "tablet"};  // in the order of silhouette::Preset

/// What hands draw crosses itself; exact lines that cross are a slip.
ParameterDescription inflate_preset_choice() {
  ParameterDescription preset =
      choice_parameter("preset", {preset_names.begin(), preset_names.end()},
                       "auto for any lines, clean for exact ones that are refused where they cross, tablet for lines "
                       "drawn by hand, smoothed.")
          .titled("Lines are", {"any", "exact", "drawn by hand"});
  const auto crossings = static_cast<std::size_t>(Options::of(Preset::Clean).strokes.crossings);
  preset.presets["clean"] = {{"crossings", std::string(crossings_names[crossings])}};
  return preset;
}

std::vector<ParameterDescription> inflate_parameters() {
  const Options defaults;
  const auto weight = [](const std::string& name, double value, const std::string& sentence) {
    return number_parameter("weight-" + name, value, 1e-3, 1.0, "", sentence);
  };
  return {
      inflate_preset_choice(),
      weight("curvature", defaults.depth.weight_curvature, "How much bending costs: high gives long gentle arcs.")
          .titled("Smooth arcs"),
      weight("orientation", defaults.depth.weight_orientation, "How much tilting costs: high keeps parts flat.")
          .titled("Keep flat"),
      weight("distance", defaults.depth.weight_distance, "How much depth costs: high keeps parts near the plane.")
          .titled("Keep near the plane"),
      number_parameter("min-gap", defaults.depth.minimum_gap, 0.01, 1, "× the parts' median radius",
                       "Least distance between parts in front of one another.")
          .titled("Gap between parts"),
      number_parameter("resolution", defaults.strokes.step, 2, 20, "‰ of the drawing's diagonal",
                       "Spacing of points along the contours: smaller is finer.")
          .titled("Smallest detail"),
      choice_parameter("details", {detail_names.begin(), detail_names.end()},
                       "What the lines within a body become, such as a mouth or fur: lines on the surface, grooves cut "
                       "into it, or ridges raised from it.")
          .titled("Lines on the body", {"drawn on", "cut in", "raised"}),
      number_parameter("detail-width", defaults.details.width, 2, 50, "‰ of the drawing's diagonal",
                       "How wide grooves and ridges are; they are a quarter as deep.")
          .titled("Width of cuts and ridges"),
      list_parameter(
          "attach",
          "Objects that are held together where they overlap: auto for all that look it, else pairs: A,B or A,B=K "
          "grow together, K from 0 to 1 being the least distance of their middles in parts of that of touching ones, "
          "0.55 unless said, and A,B=K:R with a seam of radius R, 0 to 1; A,B=rest touch, A,B=apart keep a gap.")
          .titled("How parts are joined")
          .at(ParameterPlace::Nowhere),
      choice_or_preset("crossings", crossings_names,
                       "Outlines that cross in full view: the closed line drawn later lies in front, or they are "
                       "refused, as the preset clean does.")
          .titled("Outlines that cross")
          .at(ParameterPlace::Nowhere)};
}

Options read_inflate_options(const ParameterValues& parameters) {
  Options options = Options::of(named<Preset>(preset_names, text_of(parameters, "preset")));
  options.strokes.step = number_of(parameters, "resolution");
  options.depth.weight_curvature = number_of(parameters, "weight-curvature");
  options.depth.weight_orientation = number_of(parameters, "weight-orientation");
  options.depth.weight_distance = number_of(parameters, "weight-distance");
  options.depth.minimum_gap = number_of(parameters, "min-gap");
  options.details.shape = named<silhouette::DetailShape>(detail_names, text_of(parameters, "details"));
  options.details.width = number_of(parameters, "detail-width");
  options.strokes.crossings = named<silhouette::Crossings>(crossings_names, text_of(parameters, "crossings"));
  AttachText attach = read_attach_text(text_of(parameters, "attach"));
  options.attach = std::move(attach.pairs);
  options.attach_suggested = attach.suggested;
  return options;
}

PolyMesh polylines(const std::vector<silhouette::SurfaceLine>& lines) {
  PolyMesh mesh;
  for (const silhouette::SurfaceLine& line : lines) {
    std::vector<Index> vertices(line.points.size());
    std::iota(vertices.begin(), vertices.end(), static_cast<Index>(mesh.positions.size()));
    mesh.positions.insert(mesh.positions.end(), line.points.begin(), line.points.end());
    mesh.add_line(vertices);
  }
  return mesh;
}

/// Solids are made over the plane z = 0; nothing changes for drawings that lie there.
Value on_plane(PolyMesh mesh, const DrawingPlane& plane) {
  if (!plane.is_default()) mesh = transformed(mesh, frame_of(plane));
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

}  // namespace

OperationDescription InflateOperation::describe() const {
  return {"inflate",
          1,
          "Solid",
          "Turns drawn contours, whose parts may hide each other, into closed solids.",
          {{"drawing", ValueType::Drawing, "The visible contours; a line stops where it passes behind something."}},
          {{"mesh", ValueType::Mesh, "The solids: closed, in the drawn order, free of self-intersection.", true},
           {"labels", ValueType::Drawing, "Every contour, hidden parts included, cut where contours cross."},
           {"skeleton", ValueType::Mesh, "The skeleton in space, as polylines."},
           {"lines", ValueType::Mesh, "Drawn lines on the surface, as polylines."},
           {"details", ValueType::Report, "Counts and figures of every stage."}},
          inflate_parameters()};
}

OperationResult InflateOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                          Context& context) const {
  const Drawing& drawing = inputs.at("drawing").get<Drawing>();
  Options options = read_inflate_options(parameters);
  options.quality = context.quality == Quality::Draft ? silhouette::Quality::Draft : silhouette::Quality::Final;
  MemoStageCache cache(context.memo);
  if (context.memo != nullptr) options.cache = &cache;
  Progress labelling = context.progress.step("label", 0.3);
  const silhouette::LabelledDrawing labelled = silhouette::label(drawing, options, labelling);
  Progress inflating = context.progress.step("inflate", 0.7);
  silhouette::Solid solid = silhouette::inflate(labelled, drawing, options, inflating);

  OperationResult result;
  result.warnings = labelled.findings;
  result.warnings.insert(result.warnings.end(), solid.findings.begin(), solid.findings.end());
  InflateResult details = result_of_inflating(drawing, labelled, solid);
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.outputs["labels"] = std::make_shared<const Drawing>(label_drawing(drawing, labelled, details.arcs));
  result.details = std::move(details);
  result.outputs["skeleton"] = on_plane(std::move(solid.skeleton), drawing.plane);
  result.outputs["lines"] = on_plane(polylines(solid.lines), drawing.plane);
  result.outputs["mesh"] = on_plane(std::move(solid.mesh), drawing.plane);
  return result;
}

}  // namespace croquis
