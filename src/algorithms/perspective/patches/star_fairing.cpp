// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/star_fairing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

#include "algorithms/perspective/patches/patch_energy.h"

namespace croquis {
namespace {

/// How much the squares of differences across the spokes count beside the variation of the patches.
constexpr double spoke_weight = 100;

constexpr int most_rounds = 8;
constexpr double least_gain = 1e-4;  ///< of the energy in a round

/// A spoke's handles stay within these parts of what they were, seen along their first direction.
constexpr double shortest_handle = 0.2, longest_handle = 4;

constexpr std::array<double, 4> spoke_places = {0.2, 0.45, 0.7, 0.95};

/// What may move: the middle (3), the normal there (2), and of each spoke the handle at the side (2 or 3) and the one
/// at the middle (2).
class StarVariables {
 public:
  StarVariables(const std::vector<FaceSide>& sides, const StarShape& start) : start_(start) {
    size_ = start.end_legs.front().norm();
    for (const Vec3& leg : start.end_legs) size_ = std::max(size_, leg.norm());
    plane_ = {start.end_legs[0].normalized(), start.normal.cross(start.end_legs[0].normalized())};
    int next = 5;
    for (const FaceSide& side : sides) {
      first_.push_back(next);
      bases_.push_back({side.tangent, side.inwards});
      // Where faces go on smoothly into each other the handle stays in their tangent plane.
      if (!side.first.common) bases_.back().push_back(side.tangent.cross(side.inwards).normalized());
      next += static_cast<int>(bases_.back().size()) + 2;
    }
    first_.push_back(next);
  }

  int count() const { return first_.back(); }

  /// The variables that a patch depends on.
  std::vector<int> of_patch(std::size_t i) const {
    const std::size_t spokes = bases_.size(), before = (i + spokes - 1) % spokes;
    std::vector<int> result = {0, 1, 2, 3, 4};
    for (const std::size_t spoke : {before, i}) {
      for (int v = first_[spoke]; v < first_[spoke + 1]; ++v) result.push_back(v);
      if (before == i) break;
    }
    return result;
  }

  /// Values are parts of the face's size; all zero give the start.
  StarShape shape(const Eigen::VectorXd& values) const {
    StarShape shape = start_;
    shape.middle += size_ * values.head<3>();
    shape.normal = (start_.normal + values[3] * plane_[0] + values[4] * plane_[1]).normalized();
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      int v = first_[i];
      for (const Vec3& direction : bases_[i]) shape.start_legs[i] += size_ * values[v++] * direction;
      shape.end_legs[i] += size_ * (values[v] * plane_[0] + values[v + 1] * plane_[1]);
      shape.end_legs[i] -= shape.normal.dot(shape.end_legs[i]) * shape.normal;
    }
    return shape;
  }

  /// Whether no handle became too short, too long or turned round.
  bool allowed(const StarShape& shape) const {
    const auto near = [](const Vec3& now, const Vec3& then) {
      const double part = now.dot(then) / then.squaredNorm();
      return part > shortest_handle && part < longest_handle;
    };
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      if (!near(shape.start_legs[i], start_.start_legs[i]) || !near(shape.end_legs[i], start_.end_legs[i]))
        return false;
    }
    return true;
  }

 private:
  const StarShape& start_;
  double size_ = 1;
  std::array<Vec3, 2> plane_;
  std::vector<std::vector<Vec3>> bases_;
  std::vector<int> first_;
};

/// The energy of a star and, by Gauss and Newton, how it changes with the variables.
class StarEnergy {
 public:
  StarEnergy(const std::vector<FaceSide>& sides, const StarVariables& variables, const PatchOptions& options)
      : sides_(sides), variables_(variables), options_(options) {
    for (std::size_t k = 0; k < spoke_places.size(); ++k) {
      ending_[k] = second_derivative(1, spoke_places[k], true);
      beginning_[k] = second_derivative(spoke_places[k], 1, false);
    }
  }

  double at(const Eigen::VectorXd& values) const {
    const std::vector<PatchPoints> points = points_at(variables_.shape(values));
    double energy = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      energy += points[i].cwiseProduct(variation_energy() * points[i]).sum();
      for (std::size_t k = 0; k < spoke_places.size(); ++k) {
        energy += spoke_share * difference(points, i, k).squaredNorm();
      }
    }
    return energy;
  }

  /// @param hessian,gradient are set
  void derive(const Eigen::VectorXd& values, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    const std::vector<PatchPoints> points = points_at(variables_.shape(values));
    const std::vector<std::vector<PatchPoints>> changes = changes_at(values, points);
    hessian = Eigen::MatrixXd::Zero(variables_.count(), variables_.count());
    gradient = Eigen::VectorXd::Zero(variables_.count());
    for (std::size_t i = 0; i < points.size(); ++i) {
      add_variation(variables_.of_patch(i), changes[i], points[i], hessian, gradient);
      add_differences(i, changes, points, hessian, gradient);
    }
  }

 private:
  static constexpr double spoke_share = spoke_weight / spoke_places.size();
  static constexpr double step = 1e-5;

  std::vector<PatchPoints> points_at(const StarShape& shape) const {
    std::vector<PatchPoints> points;
    for (std::size_t i = 0; i < sides_.size(); ++i) points.push_back(points_of(star_patch(sides_, shape, i, options_)));
    return points;
  }

  /// What the patches before and behind spoke i differ by in the second derivative across it.
  Eigen::RowVector3d difference(const std::vector<PatchPoints>& points, std::size_t i, std::size_t place) const {
    const std::size_t behind = (i + 1) % points.size();
    return ending_[place].transpose() * points[i] - beginning_[place].transpose() * points[behind];
  }

  /// Per patch and variable of it, how its points change.
  std::vector<std::vector<PatchPoints>> changes_at(const Eigen::VectorXd& values,
                                                   const std::vector<PatchPoints>& points) const {
    std::vector<std::vector<PatchPoints>> changes(points.size());
    std::vector<StarShape> shapes;
    for (int v = 0; v < variables_.count(); ++v) {
      Eigen::VectorXd moved = values;
      moved[v] += step;
      shapes.push_back(variables_.shape(moved));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const int v : variables_.of_patch(i)) {
        const StarShape& shape = shapes[static_cast<std::size_t>(v)];
        changes[i].push_back((points_of(star_patch(sides_, shape, i, options_)) - points[i]) / step);
      }
    }
    return changes;
  }

  static void add_variation(const std::vector<int>& variables, const std::vector<PatchPoints>& changes,
                            const PatchPoints& points, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) {
    for (std::size_t a = 0; a < variables.size(); ++a) {
      const PatchPoints force = variation_energy() * changes[a];
      gradient[variables[a]] += force.cwiseProduct(points).sum();
      for (std::size_t b = 0; b < variables.size(); ++b) {
        hessian(variables[a], variables[b]) += force.cwiseProduct(changes[b]).sum();
      }
    }
  }

  void add_differences(std::size_t i, const std::vector<std::vector<PatchPoints>>& changes,
                       const std::vector<PatchPoints>& points, Eigen::MatrixXd& hessian,
                       Eigen::VectorXd& gradient) const {
    const std::size_t behind = (i + 1) % points.size();
    const std::vector<int> before_variables = variables_.of_patch(i), behind_variables = variables_.of_patch(behind);
    for (std::size_t k = 0; k < spoke_places.size(); ++k) {
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(variables_.count(), 3);
      for (std::size_t a = 0; a < before_variables.size(); ++a) {
        rows.row(before_variables[a]) += ending_[k].transpose() * changes[i][a];
      }
      for (std::size_t a = 0; a < behind_variables.size(); ++a) {
        rows.row(behind_variables[a]) -= beginning_[k].transpose() * changes[behind][a];
      }
      hessian += spoke_share * rows * rows.transpose();
      gradient += spoke_share * rows * difference(points, i, k).transpose();
    }
  }

  const std::vector<FaceSide>& sides_;
  const StarVariables& variables_;
  const PatchOptions& options_;
  std::array<PatchWeights, spoke_places.size()> ending_, beginning_;
};

}  // namespace

StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start, const PatchOptions& options) {
  const StarVariables variables(sides, start);
  const StarEnergy energy(sides, variables, options);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(variables.count()), gradient;
  Eigen::MatrixXd hessian;
  double now = energy.at(values), damping = 1e-3;
  for (int round = 0; round < most_rounds; ++round) {
    energy.derive(values, hessian, gradient);
    const double before = now;
    for (int attempt = 0; attempt < 4; ++attempt, damping *= 10) {
      Eigen::MatrixXd damped = hessian;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * hessian.diagonal().maxCoeff();
      const Eigen::VectorXd trial = values - damped.ldlt().solve(gradient);
      if (!trial.allFinite() || !variables.allowed(variables.shape(trial))) continue;
      const double there = energy.at(trial);
      if (there >= now) continue;
      values = trial;
      now = there;
      damping /= 10;
      break;
    }
    if (now > (1 - least_gain) * before) break;
  }
  return variables.shape(values);
}

}  // namespace croquis
