// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/measure/measure_tool.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// As many figures as can be trusted on a screen.
std::string figures(double value) {
  if (std::isinf(value)) return "∞";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

MeasuredValue distance_between(const Vec3& a, const Vec3& b) {
  const double distance = (b - a).norm();
  return {"Distance", distance, figures(distance), (a + b) / 2};
}

constexpr double grab_pixels = 10;

/// The place seen nearest to a pixel, within reach; none as the number of places.
std::size_t place_at(const std::vector<Vec3>& places, const ViewFrame& frame, const Vec2& pixel) {
  std::size_t nearest = places.size();
  double least = grab_pixels;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto seen = frame.project(places[i]);
    if (!seen || (seen->pixel - pixel).norm() > least) continue;
    least = (seen->pixel - pixel).norm();
    nearest = i;
  }
  return nearest;
}

}  // namespace

double angle_at(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 first = a - b, second = c - b;
  if (first.isZero(0) || second.isZero(0)) return 0;
  // Exact near 0 and 180 degrees, where the cosine hardly changes.
  return std::atan2(first.cross(second).norm(), first.dot(second)) * 180 / std::numbers::pi;
}

double radius_through(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double first = (b - a).norm(), second = (c - b).norm(), third = (a - c).norm();
  const double twice_area = (b - a).cross(c - a).norm();
  constexpr double flat = 1e-12;  // of the square of the longest side
  const double longest = std::max({first, second, third});
  if (twice_area <= flat * longest * longest) return std::numeric_limits<double>::infinity();
  return first * second * third / (2 * twice_area);
}

std::vector<MeasuredValue> measured(const std::vector<Vec3>& places) {
  std::vector<MeasuredValue> values;
  for (std::size_t i = 1; i < places.size(); ++i) values.push_back(distance_between(places[i - 1], places[i]));
  if (places.size() < 3) return values;
  const double angle = angle_at(places[0], places[1], places[2]);
  values.push_back({"Angle", angle, figures(angle) + "°", places[1]});
  const double radius = radius_through(places[0], places[1], places[2]);
  values.push_back({"Radius", radius, figures(radius), places[2]});
  return values;
}

std::string measured_text(const std::vector<Vec3>& places) {
  std::string text;
  std::size_t leg = 0;
  for (const MeasuredValue& value : measured(places)) {
    text += value.name + ": " + value.text;
    if (value.name == "Distance") {
      const Vec3 along = places[leg + 1] - places[leg];
      text += " (x " + figures(along.x()) + ", y " + figures(along.y()) + ", z " + figures(along.z()) + ")";
      ++leg;
    }
    text += '\n';
  }
  return text;
}

void MeasureTool::begin(const MeshEvent& event) {
  held_ = place_at(places_, event.frame, event.pixel);
  const auto place = pick_(event.frame, event.pixel);
  if (held_ == places_.size() && !place) return;
  before_ = places_;
  if (held_ < places_.size()) return;
  if (places_.size() == most_places) places_.clear();
  held_ = places_.size();
  places_.push_back(*place);
}

bool MeasureTool::handle(const MeshEvent& event) {
  switch (event.kind) {
    case PenStep::Kind::Begin:
      abandon();
      begin(event);
      return false;
    case PenStep::Kind::Sample:
      if (before_) {
        if (const auto place = pick_(event.frame, event.pixel)) places_[held_] = *place;
      }
      return false;
    case PenStep::Kind::End: {
      const auto before = std::exchange(before_, std::nullopt);
      return before && *before != places_;
    }
    case PenStep::Kind::Cancel: abandon(); return false;
  }
  return false;
}

bool MeasureTool::abandon() {
  if (!before_) return false;
  places_ = *std::exchange(before_, std::nullopt);
  return true;
}

bool MeasureTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  auto place = pick_(frame, pixel);
  const bool changed = place != hovered_;
  hovered_ = std::move(place);
  return changed;
}

bool MeasureTool::leave() { return std::exchange(hovered_, std::nullopt).has_value(); }

void MeasureTool::set_places(std::vector<Vec3> places) {
  before_.reset();
  if (places.size() > most_places) places.resize(most_places);
  places_ = std::move(places);
}

bool MeasureTool::remove_last() {
  if (places_.empty()) return false;
  before_.reset();
  places_.pop_back();
  return true;
}

}  // namespace croquis
