// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sample_problems.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace croquis::test {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Collects rows one after the other.
class Rows {
 public:
  void begin(double bound = 0) { bounds_.push_back(bound); }
  void add(int column, double value) { entries_.emplace_back(static_cast<int>(bounds_.size()) - 1, column, value); }

  void store(int unknowns, Eigen::SparseMatrix<double>& matrix, Eigen::VectorXd& bounds) const {
    matrix.resize(static_cast<Eigen::Index>(bounds_.size()), unknowns);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    bounds = Eigen::Map<const Eigen::VectorXd>(bounds_.data(), static_cast<Eigen::Index>(bounds_.size()));
  }

 private:
  Triplets entries_;
  std::vector<double> bounds_;
};

double turn(int i, int n) { return 2 * std::numbers::pi * i / n; }

struct DepthRows {
  Rows objective, equalities, inequalities;
};

/// Bending with nu = 1/2 and the C1 row of one edge.
void add_edge(int a, int b, const Eigen::Vector2d& way, double size, DepthRows& rows) {
  const double length = way.norm();
  const Eigen::Vector2d along = way / length;
  const Eigen::Vector2d across(-along.y(), along.x());
  const double weight = std::sqrt(size / length);
  for (const Eigen::Vector2d& direction : {Eigen::Vector2d(std::sqrt(0.75) * along), across}) {
    rows.objective.begin();
    for (int k = 0; k < 2; ++k) {
      rows.objective.add(3 * b + 1 + k, weight * direction[k]);
      rows.objective.add(3 * a + 1 + k, -weight * direction[k]);
    }
  }
  rows.equalities.begin();
  rows.equalities.add(3 * b, 2 / length);
  rows.equalities.add(3 * a, -2 / length);
  for (int k = 0; k < 2; ++k) {
    rows.equalities.add(3 * a + 1 + k, -along[k]);
    rows.equalities.add(3 * b + 1 + k, -along[k]);
  }
}

void add_node(int node, double share, double size, DepthRows& rows) {
  const double weight = 0.1 * std::sqrt(share / size);
  for (int k = 0; k < 3; ++k) {
    rows.objective.begin();
    rows.objective.add(3 * node + k, k == 0 ? weight / size : weight);
  }
}

struct PlacedNode {
  Eigen::Vector3d place;
  int line, index, count;
};

/// Neighbours on one line touch by nature; only nodes well apart along it can collide.
bool may_collide(const PlacedNode& a, const PlacedNode& b) {
  if (a.line != b.line) return true;
  const int apart = std::abs(a.index - b.index);
  return std::min(apart, a.count - apart) > a.count / 12;
}

void add_collisions(const std::vector<PlacedNode>& nodes, double radius, DepthRows& rows) {
  const double reach = 2.1 * radius;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t k = i + 1; k < nodes.size(); ++k) {
      const Eigen::Vector3d way = nodes[i].place - nodes[k].place;
      const double distance = way.head<2>().norm();
      if (distance >= reach || !may_collide(nodes[i], nodes[k])) continue;
      rows.inequalities.begin(std::sqrt(reach * reach - distance * distance));
      const double sign = way.z() > 0 ? 1 : -1;
      rows.inequalities.add(3 * static_cast<int>(i), sign);
      rows.inequalities.add(3 * static_cast<int>(k), -sign);
    }
  }
}

struct SheetRows {
  int length, width;  // cells
  Rows objective, inequalities;

  int vertex(int sheet, int i, int k) const { return (sheet * (length + 1) + i) * (width + 1) + k; }
};

/// The plate's row of one vertex, and the membrane's of the edges that start there.
void add_bending(int sheet, int i, int k, SheetRows& rows) {
  const double plate = std::sqrt(0.02) * 20 / 3;  // a tube's radius over the spacing of triangles
  const double membrane = std::sqrt(0.02);
  const int here = rows.vertex(sheet, i, k);
  std::vector<int> later;
  if (i < rows.length) later.push_back(rows.vertex(sheet, i + 1, k));
  if (k < rows.width) later.push_back(rows.vertex(sheet, i, k + 1));
  std::vector<int> neighbours = later;
  if (i > 0) neighbours.push_back(rows.vertex(sheet, i - 1, k));
  if (k > 0) neighbours.push_back(rows.vertex(sheet, i, k - 1));
  rows.objective.begin();
  for (const int other : neighbours) rows.objective.add(other, plate);
  rows.objective.add(here, -plate * static_cast<double>(neighbours.size()));
  for (const int other : later) {
    rows.objective.begin();
    rows.objective.add(other, membrane);
    rows.objective.add(here, -membrane);
  }
}

void add_anchor(int sheet, int i, int k, SheetRows& rows) {
  rows.objective.begin(10 * std::sin(0.1 * i + sheet) + 8 * std::cos(0.13 * k * (sheet + 1)) - 4 * sheet);
  rows.objective.add(rows.vertex(sheet, i, k), 1);
}

void add_separation(int sheet, int i, int k, double share, SheetRows& rows) {
  const double from_centre = std::hypot(2.0 * i / rows.length - 1, 2.0 * k / rows.width - 1);
  if (from_centre * from_centre * std::numbers::pi / 4 >= share) return;
  rows.inequalities.begin(2 + 10 * std::sqrt(std::max(0.0, 1 - from_centre * from_centre)));
  rows.inequalities.add(rows.vertex(sheet, i, k), 1);
  rows.inequalities.add(rows.vertex(sheet - 1, i, k), -1);
}

}  // namespace

std::vector<CentreLine> chain_of_rings(int rings, int nodes_per_ring) {
  std::vector<CentreLine> lines(static_cast<std::size_t>(rings));
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < nodes_per_ring; ++i) {
      const double angle = turn(i, nodes_per_ring);
      const double y = 100 * std::sin(angle);
      lines[static_cast<std::size_t>(ring)].nodes.emplace_back(130 * ring + 100 * std::cos(angle), y,
                                                               ring % 2 == 0 ? y : -y);
    }
  return lines;
}

std::vector<CentreLine> trefoil(int nodes) {
  CentreLine line;
  for (int i = 0; i < nodes; ++i) {
    const double t = turn(i, nodes);
    line.nodes.emplace_back(50 * (std::sin(t) + 2 * std::sin(2 * t)), 50 * (std::cos(t) - 2 * std::cos(2 * t)),
                            -50 * std::sin(3 * t));
  }
  return {line};
}

LeastSquaresProblem depth_problem(const std::vector<CentreLine>& lines, double radius) {
  DepthRows rows;
  std::vector<PlacedNode> nodes;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const int first = static_cast<int>(nodes.size());
    const int count = static_cast<int>(lines[line].nodes.size());
    for (int i = 0; i < count; ++i)
      nodes.push_back({lines[line].nodes[static_cast<std::size_t>(i)], static_cast<int>(line), i, count});
    for (int i = 0; i < count; ++i) {
      const auto at = [&](int k) { return nodes[static_cast<std::size_t>(first + k)].place.head<2>(); };
      const Eigen::Vector2d way = at((i + 1) % count) - at(i);
      add_edge(first + i, first + (i + 1) % count, way, radius, rows);
      add_node(first + i, way.norm(), radius, rows);
    }
  }
  add_collisions(nodes, radius, rows);

  const int unknowns = 3 * static_cast<int>(nodes.size());
  LeastSquaresProblem problem;
  rows.objective.store(unknowns, problem.objective, problem.target);
  rows.equalities.store(unknowns, problem.equalities, problem.equality_values);
  rows.inequalities.store(unknowns, problem.inequalities, problem.inequality_bounds);
  return problem;
}

LeastSquaresProblem sheet_problem(int cells, int sheets, double constrained_share) {
  return sheet_strip(cells, cells, sheets, constrained_share);
}

LeastSquaresProblem sheet_strip(int length, int width, int sheets, double constrained_share) {
  SheetRows rows{length, width, {}, {}};
  for (int sheet = 0; sheet < sheets; ++sheet)
    for (int i = 0; i <= length; ++i)
      for (int k = 0; k <= width; ++k) {
        add_bending(sheet, i, k, rows);
        if (i % 7 == 3 && k % 7 == 3) add_anchor(sheet, i, k, rows);
        if (sheet > 0) add_separation(sheet, i, k, constrained_share, rows);
      }
  const int unknowns = rows.vertex(sheets, 0, 0);
  LeastSquaresProblem problem;
  rows.objective.store(unknowns, problem.objective, problem.target);
  rows.inequalities.store(unknowns, problem.inequalities, problem.inequality_bounds);
  return problem;
}

LeastSquaresProblem random_problem(const RandomShape& shape, std::uint32_t seed) {
  std::mt19937 random(seed);
  // Not std::normal_distribution: its numbers differ between libraries.
  const auto number = [&random] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  const auto rows = [&](int count) {
    Eigen::MatrixXd matrix(count, shape.unknowns);
    for (double& value : matrix.reshaped()) value = number();
    return matrix;
  };
  const Eigen::MatrixXd objective = rows(shape.objective_rows);
  const Eigen::MatrixXd equalities = rows(shape.equalities);
  const Eigen::MatrixXd inequalities = rows(shape.inequalities);
  Eigen::VectorXd feasible(shape.unknowns);
  for (double& value : feasible) value = 3 * number();

  LeastSquaresProblem problem;
  problem.objective = objective.sparseView();
  problem.equalities = equalities.sparseView();
  problem.inequalities = inequalities.sparseView();
  problem.target.resize(shape.objective_rows);
  for (double& value : problem.target) value = number();
  problem.equality_values = equalities * feasible;
  problem.inequality_bounds = inequalities * feasible;
  for (int row = shape.tight; row < shape.inequalities; ++row)
    problem.inequality_bounds[row] -= std::max(0.0, number() + 0.3);
  return problem;
}

}  // namespace croquis::test
