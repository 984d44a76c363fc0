// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/holes/hole_pins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

constexpr int directions = 12;  // around a place that is taken

/// The middle of the line itself, however unevenly its points lie.
Vec3 mean_along(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& a = points[i];
    const Vec3& b = points[(i + 1) % points.size()];
    sum += (b - a).norm() * ((a - points[0]) + (b - points[0])) / 2;
    length += (b - a).norm();
  }
  return length > 0 ? Vec3(points[0] + sum / length) : points[0];
}

HoleRim rim_of(Index id, std::vector<Vec3> points) {
  HoleRim rim;
  rim.id = id;
  if (points.size() > 1 && points.back() == points.front()) points.pop_back();
  rim.points = std::move(points);
  if (rim.points.empty()) return rim;
  rim.at = mean_along(rim.points);
  const Vec3 area = area_normal(rim.points);
  rim.normal = area.norm() > 0 ? Vec3(-area.normalized()) : Vec3::Zero();
  for (const Vec3& point : rim.points) rim.radius = std::max(rim.radius, (point - rim.at).norm());
  return rim;
}

bool is_inside(const Vec2& pixel, const Vec2& size) {
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= size.x() && pixel.y() <= size.y();
}

/// A pin that is to be placed for one hole.
struct PinRequest {
  HolePin pin;
  double depth = 0;
  double radius = 0;
};

std::vector<PinRequest> requests_of(std::span<const HoleRim> rims, const ViewFrame& frame, const HoleSight& sight) {
  std::vector<PinRequest> requests;
  for (const HoleRim& rim : rims) {
    const auto at = frame.project(rim.at);
    if (!at || !is_inside(at->pixel, frame.size) || std::abs(at->depth) > 1) continue;
    const bool facing = rim.normal.dot(frame.to_eye(rim.at)) >= 0;
    const bool visible = !sight || sight(frame, rim.at);
    requests.push_back({{{rim.id}, rim.id, at->pixel, at->pixel, rim.at, facing, visible}, at->depth, rim.radius});
  }
  std::sort(requests.begin(), requests.end(), [](const PinRequest& a, const PinRequest& b) {
    const auto key = [](const PinRequest& w) {
      return std::tuple(!(w.pin.facing && w.pin.visible), -w.radius, w.pin.hole);
    };
    return key(a) < key(b);
  });
  return requests;
}

/// The pins that have a place, in cells as large as the distance between pins has to be.
class PinBoard {
 public:
  PinBoard(const Vec2& size, const HolePinOptions& options)
      : size_(size), options_(options), apart_(std::max(1.0, 2 * options.radius + options.gap)) {
    std::tie(columns_, rows_) = cell_of(size);
    ++columns_;
    ++rows_;
    cells_.resize(index_of(columns_ - 1, rows_ - 1) + 1);
  }

  void add(const PinRequest& request, const ViewFrame& frame) {
    HolePin pin = request.pin;
    if (HolePin* blocker = nearest(pin.anchor, apart_)) {
      const auto place = free_place(pin.anchor, blocker->pixel);
      if (!place) {
        blocker->holes.push_back(pin.hole);
        return;
      }
      pin.pixel = *place;
      pin.place = frame.unproject(pin.pixel, request.depth);
    }
    const auto [column, row] = cell_of(pin.pixel);
    cells_[index_of(column, row)].push_back(pins_.size());
    pins_.push_back(std::move(pin));
  }

  std::vector<HolePin> take() {
    for (HolePin& pin : pins_) std::sort(pin.holes.begin(), pin.holes.end());
    std::sort(pins_.begin(), pins_.end(), [](const HolePin& a, const HolePin& b) { return a.hole < b.hole; });
    return std::move(pins_);
  }

 private:
  using Cell = std::pair<int, int>;

  Cell cell_of(const Vec2& pixel) const {
    return {static_cast<int>(std::floor(pixel.x() / apart_)), static_cast<int>(std::floor(pixel.y() / apart_))};
  }

  std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  /// The pin nearest to a place and less than that away, of equally near ones the first; or null.
  HolePin* nearest(const Vec2& pixel, double within) {
    const int reach = static_cast<int>(std::ceil(within / apart_));
    const auto [column, row] = cell_of(pixel);
    std::size_t best = pins_.size();
    double best_distance = within;
    for (int x = std::max(column - reach, 0); x <= std::min(column + reach, columns_ - 1); ++x) {
      for (int y = std::max(row - reach, 0); y <= std::min(row + reach, rows_ - 1); ++y) {
        for (const std::size_t number : cells_[index_of(x, y)]) {
          const double distance = (pins_[number].pixel - pixel).norm();
          if (!(distance < best_distance || (distance == best_distance && number < best))) continue;
          if (distance >= within) continue;
          best = number;
          best_distance = distance;
        }
      }
    }
    return best < pins_.size() ? &pins_[best] : nullptr;
  }

  /// The nearest of some places around, first away from what is in the way.
  std::optional<Vec2> free_place(const Vec2& anchor, const Vec2& blocker) {
    const Vec2 away = anchor - blocker;
    const double first = away.norm() > 0 ? std::atan2(away.y(), away.x()) : -std::numbers::pi / 2;
    for (double distance = apart_ / 3; distance <= options_.most_moved; distance += apart_ / 3) {
      for (int i = 0; i < directions; ++i) {
        const int turn = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
        const double angle = first + turn * 2 * std::numbers::pi / directions;
        const Vec2 place = anchor + distance * Vec2(std::cos(angle), std::sin(angle));
        if (is_inside(place, size_) && nearest(place, apart_) == nullptr) return place;
      }
    }
    return std::nullopt;
  }

  Vec2 size_;
  HolePinOptions options_;
  double apart_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
  std::vector<HolePin> pins_;
};

}  // namespace

std::vector<HoleRim> rims_from_lines(const PolyMesh& lines) {
  std::vector<HoleRim> rims;
  rims.reserve(lines.line_count());
  for (std::size_t i = 0; i < lines.line_count(); ++i) {
    std::vector<Vec3> points;
    for (const Index vertex : lines.line(i)) points.push_back(lines.positions[vertex]);
    rims.push_back(rim_of(static_cast<Index>(i), std::move(points)));
  }
  return rims;
}

std::vector<HolePin> place_pins(std::span<const HoleRim> rims, const ViewFrame& frame, const HolePinOptions& options,
                                const HoleSight& sight) {
  PinBoard board(frame.size, options);
  for (const PinRequest& request : requests_of(rims, frame, sight)) board.add(request, frame);
  return board.take();
}

}  // namespace croquis
