// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/strokes/stroke_fit.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using test::drawn_curves;
using test::DrawnCurve;
using test::sampled;

std::vector<Vec2> traced(const StrokeFit& fit) {
  std::vector<Vec2> places;
  for (const CubicSegment& segment : fit.segments) {
    for (int i = 0; i <= 50; ++i) places.push_back(point_at(segment, i / 50.0));
  }
  return places;
}

/// From places on the fit to the true curve, the farthest; an oracle that knows nothing of the fit's parameters.
double deviation(const StrokeFit& fit, const DrawnCurve& curve) {
  std::vector<Vec2> truth;
  for (int i = 0; i <= 20000; ++i) truth.push_back(curve.at(i / 20000.0));
  double largest = 0;
  for (const Vec2& place : traced(fit)) {
    double nearest = std::numeric_limits<double>::max();
    for (const Vec2& other : truth) nearest = std::min(nearest, (place - other).squaredNorm());
    largest = std::max(largest, nearest);
  }
  return std::sqrt(largest);
}

int corner_count(const StrokeFit& fit) {
  return static_cast<int>(
      std::count_if(fit.anchors.begin(), fit.anchors.end(), [](const StrokeAnchor& anchor) { return anchor.corner; }));
}

void check_is_chain(const Stroke& stroke, const StrokeFit& fit) {
  REQUIRE(fit.segments.size() == fit.anchors.size() - (fit.closed ? 0 : 1));
  for (std::size_t k = 0; k < fit.segments.size(); ++k) {
    const StrokeAnchor& next = fit.anchors[(k + 1) % fit.anchors.size()];
    CHECK(fit.segments[k][0] == fit.anchors[k].position);
    CHECK(fit.segments[k][3] == next.position);
    if (k + 1 < fit.anchors.size()) CHECK(fit.anchors[k].sample < next.sample);
    CHECK(next.sample < stroke.samples.size());
  }
}

void check_smooth_joints(const StrokeFit& fit) {
  for (std::size_t k = 0; k < fit.segments.size(); ++k) {
    if (k + 1 == fit.segments.size() && !fit.closed) break;
    if (fit.anchors[(k + 1) % fit.anchors.size()].corner) continue;
    const CubicSegment& before = fit.segments[k];
    const CubicSegment& after = fit.segments[(k + 1) % fit.segments.size()];
    const Vec2 in = (before[3] - before[2]).normalized();
    const Vec2 out = (after[1] - after[0]).normalized();
    CHECK(in.dot(out) > 0.999);
  }
}

TEST_CASE("fits of clean strokes stay within 0.3 px RMS, keep corners and join smoothly elsewhere") {
  for (const DrawnCurve& curve : drawn_curves()) {
    INFO(curve.name);
    const Stroke stroke = sampled(curve);
    const StrokeFit fit = fit_stroke(stroke);
    CHECK(fit.closed == curve.closed);
    CHECK(fit.rms <= 0.3);
    CHECK(fit.raw_rms <= 0.3);
    CHECK(fit.largest <= 1.5);
    CHECK(corner_count(fit) == curve.corners);
    check_is_chain(stroke, fit);
    check_smooth_joints(fit);
    CHECK(deviation(fit, curve) <= 2);
  }
}

TEST_CASE("few anchors suffice: a circle needs no more than twelve, a straight line two") {
  for (const DrawnCurve& curve : drawn_curves()) {
    const StrokeFit fit = fit_stroke(sampled(curve));
    INFO(curve.name << ": " << fit.anchors.size());
    if (curve.name.find("circle") != std::string::npos) CHECK(fit.anchors.size() <= 12);
    if (curve.name == "straight line") CHECK(fit.anchors.size() == 2);
    CHECK(fit.anchors.size() <= 40);
  }
}

TEST_CASE("jitter of up to 0.4 px neither breaks the tolerance nor multiplies the anchors") {
  test::Random random(5);
  for (const DrawnCurve& curve : drawn_curves()) {
    for (const double noise : {0.1, 0.25, 0.4}) {
      Stroke stroke = sampled(curve);
      for (StrokeSample& sample : stroke.samples) sample.position += test::jitter(random, noise);
      const StrokeFit fit = fit_stroke(stroke);
      INFO(curve.name << ", jitter " << noise << ", raw RMS " << fit.raw_rms << ", anchors " << fit.anchors.size());
      CHECK(fit.rms <= 0.3);
      CHECK(fit.raw_rms <= 0.3 + 1.5 * noise);
      CHECK(fit.anchors.size() <= 2 * fit_stroke(sampled(curve)).anchors.size() + 45);
      check_is_chain(stroke, fit);
    }
  }
}

TEST_CASE("a fit follows the stroke when it is turned by a quarter and scaled, to the last bit") {
  for (const DrawnCurve& curve : drawn_curves()) {
    INFO(curve.name);
    const Stroke stroke = sampled(curve);
    const StrokeFit fit = fit_stroke(stroke);
    Stroke other = stroke;
    for (StrokeSample& sample : other.samples) sample.position = 4 * left_of(sample.position);
    FitOptions options;
    options.units_per_pixel = 4;
    const StrokeFit moved = fit_stroke(other, options);
    REQUIRE(moved.anchors.size() == fit.anchors.size());
    CHECK(moved.rms == Approx(4 * fit.rms).margin(1e-9));
    for (std::size_t k = 0; k < fit.anchors.size(); ++k) {
      CHECK(moved.anchors[k].sample == fit.anchors[k].sample);
      CHECK((moved.anchors[k].position - 4 * left_of(fit.anchors[k].position)).norm() < 1e-9);
    }
  }
}

TEST_CASE("a fit is as good for a stroke drawn elsewhere at any angle") {
  for (const DrawnCurve& curve : drawn_curves()) {
    INFO(curve.name);
    Stroke stroke = sampled(curve);
    for (StrokeSample& sample : stroke.samples)
      sample.position = 0.6 * sample.position + 0.8 * left_of(sample.position) + Vec2(1000, -300);
    const StrokeFit fit = fit_stroke(stroke);
    CHECK(fit.rms <= 0.3);
    CHECK(corner_count(fit) == curve.corners);
    CHECK(std::abs(static_cast<int>(fit.anchors.size()) -
                   static_cast<int>(fit_stroke(sampled(curve)).anchors.size())) <= 2);
  }
}

TEST_CASE("a finer tolerance is met as well") {
  for (const DrawnCurve& curve : drawn_curves()) {
    FitOptions options;
    options.tolerance = 0.02;
    options.smoothing = 0;
    const StrokeFit fit = fit_stroke(sampled(curve), options);
    INFO(curve.name);
    CHECK(fit.rms <= 0.02);
    CHECK(fit.raw_rms <= 0.05);  // crowded samples are fitted by their means
  }
}

TEST_CASE("strokes of one and two samples, and repeated samples, have their fits") {
  const StrokeFit dot = fit_stroke(test::stroke_through({{3, 4}}, "s"));
  CHECK(dot.anchors.size() == 1);
  CHECK(dot.segments.empty());
  const StrokeFit still = fit_stroke(test::stroke_through(std::vector<Vec2>(500, Vec2(3, 4)), "s", true));
  CHECK(still.anchors.size() == 1);
  CHECK(!still.closed);
  const StrokeFit line = fit_stroke(test::stroke_through({{0, 0}, {9, 0}}, "s"));
  REQUIRE(line.segments.size() == 1);
  CHECK(line.largest == 0);
  CHECK((point_at(line.segments[0], 0.5) - Vec2(4.5, 0)).norm() < 1e-12);
  std::vector<Vec2> repeated;
  for (int i = 0; i < 100; ++i) repeated.insert(repeated.end(), 5, Vec2(i * 3.0, 40 * std::sin(i * 0.1)));
  const Stroke stroke = test::stroke_through(repeated, "s");
  const StrokeFit fit = fit_stroke(stroke);
  CHECK(fit.raw_rms <= 0.3);
  check_is_chain(stroke, fit);
}

TEST_CASE("random scrawls fit within tolerance, whatever they do") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO(seed);
    test::Random random(seed);
    std::vector<Vec2> places = {{0, 0}};
    const std::size_t count = 2 + random.below(400);
    const double step = random.between(0.01, 20);
    while (places.size() < count)
      places.push_back(places.back() + Vec2(random.between(-step, step), random.between(-step, step)));
    const Stroke stroke = test::stroke_through(places, "s", random.below(2) == 0);
    const StrokeFit fit = fit_stroke(stroke);
    CHECK(fit.rms <= 0.3);
    CHECK(std::isfinite(fit.largest));
    if (!fit.segments.empty()) check_is_chain(stroke, fit);
  }
}

TEST_CASE("a very long stroke is fitted without trouble") {
  const DrawnCurve coil = {"coil", [](double t) { return Vec2(9000 * t, 90 * std::sin(400 * t)); }, 200000};
  const StrokeFit fit = fit_stroke(sampled(coil));
  CHECK(fit.rms <= 0.3);
  CHECK(fit.anchors.size() < 1000);
}

TEST_CASE("strokes without samples or with places that are not finite are refused by name") {
  const auto code_of = [](const Stroke& stroke) {
    try {
      fit_stroke(stroke);
    } catch (const Error& error) {
      REQUIRE(error.findings().front().subjects.front().id == stroke.id);
      return error.findings().front().code;
    }
    return std::string();
  };
  CHECK(code_of(test::stroke_through({}, "empty")) == "E_NO_STROKES");
  CHECK(code_of(test::stroke_through({{0, 0}, {std::nan(""), 1}}, "bad")) == "E_NOT_FINITE");
}

}  // namespace
}  // namespace croquis
