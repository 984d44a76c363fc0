// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/axis_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/levenberg_marquardt.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

/// An axis with fewer long lines than this takes its short ones, too, down to this part of the least length.
constexpr int fewest_lines = 3;
constexpr double shortest_part = 0.2;

/// Short lines say little of an axis that has long ones.
std::vector<AxisLine> without_short_lines(const std::vector<AxisLine>& lines, double minimum_length) {
  PerAxis<int> long_lines{};
  for (const AxisLine& line : lines) long_lines[line.axis] += line.length() >= minimum_length ? 1 : 0;
  std::vector<AxisLine> kept;
  for (const AxisLine& line : lines) {
    if (line.length() >= minimum_length || long_lines[line.axis] < fewest_lines) kept.push_back(line);
  }
  return kept;
}

bool left_before_right(const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }

/// Homogeneous points are kept as unit vectors of (x / size, y / size, w), so that near and far ones count alike.
constexpr double homogeneous_size = sheet_units_per_diagonal;

/// Pairs of this many longest lines are tried as starts.
constexpr std::size_t most_pair_lines = 40;

/// A line that misses a point by more doesn't point there; how much more doesn't matter. u, beyond the noise of any
/// hand.
constexpr double wild_residual = 25;

Vec3 from_unit(const Vec3& unit) { return {unit.x() * homogeneous_size, unit.y() * homogeneous_size, unit.z()}; }

Vec3 to_unit(const Vec3& point) {
  return Vec3(point.x() / homogeneous_size, point.y() / homogeneous_size, point.z()).normalized();
}

double squared_cost(const Vec3& point, std::span<const AxisLine> lines) {
  double sum = 0;
  for (const AxisLine& line : lines) {
    const double residual = line_residual(point, line);
    sum += residual * residual;
  }
  return sum;
}

double capped_cost(const Vec3& point, std::span<const AxisLine> lines) {
  double sum = 0;
  for (const AxisLine& line : lines) sum += std::min(std::abs(line_residual(point, line)), wild_residual);
  return sum;
}

Vec3 crossing(const AxisLine& one, const AxisLine& other) {
  const Vec3 first = one.a.homogeneous().cross(one.b.homogeneous());
  const Vec3 second = other.a.homogeneous().cross(other.b.homogeneous());
  return first.cross(second);
}

/// The crossing of two lines that all lines miss least in the sum of distances: a few wrong ones don't count.
Vec3 consensus(std::span<const AxisLine> lines) {
  std::vector<AxisLine> longest(lines.begin(), lines.end());
  if (longest.size() > most_pair_lines) {
    std::stable_sort(longest.begin(), longest.end(),
                     [](const AxisLine& a, const AxisLine& b) { return a.length() > b.length(); });
    longest.resize(most_pair_lines);
  }
  Vec3 best = Vec3::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < longest.size(); ++i) {
    for (std::size_t j = i + 1; j < longest.size(); ++j) {
      const Vec3 point = crossing(longest[i], longest[j]);
      if (!(point.norm() > 0)) continue;
      const double cost = capped_cost(point, lines);
      if (cost < least) {
        least = cost;
        best = point;
      }
    }
  }
  return best;
}

/// Least squares from there. Moves on the unit sphere of homogeneous points.
Vec3 refined(const Vec3& start, std::span<const AxisLine> lines) {
  Vec3 unit = to_unit(start);
  const auto tangents = [](const Vec3& at) {
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = at.unitOrthogonal();
    basis.col(1) = at.cross(basis.col(0));
    return basis;
  };
  levenberg_marquardt(
      unit, 2, [&](const Vec3& at) { return squared_cost(from_unit(at), lines); },
      [&](const Vec3& at, NormalEquations& equations) {
        const Eigen::Matrix<double, 3, 2> basis = tangents(at);
        for (const AxisLine& line : lines) {
          Vec3 derivative;
          const double residual = line_residual(from_unit(at), line, &derivative);
          derivative.head<2>() *= homogeneous_size;
          equations.add(basis.transpose() * derivative, residual);
        }
      },
      [&](const Vec3& at, const NormalEquations::Vector& step) {
        return Vec3(at + tangents(at) * Vec2(step)).normalized();
      });
  return from_unit(unit);
}

/// What it costs to have all lines parallel: for small angles the residual is linear in the direction.
double cost_of_parallel(std::span<const AxisLine> lines) {
  Vec2 doubled = Vec2::Zero();  // direction of the axis of inertia, at twice its angle
  double total = 0;
  for (const AxisLine& line : lines) {
    const Vec2 along = line.b - line.a;
    doubled += Vec2(along.x() * along.x() - along.y() * along.y(), 2 * along.x() * along.y());
    total += along.squaredNorm();
  }
  return std::max(0.0, (total - doubled.norm()) / 4);
}

std::vector<AxisLine> kept_lines(const std::vector<AxisLine>& lines, int axis) {
  std::vector<AxisLine> kept;
  for (const AxisLine& line : lines) {
    if (line.axis == axis && !line.outlier) kept.push_back(line);
  }
  return kept;
}

std::vector<double> residuals_of(const Vec3& point, std::span<const AxisLine> lines) {
  std::vector<double> residuals;
  for (const AxisLine& line : lines) residuals.push_back(std::abs(line_residual(point, line)));
  return residuals;
}

/// An axis' lines and the point that most of them agree on.
struct AxisConsensus {
  std::vector<AxisLine> kept;
  std::vector<double> residuals;
};

AxisConsensus consensus_of(const std::vector<AxisLine>& lines, int axis) {
  AxisConsensus result;
  result.kept = kept_lines(lines, axis);
  if (result.kept.size() >= 2) result.residuals = residuals_of(consensus(result.kept), result.kept);
  return result;
}

/// The noise of all axes together. The two lines that a consensus runs through say nothing about it.
double consensus_sigma(const PerAxis<AxisConsensus>& axes) {
  std::vector<double> all;
  for (const AxisConsensus& axis : axes) {
    std::vector<double> residuals = axis.residuals;
    if (residuals.size() <= 2) continue;
    std::sort(residuals.begin(), residuals.end());
    all.insert(all.end(), residuals.begin() + 2, residuals.end());
  }
  return robust_sigma(all, 0);
}

/// Leaves out the worst line of an axis if it is far off the point of the others.
bool leave_out_worst(std::vector<AxisLine>& lines, const AxisConsensus& axis, double limit) {
  if (axis.kept.size() < 4) return false;  // of three lines any one may be the wrong one
  const auto worst = std::max_element(axis.residuals.begin(), axis.residuals.end());
  if (*worst <= limit) return false;
  const Index stroke = axis.kept[static_cast<std::size_t>(worst - axis.residuals.begin())].stroke;
  for (AxisLine& line : lines) line.outlier |= line.stroke == stroke;
  return true;
}

}  // namespace

std::vector<AxisLine> axis_lines(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                                 const SheetFrame& frame, double minimum_length) {
  std::vector<AxisLine> lines;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const PerspectiveStroke& stroke = drawing.strokes[s];
    if (!is_parallel(groups[s]) || !are_usable_numbers(stroke.start()) || !are_usable_numbers(stroke.end())) continue;
    AxisLine line{static_cast<Index>(s), axis_of(groups[s]), frame.to_sheet(stroke.start()),
                  frame.to_sheet(stroke.end())};
    if (line.length() < shortest_part * minimum_length) continue;
    if (left_before_right(line.b, line.a)) std::swap(line.a, line.b);
    lines.push_back(line);
  }
  const auto place = [](const AxisLine& line) {
    return std::tuple(line.axis, line.a.x(), line.a.y(), line.b.x(), line.b.y());
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const AxisLine& one, const AxisLine& other) { return place(one) < place(other); });
  return without_short_lines(lines, minimum_length);
}

PerAxis<int> lines_per_axis(std::span<const AxisLine> lines) {
  PerAxis<int> counts{};
  for (const AxisLine& line : lines) counts[line.axis] += line.outlier ? 0 : 1;
  return counts;
}

double line_residual(const Vec3& vanishing_point, const AxisLine& line, Vec3* derivative) {
  // Twice the area between the vanishing point and the segment, over the distance of the vanishing point from its
  // middle; homogeneous, so that neither grows beyond bounds.
  constexpr double factor = std::numbers::sqrt2 / 2;
  const Vec2 middle = (line.a + line.b) / 2;
  const Vec2 along = line.b - line.a;
  const Vec2 towards = vanishing_point.head<2>() - vanishing_point.z() * middle;
  const double distance = towards.norm();
  if (!(distance > 0)) {
    if (derivative != nullptr) derivative->setZero();
    return 0;
  }
  const double residual = factor * cross(towards, along) / distance;
  if (derivative != nullptr) {
    const Vec2 by_towards =
        factor / distance * Vec2(along.y(), -along.x()) - residual / (distance * distance) * towards;
    *derivative << by_towards, -by_towards.dot(middle);
  }
  return residual;
}

double vanishing_residual(const Vec3& vanishing_point, const Vec2& a, const Vec2& b) {
  return std::abs(line_residual(vanishing_point, AxisLine{no_index, 0, a, b}));
}

double robust_sigma(std::vector<double> residuals, int unknowns) {
  constexpr double of_normal_distribution = 1.4826;
  const auto count = static_cast<double>(residuals.size());
  if (residuals.empty() || count <= unknowns) return 0;
  for (double& residual : residuals) residual = std::abs(residual);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return of_normal_distribution * *middle * std::sqrt(count / (count - unknowns));
}

int most_outliers(int count) { return std::max(0, std::min(count / 3, count - 2)); }

AxisFits fit_kept_lines(const std::vector<AxisLine>& lines) {
  AxisFits fits;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<AxisLine> kept = kept_lines(lines, axis);
    fits.well_determined[axis] = kept.size() >= 2;
    if (kept.size() < 2) continue;
    Vec3 point = consensus(kept);
    if (!(point.norm() > 0)) point << kept[0].b - kept[0].a, 0;  // all on one line: any point of it will do
    fits.vanishing_points[axis] = refined(point, kept);
    fits.cost[axis] = squared_cost(fits.vanishing_points[axis], kept);
    fits.parallel_cost[axis] = cost_of_parallel(kept);
    sum += fits.cost[axis];
    fits.freedom += static_cast<int>(kept.size()) - 2;
  }
  fits.sigma = fits.freedom > 0 ? std::sqrt(sum / fits.freedom) : 0;
  return fits;
}

AxisFits fit_axes(std::vector<AxisLine>& lines, const CameraOptions& options) {
  const PerAxis<int> counts = lines_per_axis(lines);
  PerAxis<AxisConsensus> axes{consensus_of(lines, 0), consensus_of(lines, 1), consensus_of(lines, 2)};
  const double sigma = std::max(consensus_sigma(axes), options.noise_floor);
  const double limit = std::max(options.outlier_sigmas * sigma, options.outlier_distance);
  for (int axis = 0; axis < 3; ++axis) {
    for (int allowed = most_outliers(counts[axis]); allowed > 0; --allowed) {
      if (!leave_out_worst(lines, axes[axis], limit)) break;
      axes[axis] = consensus_of(lines, axis);
    }
  }
  return fit_kept_lines(lines);
}

}  // namespace croquis
