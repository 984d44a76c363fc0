// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/network_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>

namespace croquis::test {
namespace {

/// Row of all Bernstein polynomials of a degree.
Eigen::RowVectorXd bernstein_row(int degree, double t) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(degree + 1);
  row[0] = 1;
  for (int d = 1; d <= degree; ++d) {
    for (int i = d; i > 0; --i) row[i] = (1 - t) * row[i] + t * row[i - 1];
    row[0] *= 1 - t;
  }
  return row;
}

/// The Bézier curve through a curve at places that crowd towards its ends, where interpolation would swing.
std::vector<Vec3> interpolated(const std::function<Vec3(double)>& curve, int degree) {
  Eigen::MatrixXd rows(degree + 1, degree + 1);
  Eigen::MatrixXd places(degree + 1, 3);
  for (int i = 0; i <= degree; ++i) {
    const double t = 0.5 - 0.5 * std::cos(std::numbers::pi * i / degree);
    rows.row(i) = bernstein_row(degree, t);
    places.row(i) = curve(t).transpose();
  }
  const Eigen::MatrixXd found = rows.colPivHouseholderQr().solve(places);
  std::vector<Vec3> control;
  for (int i = 0; i <= degree; ++i) control.emplace_back(found.row(i).transpose());
  control.front() = curve(0);
  control.back() = curve(1);
  return control;
}

double largest_difference(const std::function<Vec3(double)>& curve, const std::vector<Vec3>& control) {
  constexpr int places = 97;
  double largest = 0;
  for (int i = 0; i <= places; ++i) {
    const double t = static_cast<double>(i) / places;
    largest = std::max(largest, (curve(t) - bezier_point(control, t)).norm());
  }
  return largest;
}

}  // namespace

Index NetworkBuilder::node(const Vec3& point) {
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    if ((network.nodes[i].point - point).norm() < 1e-9) return static_cast<Index>(i);
  }
  network.nodes.push_back({"n" + std::to_string(network.nodes.size()), point});
  return static_cast<Index>(network.nodes.size() - 1);
}

Index NetworkBuilder::curve(Index from, Index to, const std::vector<Vec3>& inner, CurveJoin join) {
  AttributeCurve made{"c" + std::to_string(network.curves.size()), from, to, {}, join};
  if (!inner.empty()) {
    made.control.push_back(network.nodes[from].point);
    made.control.insert(made.control.end(), inner.begin(), inner.end());
    made.control.push_back(network.nodes[to].point);
  }
  network.curves.push_back(std::move(made));
  return static_cast<Index>(network.curves.size() - 1);
}

Index NetworkBuilder::curve(const std::vector<Vec3>& control, CurveJoin join) {
  return curve(node(control.front()), node(control.back()), {control.begin() + 1, control.end() - 1}, join);
}

AttributeSide NetworkBuilder::side_between(Index from, Index to) {
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    const AttributeCurve& each = network.curves[i];
    if (each.from == from && each.to == to) return {static_cast<Index>(i), false};
    if (each.from == to && each.to == from) return {static_cast<Index>(i), true};
  }
  return {curve(from, to), false};
}

Index NetworkBuilder::face(const std::vector<Index>& corners) {
  std::vector<AttributeSide> loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.push_back(side_between(corners[i], corners[(i + 1) % corners.size()]));
  return face(std::move(loop));
}

Index NetworkBuilder::face(std::vector<AttributeSide> loop) {
  AttributeFace made;
  made.id = "f" + std::to_string(network.faces.size());
  made.loop = std::move(loop);
  network.faces.push_back(std::move(made));
  return static_cast<Index>(network.faces.size() - 1);
}

std::vector<Vec3> bezier_near(const std::function<Vec3(double)>& curve, double tolerance) {
  std::vector<Vec3> control;
  for (int degree = 1; degree <= 24; ++degree) {
    control = interpolated(curve, degree);
    if (largest_difference(curve, control) <= tolerance) break;
  }
  return control;
}

}  // namespace croquis::test
