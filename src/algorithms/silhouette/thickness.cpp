// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/thickness.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace croquis::silhouette {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Factorisation = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>>;

/// Against the stiffness matrix, which has no unit: on a tube values settle within a quarter of the radius.
constexpr double node_stiffness = 10;

/// Keeps a part without any node regular; too weak to be noticed elsewhere.
constexpr double background_stiffness = 1e-9;

/// The least u inside, as a part of that of a disk inscribed at the vertex' own triangles. Only reached when a very
/// obtuse triangle breaks the maximum principle.
constexpr double least_load = 0.25;

/// Rows and columns of inner vertices.
struct InnerSystem {
  std::vector<int> row_of;  ///< per vertex; -1 on the boundary
  std::vector<int> vertex;  ///< per row
  Matrix matrix;
};

InnerSystem inner_system(const SheetOperator& op) {
  InnerSystem system;
  for (int v = 0; v < op.stiffness.cols(); ++v) {
    const bool inner = !op.on_boundary[static_cast<std::size_t>(v)];
    system.row_of.push_back(inner ? static_cast<int>(system.vertex.size()) : -1);
    if (inner) system.vertex.push_back(v);
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(op.stiffness.nonZeros()));
  for (const int v : system.vertex) {
    for (Matrix::InnerIterator near(op.stiffness, v); near; ++near) {
      const int row = system.row_of[static_cast<std::size_t>(near.row())];
      if (row >= 0) entries.emplace_back(row, system.row_of[static_cast<std::size_t>(v)], near.value());
    }
  }
  const auto count = static_cast<Eigen::Index>(system.vertex.size());
  system.matrix.resize(count, count);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

Eigen::VectorXd solve_inner(const InnerSystem& system, const Factorisation& factors, const Eigen::VectorXd& load) {
  Eigen::VectorXd right(system.matrix.cols());
  for (Eigen::Index row = 0; row < right.size(); ++row) right[row] = load[system.vertex[static_cast<std::size_t>(row)]];
  const Eigen::VectorXd inner = factors.solve(right);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(load.size());
  for (Eigen::Index row = 0; row < inner.size(); ++row)
    values[system.vertex[static_cast<std::size_t>(row)]] = inner[row];
  return values;
}

/// The load for which linear elements give at the vertices what the true solution, close to u, has there.
Eigen::VectorXd corrected_load(const SheetOperator& op, const Eigen::VectorXd& u) {
  std::vector<Hessian> hessians = recover_hessians(op, u);
  for (Hessian& h : hessians) {
    const double excess = (h[0] + h[2] + 4) / 2;  // the equation says what the trace is
    h[0] -= excess;
    h[2] -= excess;
    const double deviation = std::hypot((h[0] - h[2]) / 2, h[1]);
    // A tube has (0, -4), deviation 2; more than that is noise near a corner.
    if (deviation > 2) h = Hessian(-2, 0, -2) + (h - Hessian(-2, 0, -2)) * (2 / deviation);
  }
  return apply_to_hessians(op, hessians).cwiseMax(least_load * 4 * op.area);
}

}  // namespace

struct NodeExtension::Factors {
  Factorisation factorisation;
  std::vector<LiftedPlace> nodes;
  Eigen::VectorXd background;
};

NodeExtension::NodeExtension(const SheetOperator& op, const std::vector<LiftedPlace>& nodes)
    : factors_(std::make_unique<Factors>()) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const LiftedPlace& node : nodes) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        entries.emplace_back(node.vertices[i], node.vertices[j], node_stiffness * node.weights[i] * node.weights[j]);
      }
    }
  }
  const Eigen::Index count = op.stiffness.cols();
  factors_->background = Eigen::VectorXd::Constant(count, background_stiffness);
  for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(v, v, background_stiffness);
  Matrix springs(count, count);
  springs.setFromTriplets(entries.begin(), entries.end());
  factors_->factorisation.compute(op.stiffness + springs);
  factors_->nodes = nodes;
}

NodeExtension::~NodeExtension() = default;
NodeExtension::NodeExtension(NodeExtension&&) noexcept = default;

Eigen::VectorXd NodeExtension::extend(const Eigen::VectorXd& node_values) const {
  const double middle = node_values.size() > 0 ? node_values.mean() : 1;
  Eigen::VectorXd right = middle * factors_->background;
  for (std::size_t n = 0; n < factors_->nodes.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      right[factors_->nodes[n].vertices[i]] +=
          node_stiffness * factors_->nodes[n].weights[i] * node_values[static_cast<Eigen::Index>(n)];
    }
  }
  return factors_->factorisation.solve(right);
}

double value_at(const LiftedPlace& place, const Eigen::VectorXd& values) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += place.weights[i] * values[place.vertices[i]];
  return sum;
}

Eigen::VectorXd sheet_thickness(const SheetOperator& op, const std::vector<LiftedPlace>& nodes,
                                const Eigen::VectorXd& radii, const NodeExtension& extension, Progress& progress) {
  const InnerSystem system = inner_system(op);
  const Factorisation factors(system.matrix);
  progress.check();
  Eigen::VectorXd u = solve_inner(system, factors, 4 * op.area);
  u = solve_inner(system, factors, corrected_load(op, u));
  for (const int v : system.vertex) u[v] = std::max(u[v], least_load * op.area[v]);
  progress.check();

  Eigen::VectorXd beta(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    // Interpolated u rather than its root: the root of the mean has the smaller error.
    beta[i] = std::clamp(radii[i] / std::sqrt(std::max(value_at(nodes[n], u), 1e-300)), 0.5, 1.2);
  }
  return extension.extend(beta).cwiseProduct(u.cwiseSqrt());
}

}  // namespace croquis::silhouette
