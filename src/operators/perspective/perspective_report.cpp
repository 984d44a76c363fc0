// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/perspective_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
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

/// Strokes of a loop of curves; the parts of one stroke are named once.
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

/// Finite ones as [x, y]; those at infinity as null.
Report vanishing_point_list(const PerspectiveResult& result) {
  Report list = Report::array();
  for (const Vec3& point : result.vanishing_points) {
    const bool is_finite = std::abs(point.z()) > 1e-12 * point.head<2>().norm();
    list.push(is_finite ? to_report(Vec2(point.head<2>() / point.z())) : Report());
  }
  return list;
}

Report residual_list(const PerspectiveResult& result) {
  Report list = Report::object();
  for (const PerspectiveStrokeResult& stroke : result.strokes) {
    if (stroke.residual) list.set(stroke.id, *stroke.residual);
  }
  return list;
}

Report use_list(const PerspectiveResult& result) {
  Report::Object members;
  for (const PerspectiveStrokeResult& stroke : result.strokes) {
    members.emplace_back(stroke.id, stroke.used ? "used" : "flagged");
  }
  return Report::of_members(std::move(members));
}

std::string summary_of(const PerspectiveResult& result) {
  const auto counted = [](std::size_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  };
  return std::to_string(result.mode) + "-point perspective, " + counted(result.edge_strokes, "edge") + ", " +
         counted(result.faces.size(), "face") + ", " + (result.closed ? "closed" : "not closed");
}

/// The strokes along a patch's sides; null where none was drawn.
Report side_list(const Brep& brep, const BrepFace& face, std::size_t patch,
                 const std::vector<std::string>& stroke_of_curve) {
  const std::vector<Index> halves = brep.around(face.loops.front());
  const auto stroke = [&](Index half) {
    const Index curve = brep.edges[brep.half_edges[half].edge].curve;
    return curve == no_index ? Report() : Report(stroke_of_curve[curve]);
  };
  Report sides = Report::array();
  if (face.patches.size() > 1) {
    const std::size_t before = (patch + halves.size() - 1) % halves.size();
    return sides.push(stroke(halves[patch])), sides.push(Report()), sides.push(Report()),
           sides.push(stroke(halves[before])), sides;
  }
  for (const Index half : halves) sides.push(stroke(half));
  return sides;
}

Report point_list(const GregoryPatch& patch) {
  Report points = Report::array();
  for (const Vec3& point : patch.boundary) points.push(to_report(point));
  for (const Vec3& point : patch.inner) points.push(to_report(point));
  return points;
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

Report to_report(const PerspectiveResult& result) {
  const Camera& camera = result.camera;
  return to_report(fields(
      named("summary", summary_of(result)), named("mode", result.mode), named("eye", camera.eye),
      named("focal_length", camera.focal_length), named("focal_length_deviation", result.focal_deviation),
      named("principal_point", camera.principal_point), named("principal_point_deviation", result.principal_deviation),
      named("vanishing_points", vanishing_point_list(result)), named("line_residuals", residual_list(result)),
      named("vertices", result.corners), named("curves", result.edge_strokes), named("faces", result.faces),
      named("internal_faces_rejected", result.internal_faces_rejected),
      named("alternatives", result.alternatives.size()), named("shells", result.shells), named("closed", result.closed),
      named("strokes", use_list(result)), named("max_reprojection_error", result.max_reprojection_error),
      named("max_g1_angle_degrees", result.max_g1_angle * 180 / std::numbers::pi)));
}

Report patch_report(const Brep& brep, const std::vector<PerspectiveFace>& faces,
                    const std::vector<std::string>& stroke_of_curve) {
  Report patches = Report::array(), planes = Report::array();
  for (const BrepFace& face : brep.faces) {
    const PerspectiveFace& outline = faces[face.outline];
    for (std::size_t k = 0; k < face.patches.size(); ++k)
      patches.push(
          to_report(fields(named("face", outline.id), named("strokes", side_list(brep, face, k, stroke_of_curve)),
                           named("points", point_list(face.patches[k])))));
    if (face.planar)
      planes.push(to_report(fields(named("face", outline.id), named("origin", face.origin),
                                   named("normal", face.normal), named("loops", outline.strokes))));
  }
  return to_report(fields(named("format", "croquis-patches/1"), named("patches", patches), named("planes", planes)));
}

std::size_t byte_size(const PerspectiveResult& result) {
  std::size_t bytes = sizeof(PerspectiveResult) + result.strokes.capacity() * sizeof(PerspectiveStrokeResult) +
                      result.vertex_places.capacity() * sizeof(Vec2) +
                      result.network.vertices.capacity() * sizeof(Vec3) +
                      result.corners.capacity() * sizeof(PerspectiveCorner);
  for (const NetworkCurve& curve : result.network.curves)
    bytes += sizeof curve + curve.id.capacity() + curve.pieces.capacity() * sizeof(RationalCubic);
  bytes += heap_size(result.faces);
  for (const FaceAlternative& alternative : result.alternatives) bytes += heap_size(alternative.faces);
  return bytes;
}

}  // namespace croquis
