// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/silhouette_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace croquis::silhouette {
namespace {

constexpr double line_count = 1500;
constexpr double irrational_offset = 0.6180339887498949;  // drawings often have round coordinates, lines should not

/// Where a scan line's count of something changes.
struct Event {
  double x = 0;
  int change = 0;
  bool outline = false;  ///< else the mesh
};

class ScanLines {
 public:
  ScanLines(double low, double high, double spacing) : low_(low + irrational_offset * spacing), spacing_(spacing) {
    events_.resize(static_cast<std::size_t>(std::max(0.0, std::floor((high - low_) / spacing))) + 1);
  }

  /// Calls visit(line, x) where the segment a–b crosses a line; a line through the lower end counts, the upper not.
  template <typename Visit>
  void cross(const Vec2& a, const Vec2& b, Visit visit) const {
    const auto [low, high] = std::minmax(a.y(), b.y());
    const double last = static_cast<double>(events_.size()) - 1;
    const double first = std::max(0.0, std::ceil((low - low_) / spacing_));
    for (double k = first; k <= last && low_ + k * spacing_ < high; ++k) {
      const double t = (low_ + k * spacing_ - a.y()) / (b.y() - a.y());
      visit(static_cast<std::size_t>(k), a.x() + t * (b.x() - a.x()));
    }
  }

  void add_outline(const SidedOutline& outline) {
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      const Vec2& a = outline.points[i];
      const Vec2& b = outline.points[(i + 1) % outline.points.size()];
      // The surface on the left of a descending line begins there.
      const int change = (b.y() < a.y() ? 1 : -1) * outline.side;
      cross(a, b, [&](std::size_t line, double x) { events_[line].push_back({x, change, true}); });
    }
  }

  void add_triangle(const std::array<Vec2, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& a = corners[i];
      const Vec2& b = corners[(i + 1) % 3];
      const int change = b.y() < a.y() ? 1 : -1;
      cross(a, b, [&](std::size_t line, double x) { events_[line].push_back({x, change, false}); });
    }
  }

  Overlap measure() {
    Overlap overlap;
    for (std::vector<Event>& line : events_) {
      std::sort(line.begin(), line.end(), [](const Event& a, const Event& b) { return a.x < b.x; });
      int mesh = 0;
      int outlines = 0;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        (line[i].outline ? outlines : mesh) += line[i].change;
        const double length = (line[i + 1].x - line[i].x) * spacing_;
        if (mesh > 0 && outlines > 0) overlap.both += length;
        if (mesh > 0 || outlines > 0) overlap.either += length;
      }
    }
    return overlap;
  }

 private:
  double low_;
  double spacing_;
  std::vector<std::vector<Event>> events_;
};

}  // namespace

Overlap silhouette_overlap(const PolyMesh& mesh, const std::vector<SidedOutline>& outlines) {
  std::vector<Vec2> places;
  for (const SidedOutline& outline : outlines) {
    places.insert(places.end(), outline.points.begin(), outline.points.end());
  }
  for (const Vec3& p : mesh.positions) places.emplace_back(p.x(), p.y());
  if (places.empty()) return {};
  Vec2 low = places.front();
  Vec2 high = places.front();
  for (const Vec2& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  if (!(high.y() > low.y())) return {};

  ScanLines lines(low.y(), high.y(), (high - low).norm() / line_count);
  for (const SidedOutline& outline : outlines) lines.add_outline(outline);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    std::array<Vec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[face[i]].head<2>();
    // Backs cover what their fronts cover.
    if (cross(corners[1] - corners[0], corners[2] - corners[0]) > 0) lines.add_triangle(corners);
  }
  return lines.measure();
}

}  // namespace croquis::silhouette
