// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/silhouette_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

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

  /// An edge with the mesh on its left so many times more than on its right.
  void add_edge(const Vec2& a, const Vec2& b, int times) {
    const int change = b.y() < a.y() ? times : -times;
    cross(a, b, [&](std::size_t line, double x) { events_[line].push_back({x, change, false}); });
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

/// The edges at which faces that are turned to the viewer end, each with how many more of them lie on its left than on
/// its right: edges between two such faces would change nothing.
class FrontRims {
 public:
  explicit FrontRims(const PolyMesh& mesh) : first_(mesh.vertex_count() + 1, 0) {
    // Backs cover what their fronts cover.
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      const Vec2 a = mesh.positions[face[0]].head<2>();
      if (cross(mesh.positions[face[1]].head<2>() - a, mesh.positions[face[2]].head<2>() - a) <= 0) continue;
      for (std::size_t i = 0; i < 3; ++i) edges_.push_back({face[i], face[(i + 1) % 3]});
    }
    sort_by_lower_ends();
  }

  /// Calls visit(a, b, times) with every edge that counts.
  template <typename Visit>
  void for_each(Visit visit) {
    for (std::size_t low = 0; low + 1 < first_.size(); ++low) {
      for (Index e = first_[low]; e < first_[low + 1]; ++e) {
        HighEnd& edge = high_ends_[e];
        for (Index other = e + 1; other < first_[low + 1]; ++other) {
          if (high_ends_[other].vertex == edge.vertex) edge.times += std::exchange(high_ends_[other].times, 0);
        }
        if (edge.times != 0) visit(static_cast<Index>(low), edge.vertex, edge.times);
      }
    }
  }

 private:
  struct HighEnd {
    Index vertex = 0;
    int times = 0;  ///< 1 where the edge leads to this end, else -1
  };

  void sort_by_lower_ends() {
    for (const auto& [a, b] : edges_) ++first_[std::min(a, b) + std::size_t{1}];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    high_ends_.resize(edges_.size());
    for (const auto& [a, b] : edges_) high_ends_[next[std::min(a, b)]++] = {std::max(a, b), a < b ? 1 : -1};
  }

  std::vector<std::array<Index, 2>> edges_;  ///< of the faces, in their direction
  std::vector<Index> first_;                 ///< per vertex the first of the edges whose lower end it is
  std::vector<HighEnd> high_ends_;
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
  FrontRims(mesh).for_each([&](Index a, Index b, int times) {
    lines.add_edge(mesh.positions[a].head<2>(), mesh.positions[b].head<2>(), times);
  });
  return lines.measure();
}

}  // namespace croquis::silhouette
