// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_tubes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/sketches/sketch_spline.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double difference_step = 1e-5;  // of a parameter range of 1: rounding and truncation are both below 1e-9

/// A piece of a contour, walked with the surface on the left.
struct Piece {
  std::function<Vec2(double)> at;        ///< parameter in [0,1]
  std::function<double(double)> strand;  ///< the strand's parameter there
};

Vec2 slope(const TubeStrand& strand, double t) {
  return (strand.centre(t + difference_step) - strand.centre(t - difference_step)) / (2 * difference_step);
}

/// Half the angle between the two directions in which the envelope of the tube's circles touches the circle at t.
double touch_angle(const TubeStrand& strand, double t) {
  const double growth = (strand.radius(t + difference_step) - strand.radius(t - difference_step)) /
                        (2 * difference_step) / slope(strand, t).norm();
  return std::acos(std::clamp(-growth, -1.0, 1.0));
}

/// On the circle of the tube at t, by the angle from the centre line's direction.
Vec2 on_circle(const TubeStrand& strand, double t, double angle) {
  const Vec2 forward = slope(strand, t).normalized();
  return strand.centre(t) + strand.radius(t) * (std::cos(angle) * forward + std::sin(angle) * left_of(forward));
}

Piece right_side(const TubeStrand& strand) {
  return {[&strand](double t) { return on_circle(strand, t, -touch_angle(strand, t)); }, [](double t) { return t; }};
}

Piece left_side(const TubeStrand& strand) {
  return {[&strand](double u) { return on_circle(strand, 1 - u, touch_angle(strand, 1 - u)); },
          [](double u) { return 1 - u; }};
}

Piece end_cap(const TubeStrand& strand) {
  const double half = touch_angle(strand, 1);
  return {[&strand, half](double u) { return on_circle(strand, 1, half * (2 * u - 1)); }, [](double) { return 1.0; }};
}

Piece start_cap(const TubeStrand& strand) {
  const double half = touch_angle(strand, 0);
  return {[&strand, half](double u) { return on_circle(strand, 0, half + 2 * (pi - half) * u); },
          [](double) { return 0.0; }};
}

/// Parameters in [0,1) at even distances along a piece.
std::vector<double> even_parameters(const Piece& piece, double spacing) {
  constexpr int fine = 4000;
  std::vector<double> length{0};
  for (int i = 1; i <= fine; ++i) {
    const double u = static_cast<double>(i) / fine;
    length.push_back(length.back() + (piece.at(u) - piece.at(u - 1.0 / fine)).norm());
  }
  const int count = std::max(4, static_cast<int>(std::lround(length.back() / spacing)));
  std::vector<double> parameters;
  std::size_t k = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = length.back() * i / count;
    while (length[k + 1] < wanted) ++k;
    const double fraction = (wanted - length[k]) / (length[k + 1] - length[k]);
    parameters.push_back((static_cast<double>(k) + fraction) / fine);
  }
  return parameters;
}

TrueContour sample(const std::vector<Piece>& pieces, const TubeStrand& strand, double spacing, int component) {
  TrueContour contour;
  contour.component = component;
  for (const Piece& piece : pieces) {
    for (const double u : even_parameters(piece, spacing)) {
      contour.points.push_back(piece.at(u));
      contour.height.push_back(strand.height(piece.strand(u)));
    }
  }
  return contour;
}

std::vector<Piece> capsule_pieces(const TubeStrand& strand) {
  return {right_side(strand), end_cap(strand), left_side(strand), start_cap(strand)};
}

}  // namespace

Sketch tube_sketch(const std::vector<TubeStrand>& strands, const TubeOptions& options) {
  std::vector<TrueContour> contours;
  std::vector<int> euler;
  for (const TubeStrand& strand : strands) {
    const int component = static_cast<int>(euler.size());
    if (strand.closed) {
      contours.push_back(sample({right_side(strand)}, strand, options.spacing, component));
      contours.push_back(sample({left_side(strand)}, strand, options.spacing, component));
    } else {
      contours.push_back(sample(capsule_pieces(strand), strand, options.spacing, component));
    }
    euler.push_back(strand.closed ? 0 : 1);
  }
  return draw_visible(std::move(contours), std::move(euler));
}

TubeStrand bar(const Vec2& a, const Vec2& b, double radius, std::function<double(double)> height) {
  return {[a, b](double t) -> Vec2 { return a + t * (b - a); }, [radius](double) { return radius; }, std::move(height),
          false};
}

TubeStrand ring(const Vec2& centre, double ring_radius, double radius, std::function<double(double)> height) {
  return {[centre, ring_radius](double t) -> Vec2 {
            return centre + ring_radius * Vec2(std::cos(2 * pi * t), std::sin(2 * pi * t));
          },
          [radius](double) { return radius; }, std::move(height), true};
}

TubeStrand limb(const std::vector<Vec2>& through, const std::vector<double>& radii, double height) {
  const Spline line(through, false);
  std::vector<Vec2> widths;
  for (const double radius : radii) widths.emplace_back(radius, 0);
  const Spline width(widths, line.parameters(), false);
  return {[line](double t) { return line.at(t); }, [width](double t) { return width.at(t).x(); },
          [height](double) { return height; }, false};
}

std::vector<Vec2> tube_outline(const TubeStrand& strand, double spacing) {
  return sample(capsule_pieces(strand), strand, spacing, 0).points;
}

}  // namespace croquis::test
