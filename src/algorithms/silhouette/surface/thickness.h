// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"
#include "croquis/solver/symmetric_factors.h"

namespace croquis::silhouette {

/// Piecewise linear finite elements on the immersed region; the immersion is a local isometry, so that lengths and
/// angles are those of the plane.
struct SheetOperator {
  Eigen::SparseMatrix<double> stiffness;  ///< #V by #V, cotangent weights, free boundary: -div(w grad), integrated
  Eigen::VectorXd area;                   ///< #V, a third of the triangles around, times w
  std::vector<std::uint8_t> on_boundary;  ///< #V
  std::vector<Vec2> position;             ///< #V
};

/// @param weight per lifted vertex the weight w > 0, linear in between; empty: 1
SheetOperator make_sheet_operator(const SheetSampling& sheets, const Eigen::VectorXd& weight = {});

/// A node's share of a vertex.
struct NodeShare {
  Index vertex = 0;
  Index node = 0;
  double weight = 0;
};

/// Carries values from the skeleton's nodes over the whole region, nearly harmonic between them.
///
/// Each node pulls like a spring, spread over the vertices around it in its sheet: a value held at a point of the plane
/// would stand out as a spike.
/// Nodes whose ball a larger one covers don't pull: where limbs or points meet in a wide body, how it is triangulated
/// is left to chance, and so is where its chords lie.
class NodeExtension {
 public:
  /// @param nodes where the skeleton's nodes lie
  NodeExtension(const SheetOperator& op, const std::vector<LiftedPlace>& nodes, const Skeleton& skeleton);

  /// @param node_values one per node
  Eigen::VectorXd extend(const Eigen::VectorXd& node_values) const;

 private:
  std::unique_ptr<SymmetricFactors> factors_;
  std::vector<NodeShare> shares_;
  Eigen::VectorXd background_;
};

/// Per lifted vertex of the boundary the curvature of the rim times the radius of the surface there: 1 around a disk, 0
/// along a straight tube, positive on the outer and negative on the inner side of a bend. 0 inside.
///
/// A mean over about a radius of the rim to either side, so that corners and the sampling's noise count as what they
/// turn in all.
Eigen::VectorXd rim_turn(const SheetSampling& sheets);

/// Half thickness of the surface over every lifted vertex: 0 exactly on the boundary, positive inside.
///
/// u solves div(w grad u) = -4 w, u = 0 on the boundary, and thickness is beta sqrt(u), where beta makes it the radius
/// at the skeleton. With w = 1, u is 2 (r^2 - d^2) on a straight tube and r^2 - d^2 on a disk, so that both get
/// circular sections. Around a bend the solution leans outwards; with w the length of the axis per length at a place it
/// is that of the straight tube again. There ln w is harmonic, so it is extended harmonically from the rim, where it is
/// ln(1 - curvature * radius).
/// @param nodes where the skeleton's nodes lie
/// Three sparse factorisations of the size of the region. @throws Cancelled
Eigen::VectorXd sheet_thickness(const SheetSampling& sheets, const SheetOperator& op, const Skeleton& skeleton,
                                const std::vector<LiftedPlace>& nodes, const NodeExtension& extension,
                                Progress& progress);

/// The value at a node's place.
double value_at(const LiftedPlace& place, const Eigen::VectorXd& values);

}  // namespace croquis::silhouette
