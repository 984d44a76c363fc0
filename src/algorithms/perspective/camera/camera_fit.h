// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "algorithms/perspective/camera/axis_fit.h"
#include "croquis/base/progress.h"

namespace croquis {

/// A camera in sheet units. Columns of the rotation are the world's axes seen from the camera.
struct CameraParameters {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double log_focal = 0;
  Vec2 principal = Vec2::Zero();

  double focal() const { return std::exp(log_focal); }
  Vec3 vanishing_point(int axis) const;
};

/// Which axes are parallel to the picture plane, so that their vanishing points are at infinity.
using FlatAxes = PerAxis<bool>;

inline int count_of(const FlatAxes& flat) { return flat[0] + flat[1] + flat[2]; }

/// What is known besides the lines; lengths in u.
struct CameraPrior {
  Vec2 principal = Vec2::Zero();
  double principal_spread = 1;  ///< across the horizon, and along it with three finite vanishing points
  double flat_spread = 1;       ///< along the horizon otherwise
  double log_focal = 0;
  double focal_spread = 1;
  bool focal_stated = false;
  double one_point_log_focal = 0;  ///< taken where the lines say nothing about it
};

/// How lines are weighed.
struct LineNoise {
  double sigma = 1;                ///< u; the prior's weight is relative to it
  std::optional<double> robust{};  ///< u: from where on residuals count by their size instead of its square
};

struct CameraFit {
  CameraParameters parameters;
  FlatAxes flat{};
  double cost = 0;       ///< what is minimised, u^2
  double line_cost = 0;  ///< sum of squared residuals of the kept lines, u^2
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< rotation, log focal, principal
};

/// The best camera with those axes flat, from several starts: the axes' own vanishing points where they give one, and
/// five focal lengths. None of the steps needs finite vanishing points.
CameraFit fit_camera(std::span<const AxisLine> lines, const AxisFits& axes, const FlatAxes& flat,
                     const CameraPrior& prior, const LineNoise& noise);

/// The same from one start.
CameraFit refit_camera(std::span<const AxisLine> lines, const CameraParameters& start, const FlatAxes& flat,
                       const CameraPrior& prior, const LineNoise& noise);

/// The square of the focal length for which three finite vanishing points are at right angles as seen from the eye, and
/// the point below the eye: the orthocentre. None if one is at infinity.
struct Orthocentre {
  Vec2 point = Vec2::Zero();
  double focal_squared = 0;  ///< not positive where the triangle isn't acute
};

std::optional<Orthocentre> orthocentre(const PerAxis<Vec3>& vanishing_points);

/// What is known about the camera before looking at lines.
CameraPrior camera_prior(const PerspectiveDrawing& drawing, const SheetFrame& frame, const CameraOptions& options,
                         const AxisFits& axes);

/// A noise to judge by: that of the axes' own fits, never below the floor, u.
double judging_sigma(const AxisFits& axes, const CameraOptions& options);

/// Fits of every set of flat axes that is allowed: three, two, one finite vanishing point in this order.
std::vector<CameraFit> fit_all_modes(const std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                                     double sigma, PerspectiveMode mode, Progress& progress);

/// The simplest fit that explains the lines nearly as well as the best one.
const CameraFit& simplest_fit(const std::vector<CameraFit>& fits, const AxisFits& axes, double sigma,
                              const CameraOptions& options);

/// Leaves out the lines that no camera explains together with the others, as far as may be.
/// @param lines outliers are marked
/// @return whether far more would have to be left out than may be
bool leave_out_joint_outliers(std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                              const CameraOptions& options, Progress& progress);

}  // namespace croquis
