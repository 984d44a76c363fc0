// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/surface/sheet_operator.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Carries values from the skeleton's nodes over the whole region, nearly harmonic between them.
///
/// Each node pulls like a spring, spread over the vertices around it in its sheet: a value held at a point of the plane
/// would stand out as a spike.
/// Keeps its factorisation.
class NodeExtension {
 public:
  /// @param radii per node
  NodeExtension(const SheetOperator& op, const std::vector<LiftedPlace>& nodes, const Eigen::VectorXd& radii);
  ~NodeExtension();
  NodeExtension(NodeExtension&&) noexcept;

  /// @param node_values one per node
  Eigen::VectorXd extend(const Eigen::VectorXd& node_values) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Half thickness of the surface over every lifted vertex: 0 exactly on the boundary, positive inside.
///
/// u solves Lap u = -4, u = 0 on the boundary, and thickness is beta sqrt(u), where beta makes it the radius at the
/// skeleton: on a tube u = 2 (r^2 - d^2), on a disk r^2 - d^2, so that both get circular sections.
/// @param radii per node
/// Two sparse factorisations of the size of the region. @throws Cancelled
Eigen::VectorXd sheet_thickness(const SheetOperator& op, const std::vector<LiftedPlace>& nodes,
                                const Eigen::VectorXd& radii, const NodeExtension& extension, Progress& progress);

/// The value at a node's place.
double value_at(const LiftedPlace& place, const Eigen::VectorXd& values);

}  // namespace croquis::silhouette
