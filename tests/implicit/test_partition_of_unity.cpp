// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/implicit/partition_of_unity.h"
#include "implicit/sample_points.h"

namespace croquis::implicit {
namespace {

using namespace croquis::test;

PartitionOfUnity make(const Constraints& data, const DomainOptions& options = {},
                      std::vector<ExtraDomain> extras = {}) {
  Progress progress;
  return PartitionOfUnity(data.positions, data.gradients, std::move(extras), options, progress);
}

double torus_distance(const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4; }

std::vector<Vec3> near_torus(std::size_t count) {
  Constraints points = torus_points(count, 1, 0.4);
  for (std::size_t i = 0; i < count; ++i)
    points.positions[i] += 0.02 * std::sin(static_cast<double>(i)) * points.gradients[i];
  return points.positions;
}

/// Largest difference of values and of gradients over a step of 1e-9 across faces of domains, near the torus.
std::pair<double, double> jumps_across_faces(const PartitionOfUnity& field) {
  double value_jump = 0;
  double gradient_jump = 0;
  const std::vector<Vec3> places = near_torus(300);
  for (const Box& box : field.domain_boxes()) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const Vec3& place : places) {
        if (!box.contains(place)) continue;
        for (const double face : {box.low[axis], box.high[axis]}) {
          Vec3 before = place;
          Vec3 after = place;
          before[axis] = face - 1e-9;
          after[axis] = face + 1e-9;
          if (std::abs(torus_distance(before)) > 0.1) continue;
          value_jump = std::max(value_jump, std::abs(field.value(before) - field.value(after)));
          gradient_jump = std::max(gradient_jump, (field.gradient(before) - field.gradient(after)).norm());
        }
      }
    }
  }
  return {value_jump, gradient_jump};
}

TEST_CASE("a blended field follows a torus and its normals") {
  const PartitionOfUnity field = make(torus_points(4000, 1, 0.4));
  double worst = 0;
  double turned = 0;
  const Constraints places = torus_points(2001, 1, 0.4);
  for (std::size_t i = 0; i < places.size(); ++i) {
    worst = std::max(worst, std::abs(field.value(places.positions[i])));
    turned = std::max(turned, (field.gradient(places.positions[i]).normalized() - places.gradients[i]).norm());
  }
  INFO(worst << ", " << turned);
  CHECK(worst < 1e-3);
  CHECK(turned < 0.05);
  const DomainReport report = field.report();
  CHECK(report.data_domains > 100);
  CHECK(report.fitted >= report.data_domains);
  CHECK(report.min_centres >= 30);
  CHECK(report.max_centres <= 300);
  CHECK(report.rank_revealing == 0);
  CHECK(report.bytes > report.data_domains * 30 * 7 * sizeof(double));
}

TEST_CASE("values and gradients don't jump across the faces of domains") {
  const auto [value, gradient] = jumps_across_faces(make(torus_points(1500, 1, 0.4)));
  // A step of 2e-9 along a slope of 1 and a bend of a few 1/unit, rounding, and nothing else.
  CHECK(value < 4e-9);
  CHECK(gradient < 1e-7);
}

TEST_CASE("equal boxes have seams without overlap and none with a quarter") {
  DomainOptions paper;
  paper.equal_boxes = true;
  paper.filler_weight = 0;
  paper.offset_both_sides = false;
  paper.fit = {Kernel::ThinPlate, 0, 0, 0};
  const Constraints data = torus_points(1500, 1, 0.4);
  paper.overlap = 0;
  const auto [without, without_gradient] = jumps_across_faces(make(data, paper));
  paper.overlap = 0.25;
  const auto [with, with_gradient] = jumps_across_faces(make(data, paper));
  INFO(without << ", " << without_gradient << "; " << with << ", " << with_gradient);
  CHECK(without > 1e-4);
  CHECK(without_gradient > 1e-2);
  CHECK(with < 1e-7);
  CHECK(with_gradient < 1e-4);
}

TEST_CASE("full gradients agree with finite differences; the first sum agrees near the surface") {
  for (const Kernel kernel : {Kernel::Hermite, Kernel::Triharmonic}) {
    DomainOptions options;
    options.fit.kernel = kernel;
    const PartitionOfUnity field = make(torus_points(1500, 1, 0.4), options);
    const std::vector<Vec3> places = near_torus(300);
    std::vector<double> values(places.size());
    std::vector<Vec3> first(places.size());
    field.evaluate_for_projection(places, values, first);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec3 gradient = field.gradient(places[i]);
      Vec3 slopes;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 aside = 1e-5 * Vec3::Unit(axis);
        slopes[axis] = (field.value(places[i] + aside) - field.value(places[i] - aside)) / 2e-5;
      }
      CHECK((slopes - gradient).norm() < 1e-5 * gradient.norm());
      CHECK((first[i] - gradient).norm() < 0.1);
    }
  }
}

TEST_CASE("far from the points too, where fillers fade in, gradients agree with finite differences") {
  const PartitionOfUnity field = make(ellipsoid_points(600, Vec3(1, 0.7, 0.5)));
  const std::vector<Vec3> places = random_points(3000, 63);
  const std::size_t before = field.report().fitted;
  for (const Vec3& place : places) {
    const Vec3 gradient = field.gradient(place);
    Vec3 slopes;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 aside = 1e-6 * Vec3::Unit(axis);
      slopes[axis] = (field.value(place + aside) - field.value(place - aside)) / 2e-6;
    }
    CHECK((slopes - gradient).norm() < 1e-4 * (1 + gradient.norm()));
  }
  CHECK(field.report().fitted > before);
}

TEST_CASE("a box that only grazes a dense sheet doesn't take the whole sheet") {
  // A plane just above a face of the tree's cells, and few points below it.
  Constraints data;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      data.positions.emplace_back(0.01 * i, 0.01 * j, 0.5005 + (i % 10 == 0 && j % 10 == 0 ? -0.002 : 0.0));
      data.gradients.push_back(Vec3::UnitZ());
    }
  }
  const DomainReport report = make(data).report();
  CHECK(report.max_centres <= 120);
  CHECK(report.data_domains > 250);
}

TEST_CASE("the bits are the same for any number of threads and any order of queries") {
  const Constraints data = ellipsoid_points(1500, Vec3(1, 0.6, 0.3));
  const std::vector<Vec3> places = random_points(500, 61);
  std::vector<std::vector<double>> all;
  for (const int threads : {1, 2, 8}) {
    DomainOptions options;
    options.threads = threads;
    const PartitionOfUnity field = make(data, options);
    std::vector<double> values(places.size());
    if (threads == 2) {  // backwards, one by one: fillers are fitted in another order
      for (std::size_t i = places.size(); i-- > 0;) values[i] = field.value(places[i]);
    } else {
      field.evaluate(places, values);
    }
    all.push_back(values);
  }
  CHECK(std::memcmp(all[0].data(), all[1].data(), places.size() * sizeof(double)) == 0);
  CHECK(std::memcmp(all[0].data(), all[2].data(), places.size() * sizeof(double)) == 0);
}

TEST_CASE("many threads may ask at once, also where nothing has been fitted yet") {
  const PartitionOfUnity field = make(ellipsoid_points(800, Vec3(1, 0.6, 0.3)));
  const std::vector<Vec3> places = random_points(300, 62);
  std::vector<std::vector<double>> all(6, std::vector<double>(places.size()));
  {
    std::vector<std::jthread> threads;
    for (auto& values : all) threads.emplace_back([&] { field.evaluate(places, values); });
  }
  for (const auto& values : all) CHECK(values == all[0]);
  CHECK(field.report().filler_domains > 0);
}

TEST_CASE("an extra domain rules where there are no data, and nowhere else") {
  // A sphere without its cap z > 0.6, and the cap's domain fitted to points that lie 0.05 further out.
  Constraints open, cap;
  const Constraints sphere = sphere_points(3000, Vec3::Zero(), 1);
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    Constraints& part = sphere.positions[i].z() < 0.6 ? open : cap;
    part.positions.push_back(sphere.positions[i]);
    part.gradients.push_back(sphere.gradients[i]);
  }
  for (Vec3& p : cap.positions) p *= 1.05;
  Constraints thin;
  for (std::size_t i = 0; i < cap.size(); i += 4) {
    thin.positions.push_back(cap.positions[i]);
    thin.gradients.push_back(cap.gradients[i]);
  }
  const Box box = Box{Vec3(-0.85, -0.85, 0.55), Vec3(0.85, 0.85, 1.1)}.grown(0.35);
  const PartitionOfUnity field = make(open, {}, {{box, thin, 1.0}});
  CHECK(field.report().extra_domains == 1);
  CHECK(std::abs(field.value(Vec3(0, 0, 1.05))) < 2e-3);
  CHECK(std::abs(field.value(Vec3(0.3, 0.2, std::sqrt(1.05 * 1.05 - 0.13)))) < 2e-3);
  CHECK(std::abs(field.value(Vec3(0, 0, -1))) < 1e-3);
  CHECK(std::abs(field.value(Vec3(0.8, 0, 0.5999))) < 0.03);
  const PartitionOfUnity without = make(open);
  CHECK(std::abs(field.value(Vec3(0, 0.6, -0.8)) - without.value(Vec3(0, 0.6, -0.8))) < 1e-4);
}

TEST_CASE("outside the tree the field has no value") {
  const PartitionOfUnity field = make(sphere_points(500, Vec3::Zero(), 1));
  CHECK(std::isnan(field.value(Vec3(50, 0, 0))));
  CHECK(field.gradient(Vec3(50, 0, 0)) == Vec3::Zero());
}

TEST_CASE("points far from the origin give the same surface") {
  const Constraints data = torus_points(1500, 1, 0.4);
  Constraints moved = data;
  const Vec3 shift(1e6, -2e6, 5e5);
  for (Vec3& p : moved.positions) p = 1e-3 * p + shift;
  const PartitionOfUnity near = make(data);
  const PartitionOfUnity far = make(moved);
  for (const Vec3& place : near_torus(200))
    CHECK(std::abs(1e3 * far.value(1e-3 * place + shift) - near.value(place)) < 2e-5);
}

TEST_CASE("degenerate points never crash: one, two, a line, a plane, all at one place") {
  Progress progress;
  for (const Kernel kernel : {Kernel::Hermite, Kernel::Triharmonic, Kernel::Biharmonic, Kernel::ThinPlate}) {
    DomainOptions options;
    options.fit.kernel = kernel;
    for (int shape = 0; shape < 5; ++shape) {
      Constraints data;
      const std::size_t count = shape == 0 ? 1 : shape == 1 ? 2 : 200;
      for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i);
        data.positions.push_back(shape == 4 ? Vec3::Ones() : Vec3(t, shape == 3 ? std::sin(t * t) * 90 : 0, 0));
        data.gradients.push_back(Vec3::UnitZ());
      }
      const PartitionOfUnity field = make(data, options);
      CHECK(std::isfinite(field.value(data.positions[0] + Vec3(0.1, 0.1, 0.1))));
      const PartitionOfUnity bare(data.positions, {}, {}, options, progress);
      CHECK(std::isfinite(bare.value(data.positions[0] + Vec3(0.1, 0.1, 0.1))));
    }
  }
}

TEST_CASE("fitting can be cancelled and reports how far it is") {
  const Constraints data = torus_points(3000, 1, 0.4);
  for (const int threads : {1, 4}) {
    DomainOptions options;
    options.threads = threads;
    std::atomic<bool> cancel = false;
    int reports = 0;
    Progress stopping([&](double, const std::string&) { cancel = ++reports == 5; }, &cancel);
    CHECK_THROWS_AS(PartitionOfUnity(data.positions, data.gradients, {}, options, stopping), Cancelled);
    double last = 0;
    Progress reported([&](double fraction, const std::string&) {
      CHECK(fraction >= last);
      last = fraction;
    });
    const PartitionOfUnity field(data.positions, data.gradients, {}, options, reported);
    CHECK(last == 1);
  }
}

TEST_CASE("options out of range and unusable points are refused") {
  const Constraints data = sphere_points(50, Vec3::Zero(), 1);
  DomainOptions options;
  options.overlap = 1.5;
  CHECK_THROWS_AS(make(data, options), Error);
  options = {};
  options.max_points = 10;
  CHECK_THROWS_AS(make(data, options), Error);
  CHECK_THROWS_AS(make({}), Error);
  CHECK_THROWS_AS(make(data, {}, {{{Vec3::Zero(), Vec3(1, 0, 1)}, data, 1.0}}), Error);
  CHECK_THROWS_AS(make(data, {}, {{{Vec3::Zero(), Vec3(1, 1, NAN)}, data, 1.0}}), Error);
  CHECK_THROWS_AS(make(data, {}, {{{Vec3::Zero(), Vec3::Ones()}, {}, 1.0}}), Error);
  CHECK_THROWS_AS(make({{Vec3(0, 0, NAN)}, {}, {}}), Error);
}

}  // namespace
}  // namespace croquis::implicit
