// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/problem_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Finding solver_error(std::string message) { return make_error(Category::Internal, "E_SOLVER", std::move(message)); }

std::string size_text(Eigen::Index rows, Eigen::Index columns) {
  return std::to_string(rows) + " by " + std::to_string(columns);
}

/// A matrix without rows may have any width.
void check_matrix(Matrix& matrix, Eigen::Index unknowns, const std::string& name, Findings& findings) {
  matrix.makeCompressed();
  if (matrix.rows() == 0) matrix = Matrix(0, unknowns);
  if (matrix.cols() != unknowns)
    findings.push_back(solver_error("The matrix of the " + name + " is " + size_text(matrix.rows(), matrix.cols()) +
                                    ", but there are " + std::to_string(unknowns) + " unknowns; give it that width."));
  const Eigen::Map<const Eigen::VectorXd> values(matrix.valuePtr(), matrix.nonZeros());
  if (!values.allFinite())
    findings.push_back(
        solver_error("The matrix of the " + name + " holds a number that is not finite; check the rows' geometry."));
}

void check_vector(const Eigen::VectorXd& vector, Eigen::Index size, const std::string& name, Findings& findings) {
  if (vector.size() != size)
    findings.push_back(solver_error("There are " + std::to_string(vector.size()) + " " + name + " for " +
                                    std::to_string(size) + " rows; give one for each."));
  for (Eigen::Index row = 0; row < vector.size(); ++row) {
    if (std::isfinite(vector[row])) continue;
    findings.push_back(solver_error("Number " + std::to_string(row) + " of the " + name +
                                    " is not finite; check the geometry it comes from."));
    return;
  }
}

void complete_vector(Eigen::VectorXd& vector, Eigen::Index size) {
  if (vector.size() == 0) vector = Eigen::VectorXd::Zero(size);
}

}  // namespace

LeastSquaresProblem checked_and_completed(LeastSquaresProblem problem) {
  const Eigen::Index unknowns =
      std::max({problem.objective.cols(), problem.equalities.cols(), problem.inequalities.cols()});
  Findings findings;
  check_matrix(problem.objective, unknowns, "objective", findings);
  check_matrix(problem.equalities, unknowns, "equalities", findings);
  check_matrix(problem.inequalities, unknowns, "inequalities", findings);

  complete_vector(problem.target, problem.objective.rows());
  complete_vector(problem.equality_values, problem.equalities.rows());
  complete_vector(problem.inequality_bounds, problem.inequalities.rows());
  check_vector(problem.target, problem.objective.rows(), "targets", findings);
  check_vector(problem.equality_values, problem.equalities.rows(), "equality values", findings);
  check_vector(problem.inequality_bounds, problem.inequalities.rows(), "inequality bounds", findings);
  if (!findings.empty()) throw Error(std::move(findings));
  return problem;
}

void check_replacement(const Eigen::VectorXd& vector, Eigen::Index size, const char* name) {
  Findings findings;
  check_vector(vector, size, name, findings);
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace croquis
