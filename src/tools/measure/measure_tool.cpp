// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/measure/measure_tool.h"

#include <limits>
#include <utility>

namespace croquis {
namespace {

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
