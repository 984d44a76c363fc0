// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/network_reconstruction.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "algorithms/perspective/coordinates/contradiction_search.h"
#include "algorithms/perspective/stroke_words.h"
#include "croquis/base/error.h"
#include "croquis/base/stage_key.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {
namespace {

/// Ends of a corner.
constexpr int least_ends = 3;

/// There are about two hundred ways to divide so many.
constexpr std::size_t most_ends = 9;

/// Chi-squared that a division has to take away.
constexpr double least_gain = 100;

/// Which ends of a vertex go to a vertex of their own: bit i stands for the i-th.
using EndSet = std::uint32_t;

class VertexSplitter {
 public:
  VertexSplitter(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                 std::span<const StrokeGroup> groups, double sigma)
      : drawing_(drawing), tied_(tied_vertices(drawing, vertices, camera, groups)), sigma_(sigma), result_(vertices) {
    for (Index v = 0; v < vertices.vertices.size(); ++v) {
      const DrawingVertex& vertex = vertices.vertices[v];
      if (vertex.name.empty() && vertex.ends.size() >= 2 * least_ends && vertex.ends.size() <= most_ends)
        candidates_.push_back(v);
    }
  }

  std::optional<DrawingVertices> run(Progress& progress) {
    bool any = false;
    for (const Index v : candidates_) {
      progress.check();
      const EndSet moved = best_division(v, without_others(v));
      if (moved == 0) continue;
      divide(v, moved);
      any = true;
    }
    return any ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  const std::vector<StrokeEnd>& ends_of(Index v) const { return result_.vertices[v].ends; }

  /// Infinite where vertices would lie behind the eye.
  static double squares(const TiedVertices& tied) {
    const SolvedVertices now = solved(tied);
    return now.solution.in_front ? now.solution.squares : std::numeric_limits<double>::infinity();
  }

  /// A vertex of its own for an end.
  static void detach(const StrokeEnd& end, Index place, TiedVertices& tied) {
    tied.ties.of_stroke[end.stroke][end.at_end ? 1 : 0] = place;
  }

  static Index copy_of(Index v, TiedVertices& tied) {
    tied.seen.places.push_back(Vec2(tied.seen.places[v]));
    tied.seen.weights.push_back(double(tied.seen.weights[v]));
    return static_cast<Index>(tied.seen.places.size() - 1);
  }

  /// Other vertices that may be two corners tie nothing, so that each is judged by itself.
  TiedVertices without_others(Index kept) const {
    TiedVertices tied = tied_;
    for (const Index v : candidates_) {
      if (v == kept) continue;
      for (std::size_t i = 1; i < ends_of(v).size(); ++i) detach(ends_of(v)[i], copy_of(v, tied), tied);
    }
    return tied;
  }

  Vec2 direction(const StrokeEnd& end) const {
    const PerspectiveStroke& stroke = drawing_.strokes[end.stroke];
    return (end.at_end ? -1 : 1) * (stroke.end() - stroke.start());
  }

  bool would_overlap(const StrokeEnd& a, const StrokeEnd& b) const {
    const StrokeGroup group = tied_.ties.groups[a.stroke];
    return is_parallel(group) && group == tied_.ties.groups[b.stroke] && direction(a).dot(direction(b)) > 0;
  }

  bool has_overlap(const std::vector<StrokeEnd>& ends, EndSet moved) const {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (((moved >> i ^ moved >> j) & 1) == 0 && would_overlap(ends[i], ends[j])) return true;
      }
    }
    return false;
  }

  /// The first end stays. 0 where no division is much better than none.
  EndSet best_division(Index v, const TiedVertices& whole) const {
    const std::vector<StrokeEnd>& ends = ends_of(v);
    const EndSet all = (EndSet{1} << ends.size()) - 1;
    double least = squares(whole) - least_gain * sigma_ * sigma_;
    EndSet best = 0;
    for (EndSet moved = 2; moved <= all; moved += 2) {
      if (std::popcount(moved) < least_ends || std::popcount(all & ~moved) < least_ends) continue;
      if (has_overlap(ends, moved)) continue;
      const double after = squares(divided(whole, v, moved));
      if (after >= least) continue;
      least = after;
      best = moved;
    }
    return best;
  }

  TiedVertices divided(TiedVertices tied, Index v, EndSet moved) const {
    const Index copy = copy_of(v, tied);
    for (std::size_t i = 0; i < ends_of(v).size(); ++i) {
      if ((moved >> i & 1) != 0) detach(ends_of(v)[i], copy, tied);
    }
    return tied;
  }

  void divide(Index v, EndSet moved) {
    const auto copy = static_cast<Index>(result_.vertices.size());
    std::array<DrawingVertex, 2> parts;
    for (std::size_t i = 0; i < ends_of(v).size(); ++i) {
      const StrokeEnd end = ends_of(v)[i];
      const bool is_moved = (moved >> i & 1) != 0;
      const PerspectiveStroke& stroke = drawing_.strokes[end.stroke];
      parts[is_moved ? 1 : 0].ends.push_back(end);
      parts[is_moved ? 1 : 0].position += end.at_end ? stroke.end() : stroke.start();
      if (is_moved) result_.of_stroke[end.stroke][end.at_end ? 1 : 0] = copy;
    }
    for (DrawingVertex& part : parts) part.position /= static_cast<double>(part.ends.size());
    result_.vertices[v] = parts[0];
    result_.vertices.push_back(parts[1]);
  }

  const PerspectiveDrawing& drawing_;
  TiedVertices tied_;
  double sigma_;  // u
  DrawingVertices result_;
  std::vector<Index> candidates_;
};

/// Two corners that are seen at one place were taken for one vertex; its strokes contradict each other then. The
/// drawing's vertices with those divided that fit much better so: every part has three ends or more, as corners of
/// solids have, and no two strokes that would lie on each other. None where nothing is to be divided. Vertices that
/// strokes name stay, as do those of more than nine ends. Up to two hundred solves for each vertex of six ends or more.
/// @param groups what each stroke is taken for
/// @throws Cancelled
std::optional<DrawingVertices> with_split_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                                   const CameraEstimate& camera, std::span<const StrokeGroup> groups,
                                                   const CoordinateOptions& options, Progress& progress) {
  const double sigma = std::max(camera.sigma / SheetFrame(drawing).unit, options.contradiction_noise);
  return VertexSplitter(drawing, vertices, camera, groups, sigma).run(progress);
}

/// The focal length of one-point perspective from two known lengths or more, one of them going into depth: depths are
/// in proportion to the focal length that was assumed, so squared lengths are linear in its square. None where the
/// lengths don't give it.
/// @param coordinates found with the camera's assumed focal length
/// @return px
std::optional<double> focal_from_lengths(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                         const VertexCoordinates& coordinates) {
  constexpr double least_rank = 1e-9;
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  for (const KnownLength& known : drawing.known_lengths) {
    for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
      const auto [a, b] = vertices.of_stroke[s];
      if (drawing.strokes[s].id != known.stroke || a == no_index || b == no_index) continue;
      if (!drawing.strokes[s].straight || coordinates.component[a] != coordinates.component[b]) continue;
      const Vec3 span = coordinates.camera.rotation * (coordinates.positions[b] - coordinates.positions[a]);
      // Relative lengths count alike.
      const Vec2 row = Vec2(span.head<2>().squaredNorm(), span.z() * span.z()) / (known.length * known.length);
      matrix += row * row.transpose();
      right += row;
    }
  }
  const double determinant = matrix.determinant();
  if (!(determinant > least_rank * matrix(0, 0) * matrix(1, 1))) return std::nullopt;
  const Vec2 squares = matrix.inverse() * right;  // of the scales across and along the view
  if (!(squares.minCoeff() > 0)) return std::nullopt;
  return coordinates.camera.focal_length * std::sqrt(squares.y() / squares.x());
}

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

/// The drawing with the field of view that known lengths give, if the lines give none.
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
  // A length into depth and one across give the focal length of a drawing with one vanishing point.
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

Findings findings_of_strokes(Findings findings, const PerspectiveDrawing& drawing, const LiftedCurves& curves) {
  std::map<std::string, Index> strokes;
  for (std::size_t c = 0; c < curves.stroke.size(); ++c) strokes.emplace(curves.network.curves[c].id, curves.stroke[c]);
  for (Finding& finding : findings) {
    std::vector<Subject> subjects;
    std::set<Index> reported;
    for (Subject& subject : finding.subjects) {
      const auto stroke = subject.kind == SubjectKind::Stroke ? strokes.find(subject.id) : strokes.end();
      if (stroke == strokes.end()) {
        subjects.push_back(std::move(subject));
      } else if (reported.insert(stroke->second).second) {
        subjects.push_back(stroke_subject(drawing, stroke->second));
      }
    }
    finding.subjects = std::move(subjects);
  }
  return findings;
}

}  // namespace croquis
