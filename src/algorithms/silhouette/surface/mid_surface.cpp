// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/mid_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/solver/least_squares_solver.h"

namespace croquis::silhouette {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Against the nodes' pull: bends shorter than about half of L are smoothed out.
constexpr double bending = 0.02;

/// Added to the gap, in L: what rounding and the solver's tolerance may take away again.
constexpr double gap_margin = 1e-5;

/// Scales a row of the stiffness matrix to the root of the bending energy at its vertex.
double row_scale(const SheetOperator& op, double scale, Eigen::Index v) {
  return std::sqrt(bending / op.area[v]) * scale;
}

double stiffness_at(const MidSurfaceData& data, Eigen::Index v) {
  return data.stiffness.size() > 0 ? data.stiffness[v] : 1;
}

double bending_at(const MidSurfaceData& data, Eigen::Index v) {
  return data.bending.size() > 0 ? data.bending[v] * stiffness_at(data, v) : 1;
}

/// Of a node's row: the root of the length that it stands for, times its sheet's stiffness.
double pull_of(const MidSurfaceData& data, Eigen::Index n) {
  const LiftedPlace& place = data.nodes[static_cast<std::size_t>(n)];
  return std::sqrt(data.node_length[n] / data.scale) * stiffness_at(data, place.vertices[0]);
}

LeastSquaresProblem make_problem(const SheetOperator& op, const MidSurfaceData& data) {
  const Eigen::Index count = op.stiffness.cols();
  Triplets rows;
  rows.reserve(static_cast<std::size_t>(op.stiffness.nonZeros()) + 3 * data.nodes.size());
  for (Eigen::Index v = 0; v < count; ++v) {
    for (Matrix::InnerIterator entry(op.stiffness, v); entry; ++entry) {
      const double factor = row_scale(op, data.scale, entry.row()) * bending_at(data, entry.row());
      rows.emplace_back(entry.row(), v, factor * entry.value());
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

/// Pairs of vertices of triangles above one another, each once.
class PairCollector {
 public:
  explicit PairCollector(const LiftedTriangulation& lifted)
      : lifted_(lifted), last_(lifted.planar_vertex.size(), no_index) {}

  void add(Index upper, Index lower, double kappa) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const StackedPair pair{lifted_.triangles[upper][corner], lifted_.triangles[lower][corner], kappa, false};
      // Most triangles around a vertex repeat its pair.
      if (std::exchange(last_[pair.upper], pair.lower) != pair.lower) pairs_.push_back(pair);
    }
  }

  std::vector<StackedPair> take() {
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return std::move(pairs_);
  }

 private:
  const LiftedTriangulation& lifted_;
  std::vector<Index> last_;  ///< per vertex the last one that was found below it
  std::vector<StackedPair> pairs_;
};

}  // namespace

std::vector<StackedPair> stacked_pairs(const SheetSampling& sheets, const std::vector<Index>& objects,
                                       const Attachments& attachments) {
  PairCollector pairs(sheets.lifted);
  const LiftedTriangulation& lifted = sheets.lifted;
  for (Index t = 0; t < sheets.planar.triangles.size(); ++t) {
    for (Index upper = lifted.first_copy[t]; upper < lifted.first_copy[t + 1]; ++upper) {
      for (Index lower = upper + 1; lower < lifted.first_copy[t + 1]; ++lower) {
        pairs.add(upper, lower, attachments.kappa(objects[upper], objects[lower]).value_or(StackedPair::apart));
      }
    }
  }
  return pairs.take();
}

std::vector<StackedPair> stacked_pairs(const SheetSampling& sheets) {
  PairCollector pairs(sheets.lifted);
  const LiftedTriangulation& lifted = sheets.lifted;
  for (Index t = 0; t < sheets.planar.triangles.size(); ++t) {
    for (Index m = lifted.first_copy[t]; m + 1 < lifted.first_copy[t + 1]; ++m) {
      pairs.add(m, m + 1, StackedPair::apart);
    }
  }
  return pairs.take();
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

struct MidSurface::State {
  const SheetOperator& op;
  MidSurfaceData data;
  LeastSquaresSolver solver;
  Eigen::VectorXd shape;  ///< unknowns are heights over it

  State(const SheetOperator& sheet_operator, MidSurfaceData d)
      : op(sheet_operator),
        data(std::move(d)),
        solver(make_problem(op, data)),
        shape(Eigen::VectorXd::Zero(op.stiffness.cols())) {
    solver.set_target(target());
  }

  Eigen::VectorXd target() const {
    const Eigen::Index count = op.stiffness.cols();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(count + data.node_z.size());
    for (Eigen::Index n = 0; n < data.node_z.size(); ++n) {
      result[count + n] = pull_of(data, n) * data.node_z[n];
    }
    return result;
  }

  Eigen::VectorXd bounds(const Eigen::VectorXd& thickness) const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(data.pairs.size()));
    Eigen::Index row = 0;
    for (const StackedPair& pair : data.pairs) {
      result[row++] = least_distance(data, pair, thickness) - (shape[pair.upper] - shape[pair.lower]);
    }
    return result;
  }
};

MidSurface::MidSurface(const SheetOperator& op, MidSurfaceData data)
    : state_(std::make_unique<State>(op, std::move(data))) {}

MidSurface::~MidSurface() = default;

void MidSurface::move_nodes(const Eigen::VectorXd& node_z) {
  state_->data.node_z = node_z;
  state_->solver.set_target(state_->target());
}

void MidSurface::set_shape(const Eigen::VectorXd& shape) { state_->shape = shape; }

MidSurfaceResult MidSurface::solve(const Eigen::VectorXd& thickness, Progress& progress) {
  state_->solver.set_inequality_bounds(state_->bounds(thickness));
  const LeastSquaresSolution solution = state_->solver.solve(progress);
  const bool found = solution.converged && !solution.singular_objective;
  const Eigen::VectorXd open = solution.remaining_step.cwiseAbs() / state_->data.scale;
  return {solution.x + state_->shape, solution.iterations, std::max(solution.primal_residual, solution.dual_residual),
          found ? open : Eigen::VectorXd::Constant(solution.x.size(), std::numeric_limits<double>::infinity())};
}

}  // namespace croquis::silhouette
