// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/perspective/bicubic_fit.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Every generated solid that has patches, and the balls of arcs, whose patches twist most.
std::map<std::string, Brep> breps_with_patches() {
  std::map<std::string, Brep> breps;
  for (const PerspectiveSolid& solid : all_solids()) breps[solid.name] = solid_of(solid.network).brep;
  for (const PolyhedronNet& net : sphere_nets()) {
    breps["round " + net.name] = solid_of(net.network).brep;
    breps["bent " + net.name] = solid_of(perturbed(net.network, 0.05, 3)).brep;
  }
  std::erase_if(breps, [](const auto& named) {
    return std::ranges::all_of(named.second.faces, [](const BrepFace& face) { return face.patches.empty(); });
  });
  return breps;
}

std::vector<std::vector<BicubicFit>> fits_of(const Brep& brep, const BicubicFitOptions& options = {}) {
  Progress progress;
  return fit_patches(brep, progress, options);
}

/// De Boor's algorithm: corners cut until one point is left.
Vec3 cut_corners(const std::vector<double>& knots, const std::vector<Vec3>& points, double t) {
  std::size_t span = 3;
  while (span + 5 < knots.size() && knots[span + 1] <= t) ++span;
  std::array<Vec3, 4> d;
  for (std::size_t k = 0; k < 4; ++k) d[k] = points[span - 3 + k];
  for (std::size_t level = 1; level <= 3; ++level) {
    for (std::size_t k = 3; k >= level; --k) {
      const double low = knots[span - 3 + k], high = knots[span + 1 + k - level];
      const double share = (t - low) / (high - low);
      d[k] = (1 - share) * d[k - 1] + share * d[k];
    }
  }
  return d[3];
}

Vec3 cut_corners(const BicubicSpline& spline, double u, double v) {
  std::vector<Vec3> column;
  for (std::size_t j = 0; j < spline.v_count(); ++j) {
    const auto row = spline.points.begin() + static_cast<std::ptrdiff_t>(j * spline.u_count());
    column.push_back(cut_corners(spline.u_knots, {row, row + static_cast<std::ptrdiff_t>(spline.u_count())}, u));
  }
  return cut_corners(spline.v_knots, column, v);
}

/// A bicubic patch: both inner points of each corner are the same.
GregoryPatch bicubic_patch() {
  GregoryPatch patch;
  const auto point = [](double i, double j) { return Vec3(i, j + 0.1 * i * i, 0.3 * std::sin(i + 2 * j)); };
  patch.boundary = {point(0, 0), point(1, 0), point(2, 0), point(3, 0), point(3, 1), point(3, 2),
                    point(3, 3), point(2, 3), point(1, 3), point(0, 3), point(0, 2), point(0, 1)};
  patch.inner = {point(1, 1), point(1, 1), point(2, 1), point(2, 1),
                 point(2, 2), point(2, 2), point(1, 2), point(1, 2)};
  return patch;
}

/// A side of a surface at t, 0..1, going around it.
std::array<double, 2> on_side(std::size_t side, double t) {
  const std::array<std::array<double, 2>, 4> places = {{{t, 0}, {1, t}, {1 - t, 1}, {0, 1 - t}}};
  return places[side];
}

}  // namespace

TEST_CASE("a bicubic B-spline is what de Boor's algorithm finds") {
  BicubicSpline spline;
  spline.u_knots = {0, 0, 0, 0, 0.125, 0.25, 0.75, 1, 1, 1, 1};
  spline.v_knots = {0, 0, 0, 0, 0.4, 1, 1, 1, 1};
  for (std::size_t k = 0; k < spline.u_count() * spline.v_count(); ++k) {
    const double x = static_cast<double>(k);
    spline.points.emplace_back(std::sin(x), std::cos(3 * x), std::sin(7 * x));
  }
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const double u = i / 16.0, v = j / 20.0;
      const PatchPoint p = spline.at(u, v);
      CHECK((p.at - cut_corners(spline, u, v)).norm() < 1e-14);
      if (i == 0 || i == 16 || j == 0 || j == 20) continue;
      constexpr double step = 1e-5;
      CHECK((p.du - (spline.at(u + step, v).at - spline.at(u - step, v).at) / (2 * step)).norm() < 1e-6);
      CHECK((p.dv - (spline.at(u, v + step).at - spline.at(u, v - step).at) / (2 * step)).norm() < 1e-6);
    }
  }
}

TEST_CASE("a cubic stays itself on any knots") {
  const RationalCubic cubic{{Vec3(0, 0, 0), Vec3(1, 2, 0), Vec3(3, -1, 1), Vec3(4, 0, 2)}};
  const std::vector<double> knots = {0, 0, 0, 0, 0.1, 0.35, 0.5, 0.9, 1, 1, 1, 1};
  const std::vector<Vec3> points = spline_points(cubic.points, knots);
  CHECK(points.front() == cubic.points[0]);
  CHECK(points.back() == cubic.points[3]);
  for (int i = 0; i <= 50; ++i) CHECK((cut_corners(knots, points, i / 50.0) - cubic.at(i / 50.0)).norm() < 1e-14);
}

TEST_CASE("a patch that is bicubic needs no knots") {
  const GregoryPatch patch = bicubic_patch();
  const BicubicFit fit = fit_bicubic(patch, 1e-12, {true, true, true, true});
  CHECK(fit.within);
  CHECK(fit.spline.points.size() == 16);
  CHECK(fit.error < 1e-14);
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      CHECK((cut_corners(fit.spline, i / 10.0, j / 10.0) - patch.at(i / 10.0, j / 10.0).at).norm() < 1e-14);
    }
  }
}

TEST_CASE("patches are fitted within the tolerance, at other places too") {
  const BicubicFitOptions options;
  for (const auto& [name, brep] : breps_with_patches()) {
    INFO(name);
    const double size = size_of(brep);
    const auto fits = fits_of(brep);
    for (std::size_t f = 0; f < brep.faces.size(); ++f) {
      REQUIRE(fits[f].size() == brep.faces[f].patches.size());
      for (std::size_t p = 0; p < fits[f].size(); ++p) {
        const BicubicFit& fit = fits[f][p];
        CHECK(fit.within);
        CHECK(fit.error <= options.tolerance * size);
        CHECK(fit.angle <= options.angle);
        double greatest = 0;
        for (int i = 0; i <= 37; ++i) {
          for (int j = 0; j <= 37; ++j) {
            const double u = i / 37.0, v = j / 37.0;
            greatest =
                std::max(greatest, (cut_corners(fit.spline, u, v) - brep.faces[f].patches[p].at(u, v).at).norm());
          }
        }
        CHECK(greatest <= 1.02 * options.tolerance * size);
      }
    }
  }
}

TEST_CASE("sides of fits are the patches' own, so that neighbours share them") {
  for (const auto& [name, brep] : breps_with_patches()) {
    INFO(name);
    const double size = size_of(brep);
    const auto fits = fits_of(brep);
    double gap = 0, corner_gap = 0, turn = 0;
    for (std::size_t f = 0; f < brep.faces.size(); ++f) {
      for (std::size_t p = 0; p < fits[f].size(); ++p) {
        const GregoryPatch& patch = brep.faces[f].patches[p];
        const BicubicSpline& spline = fits[f][p].spline;
        for (std::size_t side = 0; side < 4; ++side) {
          for (int k = 0; k <= 101; ++k) {
            const auto [u, v] = on_side(side, k / 101.0);
            gap = std::max(gap, (cut_corners(spline, u, v) - patch.at(u, v).at).norm());
          }
          const auto [u, v] = on_side(side, 0);
          corner_gap = std::max(corner_gap, (spline.at(u, v).at - patch.boundary[3 * side]).norm());
        }
        // Lines inside a face are smooth: both neighbours keep the normal of the patches.
        for (int k = 0; k <= 101 && fits[f].size() > 1; ++k) {
          const BicubicSpline& next = fits[f][(p + 1) % fits[f].size()].spline;
          turn = std::max(turn, angle_between(spline.at(1, k / 101.0).normal(), next.at(k / 101.0, 1).normal()));
        }
      }
    }
    CHECK(gap < 1e-15 * size * 8);
    CHECK(corner_gap == 0);
    CHECK(turn < 2 * BicubicFitOptions{}.angle);
  }
}

TEST_CASE("a fit turns and grows with its patch") {
  const Brep brep = solid_of(sphere_nets()[3].network).brep;
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  constexpr double scale = 250;
  const Vec3 move(3, -20, 5);
  const auto image = [&](const Vec3& p) { return Vec3(scale * (turn * p) + move); };
  for (const BrepFace& face : brep.faces) {
    for (const GregoryPatch& patch : face.patches) {
      GregoryPatch moved = patch;
      for (Vec3& p : moved.boundary) p = image(p);
      for (Vec3& p : moved.inner) p = image(p);
      const BicubicFit a = fit_bicubic(patch, 1e-4, {true, true, true, true});
      const BicubicFit b = fit_bicubic(moved, 1e-4 * scale, {true, true, true, true});
      REQUIRE(a.spline.u_knots == b.spline.u_knots);
      REQUIRE(a.spline.v_knots == b.spline.v_knots);
      CHECK(b.error == Approx(scale * a.error).epsilon(1e-6).margin(1e-10));
      for (std::size_t k = 0; k < a.spline.points.size(); ++k) {
        CHECK((image(a.spline.points[k]) - b.spline.points[k]).norm() < 1e-10 * scale);
      }
    }
  }
}

TEST_CASE("a fit that may have no more spans says what it reaches") {
  const Brep brep = solid_of(sphere_nets()[0].network).brep;
  BicubicFitOptions coarse;
  coarse.most_spans = 2;
  const BicubicFit few = fit_bicubic(brep.faces[0].patches[0], 1e-9, {true, true, true, true}, coarse);
  CHECK(!few.within);
  CHECK(few.error > 1e-9);
  CHECK(few.spline.u_count() <= 5);
  coarse.most_spans = 8;
  CHECK(fit_bicubic(brep.faces[0].patches[0], 1e-9, {true, true, true, true}, coarse).error < few.error);
}

TEST_CASE("a finer tolerance is kept with more control points") {
  const Brep brep = solid_of(bottle().network).brep;
  const auto count = [&](double tolerance) {
    BicubicFitOptions options;
    options.tolerance = tolerance;
    std::size_t points = 0;
    for (const auto& face : fits_of(brep, options)) {
      for (const BicubicFit& fit : face) {
        CHECK(fit.error <= tolerance * size_of(brep));
        points += fit.spline.points.size();
      }
    }
    return points;
  };
  CHECK(count(1e-6) > count(1e-3));
}
