// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/silhouette_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "algorithms/silhouette/surface/shell.h"
#include "croquis/geometry/morton_order.h"

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

/// Lines y = low + k * spacing, each with its events.
struct ScanLines {
  double low = 0;
  double spacing = 1;
  std::vector<std::vector<Event>> events;
};

/// Adds an edge with so many more surfaces on its left than on its right to all lines that it crosses; a line through
/// its lower end counts, through the upper not.
void add_edge(const Vec2& a, const Vec2& b, int times, bool outline, ScanLines& lines) {
  const auto [low, high] = std::minmax(a.y(), b.y());
  const int change = b.y() < a.y() ? times : -times;  // what lies on the left of a descending edge begins there
  const double last = static_cast<double>(lines.events.size()) - 1;
  const double first = std::max(0.0, std::ceil((low - lines.low) / lines.spacing));
  for (double k = first; k <= last && lines.low + k * lines.spacing < high; ++k) {
    const double t = (lines.low + k * lines.spacing - a.y()) / (b.y() - a.y());
    lines.events[static_cast<std::size_t>(k)].push_back({a.x() + t * (b.x() - a.x()), change, outline});
  }
}

/// Adds the edges at which faces that are turned to the viewer end: between two of them nothing changes. Backs cover
/// what their fronts cover.
void add_front_rims(const PolyMesh& mesh, ScanLines& lines) {
  std::vector<std::uint64_t> ends;  // of edges, the lower vertex first
  std::vector<int> times;           // 1 where the edge leads to its higher vertex, else -1
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (seen_area(mesh, f) <= 0) continue;
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = face[i], to = face[(i + 1) % 3];
      ends.push_back(std::min(from, to) << 32 | std::max(from, to));
      times.push_back(from < to ? 1 : -1);
    }
  }
  const std::vector<Index> order = radix_order(ends);
  for (std::size_t i = 0; i < order.size();) {
    const std::uint64_t edge = ends[order[i]];
    int more = 0;
    for (; i < order.size() && ends[order[i]] == edge; ++i) more += times[order[i]];
    const auto point = [&](std::uint64_t vertex) -> Vec2 { return mesh.positions[vertex].head<2>(); };
    if (more != 0) add_edge(point(edge >> 32), point(edge & 0xffffffff), more, false, lines);
  }
}

}  // namespace

Overlap silhouette_overlap(std::span<const PolyMesh* const> meshes, const std::vector<SidedOutline>& outlines) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  const auto widen = [&](const Vec2& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  };
  for (const SidedOutline& outline : outlines) std::ranges::for_each(outline.points, widen);
  for (const PolyMesh* mesh : meshes) {
    for (const Vec3& p : mesh->positions) widen(p.head<2>());
  }
  if (!(high.y() > low.y())) return {};

  const double spacing = (high - low).norm() / line_count;
  ScanLines lines{low.y() + irrational_offset * spacing, spacing, {}};
  lines.events.resize(static_cast<std::size_t>(std::max(0.0, std::floor((high.y() - lines.low) / spacing))) + 1);
  for (const auto& [points, side] : outlines) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      add_edge(points[i], points[(i + 1) % points.size()], side, true, lines);
    }
  }
  for (const PolyMesh* mesh : meshes) add_front_rims(*mesh, lines);

  Overlap overlap;
  for (std::vector<Event>& line : lines.events) {
    std::ranges::sort(line, {}, &Event::x);
    int covered = 0;
    int drawn = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      (line[i].outline ? drawn : covered) += line[i].change;
      const double length = (line[i + 1].x - line[i].x) * spacing;
      if (covered > 0 && drawn > 0) overlap.both += length;
      if (covered > 0 || drawn > 0) overlap.either += length;
    }
  }
  return overlap;
}

}  // namespace croquis::silhouette
