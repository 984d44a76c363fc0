// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "croquis/geometry/gregory_patch.h"

namespace croquis {

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
