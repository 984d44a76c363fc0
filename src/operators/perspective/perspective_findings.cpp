// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/perspective_findings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "croquis/perspective/edge_continuity.h"

namespace croquis {
namespace {

/// "parallel to x", "in a plane with normal y".
std::string words_of(StrokeGroup group) {
  const std::string axis(1, "xyz"[axis_of(group)]);
  return is_parallel(group) ? "parallel to " + axis : "in a plane with normal " + axis;
}

/// As reports and files name it.
std::string group_name(StrokeGroup group) {
  return group == StrokeGroup::Unknown ? std::string() : std::to_string(static_cast<int>(group));
}

std::set<std::string> named_strokes_of(const Findings& findings) {
  std::set<std::string> names;
  for (const Finding& finding : findings) {
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == SubjectKind::Stroke) names.insert(subject.id);
    }
  }
  return names;
}

std::vector<PerspectiveStrokeResult> stroke_results(const PerspectiveDrawing& drawing,
                                                    const ReconstructedNetwork& network, const Findings& findings) {
  const std::set<std::string> named = named_strokes_of(findings);
  std::vector<PerspectiveStrokeResult> results;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const std::string& id = drawing.strokes[s].id;
    results.push_back({id, !named.contains(id), network.coordinates.groups[s], std::nullopt});
  }
  for (const VanishingLine& line : network.camera.lines) results[line.stroke].residual = line.residual;
  return results;
}

/// Strokes of a loop of curves; the parts of one stroke are told once.
class StrokeNames {
 public:
  StrokeNames(const PerspectiveDrawing& drawing, const LiftedCurves& curves) : drawing_(drawing), curves_(curves) {}

  const std::string& of_curve(Index curve) const { return drawing_.strokes[curves_.stroke[curve]].id; }

  template <class Curves>
  std::vector<std::string> of_loop(const Curves& loop) const {
    std::vector<std::string> names;
    for (const Index curve : loop) {
      if (names.empty() || names.back() != of_curve(curve)) names.push_back(of_curve(curve));
    }
    if (names.size() > 1 && names.front() == names.back()) names.pop_back();
    return names;
  }

 private:
  const PerspectiveDrawing& drawing_;
  const LiftedCurves& curves_;
};

/// The curves around an outline from a half-edge on, across the edges that divide it.
std::vector<Index> curves_around(const Brep& brep, Index first) {
  std::vector<Index> curves;
  Index half = first;
  do {
    const Index curve = brep.edges[brep.half_edges[half].edge].curve;
    if (curve != no_index) curves.push_back(curve);
    half = curve != no_index ? brep.half_edges[half].next : brep.half_edges[brep.twin(half)].next;
  } while (half != first);
  return curves;
}

Index first_drawn(const Brep& brep, Index loop) {
  for (const Index half : brep.around(loop)) {
    if (brep.edges[brep.half_edges[half].edge].curve != no_index) return half;
  }
  return brep.loops[loop].first;
}

std::vector<PerspectiveFace> faces_of(const Brep& brep, const StrokeNames& names) {
  std::vector<PerspectiveFace> faces;
  for (const BrepFace& face : brep.faces) {
    if (face.outline != faces.size()) break;  // a further part of an outline
    PerspectiveFace made{"f" + std::to_string(faces.size()), {}, face.planar};
    for (const Index loop : face.loops)
      made.strokes.push_back(names.of_loop(curves_around(brep, first_drawn(brep, loop))));
    faces.push_back(std::move(made));
  }
  return faces;
}

FaceAlternative alternative_of(const FaceSet& set, const StrokeNames& names) {
  FaceAlternative alternative;
  for (const NetworkFace& face : set.faces) {
    PerspectiveFace made{"f" + std::to_string(alternative.faces.size()), {}, face.planar};
    for (const CurveLoop& loop : face.loops) {
      std::vector<Index> curves;
      for (const CurveUse& use : loop) curves.push_back(use.curve);
      made.strokes.push_back(names.of_loop(curves));
    }
    alternative.faces.push_back(std::move(made));
  }
  return alternative;
}

/// Names that strokes give to their ends, by vertices of the network.
std::vector<PerspectiveCorner> corners_of(const Brep& brep, const ReconstructedNetwork& network) {
  std::map<Index, std::string> given;
  const auto& vertex = network.curves.vertex;
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    if (vertex[v] != no_index) given[vertex[v]] = network.vertices.vertices[v].name;
  }
  std::vector<PerspectiveCorner> corners;
  for (const BrepVertex& corner : brep.vertices) {
    const auto name = given.find(corner.network_vertex);
    const bool is_named = name != given.end() && !name->second.empty();
    corners.push_back({is_named ? name->second : "v" + std::to_string(corners.size()), corner.point});
  }
  return corners;
}

double greatest_residual(const VertexCoordinates& coordinates) {
  double greatest = 0;
  for (std::size_t v = 0; v < coordinates.residuals.size(); ++v) {
    if (coordinates.in_front[v]) greatest = std::max(greatest, coordinates.residuals[v].norm());
  }
  return greatest;
}

void add_camera(const ReconstructedNetwork& network, PerspectiveResult& result) {
  result.mode = static_cast<int>(network.camera.mode);
  result.camera = network.coordinates.camera;
  for (int axis = 0; axis < 3; ++axis)
    result.vanishing_points[static_cast<std::size_t>(axis)] = network.camera.vanishing_points[axis];
  result.focal_deviation = network.camera.focal_deviation;
  result.principal_deviation = network.camera.principal_deviation;
  result.max_reprojection_error = greatest_residual(network.coordinates);
}

}  // namespace

PerspectiveResult result_of_perspective(const PerspectiveDrawing& drawing, const ReconstructedNetwork& network,
                                        const FaceFindingResult& faces, const Solid& solid, const Findings& findings) {
  PerspectiveResult result;
  add_camera(network, result);
  result.strokes = stroke_results(drawing, network, findings);
  for (const DrawingVertex& vertex : network.vertices.vertices) result.vertex_places.push_back(vertex.position);
  result.network = network.curves.network;
  result.edge_strokes = static_cast<std::size_t>(std::ranges::count_if(
      drawing.strokes, [](const PerspectiveStroke& stroke) { return stroke.role == StrokeRole::Edge; }));
  const StrokeNames names(drawing, network.curves);
  result.corners = corners_of(solid.brep, network);
  result.faces = faces_of(solid.brep, names);
  result.internal_faces_rejected = faces.internal_rejected;
  for (const FaceSet& set : faces.alternatives) result.alternatives.push_back(alternative_of(set, names));
  for (const Index curve : faces.open_curves) result.open_strokes.push_back(names.of_curve(curve));
  result.fixes = proposed_fixes(drawing, network.coordinates.contradictions);
  result.shells = solid.brep.shells.size();
  result.closed = result.shells > 0 && std::ranges::all_of(solid.brep.shells, &BrepShell::closed);
  result.max_g1_angle = greatest_normal_jump(solid.brep);
  return result;
}

std::vector<ProposedFix> proposed_fixes(const PerspectiveDrawing& drawing,
                                        const std::vector<Contradiction>& contradictions) {
  std::vector<ProposedFix> fixes;
  for (const Contradiction& contradiction : contradictions) {
    if (contradiction.fix == StrokeGroup::Unknown) continue;
    const std::string& id = drawing.strokes[contradiction.stroke].id;
    fixes.push_back({id, contradiction.fix, "Draw stroke " + id + ' ' + words_of(contradiction.fix) + "."});
  }
  return fixes;
}

PerspectiveDrawing with_fix(PerspectiveDrawing drawing, const ProposedFix& fix) {
  for (PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.id != fix.stroke) continue;
    stroke.group = fix.group;
    stroke.colour.clear();  // the one of its new group
  }
  return drawing;
}

void attach_fixes(const std::vector<ProposedFix>& fixes, Findings& findings) {
  for (Finding& finding : findings) {
    if (finding.code != "CONTRADICTION" || finding.subjects.empty()) continue;
    const auto fix = std::ranges::find(fixes, finding.subjects.front().id, &ProposedFix::stroke);
    if (fix != fixes.end()) finding.fix = FindingFix{fix->stroke, group_name(fix->group), fix->text};
  }
}

}  // namespace croquis
