// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <Eigen/Dense>

namespace croquis::test {
namespace {

using Cubic = std::array<Vec2, 4>;

class Page {
 public:
  explicit Page(const SvgStyle& style) : style_(style) {}

  std::string number(double value) const {
    std::array<char, 64> buffer{};
    const auto end = style_.decimals < 0 ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value)
                                         : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                         std::chars_format::fixed, style_.decimals);
    std::string text(buffer.data(), end.ptr);
    if (style_.decimals > 0) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
  }

  std::string place(const Vec2& p) const {
    return number(p.x()) + ' ' + number((style_.shift ? style_.height : 0) - p.y());
  }

 private:
  SvgStyle style_;
};

Vec2 evaluate(const Cubic& c, double t) {
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

/// Least squares for the two handle lengths at given parameters.
Cubic fit_handles(const std::vector<Vec2>& points, const std::vector<double>& at, const Vec2& out, const Vec2& in) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  const Vec2 a = points.front();
  const Vec2 b = points.back();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = at[i];
    const double s = 1 - t;
    const Vec2 u = 3 * s * s * t * out;
    const Vec2 v = 3 * s * t * t * in;
    const Vec2 rest = points[i] - (s * s * s + 3 * s * s * t) * a - (t * t * t + 3 * s * t * t) * b;
    normal += Eigen::Matrix2d{{u.dot(u), u.dot(v)}, {u.dot(v), v.dot(v)}};
    right += Vec2(u.dot(rest), v.dot(rest));
  }
  const double chord = (b - a).norm();
  Vec2 lengths(chord / 3, chord / 3);
  if (std::abs(normal.determinant()) > 1e-12 * normal.trace() * normal.trace()) lengths = normal.inverse() * right;
  if (lengths.minCoeff() < chord * 1e-3 || lengths.maxCoeff() > chord * 3) lengths.setConstant(chord / 3);
  return {a, a + lengths.x() * out, b + lengths.y() * in, b};
}

std::vector<double> chord_parameters(const std::vector<Vec2>& points) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
  for (double& t : at) t /= at.back();
  at.back() = 1;
  return at;
}

/// One Newton step per point towards its nearest parameter.
void improve(const Cubic& c, const std::vector<Vec2>& points, std::vector<double>& at) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double t = at[i];
    const double s = 1 - t;
    const Vec2 first = 3 * (s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
    const Vec2 second = 6 * (s * (c[2] - 2 * c[1] + c[0]) + t * (c[3] - 2 * c[2] + c[1]));
    const Vec2 off = evaluate(c, t) - points[i];
    const double slope = first.squaredNorm() + off.dot(second);
    if (slope > 0) at[i] = std::clamp(t - off.dot(first) / slope, 0.0, 1.0);
  }
}

Vec2 tangent(const std::vector<Vec2>& points, std::size_t i, bool closed) {
  const std::size_t n = points.size();
  if (!closed && n > 2 && i == 0) return (4 * points[1] - 3 * points[0] - points[2]).normalized();
  if (!closed && n > 2 && i + 1 == n) return (3 * points[n - 1] - 4 * points[n - 2] + points[n - 3]).normalized();
  if (!closed && n == 2) return (points[1] - points[0]).normalized();
  return (points[(i + 1) % n] - points[(i + n - 1) % n]).normalized();
}

/// Fits one cubic to a run of points, or splits the run where the fit is worst (after Schneider 1990).
void fit(const std::vector<Vec2>& points, const std::vector<Vec2>& tangents, double tolerance,
         std::vector<Cubic>& out) {
  std::vector<double> at = chord_parameters(points);
  Cubic cubic{};
  double worst = 0;
  std::size_t split = 0;
  for (int round = 0; round < 6; ++round) {
    cubic = fit_handles(points, at, tangents.front(), -tangents.back());
    worst = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double off = (evaluate(cubic, at[i]) - points[i]).norm();
      if (off > worst) split = i;
      worst = std::max(worst, off);
    }
    if (worst <= tolerance) break;
    improve(cubic, points, at);
  }
  if (worst <= tolerance) {
    out.push_back(cubic);
    return;
  }
  const auto cut = static_cast<std::ptrdiff_t>(split);
  fit({points.begin(), points.begin() + cut + 1}, {tangents.begin(), tangents.begin() + cut + 1}, tolerance, out);
  fit({points.begin() + cut, points.end()}, {tangents.begin() + cut, tangents.end()}, tolerance, out);
}

std::vector<Cubic> fit_stroke(const std::vector<Vec2>& samples, bool closed, double tolerance) {
  std::vector<Vec2> points = samples;
  std::vector<Vec2> tangents;
  for (std::size_t i = 0; i < points.size(); ++i) tangents.push_back(tangent(samples, i, closed));
  std::vector<Cubic> cubics;
  if (!closed) {
    fit(points, tangents, tolerance, cubics);
    return cubics;
  }
  points.push_back(points.front());
  tangents.push_back(tangents.front());
  // In two halves: a chord from a point to itself has no direction.
  const auto half = static_cast<std::ptrdiff_t>(points.size() / 2);
  fit({points.begin(), points.begin() + half + 1}, {tangents.begin(), tangents.begin() + half + 1}, tolerance, cubics);
  fit({points.begin() + half, points.end()}, {tangents.begin() + half, tangents.end()}, tolerance, cubics);
  return cubics;
}

std::string path_of(const Stroke& stroke, const SvgStyle& style) {
  const Page page(style);
  std::vector<Vec2> points;
  for (const StrokeSample& sample : stroke.samples) points.push_back(sample.position);
  std::string path = "M " + page.place(points.front());
  if (style.curves == SvgCurves::Polyline || points.size() < 3) {
    for (std::size_t i = 1; i < points.size(); ++i) path += " L " + page.place(points[i]);
  } else {
    for (const Cubic& c : fit_stroke(points, stroke.closed, style.tolerance)) {
      path += " C " + page.place(c[1]) + ' ' + page.place(c[2]) + ' ' + page.place(c[3]);
    }
  }
  return stroke.closed ? path + " Z" : path;
}

}  // namespace

std::string to_svg(const Drawing& drawing, const SvgStyle& style) {
  const Page page(style);
  const std::string size = page.number(style.width) + "\" height=\"" + page.number(style.height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 " +
                    (style.shift ? "0" : page.number(-style.height)) + ' ' + page.number(style.width) + ' ' +
                    page.number(style.height) + "\">\n";
  svg += "<g fill=\"none\" stroke=\"#222\" stroke-width=\"3\" stroke-linecap=\"round\">\n";
  for (const Stroke& stroke : drawing.strokes) {
    svg += "<path id=\"" + stroke.id + '"';
    for (const auto& [name, value] : stroke.data) svg += " data-" + name + "=\"" + value + '"';
    svg += " d=\"" + path_of(stroke, style) + "\"/>\n";
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace croquis::test
