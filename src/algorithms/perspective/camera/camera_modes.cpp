// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/camera_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Stated values of the camera are taken to be so exact: the focal length relatively, places in diagonals.
constexpr double stated_spread = 1e-3;

/// Taken in one-point perspective, where nothing tells it.
constexpr double usual_field_of_view = 50 * std::numbers::pi / 180;

/// Where the likely place of the principal point gives the focal length, a guess of it counts by so much less.
constexpr double unguessed = 1e3;

/// Cameras outside aren't believed in two-point perspective, diagonals.
constexpr double least_focal = 0.35;
constexpr double greatest_focal = 8;

/// The noise where no line is to spare, u.
constexpr double unknown_noise = 0.5;

/// Residuals count by their size beyond so many deviations.
constexpr double robust_from = 2.5;

double focal_of(double field_of_view, double width) { return width / 2 / std::tan(field_of_view / 2); }

bool all_well_determined(const AxisFits& axes) {
  return axes.well_determined[0] && axes.well_determined[1] && axes.well_determined[2];
}

bool is_allowed(const FlatAxes& flat, PerspectiveMode mode) {
  return mode == PerspectiveMode::Automatic || count_of(flat) == 3 - static_cast<int>(mode);
}

}  // namespace

CameraPrior camera_prior(const PerspectiveDrawing& drawing, const SheetFrame& frame, const CameraOptions& options,
                         const AxisFits& axes) {
  constexpr double diagonal = sheet_units_per_diagonal;
  const double width = drawing.image_size.x() / frame.unit;
  CameraPrior prior;
  prior.log_focal = std::log(options.focal_length * diagonal);
  prior.focal_spread = options.focal_spread;
  prior.one_point_log_focal = std::log(focal_of(drawing.field_of_view.value_or(usual_field_of_view), width));
  if (drawing.field_of_view) {
    prior.log_focal = prior.one_point_log_focal;
    prior.focal_spread = stated_spread;
    prior.focal_stated = true;
  }
  prior.flat_spread = options.flat_principal_spread * diagonal;
  // Without an axis the lines say nothing about the principal point.
  prior.principal_spread = options.principal_spread * diagonal;
  if (!all_well_determined(axes)) {
    prior.principal_spread = prior.flat_spread;
    if (!prior.focal_stated) prior.focal_spread *= unguessed;
  }
  if (drawing.principal_point) {
    prior.principal = frame.to_sheet(*drawing.principal_point);
    prior.principal_spread = prior.flat_spread = stated_spread * diagonal;
  }
  return prior;
}

double judging_sigma(const AxisFits& axes, const CameraOptions& options) {
  return std::max(axes.freedom > 0 ? axes.sigma : unknown_noise, options.noise_floor);
}

std::vector<CameraFit> fit_all_modes(const std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                                     double sigma, PerspectiveMode mode, Progress& progress) {
  const FlatAxes candidates[] = {{false, false, false}, {true, false, false}, {false, true, false},
                                 {false, false, true},  {false, true, true},  {true, false, true},
                                 {true, true, false}};
  std::vector<CameraFit> fits;
  for (const FlatAxes& flat : candidates) {
    progress.check();
    if (is_allowed(flat, mode)) fits.push_back(fit_camera(lines, axes, flat, prior, {sigma, {}}));
  }
  return fits;
}

const CameraFit& simplest_fit(const std::vector<CameraFit>& fits, const AxisFits& axes, double sigma,
                              const CameraOptions& options) {
  const bool all = all_well_determined(axes);
  // The lines alone decide; without those of an axis what is likely counts, too.
  const auto cost = [&](const CameraFit& fit) { return (all ? fit.line_cost : fit.cost) / (sigma * sigma); };
  const auto believed = [](const CameraFit& fit) {
    const double focal = fit.parameters.focal() / sheet_units_per_diagonal;
    return count_of(fit.flat) != 1 || (focal > least_focal && focal < greatest_focal);
  };
  const CameraFit* best = &fits.front();
  const int most_free = count_of(best->flat);
  double least = cost(*best);
  for (const CameraFit& fit : fits) {
    if (believed(fit)) least = std::min(least, cost(fit));
  }
  for (const CameraFit& fit : fits) {
    const int dropped = count_of(fit.flat) - most_free;
    if (dropped > 0 && (cost(fit) - least >= options.mode_rise * dropped || !believed(fit))) continue;
    const int simpler = count_of(fit.flat) - count_of(best->flat);
    if (simpler > 0 || (simpler == 0 && cost(fit) < cost(*best))) best = &fit;
  }
  return *best;
}

bool leave_out_joint_outliers(std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                              const CameraOptions& options, Progress& progress) {
  PerAxis<int> allowed{};
  PerAxis<int> left_out{};
  for (const AxisLine& line : lines) ++allowed[line.axis];
  for (const AxisLine& line : lines) left_out[line.axis] += line.outlier;
  for (int axis = 0; axis < 3; ++axis) allowed[axis] = most_outliers(allowed[axis]) - left_out[axis];
  const double first_sigma = judging_sigma(axes, options);
  CameraFit fit = fit_camera(lines, axes, {}, prior, {first_sigma, robust_from * first_sigma});
  for (;;) {
    progress.check();
    std::vector<double> residuals;
    AxisLine* worst = nullptr;
    double worst_residual = 0;
    for (AxisLine& line : lines) {
      if (line.outlier) continue;
      const double residual = std::abs(line_residual(fit.parameters.vanishing_point(line.axis), line));
      residuals.push_back(residual);
      if (residual > worst_residual) {
        worst_residual = residual;
        worst = &line;
      }
    }
    const double sigma = std::max(robust_sigma(residuals, 6), options.noise_floor);
    if (residuals.size() <= 6 || worst_residual <= std::max(options.outlier_sigmas * sigma, options.outlier_distance)) {
      return false;
    }
    if (allowed[worst->axis]-- <= 0) return true;
    worst->outlier = true;
    fit = refit_camera(lines, fit.parameters, {}, prior, {sigma, robust_from * sigma});
  }
}

}  // namespace croquis
