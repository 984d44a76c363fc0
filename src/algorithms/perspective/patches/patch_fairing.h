// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "croquis/geometry/gregory_patch.h"

namespace croquis {

/// The 20 points of a patch, the boundary's first.
using PatchPoints = Eigen::Matrix<double, 20, 3>;

/// How much each point of a patch counts.
using PatchWeights = Eigen::Matrix<double, 20, 1>;

PatchPoints points_of(const GregoryPatch& patch);

/// The variation energy of a patch is the sum over coordinates of x' E x: squares of all third derivatives, by
/// differences, at the middles of a grid. It lets curvature be and resists its change, so that spheres stay round;
/// thin-plate energy flattens them.
const Eigen::Matrix<double, 20, 20>& variation_energy();

/// The second derivative at a place of the boundary across it, along u or v, by differences.
PatchWeights second_derivative(double u, double v, bool along_u);

/// A side that two patches share; they run along it in opposite directions.
struct PatchJoint {
  std::size_t before = 0;  ///< patch
  int before_side = 0;
  std::size_t behind = 0;
  int behind_side = 0;
};

/// Patches that depend on common variables. With all variables 0 they have their first shape; variables are of the
/// order of 1.
class PatchFamily {
 public:
  virtual ~PatchFamily() = default;

  virtual std::size_t patches() const = 0;
  virtual int variables() const = 0;
  virtual std::vector<int> variables_of(std::size_t patch) const = 0;
  virtual std::vector<PatchJoint> joints() const = 0;
  virtual GregoryPatch patch(std::size_t index, const Eigen::VectorXd& values) const = 0;

  /// Whether the shape may be taken.
  virtual bool allowed(const Eigen::VectorXd& values) const = 0;
};

/// The values of least energy near zero, by damped Gauss-Newton steps. The energy is the variation energy of the
/// patches, and what their second derivatives differ by across the joints. It scales with the square of lengths, so
/// that the scaled and turned family gives the same values.
Eigen::VectorXd least_energy(const PatchFamily& family);

}  // namespace croquis
