// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/camera/camera_fit.h"
#include "croquis/base/progress.h"

namespace croquis {

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
