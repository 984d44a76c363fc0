// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/mid_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace croquis::silhouette {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Against the nodes' pull: bends shorter than about half of L are smoothed out.
constexpr double bending = 0.02;

/// Added to the gap, in L: what rounding and the solver's tolerance may take away again.
constexpr double gap_margin = 1e-5;

MidSurfaceData with_stiffness(MidSurfaceData data, Eigen::Index count) {
  if (data.stiffness.size() == 0) data.stiffness = data.bending = Eigen::VectorXd::Ones(count);
  return data;
}

/// Of a node's row: the root of the length that it stands for, times its sheet's stiffness.
double pull_of(const MidSurfaceData& data, Eigen::Index n) {
  const LiftedPlace& place = data.nodes[static_cast<std::size_t>(n)];
  return std::sqrt(data.node_length[n] / data.scale) * data.stiffness[place.vertices[0]];
}

LeastSquaresProblem make_problem(const SheetOperator& op, const MidSurfaceData& data) {
  const Eigen::Index count = op.stiffness.cols();
  Triplets rows;
  rows.reserve(static_cast<std::size_t>(op.stiffness.nonZeros()) + 3 * data.nodes.size());
  for (Eigen::Index v = 0; v < count; ++v) {
    for (Matrix::InnerIterator entry(op.stiffness, v); entry; ++entry) {
      // The root of the bending energy at the row's vertex.
      const double scale = std::sqrt(bending / op.area[entry.row()]) * data.scale;
      rows.emplace_back(entry.row(), v,
                        scale * (data.bending[entry.row()] * data.stiffness[entry.row()]) * entry.value());
    }
  }
  const auto node_count = static_cast<Eigen::Index>(data.nodes.size());
  for (Eigen::Index n = 0; n < node_count; ++n) {
    const LiftedPlace& place = data.nodes[static_cast<std::size_t>(n)];
    const double pull = pull_of(data, n);
    for (std::size_t i = 0; i < 3; ++i) {
      if (place.weights[i] > 0) rows.emplace_back(count + n, place.vertices[i], pull * place.weights[i]);
    }
  }
  LeastSquaresProblem problem;
  problem.objective.resize(count + node_count, count);
  problem.objective.setFromTriplets(rows.begin(), rows.end());

  Triplets gaps;
  for (const StackedPair& pair : data.pairs) {
    const auto row = static_cast<Eigen::Index>(gaps.size() / 2);
    gaps.emplace_back(row, pair.upper, 1.0);
    gaps.emplace_back(row, pair.lower, -1.0);
  }
  problem.inequalities.resize(static_cast<Eigen::Index>(data.pairs.size()), count);
  problem.inequalities.setFromTriplets(gaps.begin(), gaps.end());
  problem.inequality_bounds = Eigen::VectorXd::Zero(problem.inequalities.rows());
  return problem;
}

}  // namespace

std::vector<StackedPair> stacked_pairs(const SheetSampling& sheets, const std::vector<Index>& objects,
                                       const Attachments& attachments) {
  const LiftedTriangulation& lifted = sheets.lifted;
  const bool joined = attachments.any(Hold::Joined);
  std::vector<StackedPair> pairs;
  std::vector<Index> last(lifted.planar_vertex.size(), no_index);  // per vertex the last one that was found below it
  for (Index t = 0; t < sheets.planar.triangles.size(); ++t) {
    const Index end = lifted.first_copy[t + 1];
    for (Index upper = lifted.first_copy[t]; upper < end; ++upper) {
      for (Index lower = upper + 1; lower < (joined ? end : std::min(end, upper + 2)); ++lower) {
        const std::optional<double> kappa =
            joined ? attachments.kappa(objects[upper], objects[lower]) : std::optional<double>{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
          const StackedPair pair{lifted.triangles[upper][corner], lifted.triangles[lower][corner],
                                 kappa.value_or(StackedPair::apart), false};
          // Most triangles around a vertex repeat its pair.
          if (std::exchange(last[pair.upper], pair.lower) != pair.lower) pairs.push_back(pair);
        }
      }
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

double least_distance(const MidSurfaceData& data, const StackedPair& pair, const Eigen::VectorXd& thickness) {
  const double upper = thickness[pair.upper];
  const double lower = thickness[pair.lower];
  const double margin = gap_margin * data.scale;
  if (pair.resting) {
    return std::max(lower - upper, upper + (1 - 2 * deepest_hollow) * lower) + data.resting_gap + margin;
  }
  if (!pair.attached()) return upper + lower + data.gap + margin;
  return std::max(attached_distance(pair.kappa, upper, lower), lower - upper + data.front_margin);
}

MidSurface::MidSurface(const SheetOperator& op, MidSurfaceData data)
    : op_(op),
      data_(with_stiffness(std::move(data), op.stiffness.cols())),
      solver_(make_problem(op_, data_)),
      shape_(Eigen::VectorXd::Zero(op_.stiffness.cols())) {
  solver_.set_target(target());
}

Eigen::VectorXd MidSurface::target() const {
  const Eigen::Index count = op_.stiffness.cols();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(count + data_.node_z.size());
  for (Eigen::Index n = 0; n < data_.node_z.size(); ++n) result[count + n] = pull_of(data_, n) * data_.node_z[n];
  return result;
}

void MidSurface::move_nodes(const Eigen::VectorXd& node_z) {
  data_.node_z = node_z;
  solver_.set_target(target());
}

MidSurfaceResult MidSurface::solve(const Eigen::VectorXd& thickness, Progress& progress) {
  Eigen::VectorXd bounds(static_cast<Eigen::Index>(data_.pairs.size()));
  Eigen::Index row = 0;
  for (const StackedPair& pair : data_.pairs) {
    bounds[row++] = least_distance(data_, pair, thickness) - (shape_[pair.upper] - shape_[pair.lower]);
  }
  solver_.set_inequality_bounds(std::move(bounds));
  const LeastSquaresSolution solution = solver_.solve(progress);
  const bool found = solution.converged && !solution.singular_objective;
  const Eigen::VectorXd open = solution.remaining_step.cwiseAbs() / data_.scale;
  return {solution.x + shape_, solution.iterations, std::max(solution.primal_residual, solution.dual_residual),
          found ? open : Eigen::VectorXd::Constant(solution.x.size(), std::numeric_limits<double>::infinity())};
}

}  // namespace croquis::silhouette
