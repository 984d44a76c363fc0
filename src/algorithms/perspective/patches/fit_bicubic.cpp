// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "croquis/perspective/bicubic_fit.h"

namespace croquis {
namespace {

/// Places per knot span that the fit is made from (their middles) and measured at (their ends); no place is both.
constexpr std::size_t fit_places = 6, check_places = 7;

/// Spans are never shorter: what is left of a kink there is no longer seen.
constexpr double shortest_span = 1.0 / 2048;

using SplineMatrix = Eigen::MatrixXd;

std::vector<double> with_ends(const std::vector<double>& breaks) {
  std::vector<double> knots(3, 0.0);
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), 3, 1.0);
  return knots;
}

/// A side of a patch as cubics in the direction of its parameter: itself, and the points of the second row.
struct SideRows {
  std::array<Vec3, 4> outer, inner;
};

/// Sides v = 0, u = 1, v = 1, u = 0, each along growing u or v.
SideRows side_rows(const GregoryPatch& patch, std::size_t side) {
  SideRows rows;
  const auto boundary = [&](std::size_t i) { return patch.boundary[i % 12]; };
  for (std::size_t i = 0; i < 4; ++i) rows.outer[i] = boundary(3 * side + i);
  rows.inner = {boundary(3 * side + 11), patch.inner[2 * side], patch.inner[(2 * side + 3) % 8],
                boundary(3 * side + 4)};
  if (side >= 2) {
    std::ranges::reverse(rows.outer);
    std::ranges::reverse(rows.inner);
  }
  return rows;
}

/// The parameters that a direction is fitted and measured at, by the breaks between its spans.
std::vector<double> places(const std::vector<double>& breaks, bool check) {
  std::vector<double> result;
  const std::size_t count = check ? check_places : fit_places;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    for (std::size_t k = 0; k < count; ++k) {
      const double t = (static_cast<double>(k) + (check ? 0 : 0.5)) / static_cast<double>(count);
      result.push_back(breaks[s] + t * (breaks[s + 1] - breaks[s]));
    }
  }
  if (check) result.push_back(1);
  return result;
}

/// Rows: places; columns: B-splines.
SplineMatrix weights_at(const std::vector<double>& knots, const std::vector<double>& places) {
  SplineMatrix result =
      SplineMatrix::Zero(static_cast<Eigen::Index>(places.size()), static_cast<Eigen::Index>(knots.size() - 4));
  for (std::size_t p = 0; p < places.size(); ++p) {
    const CubicSplineWeights weights = cubic_spline_weights(knots, places[p]);
    for (std::size_t k = 0; k < 4; ++k) {
      result(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(weights.first + k)) = weights.value[k];
    }
  }
  return result;
}

/// What was measured on the spans of one direction.
struct SpanErrors {
  std::vector<double> distance, angle;
};

class BicubicFitter {
 public:
  BicubicFitter(const GregoryPatch& patch, double tolerance, const std::array<bool, 4>& smooth,
                const BicubicFitOptions& options)
      : patch_(patch), tolerance_(tolerance), smooth_(smooth), options_(options) {}

  BicubicFit run() {
    do {
      fit_.spline.u_knots = with_ends(breaks_[0]);
      fit_.spline.v_knots = with_ends(breaks_[1]);
      fit_.spline.points.assign(fit_.spline.u_count() * fit_.spline.v_count(), Vec3::Zero());
      for (std::size_t side = 0; side < 4; ++side) set_side(side);
      if (fit_.spline.u_count() > 4 && fit_.spline.v_count() > 4) fit_inside();
      measure();
    } while (!fit_.within && refine());
    return std::move(fit_);
  }

 private:
  /// Control point k along a side, `row` rows from it.
  Vec3& point_by(std::size_t side, std::size_t k, std::size_t row) {
    BicubicSpline& spline = fit_.spline;
    switch (side) {
      case 0: return spline.point(k, row);
      case 1: return spline.point(spline.u_count() - 1 - row, k);
      case 2: return spline.point(k, spline.v_count() - 1 - row);
      default: return spline.point(row, k);
    }
  }

  /// The side's curve and the row next to it, which makes the slope across. Two sides share the point next to a corner.
  void set_side(std::size_t side) {
    const std::vector<double>& along = side % 2 == 0 ? fit_.spline.u_knots : fit_.spline.v_knots;
    const std::vector<double>& breaks = breaks_[side % 2 == 0 ? 1 : 0];
    const std::size_t last = breaks.size() - 1;
    const double span = side == 0 || side == 3 ? breaks[1] : 1 - breaks[last - 1];
    SideRows rows = side_rows(patch_, side);
    for (std::size_t i = 0; i < 4; ++i) rows.inner[i] = rows.outer[i] + span * (rows.inner[i] - rows.outer[i]);
    const std::vector<Vec3> outer = spline_points(rows.outer, along), inner = spline_points(rows.inner, along);
    for (std::size_t k = 0; k < outer.size(); ++k) point_by(side, k, 0) = outer[k];
    for (std::size_t k = 1; k + 1 < inner.size(); ++k) {
      const bool shared = k == 1 || k + 2 == inner.size();
      if (shared) {
        point_by(side, k, 1) += inner[k] / 2;
      } else {
        point_by(side, k, 1) = inner[k];
      }
    }
  }

  /// A coordinate of all control points; zero inside until they are fitted.
  SplineMatrix control_net(int axis) {
    BicubicSpline& spline = fit_.spline;
    SplineMatrix net(static_cast<Eigen::Index>(spline.u_count()), static_cast<Eigen::Index>(spline.v_count()));
    for (std::size_t j = 0; j < spline.v_count(); ++j) {
      for (std::size_t i = 0; i < spline.u_count(); ++i)
        net(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = spline.point(i, j)[axis];
    }
    return net;
  }

  /// Least squares over a grid of places: a system for each direction.
  void fit_inside() {
    BicubicSpline& spline = fit_.spline;
    const std::vector<double> us = places(breaks_[0], false), vs = places(breaks_[1], false);
    const SplineMatrix wu = weights_at(spline.u_knots, us), wv = weights_at(spline.v_knots, vs);
    const Eigen::Index nu = wu.cols(), nv = wv.cols();
    const Eigen::HouseholderQR<SplineMatrix> along_u(wu.middleCols(2, nu - 4)), along_v(wv.middleCols(2, nv - 4));
    const std::array<SplineMatrix, 3> wanted = patch_on(us, vs);
    for (int axis = 0; axis < 3; ++axis) {
      const SplineMatrix rest = wanted[static_cast<std::size_t>(axis)] - wu * control_net(axis) * wv.transpose();
      const SplineMatrix inside = along_v.solve(along_u.solve(rest).transpose()).transpose();
      for (Eigen::Index j = 0; j < inside.cols(); ++j) {
        for (Eigen::Index i = 0; i < inside.rows(); ++i) {
          spline.point(static_cast<std::size_t>(i) + 2, static_cast<std::size_t>(j) + 2)[axis] = inside(i, j);
        }
      }
    }
  }

  std::array<SplineMatrix, 3> patch_on(const std::vector<double>& us, const std::vector<double>& vs) const {
    std::array<SplineMatrix, 3> result;
    for (SplineMatrix& axis : result)
      axis.resize(static_cast<Eigen::Index>(us.size()), static_cast<Eigen::Index>(vs.size()));
    for (std::size_t j = 0; j < vs.size(); ++j) {
      for (std::size_t i = 0; i < us.size(); ++i) {
        const Vec3 p = patch_.at(us[i], vs[j]).at;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          result[axis](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = p[static_cast<int>(axis)];
        }
      }
    }
    return result;
  }

  void measure() {
    const std::array<std::vector<double>, 2> at = {places(breaks_[0], true), places(breaks_[1], true)};
    for (std::size_t d = 0; d < 2; ++d) {
      found_[d].distance.assign(breaks_[d].size() - 1, 0);
      found_[d].angle.assign(breaks_[d].size() - 1, 0);
    }
    measure_distances(at);
    for (std::size_t side = 0; side < 4; ++side) {
      if (smooth_[side]) measure_angles(side, at[side % 2]);
    }
    fit_.error = fit_.angle = 0;
    for (const SpanErrors& found : found_) {
      fit_.error = std::max(fit_.error, *std::ranges::max_element(found.distance));
      fit_.angle = std::max(fit_.angle, *std::ranges::max_element(found.angle));
    }
    fit_.within = fit_.error <= tolerance_ && fit_.angle <= options_.angle;
  }

  void measure_distances(const std::array<std::vector<double>, 2>& at) {
    const std::array<SplineMatrix, 3> wanted = patch_on(at[0], at[1]);
    const SplineMatrix wu = weights_at(fit_.spline.u_knots, at[0]), wv = weights_at(fit_.spline.v_knots, at[1]);
    SplineMatrix squares = SplineMatrix::Zero(wu.rows(), wv.rows());
    for (int axis = 0; axis < 3; ++axis)
      squares += (wu * control_net(axis) * wv.transpose() - wanted[static_cast<std::size_t>(axis)]).cwiseAbs2();
    for (Eigen::Index j = 0; j < squares.cols(); ++j) {
      for (Eigen::Index i = 0; i < squares.rows(); ++i) {
        const double distance = std::sqrt(squares(i, j));
        raise(found_[0].distance, static_cast<std::size_t>(i), distance);
        raise(found_[1].distance, static_cast<std::size_t>(j), distance);
      }
    }
  }

  /// Places on the break between two spans count for the second, the last one for the last span.
  static void raise(std::vector<double>& of_spans, std::size_t place, double value) {
    double& known = of_spans[std::min(place / check_places, of_spans.size() - 1)];
    known = std::max(known, value);
  }

  void measure_angles(std::size_t side, const std::vector<double>& at) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double u = side % 2 == 0 ? at[k] : side == 1 ? 1.0 : 0.0;
      const double v = side % 2 == 1 ? at[k] : side == 2 ? 1.0 : 0.0;
      const Vec3 wanted = patch_.at(u, v).normal(), reached = fit_.spline.at(u, v).normal();
      raise(found_[side % 2].angle, k, angle_between(wanted, reached));  // 0 where one has none
    }
  }

  /// Halves the spans that break a bound. @return false: nothing more may be halved
  bool refine() {
    bool halved = false;
    for (std::size_t d = 0; d < 2; ++d) {
      std::vector<double> breaks = {0};
      std::size_t room = options_.most_spans - std::min(options_.most_spans, breaks_[d].size() - 1);
      for (std::size_t s = 0; s + 1 < breaks_[d].size(); ++s) {
        const double from = breaks_[d][s], to = breaks_[d][s + 1];
        const bool bad = found_[d].distance[s] > tolerance_ || found_[d].angle[s] > options_.angle;
        if (bad && room > 0 && to - from > shortest_span) {
          breaks.push_back((from + to) / 2);
          --room;
          halved = true;
        }
        breaks.push_back(to);
      }
      breaks_[d] = std::move(breaks);
    }
    return halved;
  }

  const GregoryPatch& patch_;
  double tolerance_;
  const std::array<bool, 4>& smooth_;
  const BicubicFitOptions& options_;
  std::array<std::vector<double>, 2> breaks_ = {{{0, 1}, {0, 1}}};  // between spans, along u and v
  std::array<SpanErrors, 2> found_;
  BicubicFit fit_;
};

/// Lines inside a face are smooth; along the outline its edges say it.
std::array<bool, 4> smooth_sides(const Brep& brep, const BrepFace& face, std::size_t patch) {
  const std::vector<Index> around = brep.around(face.loops[0]);
  const auto smooth = [&](std::size_t i) { return brep.edges[brep.half_edges[around[i]].edge].smooth; };
  if (face.patches.size() == 1) return {smooth(0), smooth(1), smooth(2), smooth(3)};
  return {smooth(patch), true, true, smooth((patch + around.size() - 1) % around.size())};
}

}  // namespace

BicubicFit fit_bicubic(const GregoryPatch& patch, double tolerance, const std::array<bool, 4>& smooth,
                       const BicubicFitOptions& options) {
  return BicubicFitter(patch, tolerance, smooth, options).run();
}

std::vector<std::vector<BicubicFit>> fit_patches(const Brep& brep, Progress& progress,
                                                 const BicubicFitOptions& options) {
  const double tolerance = options.tolerance * size_of(brep);
  std::vector<std::vector<BicubicFit>> fits(brep.faces.size());
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    const BrepFace& face = brep.faces[f];
    for (std::size_t p = 0; p < face.patches.size(); ++p) {
      progress.check();
      fits[f].push_back(fit_bicubic(face.patches[p], tolerance, smooth_sides(brep, face, p), options));
    }
    progress.report(f + 1, brep.faces.size());
  }
  return fits;
}

}  // namespace croquis
