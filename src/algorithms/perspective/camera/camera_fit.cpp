// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "algorithms/perspective/camera/levenberg_marquardt.h"

namespace croquis {
namespace {

using Derivative = Eigen::Matrix<double, 3, 6>;
using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

/// Focal lengths that are tried, in diagonals.
constexpr std::array<double, 5> focal_starts{0.4, 0.7, 1, 1.6, 3};

/// Beyond these numbers lose their digits, diagonals.
constexpr double least_tried_focal = 1e-2;
constexpr double greatest_tried_focal = 1e3;

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// By a small rotation on the camera's side, the logarithm of the focal length and the principal point.
Derivative vanishing_point_derivative(const CameraParameters& camera, int axis) {
  const Vec3 direction = camera.rotation.col(axis);
  Eigen::Matrix3d projection = Eigen::Matrix3d::Identity();
  projection(0, 0) = projection(1, 1) = camera.focal();
  projection.block<2, 1>(0, 2) = camera.principal;
  Derivative derivative = Derivative::Zero();
  derivative.leftCols<3>() = -projection * cross_matrix(direction);
  derivative.block<2, 1>(0, 3) = camera.focal() * direction.head<2>();
  derivative(0, 4) = derivative(1, 5) = direction.z();
  return derivative;
}

double line_weight(double residual, const LineNoise& noise) {
  if (!noise.robust) return 1;
  const double ratio = residual / *noise.robust;
  return 1 / std::sqrt(1 + ratio * ratio);
}

double line_cost(double residual, const LineNoise& noise) {
  if (!noise.robust) return residual * residual;
  const double ratio = residual / *noise.robust;
  return 2 * *noise.robust * *noise.robust * (std::sqrt(1 + ratio * ratio) - 1);
}

/// One fit from one start.
class CameraProblem {
 public:
  CameraProblem(std::span<const AxisLine> lines, const FlatAxes& flat, const CameraPrior& prior, const LineNoise& noise)
      : lines_(lines), flat_(flat), prior_(prior), noise_(noise) {
    for (int axis = 0; axis < 3; ++axis) {
      if (flat_[axis]) flat_axis_ = axis;
    }
  }

  CameraFit solve(CameraParameters start) {
    if (count_of(flat_) == 2) start.log_focal = prior_.one_point_log_focal;
    set_prior_directions(start);
    CameraFit fit;
    fit.parameters = start;
    fit.flat = flat_;
    fit.cost = levenberg_marquardt(
        fit.parameters, basis(start).cols(), [&](const CameraParameters& at) { return cost(at); },
        [&](const CameraParameters& at, NormalEquations& equations) { evaluate(at, equations); },
        [&](const CameraParameters& at, const NormalEquations::Vector& step) { return moved(at, step); });
    fit.line_cost = cost_of_lines(fit.parameters, {});
    fit.covariance = covariance(fit.parameters);
    return fit;
  }

 private:
  /// The prior knows the horizon's direction: across it the lines say where the principal point is.
  void set_prior_directions(const CameraParameters& start) {
    prior_rows_ = Eigen::Matrix2d::Identity() / prior_.principal_spread;
    if (flat_axis_ < 0 || count_of(flat_) == 2) return;
    const Vec2 across = start.rotation.col(flat_axis_).head<2>().normalized();
    prior_rows_.row(0) = across.transpose() / prior_.principal_spread;
    prior_rows_.row(1) = left_of(across).transpose() / prior_.flat_spread;
  }

  /// The directions in which the six parameters may move so that flat axes stay flat.
  Basis basis(const CameraParameters& at) const {
    const int flat = count_of(flat_);
    if (flat == 0) return Basis::Identity(6, 6);
    Basis directions = Basis::Zero(6, flat == 1 ? 5 : 3);
    directions(2, 0) = 1;  // turning the picture
    directions.bottomRightCorner(2, 2).setIdentity();
    if (flat == 1) {
      directions.col(1).head<3>() = at.rotation.col(flat_axis_);
      directions(3, 2) = 1;
    }
    return directions;
  }

  CameraParameters moved(const CameraParameters& from, const NormalEquations::Vector& step) const {
    CameraParameters to = from;
    const int flat = count_of(flat_);
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    if (flat == 0) {
      const Vec3 vector = step.head<3>();
      if (vector.norm() > 0) turn = Eigen::AngleAxisd(vector.norm(), vector.normalized());
    } else {
      turn = Eigen::AngleAxisd(step[0], Vec3::UnitZ());
      if (flat == 1) turn = turn * Eigen::AngleAxisd(step[1], Vec3(from.rotation.col(flat_axis_)));
    }
    to.rotation = turn.toRotationMatrix() * from.rotation;
    if (flat < 2) {
      const double log_focal = to.log_focal + step[flat == 0 ? 3 : 2];
      to.log_focal = std::clamp(log_focal, std::log(least_tried_focal * sheet_units_per_diagonal),
                                std::log(greatest_tried_focal * sheet_units_per_diagonal));
    }
    to.principal += step.tail<2>();
    for (int axis = 0; axis < 3; ++axis) {
      if (flat_[axis]) to.rotation(2, axis) = 0;  // not even rounding moves it
    }
    return to;
  }

  double cost_of_lines(const CameraParameters& at, const LineNoise& noise) const {
    double sum = 0;
    PerAxis<Vec3> points{at.vanishing_point(0), at.vanishing_point(1), at.vanishing_point(2)};
    for (const AxisLine& line : lines_) {
      if (!line.outlier) sum += croquis::line_cost(line_residual(points[line.axis], line), noise);
    }
    return sum;
  }

  double cost(const CameraParameters& at) const {
    const Vec2 principal = prior_rows_ * (at.principal - prior_.principal);
    const double focal = focal_prior_weight() * (at.log_focal - prior_.log_focal);
    return cost_of_lines(at, noise_) + noise_.sigma * noise_.sigma * (principal.squaredNorm() + focal * focal);
  }

  /// With one flat axis the likely place of the principal point gives the focal length, and better than a guess.
  double focal_prior_weight() const {
    constexpr double of_guess = 1e-3;
    return (count_of(flat_) == 1 && !prior_.focal_stated ? of_guess : 1) / prior_.focal_spread;
  }

  void evaluate(const CameraParameters& at, NormalEquations& equations) const {
    const Basis directions = basis(at);
    PerAxis<Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3>> moves;
    PerAxis<Vec3> points;
    for (int axis = 0; axis < 3; ++axis) {
      moves[axis] = directions.transpose() * vanishing_point_derivative(at, axis).transpose();
      points[axis] = at.vanishing_point(axis);
    }
    for (const AxisLine& line : lines_) {
      if (line.outlier) continue;
      Vec3 derivative;
      const double residual = line_residual(points[line.axis], line, &derivative);
      equations.add(moves[line.axis] * derivative, residual, line_weight(residual, noise_));
    }
    add_prior(at, directions, equations);
  }

  void add_prior(const CameraParameters& at, const Basis& directions, NormalEquations& equations) const {
    const Vec2 principal = prior_rows_ * (at.principal - prior_.principal);
    const double weight = noise_.sigma * noise_.sigma;
    for (int row = 0; row < 2; ++row) {
      const Vec2 by_principal = prior_rows_.row(row);
      equations.add(directions.bottomRows<2>().transpose() * by_principal, principal[row], weight);
    }
    equations.add(focal_prior_weight() * directions.row(3).transpose(),
                  focal_prior_weight() * (at.log_focal - prior_.log_focal), weight);
  }

  Eigen::Matrix<double, 6, 6> covariance(const CameraParameters& at) const {
    const Basis directions = basis(at);
    NormalEquations equations(directions.cols());
    evaluate(at, equations);
    const NormalEquations::Matrix inverse = equations.matrix.fullPivLu().inverse();
    return noise_.sigma * noise_.sigma * directions * inverse * directions.transpose();
  }

  std::span<const AxisLine> lines_;
  FlatAxes flat_;
  CameraPrior prior_;
  LineNoise noise_;
  int flat_axis_ = -1;
  Eigen::Matrix2d prior_rows_ = Eigen::Matrix2d::Identity();
};

/// The rotation whose columns point as nearly as possible at the vanishing points; axes without one follow.
Eigen::Matrix3d rotation_towards(const PerAxis<Vec3>& points, const Vec2& principal, double focal) {
  Eigen::Matrix3d columns = Eigen::Matrix3d::Zero();
  int missing = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& point = points[axis];
    if (!(point.norm() > 0)) {
      missing = axis;
      continue;
    }
    columns.col(axis) << (point.head<2>() - point.z() * principal) / focal, point.z();
    columns.col(axis).normalize();
  }
  if (missing >= 0) {
    columns.col(missing) = unit_or_zero(columns.col((missing + 1) % 3).cross(columns.col((missing + 2) % 3)));
  }
  if (columns.determinant() < 0) columns.col(2) = -columns.col(2);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(columns, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
  if (rotation.determinant() < 0) rotation.col(2) = -rotation.col(2);
  return rotation;
}

/// The smallest turn that lays flat axes into the picture plane.
Eigen::Matrix3d flattened(Eigen::Matrix3d rotation, const FlatAxes& flat) {
  const auto lay = [&](const Vec3& from, const Vec3& to) {
    rotation = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix() * rotation;
  };
  const int count = count_of(flat);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 column = rotation.col(axis);
    if (count == 1 && flat[axis]) {
      const Vec3 laid = unit_or_zero(Vec3(column.x(), column.y(), 0));
      lay(column, laid.norm() > 0 ? laid : Vec3(Vec3::UnitX()));
    }
    if (count == 2 && !flat[axis]) lay(column, column.z() < 0 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ()));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (flat[axis]) rotation(2, axis) = 0;
  }
  return rotation;
}

std::vector<CameraParameters> camera_starts(const AxisFits& axes, const FlatAxes& flat, const CameraPrior& prior) {
  std::vector<CameraParameters> starts;
  const auto add = [&](const Vec2& principal, double focal) {
    const Eigen::Matrix3d rotation = rotation_towards(axes.vanishing_points, principal, focal);
    starts.push_back({flattened(rotation, flat), std::log(focal), principal});
  };
  const bool all = axes.well_determined[0] && axes.well_determined[1] && axes.well_determined[2];
  const std::optional<Orthocentre> centre = all ? orthocentre(axes.vanishing_points) : std::nullopt;
  if (centre && centre->focal_squared > 0) add(centre->point, std::sqrt(centre->focal_squared));
  for (const double focal : focal_starts) add(prior.principal, focal * sheet_units_per_diagonal);
  return starts;
}

/// Stated values of the camera are taken to be so exact: the focal length relatively, places in diagonals.
constexpr double stated_spread = 1e-3;

/// Taken in one-point perspective, where nothing gives it.
constexpr double usual_field_of_view = 50 * std::numbers::pi / 180;

/// Where the likely place of the principal point gives the focal length, a guess of it counts by so much less.
constexpr double unguessed = 1e3;

/// Cameras outside aren't believed in two-point perspective, diagonals.
constexpr double least_focal = 0.35;
constexpr double greatest_focal = 8;

/// The noise where no line is to spare, u.
constexpr double unknown_noise = 0.5;

/// Residuals count by their size beyond so many deviations.
constexpr double robust_from = 2.5;

double focal_of(double field_of_view, double width) { return width / 2 / std::tan(field_of_view / 2); }

bool all_well_determined(const AxisFits& axes) {
  return axes.well_determined[0] && axes.well_determined[1] && axes.well_determined[2];
}

bool is_allowed(const FlatAxes& flat, PerspectiveMode mode) {
  return mode == PerspectiveMode::Automatic || count_of(flat) == 3 - static_cast<int>(mode);
}

}  // namespace

Vec3 CameraParameters::vanishing_point(int axis) const {
  const Vec3 direction = rotation.col(axis);
  Vec3 point;
  point << focal() * direction.head<2>() + direction.z() * principal, direction.z();
  return point;
}

std::optional<Orthocentre> orthocentre(const PerAxis<Vec3>& vanishing_points) {
  PerAxis<Vec2> corners;
  for (int axis = 0; axis < 3; ++axis) {
    corners[axis] = vanishing_points[axis].head<2>() / vanishing_points[axis].z();
    if (!corners[axis].allFinite()) return std::nullopt;
  }
  const Vec2 &a = corners[0], &b = corners[1], &c = corners[2];
  Eigen::Matrix2d rows;
  rows << (c - b).transpose(), (a - c).transpose();
  const Vec2 point = rows.fullPivLu().solve(Vec2((c - b).dot(a), (a - c).dot(b)));
  if (!point.allFinite()) return std::nullopt;
  return Orthocentre{point, -(a - point).dot(b - point)};
}

CameraFit refit_camera(std::span<const AxisLine> lines, const CameraParameters& start, const FlatAxes& flat,
                       const CameraPrior& prior, const LineNoise& noise) {
  return CameraProblem(lines, flat, prior, noise)
      .solve({flattened(start.rotation, flat), start.log_focal, start.principal});
}

CameraFit fit_camera(std::span<const AxisLine> lines, const AxisFits& axes, const FlatAxes& flat,
                     const CameraPrior& prior, const LineNoise& noise) {
  CameraFit best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const CameraParameters& start : camera_starts(axes, flat, prior)) {
    const CameraFit fit = refit_camera(lines, start, flat, prior, noise);
    if (fit.cost < best.cost * (1 - 1e-9)) best = fit;
  }
  return best;
}

CameraPrior camera_prior(const PerspectiveDrawing& drawing, const SheetFrame& frame, const CameraOptions& options,
                         const AxisFits& axes) {
  constexpr double diagonal = sheet_units_per_diagonal;
  const double width = drawing.image_size.x() / frame.unit;
  CameraPrior prior;
  prior.log_focal = std::log(options.focal_length * diagonal);
  prior.focal_spread = options.focal_spread;
  prior.one_point_log_focal = std::log(focal_of(drawing.field_of_view.value_or(usual_field_of_view), width));
  if (drawing.field_of_view) {
    prior.log_focal = prior.one_point_log_focal;
    prior.focal_spread = stated_spread;
    prior.focal_stated = true;
  }
  prior.flat_spread = options.flat_principal_spread * diagonal;
  // Without an axis the lines say nothing about the principal point.
  prior.principal_spread = options.principal_spread * diagonal;
  if (!all_well_determined(axes)) {
    prior.principal_spread = prior.flat_spread;
    if (!prior.focal_stated) prior.focal_spread *= unguessed;
  }
  if (drawing.principal_point) {
    prior.principal = frame.to_sheet(*drawing.principal_point);
    prior.principal_spread = prior.flat_spread = stated_spread * diagonal;
  }
  return prior;
}

double judging_sigma(const AxisFits& axes, const CameraOptions& options) {
  return std::max(axes.freedom > 0 ? axes.sigma : unknown_noise, options.noise_floor);
}

std::vector<CameraFit> fit_all_modes(const std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                                     double sigma, PerspectiveMode mode, Progress& progress) {
  const FlatAxes candidates[] = {{false, false, false}, {true, false, false}, {false, true, false},
                                 {false, false, true},  {false, true, true},  {true, false, true},
                                 {true, true, false}};
  std::vector<CameraFit> fits;
  for (const FlatAxes& flat : candidates) {
    progress.check();
    if (is_allowed(flat, mode)) fits.push_back(fit_camera(lines, axes, flat, prior, {sigma, {}}));
  }
  return fits;
}

const CameraFit& simplest_fit(const std::vector<CameraFit>& fits, const AxisFits& axes, double sigma,
                              const CameraOptions& options) {
  const bool all = all_well_determined(axes);
  // The lines alone decide; without those of an axis what is likely counts, too.
  const auto cost = [&](const CameraFit& fit) { return (all ? fit.line_cost : fit.cost) / (sigma * sigma); };
  const auto believed = [](const CameraFit& fit) {
    const double focal = fit.parameters.focal() / sheet_units_per_diagonal;
    return count_of(fit.flat) != 1 || (focal > least_focal && focal < greatest_focal);
  };
  const CameraFit* best = &fits.front();
  const int most_free = count_of(best->flat);
  double least = cost(*best);
  for (const CameraFit& fit : fits) {
    if (believed(fit)) least = std::min(least, cost(fit));
  }
  for (const CameraFit& fit : fits) {
    const int dropped = count_of(fit.flat) - most_free;
    if (dropped > 0 && (cost(fit) - least >= options.mode_rise * dropped || !believed(fit))) continue;
    const int simpler = count_of(fit.flat) - count_of(best->flat);
    if (simpler > 0 || (simpler == 0 && cost(fit) < cost(*best))) best = &fit;
  }
  return *best;
}

bool leave_out_joint_outliers(std::vector<AxisLine>& lines, const AxisFits& axes, const CameraPrior& prior,
                              const CameraOptions& options, Progress& progress) {
  PerAxis<int> allowed{};
  PerAxis<int> left_out{};
  for (const AxisLine& line : lines) ++allowed[line.axis];
  for (const AxisLine& line : lines) left_out[line.axis] += line.outlier;
  for (int axis = 0; axis < 3; ++axis) allowed[axis] = most_outliers(allowed[axis]) - left_out[axis];
  const double first_sigma = judging_sigma(axes, options);
  CameraFit fit = fit_camera(lines, axes, {}, prior, {first_sigma, robust_from * first_sigma});
  for (;;) {
    progress.check();
    std::vector<double> residuals;
    AxisLine* worst = nullptr;
    double worst_residual = 0;
    for (AxisLine& line : lines) {
      if (line.outlier) continue;
      const double residual = std::abs(line_residual(fit.parameters.vanishing_point(line.axis), line));
      residuals.push_back(residual);
      if (residual > worst_residual) {
        worst_residual = residual;
        worst = &line;
      }
    }
    const double sigma = std::max(robust_sigma(residuals, 6), options.noise_floor);
    if (residuals.size() <= 6 || worst_residual <= std::max(options.outlier_sigmas * sigma, options.outlier_distance)) {
      return false;
    }
    if (allowed[worst->axis]-- <= 0) return true;
    worst->outlier = true;
    fit = refit_camera(lines, fit.parameters, {}, prior, {sigma, robust_from * sigma});
  }
}

}  // namespace croquis
