// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/patch_fairing.h"

#include <array>

#include <Eigen/Dense>

#include "algorithms/perspective/solid/plane_axes.h"

namespace croquis {
namespace {

constexpr double step = 1e-3;

PatchWeights slope_weights(double u, double v, bool along_u) {
  const GregoryWeights weights = gregory_weights(u, v);
  return Eigen::Map<const PatchWeights>((along_u ? weights.du : weights.dv).data());
}

Eigen::Matrix<double, 20, 20> make_variation_energy() {
  constexpr int cells = 12;
  Eigen::Matrix<double, 20, 20> energy = Eigen::Matrix<double, 20, 20>::Zero();
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double u = (i + 0.5) / cells, v = (j + 0.5) / cells;
      for (const bool slope_u : {true, false}) {
        for (const bool along_u : {true, false}) {
          const double du = along_u ? step : 0, dv = along_u ? 0 : step;
          const PatchWeights third = (slope_weights(u + du, v + dv, slope_u) - 2 * slope_weights(u, v, slope_u) +
                                      slope_weights(u - du, v - dv, slope_u)) /
                                     (step * step);
          energy += (slope_u == along_u ? 1 : 3) * third * third.transpose();
        }
      }
    }
  }
  return energy / (cells * cells);
}

/// How much the squares of differences across a joint count beside the variation of the patches.
constexpr double joint_weight = 100;

constexpr int most_rounds = 8;
constexpr int most_attempts = 4;
constexpr double least_gain = 1e-4;  ///< of the energy in a round

/// Parts of the way along a joint where its patches are compared.
constexpr std::array<double, 4> joint_places = {0.2, 0.45, 0.7, 0.95};

/// The second derivative across a side, a part t of the way along it.
PatchWeights across_side(std::size_t side, double t) {
  const auto [u, v] = place_on_side(side, t);
  return second_derivative(u, v, side % 2 == 1);
}

/// The second derivatives across the four sides at the places of joints, on the side's own way and on the way back.
struct JointWeights {
  std::array<std::array<PatchWeights, joint_places.size()>, 4> ahead, back;
};

const JointWeights& joint_weights() {
  static const JointWeights weights = [] {
    JointWeights made;
    for (std::size_t side = 0; side < 4; ++side) {
      for (std::size_t k = 0; k < joint_places.size(); ++k) {
        made.ahead[side][k] = across_side(side, joint_places[k]);
        made.back[side][k] = across_side(side, 1 - joint_places[k]);
      }
    }
    return made;
  }();
  return weights;
}

/// The energy of a family and how it changes with the variables.
class FamilyEnergy {
 public:
  explicit FamilyEnergy(const PatchFamily& family) : family_(family), joints_(family.joints()) {
    for (std::size_t i = 0; i < family.patches(); ++i) variables_.push_back(family.variables_of(i));
  }

  double at(const Eigen::VectorXd& values) const {
    const std::vector<PatchPoints> points = points_at(values);
    double energy = 0;
    for (const PatchPoints& patch : points) energy += patch.cwiseProduct(variation_energy() * patch).sum();
    for (const PatchJoint& joint : joints_) {
      for (std::size_t k = 0; k < joint_places.size(); ++k) {
        energy += joint_share * difference(points, joint, k).squaredNorm();
      }
    }
    return energy;
  }

  /// @param hessian,gradient are set: of half the energy, by Gauss and Newton
  void derive(const Eigen::VectorXd& values, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    const std::vector<PatchPoints> points = points_at(values);
    const std::vector<std::vector<PatchPoints>> changes = changes_at(values, points);
    hessian = Eigen::MatrixXd::Zero(values.size(), values.size());
    gradient = Eigen::VectorXd::Zero(values.size());
    for (std::size_t i = 0; i < points.size(); ++i) add_variation(i, changes[i], points[i], hessian, gradient);
    for (const PatchJoint& joint : joints_) add_differences(joint, changes, points, hessian, gradient);
  }

 private:
  static constexpr double joint_share = joint_weight / joint_places.size();
  static constexpr double step = 1e-5;

  static const PatchWeights& before(const PatchJoint& joint, std::size_t place) {
    return joint_weights().ahead[static_cast<std::size_t>(joint.before_side)][place];
  }
  static const PatchWeights& behind(const PatchJoint& joint, std::size_t place) {
    return joint_weights().back[static_cast<std::size_t>(joint.behind_side)][place];
  }

  static Eigen::RowVector3d difference(const std::vector<PatchPoints>& points, const PatchJoint& joint,
                                       std::size_t place) {
    return before(joint, place).transpose() * points[joint.before] -
           behind(joint, place).transpose() * points[joint.behind];
  }

  std::vector<PatchPoints> points_at(const Eigen::VectorXd& values) const {
    std::vector<PatchPoints> points;
    for (std::size_t i = 0; i < family_.patches(); ++i) points.push_back(points_of(family_.patch(i, values)));
    return points;
  }

  /// Per patch and variable of it, how its points change.
  std::vector<std::vector<PatchPoints>> changes_at(const Eigen::VectorXd& values,
                                                   const std::vector<PatchPoints>& points) const {
    std::vector<std::vector<PatchPoints>> changes(points.size());
    Eigen::VectorXd moved = values;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const int v : variables_[i]) {
        moved[v] += step;
        changes[i].push_back((points_of(family_.patch(i, moved)) - points[i]) / step);
        moved[v] = values[v];
      }
    }
    return changes;
  }

  void add_variation(std::size_t patch, const std::vector<PatchPoints>& changes, const PatchPoints& points,
                     Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    const std::vector<int>& variables = variables_[patch];
    for (std::size_t a = 0; a < variables.size(); ++a) {
      const PatchPoints force = variation_energy() * changes[a];
      gradient[variables[a]] += force.cwiseProduct(points).sum();
      for (std::size_t b = 0; b < variables.size(); ++b) {
        hessian(variables[a], variables[b]) += force.cwiseProduct(changes[b]).sum();
      }
    }
  }

  void add_differences(const PatchJoint& joint, const std::vector<std::vector<PatchPoints>>& changes,
                       const std::vector<PatchPoints>& points, Eigen::MatrixXd& hessian,
                       Eigen::VectorXd& gradient) const {
    for (std::size_t k = 0; k < joint_places.size(); ++k) {
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(gradient.size(), 3);
      for (std::size_t a = 0; a < variables_[joint.before].size(); ++a) {
        rows.row(variables_[joint.before][a]) += before(joint, k).transpose() * changes[joint.before][a];
      }
      for (std::size_t a = 0; a < variables_[joint.behind].size(); ++a) {
        rows.row(variables_[joint.behind][a]) -= behind(joint, k).transpose() * changes[joint.behind][a];
      }
      hessian += joint_share * rows * rows.transpose();
      gradient += joint_share * rows * difference(points, joint, k).transpose();
    }
  }

  const PatchFamily& family_;
  std::vector<PatchJoint> joints_;
  std::vector<std::vector<int>> variables_;  // per patch
};

}  // namespace

PatchPoints points_of(const GregoryPatch& patch) {
  PatchPoints points;
  for (std::size_t i = 0; i < 20; ++i) {
    points.row(static_cast<Eigen::Index>(i)) = i < 12 ? patch.boundary[i] : patch.inner[i - 12];
  }
  return points;
}

const Eigen::Matrix<double, 20, 20>& variation_energy() {
  static const Eigen::Matrix<double, 20, 20> energy = make_variation_energy();
  return energy;
}

PatchWeights second_derivative(double u, double v, bool along_u) {
  const double inwards = (along_u ? u : v) < 0.5 ? step : -step;
  const double du = along_u ? inwards : 0, dv = along_u ? 0 : inwards;
  return (4 * slope_weights(u + du, v + dv, along_u) - 3 * slope_weights(u, v, along_u) -
          slope_weights(u + 2 * du, v + 2 * dv, along_u)) /
         (2 * inwards);
}

Eigen::VectorXd least_energy(const PatchFamily& family) {
  const FamilyEnergy energy(family);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(family.variables()), gradient;
  Eigen::MatrixXd hessian;
  double now = energy.at(values), damping = 1e-3;
  for (int round = 0; round < most_rounds; ++round) {
    energy.derive(values, hessian, gradient);
    const double before = now;
    for (int attempt = 0; attempt < most_attempts; ++attempt, damping *= 10) {
      Eigen::MatrixXd damped = hessian;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * hessian.diagonal().maxCoeff();
      const Eigen::VectorXd trial = values - damped.ldlt().solve(gradient);
      if (!trial.allFinite() || !family.allowed(trial)) continue;
      const double there = energy.at(trial);
      if (there >= now) continue;
      values = trial;
      now = there;
      damping /= 10;
      break;
    }
    if (now > (1 - least_gain) * before) break;
  }
  return values;
}

}  // namespace croquis
