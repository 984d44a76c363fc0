// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/depth_findings.h"
#include "algorithms/silhouette/skeleton/object_weights.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_surface.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"
#include "algorithms/silhouette/surface/skeleton_curves.h"
#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

std::vector<Subject> stroke_subjects(const std::vector<Index>& strokes, const Drawing& drawing) {
  std::vector<Subject> subjects;
  for (const Index s : strokes) {
    const Stroke& stroke = drawing.strokes[s];
    Subject subject{SubjectKind::Stroke, stroke.id, {}, stroke.line, {}};
    if (!drawing.file.empty()) subject.file = drawing.file;
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

/// Puts the drawing's solids together, figure by figure.
class SolidBuilder {
 public:
  SolidBuilder(const Drawing& drawing, const Options& options) : drawing_(drawing), options_(options) {
    solid_.diagnostics.minimum_gap = std::numeric_limits<double>::infinity();
    solid_.mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>{}, {}});
  }

  /// One bad figure doesn't stop the others: its errors are kept.
  void add(const LabelledFigure& figure, std::vector<DepthWeights> weights, Progress& progress) {
    try {
      inflate_figure(figure, std::move(weights), progress);
    } catch (const Error& error) {
      for (Finding finding : error.findings()) {
        if (finding.subjects.empty()) finding.subjects = figure_subjects(figure);
        solid_.findings.push_back(std::move(finding));
      }
    }
  }

  Solid take() {
    if (solid_.objects.empty()) {
      if (!has_errors(solid_.findings)) {
        solid_.findings.push_back(
            make_error(Category::Geometry, "E_EMPTY", "The drawing has no closed outline: draw at least one"));
      }
      throw Error(std::move(solid_.findings));
    }
    solid_.diagnostics.silhouette_iou = overlap_.ratio();
    return std::move(solid_);
  }

 private:
  void inflate_figure(const LabelledFigure& figure, std::vector<DepthWeights> weights, Progress& progress) {
    Progress finding_axis = progress.step("skeleton", 0.05);
    Skeleton skeleton = chordal_axis(figure, options_.depth.node_spacing, finding_axis);
    Progress solving = progress.step("depth", 0.1);
    const DepthResult depth = solve_depth(skeleton, figure, {options_.depth, std::move(weights)}, solving);
    Progress inflating = progress.step("inflate", 0.65);
    const InflatedSheets sheets = inflate_sheets(figure, skeleton, options_.depth, inflating);
    Progress checking = progress.step("check", 0.2);
    const std::vector<ObjectSurface> surfaces = object_surfaces(figure, sheets);
    const std::vector<std::string> faults = check(figure, sheets, surfaces, checking);
    add_surfaces(figure, surfaces, faults);
    add_findings(depth_findings(depth, skeleton, figure, drawing_));
    add_diagnostics(skeleton, depth, sheets);
    append_skeleton(skeleton, solid_.skeleton);
  }

  std::vector<std::string> check(const LabelledFigure& figure, const InflatedSheets& sheets,
                                 const std::vector<ObjectSurface>& surfaces, Progress& progress) const {
    std::vector<CertificateInput> inputs;
    for (const ObjectSurface& surface : surfaces) {
      inputs.push_back({&surface.mesh, figure.objects[surface.object].euler_region});
    }
    std::vector<std::string> faults = certify_topology(inputs, progress);
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      progress.check();
      if (!sheets_in_order(sheets, rounding, figure.unit)) {
        certify_apart(inputs, rounding, figure.unit, faults, progress);
      }
    }
    return faults;
  }

  void add_surfaces(const LabelledFigure& figure, const std::vector<ObjectSurface>& surfaces,
                    const std::vector<std::string>& faults) {
    PolyMesh valid;
    std::vector<SidedOutline> outlines;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      const FigureObject& object = figure.objects[surfaces[s].object];
      if (!faults[s].empty()) {
        solid_.findings.push_back(make_error(Category::Geometry, "E_NOT_CERTIFIED",
                                             "The surface of \"" + object.name + "\" " + faults[s] +
                                                 ": draw its lines further apart, or lower the resolution step",
                                             stroke_subjects(object.strokes, drawing_)));
        continue;
      }
      append(surfaces[s].mesh, valid);
      add_object(object, surfaces[s]);
      for (const Index c : object.contours) outlines.push_back({figure.raw_contours[c], figure.contours[c].side});
    }
    const Overlap overlap = silhouette_overlap(valid, outlines);
    overlap_.both += overlap.both;
    overlap_.either += overlap.either;
  }

  void add_object(const FigureObject& object, const ObjectSurface& surface) {
    AttributeChannel& channel = *solid_.mesh.channel("object", Domain::Face);
    const auto number = static_cast<std::int32_t>(channel.labels.size());
    channel.labels.push_back(object.name);
    auto& values = std::get<std::vector<std::int32_t>>(channel.data);
    values.insert(values.end(), surface.mesh.face_count(), number);
    append(surface.mesh, solid_.mesh);
    // certify_topology has counted the mesh's Euler number and found it to be this.
    solid_.objects.push_back({object.name, object.strokes, surface.euler_region, 2 * object.euler_region});
  }

  static void append(const PolyMesh& part, PolyMesh& mesh) {
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (std::size_t f = 0; f < part.face_count(); ++f) {
      const auto face = part.face(f);
      mesh.add_triangle(face[0] + first, face[1] + first, face[2] + first);
    }
  }

  void add_findings(Findings findings) {
    solid_.findings.insert(solid_.findings.end(), findings.begin(), findings.end());
  }

  void add_diagnostics(const Skeleton& skeleton, const DepthResult& depth, const InflatedSheets& sheets) {
    SolidDiagnostics& total = solid_.diagnostics;
    total.skeleton_vertices += skeleton.nodes.size();
    total.collision_constraints += depth.rows;
    total.scale = std::max(total.scale, skeleton.scale);
    total.minimum_gap = std::min(total.minimum_gap, least_gap(sheets));
    total.solver_iterations = std::max({total.solver_iterations, depth.iterations, sheets.iterations});
    total.solver_residual = std::max({total.solver_residual, depth.residual, sheets.residual});
  }

  std::vector<Subject> figure_subjects(const LabelledFigure& figure) const {
    std::vector<Subject> subjects;
    for (const FigureObject& object : figure.objects) {
      const std::vector<Subject> own = stroke_subjects(object.strokes, drawing_);
      subjects.insert(subjects.end(), own.begin(), own.end());
    }
    return subjects;
  }

  const Drawing& drawing_;
  const Options& options_;
  Solid solid_;
  Overlap overlap_;
};

/// Of all figures before any work: a mistyped weight is told at once, and all of them together.
std::vector<std::vector<DepthWeights>> weights_of_figures(const LabelledDrawing& labelled, const Drawing& drawing,
                                                          const Options& options) {
  std::vector<std::vector<DepthWeights>> weights;
  Findings findings;
  for (const LabelledFigure& figure : labelled.figures) {
    try {
      weights.push_back(object_weights(figure, drawing, options.depth));
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return weights;
}

}  // namespace

Solid inflate(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options, Progress& progress) {
  std::vector<std::vector<DepthWeights>> weights = weights_of_figures(labelled, drawing, options);
  double total = 0;
  for (const LabelledFigure& figure : labelled.figures) total += static_cast<double>(figure.points.size());

  SolidBuilder builder(drawing, options);
  for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
    const LabelledFigure& figure = labelled.figures[f];
    Progress part = progress.step("inflate part", static_cast<double>(figure.points.size()) / total);
    builder.add(figure, std::move(weights[f]), part);
  }
  Solid solid = builder.take();
  progress.report(1);
  return solid;
}

}  // namespace croquis::silhouette
