// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "algorithms/silhouette/skeleton/skeleton.h"

namespace croquis::silhouette {

/// What a ball sweeps that runs along the skeleton with the radius of its nodes, seen over each node.
struct SweptLimbs {
  /// Per node its height in parts of what it would be if the skeleton were level, 1..2. Straight: sqrt(1 + slope^2).
  Eigen::VectorXd tilt;
  /// Per node how far its middle lies above the node: not 0 on the slopes of a bend.
  Eigen::VectorXd lift;
};

/// @param node_z per node
SweptLimbs swept_limbs(const Skeleton& skeleton, const Eigen::VectorXd& node_z);

}  // namespace croquis::silhouette
