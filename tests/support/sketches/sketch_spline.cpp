// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_spline.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace croquis::test {
namespace {

std::vector<double> chord_lengths(const std::vector<Vec2>& points, bool closed) {
  std::vector<double> knots{0};
  const std::size_t last = points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < last; ++i) {
    knots.push_back(knots.back() + (points[(i + 1) % points.size()] - points[i]).norm());
  }
  const double length = knots.back();
  for (double& knot : knots) knot /= length;
  return knots;
}

}  // namespace

Spline::Spline(std::vector<Vec2> points, bool closed) : points_(std::move(points)), closed_(closed) {
  knots_ = chord_lengths(points_, closed);
  solve(closed);
}

Spline::Spline(std::vector<Vec2> points, std::vector<double> knots, bool closed)
    : points_(std::move(points)), knots_(std::move(knots)), closed_(closed) {
  solve(closed);
}

void Spline::solve(bool closed) {
  if (closed) points_.push_back(points_.front());
  const auto count = static_cast<Eigen::Index>(points_.size());
  const auto at = [&](Eigen::Index i) { return static_cast<std::size_t>(i); };
  const auto width = [&](Eigen::Index i) { return knots_[at(i + 1)] - knots_[at(i)]; };
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 2);
  const auto row = [&](Eigen::Index i, Eigen::Index before, Eigen::Index after, double a, double b) {
    system(i, before) += a / 6;
    system(i, i) += (a + b) / 3;
    system(i, after) += b / 6;
    right.row(i) = ((points_[at(after)] - points_[at(i)]) / b - (points_[at(i)] - points_[at(before)]) / a).transpose();
  };
  for (Eigen::Index i = 1; i + 1 < count; ++i) row(i, i - 1, i + 1, width(i - 1), width(i));
  system(count - 1, count - 1) = 1;
  if (closed) {
    row(0, count - 2, 1, width(count - 2), width(0));
    system(count - 1, 0) = -1;
  } else {
    system(0, 0) = 1;
  }
  const Eigen::MatrixXd bend = system.fullPivLu().solve(right);
  for (Eigen::Index i = 0; i < count; ++i) bend_.emplace_back(bend.row(i).transpose());
}

Vec2 Spline::at(double t) const {
  if (closed_) t -= std::floor(t);
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
  const auto k = static_cast<std::size_t>(above - knots_.begin());
  const double h = knots_[k] - knots_[k - 1];
  const double a = (knots_[k] - t) / h;
  const double b = 1 - a;
  return a * points_[k - 1] + b * points_[k] +
         h * h / 6 * ((a * a * a - a) * bend_[k - 1] + (b * b * b - b) * bend_[k]);
}

std::vector<Vec2> smooth_loop(const std::vector<Vec2>& through, double spacing) {
  const Spline spline(through, true);
  constexpr int fine = 4000;
  std::vector<Vec2> loop;
  double since = spacing;
  for (int i = 0; i < fine; ++i) {
    const double t = static_cast<double>(i) / fine;
    since += (spline.at(t) - spline.at(t - 1.0 / fine)).norm();
    if (since < spacing) continue;
    loop.push_back(spline.at(t));
    since = 0;
  }
  if ((loop.back() - loop.front()).norm() < spacing / 2) loop.pop_back();
  return loop;
}

}  // namespace croquis::test
