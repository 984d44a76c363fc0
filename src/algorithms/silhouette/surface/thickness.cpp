// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/thickness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/silhouette/surface/rim_turn.h"
#include "croquis/solver/symmetric_factors.h"

namespace croquis::silhouette {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Against the stiffness matrix, which has no unit: on a tube values settle within a quarter of the radius.
constexpr double node_stiffness = 10;

constexpr int node_pulls = 2;

/// How far a node's pull is spread, in radii: a pull at a point of a wide body would be seen as a bump.
constexpr double node_reach = 0.6;

/// Keeps a part without any node regular; too weak to be noticed elsewhere.
constexpr double background_stiffness = 1e-6;

/// The least u inside, as a part of that of a disk inscribed at the vertex' own triangles. Only reached when a very
/// obtuse triangle breaks the maximum principle.
constexpr double least_load = 0.25;

/// Of a rim's curvature times radius. At 1, where a tube ends in a half disk, the weight would vanish.
constexpr double greatest_turn = 0.8;

/// A chord whose half and distance make no more than that of the square of a larger ball's radius is a section of that
/// ball. Drawn balls aren't exact.
constexpr double covered_chord = 1.1;
constexpr double smaller = 0.95;  // of the radius: along a tube each node speaks for itself

// Between these, beta is sqrt(1/2) on a tube, less where a limb flares, and 1 on a disk.
constexpr double least_beta = 0.6;
constexpr double greatest_beta = 1.2;

/// Solves systems of one region's inner vertices: what vanishes on the boundary. All weights have the same pattern, so
/// that the order of elimination is found once.
class InnerSolver {
 public:
  explicit InnerSolver(const SheetOperator& op) : row_of_(op.on_boundary.size(), -1) {
    for (std::size_t v = 0; v < row_of_.size(); ++v) {
      if (op.on_boundary[v]) continue;
      row_of_[v] = static_cast<int>(vertex_.size());
      vertex_.push_back(static_cast<Eigen::Index>(v));
    }
    matrix_.resize(static_cast<Eigen::Index>(vertex_.size()), static_cast<Eigen::Index>(vertex_.size()));
    fill(op.stiffness);
    factorisation_.compute(matrix_);
  }

  /// From then on for another weight of the same region.
  void set_operator(const SheetOperator& op) {
    fill(op.stiffness);
    factorisation_.factorize(matrix_);
  }

  /// Inner vertices, ascending.
  const std::vector<Eigen::Index>& vertices() const { return vertex_; }

  /// The solution of the load that vanishes on the boundary.
  Eigen::VectorXd solve(const Eigen::VectorXd& load) const {
    const Eigen::VectorXd right = load(vertex_);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(load.size());
    values(vertex_) = factorisation_.solve(right).eval();
    return values;
  }

 private:
  /// The lower triangle.
  void fill(const Matrix& stiffness) {
    matrix_.setZero();
    matrix_.reserve(stiffness.nonZeros() / 2 + matrix_.cols());
    for (Eigen::Index column = 0; column < matrix_.cols(); ++column) {
      matrix_.startVec(column);
      for (Matrix::InnerIterator near(stiffness, vertex_[static_cast<std::size_t>(column)]); near; ++near) {
        const int row = row_of_[static_cast<std::size_t>(near.row())];
        if (row >= column) matrix_.insertBack(row, column) = near.value();
      }
    }
    matrix_.finalize();
  }

  std::vector<int> row_of_;           ///< per vertex; -1 on the boundary
  std::vector<Eigen::Index> vertex_;  ///< per row
  Matrix matrix_;
  SymmetricFactors factorisation_;
};

/// The values of ln w on the rim: the length of the axis per length of the rim.
Eigen::VectorXd rim_log_weights(const SheetSampling& sheets) {
  return (1 - rim_turn(sheets).array().cwiseMax(-greatest_turn).cwiseMin(greatest_turn)).log();
}

/// Extends values on the boundary, 0 inside.
Eigen::VectorXd harmonic(const SheetOperator& op, const InnerSolver& inner, const Eigen::VectorXd& boundary) {
  return boundary + inner.solve(-(op.stiffness * boundary));
}

/// A node's share of a vertex.
struct NodeShare {
  Index vertex = 0;
  Index node = 0;
  double weight = 0;
};

/// Spreads nodes over the vertices around them, in their own sheet.
class NodeSpreader {
 public:
  explicit NodeSpreader(const SheetOperator& op) : op_(op), last_seen_(op.position.size(), no_index) {}

  /// The weights of a node sum to 1; they fall off smoothly towards the distance.
  void spread(Index node, const LiftedPlace& place, double distance, std::vector<NodeShare>& shares) {
    Vec2 centre = Vec2::Zero();
    for (std::size_t i = 0; i < 3; ++i) centre += place.weights[i] * op_.position[place.vertices[i]];
    const std::size_t first = shares.size();
    queue_.assign(place.vertices.begin(), place.vertices.end());
    for (const Index v : queue_) last_seen_[v] = node;
    double sum = 0;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const Index v = queue_[head];
      const double nearness = 1 - (op_.position[v] - centre).squaredNorm() / (distance * distance);
      if (nearness <= 0) continue;
      shares.push_back({v, node, op_.area[v] * nearness * nearness});
      sum += shares.back().weight;
      for (Matrix::InnerIterator near(op_.stiffness, v); near; ++near) {
        const auto other = static_cast<Index>(near.row());
        if (last_seen_[other] != node) queue_.push_back(other);
        last_seen_[other] = node;
      }
    }
    for (std::size_t s = first; s < shares.size(); ++s) shares[s].weight /= sum;
    if (sum > 0) return;
    for (std::size_t i = 0; i < 3; ++i) shares.push_back({place.vertices[i], node, place.weights[i]});
  }

 private:
  const SheetOperator& op_;
  std::vector<Index> last_seen_;  ///< per vertex, the node that met it last
  std::vector<Index> queue_;
};

}  // namespace

struct NodeExtension::Factors {
  SymmetricFactors factorisation;
  std::vector<NodeShare> shares;
  Eigen::VectorXd background;
};

NodeExtension::NodeExtension(const SheetOperator& op, const std::vector<LiftedPlace>& nodes, const Skeleton& skeleton)
    : factors_(std::make_unique<Factors>()) {
  NodeSpreader spreader(op);
  const std::vector<std::uint8_t> speaks = speaking_nodes(skeleton);
  for (Index n = 0; n < nodes.size(); ++n) {
    if (speaks[n] != 0) spreader.spread(n, nodes[n], node_reach * skeleton.nodes[n].radius, factors_->shares);
  }
  factors_->background = background_stiffness / op.area.sum() * op.area;
  Matrix matrix = op.stiffness;
  for (Eigen::Index v = 0; v < matrix.cols(); ++v) matrix.coeffRef(v, v) += factors_->background[v];
  for (const NodeShare& share : factors_->shares) {
    matrix.coeffRef(share.vertex, share.vertex) += node_stiffness * share.weight;
  }
  factors_->factorisation.compute(matrix);
}

NodeExtension::~NodeExtension() = default;
NodeExtension::NodeExtension(NodeExtension&&) noexcept = default;

Eigen::VectorXd NodeExtension::extend(const Eigen::VectorXd& node_values) const {
  const double middle = node_values.size() > 0 ? node_values.mean() : 1;
  Eigen::VectorXd values = Eigen::VectorXd::Constant(factors_->background.size(), middle);
  for (int pull = 0; pull < node_pulls; ++pull) {
    // What the springs leave of each node's value is pulled once more: they flatten peaks.
    Eigen::VectorXd missing = node_values;
    for (const NodeShare& share : factors_->shares) missing[share.node] -= share.weight * values[share.vertex];
    Eigen::VectorXd right = Eigen::VectorXd::Zero(values.size());
    for (const NodeShare& share : factors_->shares) {
      right[share.vertex] += node_stiffness * share.weight * missing[share.node];
    }
    values += factors_->factorisation.solve(right);
  }
  return values;
}

double value_at(const LiftedPlace& place, const Eigen::VectorXd& values) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += place.weights[i] * values[place.vertices[i]];
  return sum;
}

std::vector<std::uint8_t> speaking_nodes(const Skeleton& skeleton) {
  const auto count = static_cast<Index>(skeleton.nodes.size());
  std::vector<std::vector<Index>> around(count);
  for (const auto& [a, b] : skeleton.edges) {
    around[a].push_back(b);
    around[b].push_back(a);
  }
  std::vector<Index> by_radius(count);
  std::iota(by_radius.begin(), by_radius.end(), 0);
  const auto radius = [&](Index n) { return skeleton.nodes[n].radius; };
  std::stable_sort(by_radius.begin(), by_radius.end(), [&](Index a, Index b) { return radius(a) > radius(b); });
  const auto covers = [&](Index outer, Index inner) {
    const double across = (skeleton.nodes[inner].position - skeleton.nodes[outer].position).squaredNorm();
    const double reach = radius(outer) * radius(outer);
    return across < reach && across + radius(inner) * radius(inner) < covered_chord * reach &&
           radius(inner) < smaller * radius(outer);
  };
  std::vector<std::uint8_t> met(count, 0);
  std::vector<std::uint8_t> speaks(count, 0);
  std::vector<Index> queue;
  for (const Index outer : by_radius) {
    if (met[outer] != 0) continue;
    met[outer] = speaks[outer] = 1;
    queue.assign(1, outer);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (const Index inner : around[queue[head]]) {
        if (met[inner] != 0 || !covers(outer, inner)) continue;
        met[inner] = 1;
        queue.push_back(inner);
      }
    }
  }
  return speaks;
}

Eigen::VectorXd sheet_thickness(const SheetSampling& sheets, const SheetOperator& op, const Skeleton& skeleton,
                                const std::vector<LiftedPlace>& nodes, const NodeExtension& extension,
                                Progress& progress) {
  InnerSolver inner(op);
  const Eigen::VectorXd log_weight = harmonic(op, inner, rim_log_weights(sheets));
  progress.check();
  const SheetOperator unbent = make_sheet_operator(sheets, log_weight.array().exp());
  inner.set_operator(unbent);
  Eigen::VectorXd u = inner.solve(4 * unbent.area);
  for (const Eigen::Index v : inner.vertices()) u[v] = std::max(u[v], least_load * op.area[v]);
  progress.check();

  Eigen::VectorXd beta(static_cast<Eigen::Index>(nodes.size()));
  for (Index n = 0; n < nodes.size(); ++n) {
    // Interpolated u rather than its root: the root of the mean has the smaller error.
    beta[n] = std::clamp(skeleton.nodes[n].radius / std::sqrt(std::max(value_at(nodes[n], u), 1e-300)), least_beta,
                         greatest_beta);
  }
  return extension.extend(beta).cwiseProduct(u.cwiseSqrt());
}

}  // namespace croquis::silhouette
