// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/class_solution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

void tie_stroke(StrokeGroup group, const std::array<Index, 2>& ends, DisjointSets& slots) {
  const int axis = axis_of(group);
  for (int k = 0; k < 3; ++k) {
    if ((k == axis) == is_parallel(group)) continue;
    slots.unite(3 * ends[0] + static_cast<Index>(k), 3 * ends[1] + static_cast<Index>(k));
  }
}

void set_components(ClassTable& table) {
  DisjointSets sets(table.vertex_count());
  std::vector<Index> first(table.class_count(), no_index);
  for (Index v = 0; v < table.vertex_count(); ++v) {
    for (const Index c : table.of_vertex[v]) {
      if (first[c] == no_index) first[c] = v;
      sets.unite(first[c], v);
    }
  }
  table.components = sets.number(table.component);
}

using Block = Eigen::Matrix<double, 2, 3>;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<SparseMatrix>;

constexpr int reweightings = 4;
constexpr int power_rounds = 8;

/// Steps smaller than this part of the values are at the end.
constexpr double rounding = 1e-13;

/// Keeps matrices of exact drawings regular; relative to the mean diagonal.
constexpr double regularity = 1e-13;

/// Depths below this part of the mean have the weight of that part.
constexpr double least_depth = 0.05;

/// One piece that has a scale of its own.
class ComponentSolver {
 public:
  ComponentSolver(const SeenVertices& seen, const ClassTable& table, std::vector<Index> vertices)
      : seen_(seen), table_(table), vertices_(std::move(vertices)), local_(table.class_count(), no_index) {
    for (const Index v : vertices_) {
      for (const Index c : table_.of_vertex[v]) {
        if (local_[c] != no_index) continue;
        local_[c] = static_cast<Index>(classes_.size());
        classes_.push_back(c);
      }
    }
  }

  Eigen::VectorXd solve(const std::vector<Vec3>* near, int rounds) {
    Eigen::VectorXd values = start(near);
    if (near == nullptr) {
      for (int round = 0; round < reweightings; ++round) values = null_vector(values);
    }
    minimise_distances(values, rounds);
    normalise(values);
    return values;
  }

  const std::vector<Index>& classes() const { return classes_; }

  /// Inverse of the normal matrix with the scale held.
  Eigen::MatrixXd covariance(const Eigen::VectorXd& values) {
    Solver solver;
    Eigen::VectorXd gradient;
    solver.compute(newton_system(values, gradient));
    const auto count = static_cast<Eigen::Index>(classes_.size());
    if (solver.info() != Eigen::Success) return Eigen::MatrixXd::Zero(count, count);
    Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(count, count));
    const auto held = largest(values);
    inverse.row(held).setZero();
    inverse.col(held).setZero();
    return inverse;
  }

  Eigen::Vector3i slots(Index vertex) const {
    Eigen::Vector3i result;
    for (int k = 0; k < 3; ++k)
      result[k] = static_cast<int>(local_[table_.of_vertex[vertex][static_cast<std::size_t>(k)]]);
    return result;
  }

 private:
  Vec3 position(const Eigen::VectorXd& values, Index vertex) const {
    const Eigen::Vector3i at = slots(vertex);
    return {values[at[0]], values[at[1]], values[at[2]]};
  }

  /// n · X for the two planes through the ray, so that dividing by the depth gives the distance in the picture.
  Block rows(Index vertex) const {
    Block block;
    for (int i = 0; i < 2; ++i) {
      block.row(i) = seen_.focal * seen_.rotation.row(i) - seen_.places[vertex][i] * seen_.rotation.row(2);
    }
    return block;
  }

  double depth(const Eigen::VectorXd& values, Index vertex) const {
    return seen_.rotation.row(2).dot(position(values, vertex));
  }

  double mean_depth(const Eigen::VectorXd& values) const {
    double sum = 0;
    for (const Index v : vertices_) sum += depth(values, v);
    return sum / static_cast<double>(vertices_.size());
  }

  void normalise(Eigen::VectorXd& values) const {
    const double mean = mean_depth(values);
    if (mean != 0) values /= mean;
  }

  /// From those positions, or all vertices at the same depth.
  Eigen::VectorXd start(const std::vector<Vec3>* near) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(classes_.size()));
    Eigen::VectorXd count = sum;
    for (const Index v : vertices_) {
      const Vec3 place = near != nullptr ? (*near)[v] : seen_.ray(v);
      const Eigen::Vector3i at = slots(v);
      for (int k = 0; k < 3; ++k) {
        sum[at[k]] += place[k];
        count[at[k]] += 1;
      }
    }
    return sum.cwiseQuotient(count);
  }

  void add_block(const Eigen::Vector3i& at, const Eigen::Matrix3d& block,
                 std::vector<Eigen::Triplet<double>>& triplets) const {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) triplets.emplace_back(at[i], at[j], block(i, j));
    }
  }

  SparseMatrix assembled(std::vector<Eigen::Triplet<double>> triplets) const {
    const auto count = static_cast<Eigen::Index>(classes_.size());
    double trace = 0;
    for (const auto& triplet : triplets) trace += triplet.row() == triplet.col() ? triplet.value() : 0;
    const double shift = regularity * trace / static_cast<double>(count);
    for (int i = 0; i < count; ++i) triplets.emplace_back(i, i, shift);
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
  }

  Eigen::VectorXd null_vector(const Eigen::VectorXd& from) {
    const double mean = mean_depth(from);
    std::vector<Eigen::Triplet<double>> triplets;
    for (const Index v : vertices_) {
      const double ratio = std::max(depth(from, v) / mean, least_depth);
      const Block block = rows(v);
      add_block(slots(v), seen_.weights[v] / (ratio * ratio) * block.transpose() * block, triplets);
    }
    Solver solver(assembled(std::move(triplets)));
    Eigen::VectorXd values = from.normalized();
    if (solver.info() != Eigen::Success) return values;
    for (int round = 0; round < power_rounds; ++round) {
      const Eigen::VectorXd next = solver.solve(values).normalized();
      if (!next.allFinite()) return values;
      const double turned = 1 - std::abs(next.dot(values));
      values = next;
      if (turned < 1e-15) break;
    }
    if (mean_depth(values) < 0) values = -values;
    return values;
  }

  static Eigen::Index largest(const Eigen::VectorXd& values) {
    Eigen::Index at = 0;
    values.cwiseAbs().maxCoeff(&at);
    return at;
  }

  Vec2 residual(const Eigen::VectorXd& values, Index vertex) const {
    return rows(vertex) * position(values, vertex) / depth(values, vertex);
  }

  double squares(const Eigen::VectorXd& values) const {
    double sum = 0;
    for (const Index v : vertices_) {
      if (depth(values, v) <= 0) return std::numeric_limits<double>::infinity();
      sum += seen_.weights[v] * residual(values, v).squaredNorm();
    }
    return sum;
  }

  /// Distances don't change with the scale, so the largest value is held.
  SparseMatrix newton_system(const Eigen::VectorXd& values, Eigen::VectorXd& gradient) const {
    const int held = static_cast<int>(largest(values));
    gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(classes_.size()));
    std::vector<Eigen::Triplet<double>> triplets;
    for (const Index v : vertices_) {
      const Eigen::Vector3i at = slots(v);
      const Vec2 distance = residual(values, v);
      Block block = (rows(v) - distance * seen_.rotation.row(2)) / depth(values, v);
      for (int k = 0; k < 3; ++k) {
        if (at[k] == held) block.col(k).setZero();
      }
      add_block(at, seen_.weights[v] * block.transpose() * block, triplets);
      const Vec3 share = seen_.weights[v] * block.transpose() * distance;
      for (int k = 0; k < 3; ++k) gradient[at[k]] += share[k];
    }
    triplets.emplace_back(held, held, 1.0);
    return assembled(std::move(triplets));
  }

  void minimise_distances(Eigen::VectorXd& values, int rounds) const {
    normalise(values);
    double least = squares(values);
    if (!std::isfinite(least)) return;  // something lies behind the eye; who asks for the depths reports it
    Solver solver;
    for (int round = 0; round < rounds; ++round) {
      Eigen::VectorXd gradient;
      solver.compute(newton_system(values, gradient));
      if (solver.info() != Eigen::Success) return;
      const Eigen::VectorXd step = solver.solve(gradient);
      if (!step.allFinite()) return;
      // Costs are flat at their bottom: a step that leads up by rounding alone is taken.
      const double most = least * (1 + rounding) + std::numeric_limits<double>::min();
      double factor = 1;
      double next = squares(values - step);
      for (; factor > 1e-3 && !(next <= most); factor /= 2) next = squares(values - factor / 2 * step);
      if (!(next <= most)) return;
      values -= factor * step;
      least = std::min(least, next);
      if (step.norm() <= rounding * values.norm()) return;
    }
  }

  const SeenVertices& seen_;
  const ClassTable& table_;
  std::vector<Index> vertices_;
  std::vector<Index> local_;    // of each class of the table
  std::vector<Index> classes_;  // of the table
};

std::vector<std::vector<Index>> vertices_by_component(const ClassTable& table) {
  std::vector<std::vector<Index>> lists(table.components);
  for (Index v = 0; v < table.vertex_count(); ++v) lists[table.component[v]].push_back(v);
  return lists;
}

}  // namespace

ClassTable make_classes(std::size_t vertex_count, const CoordinateTies& ties) {
  DisjointSets slots(3 * vertex_count);
  for (std::size_t s = 0; s < ties.of_stroke.size(); ++s) {
    const std::array<Index, 2>& ends = ties.of_stroke[s];
    if (ties.groups[s] == StrokeGroup::Unknown || ends[0] == no_index || ends[1] == no_index) continue;
    tie_stroke(ties.groups[s], ends, slots);
  }
  for (const auto& [one, other] : ties.equal) slots.unite(one, other);
  std::vector<Index> numbers;
  const Index count = slots.number(numbers);
  ClassTable table;
  table.axis.resize(count);
  table.of_vertex.resize(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    for (int k = 0; k < 3; ++k) {
      const Index number = numbers[3 * v + static_cast<std::size_t>(k)];
      table.of_vertex[v][static_cast<std::size_t>(k)] = number;
      table.axis[number] = k;
    }
  }
  set_components(table);
  return table;
}

bool has_coincident_vertices(const ClassTable& table) {
  std::vector<std::array<Index, 3>> sorted = table.of_vertex;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

Vec3 SeenVertices::ray(Index vertex) const {
  return rotation.transpose() * Vec3(places[vertex].x() / focal, places[vertex].y() / focal, 1);
}

Vec3 ClassSolution::position(const ClassTable& table, Index vertex) const {
  const std::array<Index, 3>& at = table.of_vertex[vertex];
  return {values[at[0]], values[at[1]], values[at[2]]};
}

double ClassSolution::rms() const {
  return residuals.empty() ? 0 : std::sqrt(squares / (2 * static_cast<double>(residuals.size())));
}

double ClassSolution::rms_of_freedom() const { return std::sqrt(squares / std::max(1, freedom)); }

double ClassSolution::worst() const {
  double largest = 0;
  for (const Vec2& residual : residuals) largest = std::max(largest, residual.norm());
  return largest;
}

ClassSolution solve_classes(const SeenVertices& seen, const ClassTable& table, const std::vector<Vec3>* near,
                            int rounds) {
  ClassSolution solution;
  solution.values.resize(table.class_count());
  solution.freedom =
      static_cast<int>(2 * table.vertex_count() + table.components) - static_cast<int>(table.class_count());
  for (const std::vector<Index>& vertices : vertices_by_component(table)) {
    ComponentSolver solver(seen, table, vertices);
    const Eigen::VectorXd values = solver.solve(near, rounds);
    for (std::size_t i = 0; i < solver.classes().size(); ++i) {
      solution.values[solver.classes()[i]] = values[static_cast<Eigen::Index>(i)];
    }
  }
  for (Index v = 0; v < table.vertex_count(); ++v) {
    const Vec3 seen_from = seen.rotation * solution.position(table, v);
    if (!(seen_from.z() > 0)) solution.in_front = false;
    const Vec2 place = seen.focal * seen_from.head<2>() / seen_from.z();
    solution.residuals.push_back(place - seen.places[v]);
    solution.squares += seen.weights[v] * solution.residuals.back().squaredNorm();
  }
  return solution;
}

std::vector<double> depth_deviations(const SeenVertices& seen, const ClassTable& table, const ClassSolution& solution) {
  constexpr std::size_t most_classes = 1000;
  if (table.class_count() > most_classes) return {};
  std::vector<double> deviations(table.vertex_count(), 0);
  for (const std::vector<Index>& vertices : vertices_by_component(table)) {
    ComponentSolver solver(seen, table, vertices);
    Eigen::VectorXd values(static_cast<Eigen::Index>(solver.classes().size()));
    for (std::size_t i = 0; i < solver.classes().size(); ++i) {
      values[static_cast<Eigen::Index>(i)] = solution.values[solver.classes()[i]];
    }
    const Eigen::MatrixXd covariance = solver.covariance(values);
    for (const Index v : vertices) {
      const Eigen::Vector3i at = solver.slots(v);
      double variance = 0;
      for (int k = 0; k < 3; ++k) variance += std::max(0.0, covariance(at[k], at[k]));
      deviations[v] = std::sqrt(variance);
    }
  }
  return deviations;
}

}  // namespace croquis
