// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/skeleton/attachments.h"
#include "algorithms/silhouette/surface/thickness.h"
#include "croquis/base/progress.h"
#include "croquis/solver/least_squares_solver.h"

namespace croquis::silhouette {

/// Of the depth of what another part rests on: so much of it gives way to that part's back at most.
constexpr double deepest_hollow = 0.2;

/// Two lifted vertices above the same point.
struct StackedPair {
  static constexpr double apart = -1;

  Index upper = 0;
  Index lower = 0;
  double kappa = apart;  ///< of attached objects: how far they may sink into one another
  bool resting = false;  ///< of an object that lies on the other

  bool attached() const { return kappa >= 0; }
  friend auto operator<=>(const StackedPair&, const StackedPair&) = default;
};

/// Every pair of sheets in front of each other with nothing between them, at every point of the sampling; ascending.
/// Where objects are attached a sheet may reach past its neighbour, so that all pairs of a stack count.
/// @param objects per lifted triangle; not needed without attachments
/// O(M log M).
std::vector<StackedPair> stacked_pairs(const SheetSampling& sheets, const std::vector<Index>& objects = {},
                                       const Attachments& attachments = {});

/// What the middle of the sheets is pulled to, and what keeps them apart.
struct MidSurfaceData {
  std::vector<LiftedPlace> nodes;
  Eigen::VectorXd node_z;       ///< per node
  Eigen::VectorXd node_length;  ///< per node: length of skeleton that it stands for
  std::vector<StackedPair> pairs;
  double scale = 1;           ///< L
  double gap = 0;             ///< least distance of sheets, along z
  double resting_gap = 0;     ///< of one that rests on the other
  double front_margin = 0;    ///< how far the front of an attached object lies before that of the one below
  Eigen::VectorXd stiffness;  ///< per lifted vertex, how hard it is to move: factor of its rows; empty: all are alike
  Eigen::VectorXd bending;    ///< and, besides, of its bending
};

/// Least z_a - z_b of a pair.
/// @param thickness per lifted vertex, h
double least_distance(const MidSurfaceData& data, const StackedPair& pair, const Eigen::VectorXd& thickness);

struct MidSurfaceResult {
  Eigen::VectorXd z;  ///< per lifted vertex
  int iterations = 0;
  double residual = 0;
  /// Per vertex, L: how far it may still be from the optimum's; infinity where it gave up.
  Eigen::VectorXd uncertainty;
};

/// The surface half way between front and back: as smooth as the skeleton's depths allow, level across every rim, and
/// nowhere nearer to the next sheet than thickness and gap demand.
///
/// Minimises 0.02 L^2 integral (Lap z)^2 + sum length/L (z(node) - z_node)^2 subject to z_a - z_b >= h_a + h_b + gap at
/// all stacked vertices. For attached ones z_a - z_b >= max(attached_distance, h_b - h_a + margin): the second keeps
/// the front of the upper one in front, so that drawn contours stay in sight. What rests keeps its front
/// in front, too, and sinks into the lower one by a fifth of that one's depth at most. The square of the Laplacian is
/// per area, so that dense rows of points don't make a sheet softer there; its boundary rows make the normal derivative
/// vanish, which is right: a round tube's rims are as high as its axis. Always feasible, since every lifted vertex has
/// a height of its own.
class MidSurface {
 public:
  MidSurface(const SheetOperator& op, MidSurfaceData data);

  /// Gives the nodes other depths, one per node.
  void move_nodes(const Eigen::VectorXd& node_z);

  /// From then on heights are bent, and nodes pull, against that shape: it is what sheets look like that nothing
  /// presses on.
  /// @param shape per lifted vertex
  void set_shape(const Eigen::VectorXd& shape) { shape_ = shape; }

  /// @param thickness per lifted vertex, h; a second call reuses the first one's factorisation
  /// @throws Cancelled
  MidSurfaceResult solve(const Eigen::VectorXd& thickness, Progress& progress);

 private:
  Eigen::VectorXd target() const;

  const SheetOperator& op_;
  MidSurfaceData data_;
  LeastSquaresSolver solver_;
  Eigen::VectorXd shape_;  ///< unknowns are heights over it
};

}  // namespace croquis::silhouette
