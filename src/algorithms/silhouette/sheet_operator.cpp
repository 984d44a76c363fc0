// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sheet_operator.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace croquis::silhouette {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Quadratic = Eigen::Matrix<double, 5, 1>;  // x, y, xx/2, xy, yy/2

constexpr int averaging_passes = 2;

/// Below this part of the largest pivot a patch doesn't determine a quadratic: its vertices lie on a conic, or a line.
constexpr double least_pivot = 1e-9;

void add_triangle(const std::array<Index, 3>& corners, const std::vector<Vec2>& position,
                  std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& area) {
  const double twice_area =
      cross(position[corners[1]] - position[corners[0]], position[corners[2]] - position[corners[0]]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Index apex = corners[k];
    const Index a = corners[(k + 1) % 3];
    const Index b = corners[(k + 2) % 3];
    const double weight = 0.5 * (position[a] - position[apex]).dot(position[b] - position[apex]) / twice_area;
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    area[apex] += twice_area / 6;
  }
}

/// The vertices within two edges of one, itself left out.
void collect_patch(const Matrix& stiffness, int vertex, std::vector<int>& patch) {
  patch.clear();
  for (Matrix::InnerIterator near(stiffness, vertex); near; ++near) {
    for (Matrix::InnerIterator far(stiffness, near.row()); far; ++far) {
      if (far.row() != vertex) patch.push_back(static_cast<int>(far.row()));
    }
  }
  std::sort(patch.begin(), patch.end());
  patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
}

/// False when the patch is too poor.
bool fit_quadratic(const SheetOperator& op, const Eigen::VectorXd& values, int vertex, const std::vector<int>& patch,
                   Hessian& hessian) {
  const auto v = static_cast<std::size_t>(vertex);
  double scale = 0;
  for (const int other : patch) {
    scale = std::max(scale, (op.position[static_cast<std::size_t>(other)] - op.position[v]).squaredNorm());
  }
  if (patch.size() < 5 || scale <= 0) return false;
  scale = std::sqrt(scale);
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Quadratic right = Quadratic::Zero();
  for (const int other : patch) {
    const Vec2 d = (op.position[static_cast<std::size_t>(other)] - op.position[v]) / scale;
    Quadratic row;
    row << d.x(), d.y(), d.x() * d.x() / 2, d.x() * d.y(), d.y() * d.y() / 2;
    const double weight = 1 / (d.squaredNorm() + 0.01);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right += weight * (values[other] - values[vertex]) * row;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 5, 5>> factors(normal.selfadjointView<Eigen::Lower>());
  const Quadratic pivots = factors.vectorD();
  if (!(pivots.minCoeff() > least_pivot * pivots.maxCoeff())) return false;
  hessian = factors.solve(right).tail<3>() / (scale * scale);
  return true;
}

/// Area-weighted means over each vertex and its neighbours, of those that have a value.
void average(const SheetOperator& op, std::vector<Hessian>& hessians, std::vector<std::uint8_t>& known) {
  const std::vector<Hessian> old = hessians;
  const std::vector<std::uint8_t> had = known;
  for (int v = 0; v < op.stiffness.cols(); ++v) {
    Hessian sum = Hessian::Zero();
    double weight = 0;
    for (Matrix::InnerIterator near(op.stiffness, v); near; ++near) {
      if (!had[static_cast<std::size_t>(near.row())]) continue;
      sum += op.area[near.row()] * old[static_cast<std::size_t>(near.row())];
      weight += op.area[near.row()];
    }
    if (weight <= 0) continue;
    hessians[static_cast<std::size_t>(v)] = sum / weight;
    known[static_cast<std::size_t>(v)] = 1;
  }
}

}  // namespace

SheetOperator make_sheet_operator(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  SheetOperator op;
  const auto count = static_cast<Eigen::Index>(lifted.planar_vertex.size());
  op.on_boundary = lifted.on_boundary;
  op.position.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) op.position.push_back(sheets.points[point]);
  op.area = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * lifted.triangles.size());
  for (const auto& corners : lifted.triangles) add_triangle(corners, op.position, entries, op.area);
  op.stiffness.resize(count, count);
  op.stiffness.setFromTriplets(entries.begin(), entries.end());
  return op;
}

std::vector<Hessian> recover_hessians(const SheetOperator& op, const Eigen::VectorXd& values) {
  std::vector<Hessian> hessians(op.position.size(), Hessian::Zero());
  std::vector<std::uint8_t> known(op.position.size(), 0);
  std::vector<int> patch;
  for (int v = 0; v < op.stiffness.cols(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (op.on_boundary[i]) continue;
    collect_patch(op.stiffness, v, patch);
    known[i] = fit_quadratic(op, values, v, patch, hessians[i]) ? 1 : 0;
  }
  for (int pass = 0; pass < averaging_passes; ++pass) average(op, hessians, known);
  return hessians;
}

Eigen::VectorXd apply_to_hessians(const SheetOperator& op, const std::vector<Hessian>& hessians) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(op.stiffness.cols());
  for (int v = 0; v < op.stiffness.cols(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (op.on_boundary[i]) continue;
    for (Matrix::InnerIterator near(op.stiffness, v); near; ++near) {
      const auto j = static_cast<std::size_t>(near.row());
      const Vec2 d = op.position[j] - op.position[i];
      // Along an edge a cubic's difference takes its second derivative a third of the way.
      const Hessian h = (2 * hessians[i] + hessians[j]) / 3;
      result[v] += near.value() * (h[0] * d.x() * d.x() / 2 + h[1] * d.x() * d.y() + h[2] * d.y() * d.y() / 2);
    }
  }
  return result;
}

}  // namespace croquis::silhouette
