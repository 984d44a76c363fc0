// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/parameter.h"
#include "croquis/base/text.h"
#include "croquis/geometry/affine3.h"
#include "croquis/operators/attach_text.h"
#include "croquis/operators/drawing_readings.h"
#include "croquis/silhouette/cage.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"
#include "operators/inflate_report.h"
#include "operators/memo_stage_cache.h"
#include "operators/operations.h"

namespace croquis {
namespace {

using silhouette::Options;

/// @throws Error with one E_PARAMETER for every entry that is no index
std::vector<Index> read_swaps(const std::string& text) {
  std::vector<Index> swaps;
  Findings findings;
  for (const std::string_view entry : text_parts(text, ";, ")) {
    if (!read_number(entry, swaps.emplace_back())) {
      findings.push_back(refused_value("swap", entry, "the index of an overlap in the report, such as 0"));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return swaps;
}

void list_inflate_parameters(Options& options, ParameterList& list) {
  list.choice_of(
          "preset", 0, {"auto", "clean", "tablet"},
          "auto for any lines, clean for exact ones that are refused where they cross, tablet for lines drawn by "
          "hand, smoothed.",
          [&](std::size_t preset) { options = Options::of(static_cast<silhouette::Preset>(preset)); })
      .titled("Lines are", {"any", "exact", "drawn by hand"})
      .sets_others();
  list.number("weight-curvature", options.depth.weight_curvature, 1e-3, 1, "",
              "How much bending costs: high gives long gentle arcs.")
      .titled("Smooth arcs", {"wavy", "smooth"});
  list.number("weight-orientation", options.depth.weight_orientation, 1e-3, 1, "",
              "How much tilting costs: high keeps parts flat.")
      .titled("Keep flat", {"tilted", "flat"});
  list.number("weight-distance", options.depth.weight_distance, 1e-3, 1, "",
              "How much depth costs: high keeps parts near the plane.")
      .titled("Keep near the plane", {"deep", "shallow"});
  list.number("min-gap", options.depth.minimum_gap, 0.01, 1, {"× the parts' median radius", ParameterLength::Inner},
              "Least distance between parts in front of one another.")
      .titled("Gap between parts", {"narrow", "wide"});
  list.number("resolution", options.strokes.step, 2, 20, {"‰ of the drawing's diagonal", ParameterLength::Input, 0.001},
              "Spacing of points along the contours: smaller is finer.")
      .titled("Smallest detail", {"fine", "coarse"});
  list.choice("details", options.details.shape, {"lines", "groove", "ridge"},
              "What the lines within a body become, such as a mouth or fur: lines on the surface, grooves cut into it, "
              "or ridges raised from it.")
      .titled("Lines on the body", {"drawn on", "cut in", "raised"});
  list.number("detail-width", options.details.width, 2, 50,
              {"‰ of the drawing's diagonal", ParameterLength::Input, 0.001},
              "How wide grooves and ridges are; they are a quarter as deep.")
      .titled("Line width", {"narrow", "wide"});
  list.list("attach",
            "Objects that are held together where they overlap: auto for all that look it, else pairs: A,B or A,B=K "
            "grow together, K from 0 to 1 being the least distance of their middles in parts of that of touching ones, "
            "0.55 unless said, and A,B=K:R with a seam of radius R, 0 to 1; A,B=rest touch, A,B=apart keep a gap.",
            [&](const std::string& text) {
              AttachText attach = read_attach_text(text);
              options.attach = std::move(attach.pairs);
              options.attach_suggested = attach.suggested;
            })
      .titled("How parts are joined")
      .at(ParameterPlace::Nowhere);
  list.list("swap",
            "Overlaps of tubes, by their index in the report, at which the lower strand comes to the front: a knot "
            "becomes another one.",
            [&](const std::string& text) { options.swaps = read_swaps(text); })
      .titled("Overlaps swapped")
      .at(ParameterPlace::Nowhere);
  list.choice(
          "crossings", options.strokes.crossings, {"front", "refuse"},
          "Outlines that cross in full view: the closed line drawn later lies in front, or they are refused, as the "
          "preset clean does.")
      .or_preset()
      .titled("Outlines that cross")
      .at(ParameterPlace::Nowhere);
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

/// A drawing as it was read, and what became of it.
struct ReadDrawing {
  silhouette::LabelledDrawing labelled;
  silhouette::CagedSolid made;

  Findings findings() const {
    Findings all = labelled.findings;
    all.insert(all.end(), made.solid.findings.begin(), made.solid.findings.end());
    return all;
  }
};

/// @param rings of the cage; 0: none is made
ReadDrawing read_and_inflate(const Drawing& drawing, Options options, double rings, Context& context) {
  options.quality = context.quality == Quality::Draft ? silhouette::Quality::Draft : silhouette::Quality::Final;
  MemoStageCache cache(context.memo);
  if (context.memo != nullptr) options.cache = &cache;
  ReadDrawing read;
  Progress labelling = context.progress.step("label", 0.3);
  read.labelled = silhouette::label(drawing, options, labelling);
  Progress inflating = context.progress.step("inflate", 0.7);
  if (rings > 0) {
    read.made = silhouette::inflate_with_cage(read.labelled, drawing, options, rings, inflating);
  } else {
    read.made.solid = silhouette::inflate(read.labelled, drawing, options, inflating);
  }
  return read;
}

OperationResult compute_inflate(const Values& inputs, Options options, Context& context) {
  const Drawing& drawing = inputs.at("drawing").get<Drawing>();
  ReadDrawing read = read_and_inflate(drawing, std::move(options), 0, context);
  silhouette::Solid& solid = read.made.solid;
  OperationResult result;
  result.warnings = read.findings();
  InflateResult details = result_of_inflating(drawing, read.labelled, solid);
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.outputs["labels"] = std::make_shared<const Drawing>(label_drawing(drawing, read.labelled, details.arcs));
  result.details = std::move(details);
  result.outputs["skeleton"] = on_plane(std::move(solid.skeleton), drawing.plane);
  result.outputs["lines"] = on_plane(polylines(solid.lines), drawing.plane);
  result.outputs["mesh"] = on_plane(std::move(solid.mesh), drawing.plane);
  return result;
}

struct CageSettings {
  Options options;
  double rings = 1.3;
};

void list_cage_parameters(CageSettings& settings, ParameterList& list) {
  list_inflate_parameters(settings.options, list);
  list.number("rings", settings.rings, 0.3, 3, {"× the local radius", ParameterLength::Inner},
              "Distance of the rings of quads that run around limbs.")
      .titled("Rings", {"close", "wide"});
}

OperationResult compute_cage(const Values& inputs, CageSettings settings, Context& context) {
  const Drawing& drawing = inputs.at("drawing").get<Drawing>();
  ReadDrawing read = read_and_inflate(drawing, std::move(settings.options), settings.rings, context);
  silhouette::QuadCage& cage = read.made.cage;
  OperationResult result;
  result.warnings = read.findings();
  Report details = Report::object();
  const std::size_t faces = cage.mesh.face_count();
  details.set("faces", faces).set("quads", faces).set("caps", cage.caps).set("shells", cage.shells);
  details.set("mirror", cage.mirror).set("silhouette_iou", cage.silhouette_iou);
  result.outputs["details"] = std::make_shared<const Report>(std::move(details));
  result.outputs["mesh"] = on_plane(std::move(cage.mesh), drawing.plane);
  return result;
}

}  // namespace

silhouette::DrawingReadings readings_of(const Drawing& drawing, const ParameterValues& parameters) {
  Options options = settings_of<Options>(list_inflate_parameters,
                                         complete(parameters_of<Options>(list_inflate_parameters), parameters));
  if (!options.swaps.empty()) {
    throw Error(refused_value("swap", text_of(parameters, "swap"),
                              "nothing where other readings are asked for, in which overlaps have other numbers"));
  }
  return {drawing, std::move(options)};
}

std::unique_ptr<const Operation> cage_operation() {
  return operation_of(
      {"cage",
       1,
       "Quad Cage",
       "Turns drawn contours into a coarse control mesh of quads, whose subdivision surface is close to their solids.",
       {{"drawing", ValueType::Drawing, "The visible contours; a line stops where it passes behind something."}},
       {{"mesh", ValueType::Mesh, "Quads only: closed, one surface per object, with rings around limbs."},
        {"details", ValueType::Report, "Counts, symmetry, and how well the outline is kept."}}},
      list_cage_parameters, compute_cage);
}

std::unique_ptr<const Operation> inflate_operation() {
  return operation_of(
      {"inflate",
       1,
       "Solid",
       "Turns drawn contours, whose parts may hide each other, into closed solids.",
       {{"drawing", ValueType::Drawing, "The visible contours; a line stops where it passes behind something."}},
       {{"mesh", ValueType::Mesh, "The solids: closed, in the drawn order, free of self-intersection.", true},
        {"labels", ValueType::Drawing, "Every contour, hidden parts included, cut where contours cross."},
        {"skeleton", ValueType::Mesh, "The skeleton in space, as polylines."},
        {"lines", ValueType::Mesh, "Drawn lines on the surface, as polylines."},
        {"details", ValueType::Report, "Counts and figures of every stage."}}},
      list_inflate_parameters, compute_inflate);
}

}  // namespace croquis
