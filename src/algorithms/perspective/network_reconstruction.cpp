// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/network_reconstruction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/focal_from_lengths.h"
#include "algorithms/perspective/coordinates/vertex_splitting.h"
#include "algorithms/perspective/stroke_words.h"
#include "croquis/base/error.h"
#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

/// How often strokes may change their groups and the camera with them.
constexpr int most_calibrations = 3;

/// All that a camera depends on.
StageKey camera_key(const PerspectiveDrawing& drawing, const std::vector<StrokeGroup>& groups,
                    const CameraOptions& options) {
  StageKey key;
  key.add(options).add(drawing.origin).add(drawing.image_size).add(drawing.file);
  key.add(drawing.known_point.has_value());
  if (drawing.known_point) key.add(drawing.known_point->at);
  key.add(drawing.field_of_view.value_or(0)).add(drawing.principal_point.has_value());
  if (drawing.principal_point) key.add(*drawing.principal_point);
  key.add(drawing.strokes.size());
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const PerspectiveStroke& stroke = drawing.strokes[s];
    key.add(groups[s]);
    if (is_parallel(groups[s])) key.add(stroke.id).add(stroke.start()).add(stroke.end()).add(stroke.line.value_or(-1));
  }
  return key;
}

std::size_t bytes_of(const CameraEstimate& estimate) {
  return sizeof estimate + estimate.lines.size() * sizeof(VanishingLine);
}

CameraEstimate cached_camera(const PerspectiveDrawing& drawing, const std::vector<StrokeGroup>& groups,
                             const NetworkReconstructionOptions& options, Progress& progress) {
  return *cached<CameraEstimate>(
      options.cache, "perspective camera", camera_key(drawing, groups, options.camera),
      [&] { return estimate_camera(drawing, groups, options.camera, progress); },
      [](const CameraEstimate& estimate) { return bytes_of(estimate); });
}

/// Groups as drawn; strokes that can't be used have none.
std::vector<StrokeGroup> usable_groups(const PerspectiveDrawing& drawing, const DrawingVertices& vertices) {
  std::vector<StrokeGroup> groups = drawn_groups(drawing);
  for (Index s = 0; s < groups.size(); ++s) {
    if (!vertices.is_used(s)) groups[s] = StrokeGroup::Unknown;
  }
  return groups;
}

/// The drawing with the field of view that known lengths tell, if the lines tell none.
std::optional<PerspectiveDrawing> with_field_of_view(const PerspectiveDrawing& drawing,
                                                     const ReconstructedNetwork& network) {
  if (!network.camera.focal_assumed) return std::nullopt;
  const std::optional<double> focal = focal_from_lengths(drawing, network.vertices, network.coordinates);
  if (!focal) return std::nullopt;
  PerspectiveDrawing known = drawing;
  known.field_of_view = 2 * std::atan(drawing.image_size.x() / 2 / *focal);
  return known;
}

/// The camera, and what strokes are taken for.
struct Calibration {
  CameraEstimate camera;
  std::vector<StrokeGroup> groups;
  std::vector<PromotedStroke> promoted;
};

Calibration calibrated(const PerspectiveDrawing& drawing, const std::vector<StrokeGroup>& drawn,
                       const NetworkReconstructionOptions& options, Progress& progress) {
  Calibration result;
  result.groups = drawn;
  for (int round = 0; round < most_calibrations; ++round) {
    Progress part = progress.step("find the camera", 1.0 / most_calibrations);
    result.camera = options.held_camera ? *options.held_camera : cached_camera(drawing, result.groups, options, part);
    std::vector<PromotedStroke> promoted;
    if (options.coordinates.promote) promoted = promoted_strokes(drawing, drawn, result.camera, options.coordinates);
    const bool settled = promoted == result.promoted;
    result.promoted = std::move(promoted);
    result.groups = drawn;
    for (const PromotedStroke& stroke : result.promoted) result.groups[stroke.stroke] = stroke.group;
    if (settled || options.held_camera) break;
  }
  return result;
}

/// One stroke of a wrong group explains itself; what needs more, or nothing explains, may be two corners at one place.
bool may_need_split(const std::vector<Contradiction>& contradictions) {
  if (contradictions.size() > 1) return true;
  return contradictions.size() == 1 && contradictions[0].fix == StrokeGroup::Unknown;
}

/// Solves for the coordinates. Vertices that turn out to be two corners are divided, if that leaves fewer
/// contradictions.
void solve_with_splits(const PerspectiveDrawing& drawing, const Calibration& calibration,
                       const CoordinateOptions& options, Progress& progress, ReconstructedNetwork& result) {
  const auto solve = [&](const DrawingVertices& vertices) {
    return solve_coordinates(drawing, vertices, result.camera, calibration.groups, calibration.promoted, options,
                             progress);
  };
  result.coordinates = solve(result.vertices);
  if (!may_need_split(result.coordinates.contradictions)) return;
  std::optional<DrawingVertices> divided =
      with_split_vertices(drawing, result.vertices, result.camera, calibration.groups, options, progress);
  if (!divided) return;
  VertexCoordinates trial = solve(*divided);
  if (trial.contradictions.size() >= result.coordinates.contradictions.size()) return;
  result.vertices = std::move(*divided);
  result.coordinates = std::move(trial);
}

/// The ends that somebody fixed, as ends of curves: of a path with corners those of its first and last part.
CurveContinuityOptions with_locks(const PerspectiveDrawing& drawing, const LiftedCurves& curves,
                                  CurveContinuityOptions options) {
  const auto add = [&](EndLock lock, const CurveEnd& end) {
    if (lock == EndLock::Corner) options.corners.push_back(end);
    if (lock == EndLock::Smooth) options.smooth.push_back(end);
  };
  for (Index c = 0; c < curves.stroke.size(); ++c) {
    const Index stroke = curves.stroke[c];
    const bool is_first = c == 0 || curves.stroke[c - 1] != stroke;
    const bool is_last = c + 1 == curves.stroke.size() || curves.stroke[c + 1] != stroke;
    if (is_first) add(drawing.strokes[stroke].start_lock, {c, false});
    if (is_last) add(drawing.strokes[stroke].end_lock, {c, true});
  }
  return options;
}

void append(Findings& all, const Findings& more) { all.insert(all.end(), more.begin(), more.end()); }

std::vector<bool> flagged_strokes(const PerspectiveDrawing& drawing, const Findings& findings) {
  std::set<std::string> names;
  for (const Finding& finding : findings) {
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == SubjectKind::Stroke) names.insert(subject.id);
    }
  }
  std::vector<bool> named;
  for (const PerspectiveStroke& stroke : drawing.strokes) named.push_back(names.contains(stroke.id));
  return named;
}

}  // namespace

ReconstructedNetwork reconstruct_network(const PerspectiveDrawing& drawing, const NetworkReconstructionOptions& options,
                                         Progress& progress) {
  ReconstructedNetwork result;
  result.vertices = find_drawing_vertices(drawing, options.vertices);
  Progress camera_part = progress.step("find the camera", 0.4);
  Calibration calibration = calibrated(drawing, usable_groups(drawing, result.vertices), options, camera_part);
  result.camera = std::move(calibration.camera);
  Progress coordinate_part = progress.step("find the vertices", 0.3);
  solve_with_splits(drawing, calibration, options.coordinates, coordinate_part, result);
  // A length into depth and one across tell the focal length of a drawing with one vanishing point.
  if (const std::optional<PerspectiveDrawing> known = with_field_of_view(drawing, result)) {
    return reconstruct_network(*known, options, progress);
  }
  Progress curve_part = progress.step("lift the curves", 0.1);
  curve_part.check();
  result.curves = lift_curves(drawing, result.vertices, result.coordinates, options.curves);
  result.joints = join_smoothly(result.curves.network, &result.coordinates.camera,
                                with_locks(drawing, result.curves, options.continuity));
  result.fitted = fit_curves(result.curves.network, result.coordinates.camera,
                             drawing.diagonal() / sheet_units_per_diagonal, options.curves);
  append(result.warnings, result.vertices.warnings);
  append(result.warnings, result.camera.warnings);
  append(result.warnings, result.coordinates.warnings);
  append(result.warnings, result.curves.warnings);
  result.flagged = flagged_strokes(drawing, result.warnings);
  progress.report(1);
  return result;
}

Findings told_of_strokes(Findings findings, const PerspectiveDrawing& drawing, const LiftedCurves& curves) {
  std::map<std::string, Index> strokes;
  for (std::size_t c = 0; c < curves.stroke.size(); ++c) strokes.emplace(curves.network.curves[c].id, curves.stroke[c]);
  for (Finding& finding : findings) {
    std::vector<Subject> subjects;
    std::set<Index> told;
    for (Subject& subject : finding.subjects) {
      const auto stroke = subject.kind == SubjectKind::Stroke ? strokes.find(subject.id) : strokes.end();
      if (stroke == strokes.end()) {
        subjects.push_back(std::move(subject));
      } else if (told.insert(stroke->second).second) {
        subjects.push_back(stroke_subject(drawing, stroke->second));
      }
    }
    finding.subjects = std::move(subjects);
  }
  return findings;
}

}  // namespace croquis
