// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/camera_estimation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "algorithms/perspective/camera/axis_fit.h"
#include "algorithms/perspective/camera/camera_fit.h"
#include "algorithms/perspective/stroke_words.h"
#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

/// An axis that is seen shorter than this part of its length is judged by its direction in depth instead.
constexpr double least_seen = 1e-3;

/// How the picture moves along an axis at a place, per focal length: 1 where the axis lies across the view.
Vec2 seen_direction(const CameraParameters& camera, int axis, const Vec2& place) {
  const Vec3 point = camera.vanishing_point(axis);
  return (point.head<2>() - point.z() * place) / camera.focal();
}

/// Vanishing points leave the signs of the axes open. Chosen so that at that place of the picture z goes up and x to
/// the right, where they are seen from the side; else z comes towards the eye and x goes away from it. y makes the
/// world right-handed.
/// @param place u
/// @param turn_round the other of the two worlds with z up
Eigen::Matrix3d signed_axes(const CameraParameters& camera, const Vec2& place, bool turn_round) {
  Eigen::Matrix3d axes = camera.rotation;
  const Vec2 up = seen_direction(camera, 2, place);
  const bool z_is_down = std::abs(up.y()) > least_seen ? up.y() > 0 : axes(2, 2) > 0;
  if (z_is_down) axes.col(2) = -axes.col(2);
  const Vec2 right = seen_direction(camera, 0, place);
  const bool x_is_left = std::abs(right.x()) > least_seen ? right.x() < 0 : axes(2, 0) < 0;
  if (x_is_left != turn_round) axes.col(0) = -axes.col(0);
  if (axes.determinant() < 0) axes.col(1) = -axes.col(1);
  return axes;
}

/// Chi-squared that being a picture of right angles may cost, before there is no eye for it.
constexpr double eye_rise = 25;

/// The prior's weight follows the noise, but some of it has to remain where lines say nothing, u.
constexpr double least_prior_noise = 1e-4;

/// Fewer lines to spare say too little about the noise.
constexpr int least_freedom = 3;

/// A focal length less certain than this is reported, relative.
constexpr double weak_focal = 0.15;

std::vector<Index> strokes_of(std::span<const AxisLine> lines, int axis) {
  std::vector<Index> strokes;
  for (const AxisLine& line : lines) {
    if (line.axis == axis && !line.outlier) strokes.push_back(line.stroke);
  }
  return strokes;
}

/// Largest angle between two lines of an axis.
double angular_spread(std::span<const AxisLine> lines, int axis) {
  double spread = 0;
  for (const AxisLine& one : lines) {
    for (const AxisLine& other : lines) {
      if (one.axis != axis || other.axis != axis || one.outlier || other.outlier) continue;
      const Vec2 a = one.b - one.a;
      const Vec2 b = other.b - other.a;
      spread = std::max(spread, std::atan2(std::abs(cross(a, b)), std::abs(a.dot(b))));
    }
  }
  return spread;
}

class Estimation {
 public:
  Estimation(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups, const CameraOptions& options)
      : drawing_(drawing), groups_(groups), options_(options), frame_(drawing) {
    lines_ = axis_lines(drawing, groups, frame_, options.minimum_line * sheet_units_per_diagonal);
  }

  CameraEstimate run(Progress& progress) {
    check_counts();
    axes_ = fit_axes(lines_, options_);
    progress.report(0.1);
    check_parallel();
    CameraPrior prior = camera_prior(drawing_, frame_, options_, axes_);
    // A triangle without an eye is reported before lines are left out: leaving out good ones could hide it.
    if (is_consistent()) check_eye(prior, progress);
    progress.report(0.4);
    const bool too_many = leave_out_joint_outliers(lines_, axes_, prior, options_, progress);
    axes_ = fit_kept_lines(lines_);
    prior = camera_prior(drawing_, frame_, options_, axes_);
    const std::vector<CameraFit> fits = check_eye(prior, progress, too_many);
    progress.report(0.9);
    const CameraFit fit = final_fit(simplest_fit(fits, axes_, judging_sigma(axes_, options_), options_), prior);
    progress.report(1);
    return result(fit);
  }

 private:
  void check_counts() const {
    const PerAxis<int> counts = lines_per_axis(lines_);
    const auto lacking = std::count_if(counts.begin(), counts.end(), [](int count) { return count < 2; });
    if (lacking < 2) return;
    std::string axes;
    for (int axis = 0; axis < 3; ++axis) {
      if (counts[axis] < 2) axes += (axes.empty() ? "" : " and ") + std::string(axis_name(axis));
    }
    throw Error(make_error(Category::Geometry, "VP_INSUFFICIENT",
                           "The drawing has fewer than two usable lines along " + axes +
                               ": draw at least two construction lines for two of the axes."));
  }

  /// No vanishing point differs from one at infinity: a parallel projection.
  void check_parallel() const {
    const double sigma = judging_sigma(axes_, options_);
    for (int axis = 0; axis < 3; ++axis) {
      if (!axes_.well_determined[axis]) return;
      const double rise = axes_.parallel_cost[axis] - axes_.cost[axis];
      if (rise >= options_.mode_rise * sigma * sigma) return;
    }
    throw Error(
        make_error(Category::Geometry, "ALL_PARALLEL",
                   "The lines of all three axes are parallel, so there is no perspective to find a camera from: "
                   "draw lines that converge towards at least one vanishing point."));
  }

  /// No axis has a line that is far off its own vanishing point.
  bool is_consistent() const {
    std::vector<double> residuals;
    for (const AxisLine& line : lines_) {
      if (line.outlier || !axes_.well_determined[line.axis]) continue;
      residuals.push_back(std::abs(line_residual(axes_.vanishing_points[line.axis], line)));
    }
    const double sigma = std::max(robust_sigma(residuals, 6), options_.noise_floor);
    return std::all_of(residuals.begin(), residuals.end(), [&](double residual) {
      return residual <= std::max(options_.outlier_sigmas * sigma, options_.outlier_distance);
    });
  }

  /// Fits of all modes.
  /// @param too_many lines contradict even the best camera
  std::vector<CameraFit> check_eye(const CameraPrior& prior, Progress& progress, bool too_many = false) const {
    const double sigma = judging_sigma(axes_, options_);
    std::vector<CameraFit> fits = fit_all_modes(lines_, axes_, prior, sigma, options_.mode, progress);
    if (options_.mode != PerspectiveMode::Automatic) return fits;
    const bool all = axes_.well_determined[0] && axes_.well_determined[1] && axes_.well_determined[2];
    const std::optional<Orthocentre> centre = all ? orthocentre(axes_.vanishing_points) : std::nullopt;
    if (!centre || centre->focal_squared > 0) return fits;
    const double least = simplest_fit(fits, axes_, sigma, options_).line_cost;
    const double rise = least - axes_.cost[0] - axes_.cost[1] - axes_.cost[2];
    if (too_many || rise > eye_rise * sigma * sigma) throw_no_eye();
    return fits;
  }

  [[noreturn]] void throw_no_eye() const {
    PerAxis<Vec2> corners;
    for (int axis = 0; axis < 3; ++axis) {
      corners[axis] = axes_.vanishing_points[axis].head<2>() / axes_.vanishing_points[axis].z();
    }
    int obtuse = 0;
    double widest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec2 one = corners[(axis + 1) % 3] - corners[axis];
      const Vec2 other = corners[(axis + 2) % 3] - corners[axis];
      const double angle = std::atan2(std::abs(cross(one, other)), one.dot(other));
      if (angle > widest) {
        widest = angle;
        obtuse = axis;
      }
    }
    const std::vector<Index> strokes = strokes_of(lines_, obtuse);
    throw Error(make_error(Category::Geometry, "EYE_NONE",
                           "No eye sees the three axes at right angles: the vanishing points form a triangle with an "
                           "obtuse angle at that of " +
                               std::string(axis_name(obtuse)) + "; redraw its lines (" +
                               stroke_names(drawing_, strokes) + ") so that they meet farther away.",
                           stroke_subjects(drawing_, strokes)));
  }

  CameraFit final_fit(const CameraFit& chosen, const CameraPrior& prior) {
    const int unknowns = 6 - PerAxis<int>(0, 1, 3)[count_of(chosen.flat)];
    freedom_ = -unknowns;
    for (const AxisLine& line : lines_) freedom_ += line.outlier ? 0 : 1;
    const double floor = freedom_ < least_freedom ? options_.noise_floor : least_prior_noise;
    CameraFit fit = chosen;
    for (int round = 0; round < 3; ++round) {  // noise and weight of the prior follow from each other
      sigma_ = freedom_ > 0 ? std::sqrt(fit.line_cost / freedom_) : 0;
      fit = refit_camera(lines_, fit.parameters, fit.flat, prior, {std::max(sigma_, floor), {}});
    }
    return fit;
  }

  CameraEstimate result(const CameraFit& fit) const {
    CameraEstimate estimate;
    const CameraParameters& parameters = fit.parameters;
    estimate.camera.focal_length = parameters.focal() * frame_.unit;
    estimate.camera.principal_point = frame_.to_picture(parameters.principal);
    estimate.camera.image_origin = drawing_.origin;
    estimate.camera.image_size = drawing_.image_size;
    const Vec2 place = drawing_.known_point ? frame_.to_sheet(drawing_.known_point->at) : Vec2(Vec2::Zero());
    estimate.camera.rotation = signed_axes(parameters, place, options_.turn_round);
    const int flat = count_of(fit.flat);
    estimate.mode = static_cast<PerspectiveMode>(3 - flat);
    estimate.focal_assumed = flat == 2 && !drawing_.field_of_view;
    for (int axis = 0; axis < 3; ++axis) {
      estimate.finite[axis] = !fit.flat[axis];
      estimate.vanishing_points[axis] = estimate.camera.vanishing_point(axis);
    }
    estimate.sigma = sigma_ * frame_.unit;
    estimate.focal_deviation = std::sqrt(fit.covariance(3, 3)) * estimate.camera.focal_length;
    for (int i = 0; i < 2; ++i) estimate.principal_deviation[i] = std::sqrt(fit.covariance(4 + i, 4 + i)) * frame_.unit;
    add_lines(estimate);
    add_warnings(estimate);
    return estimate;
  }

  void add_lines(CameraEstimate& estimate) const {
    for (std::size_t s = 0; s < drawing_.strokes.size(); ++s) {
      const PerspectiveStroke& stroke = drawing_.strokes[s];
      if (!is_parallel(groups_[s]) || !are_usable_numbers(stroke.start()) || !are_usable_numbers(stroke.end()))
        continue;
      VanishingLine line;
      line.stroke = static_cast<Index>(s);
      line.axis = axis_of(groups_[s]);
      line.residual = vanishing_residual(estimate.vanishing_points[line.axis], stroke.start(), stroke.end());
      const auto found = std::find_if(lines_.begin(), lines_.end(),
                                      [&](const AxisLine& candidate) { return candidate.stroke == line.stroke; });
      line.outlier = found != lines_.end() && found->outlier;
      line.used = found != lines_.end() && !found->outlier;
      estimate.lines.push_back(line);
    }
  }

  void add_warnings(CameraEstimate& estimate) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!axes_.well_determined[axis]) warn_insufficient(axis, estimate.warnings);
    }
    for (const Index stroke : outliers()) {
      const int axis = axis_of(groups_[stroke]);
      estimate.warnings.push_back(make_warning(Category::Geometry, "VP_OUTLIER",
                                               "Stroke " + drawing_.strokes[stroke].id +
                                                   " doesn't point at the vanishing point of " + axis_name(axis) +
                                                   " and isn't used for it: check its colour, or draw it again.",
                                               {stroke_subject(drawing_, stroke)}));
    }
    if (estimate.focal_assumed) {
      estimate.warnings.push_back(make_warning(
          Category::Geometry, "FOCAL_ASSUMED",
          "A drawing with one vanishing point doesn't show how deep things are; a field of view of 50 degrees is "
          "assumed: state the field of view, or two known lengths."));
    } else if (estimate.focal_deviation > weak_focal * estimate.camera.focal_length) {
      warn_weak(estimate);
    }
  }

  void warn_insufficient(int axis, Findings& warnings) const {
    warnings.push_back(make_warning(Category::Geometry, "VP_INSUFFICIENT",
                                    std::string("Fewer than two usable lines run along ") + axis_name(axis) +
                                        "; its vanishing point follows from the other two: draw two lines along it."));
  }

  void warn_weak(CameraEstimate& estimate) const {
    int weakest = 0;
    double least = std::numbers::pi;
    for (int axis = 0; axis < 3; ++axis) {
      const double spread = angular_spread(lines_, axis);
      if (!estimate.finite[axis] || spread >= least) continue;
      least = spread;
      weakest = axis;
    }
    const auto percent = std::lround(100 * estimate.focal_deviation / estimate.camera.focal_length);
    const std::vector<Index> strokes = strokes_of(lines_, weakest);
    estimate.warnings.push_back(make_warning(Category::Geometry, "VP_WEAK",
                                             std::string("The lines along ") + axis_name(weakest) +
                                                 " hardly converge, so that the focal length is uncertain by " +
                                                 std::to_string(percent) +
                                                 " percent: draw more of them, far from each other.",
                                             stroke_subjects(drawing_, strokes)));
  }

  std::vector<Index> outliers() const {
    std::vector<Index> strokes;
    for (const AxisLine& line : lines_) {
      if (line.outlier) strokes.push_back(line.stroke);
    }
    std::stable_sort(strokes.begin(), strokes.end(),
                     [&](Index a, Index b) { return drawing_.strokes[a].id < drawing_.strokes[b].id; });
    return strokes;
  }

  const PerspectiveDrawing& drawing_;
  std::span<const StrokeGroup> groups_;
  const CameraOptions& options_;
  SheetFrame frame_;
  std::vector<AxisLine> lines_;
  AxisFits axes_;
  double sigma_ = 0;  // u
  int freedom_ = 0;
};

}  // namespace

std::vector<StrokeGroup> drawn_groups(const PerspectiveDrawing& drawing) {
  std::vector<StrokeGroup> groups;
  for (const PerspectiveStroke& stroke : drawing.strokes) groups.push_back(stroke.group);
  return groups;
}

CameraEstimate estimate_camera(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                               const CameraOptions& options, Progress& progress) {
  return Estimation(drawing, groups, options).run(progress);
}

CameraEstimate estimate_camera(const PerspectiveDrawing& drawing, const CameraOptions& options, Progress& progress) {
  return estimate_camera(drawing, drawn_groups(drawing), options, progress);
}

}  // namespace croquis
