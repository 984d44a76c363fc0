// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/line_item.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/render/edge_item.h"
#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

bool all_finite(const LinePath& line) {
  for (const LinePoint& point : line.points) {
    if (!is_finite(point.position) || !std::isfinite(point.width_factor)) return false;
  }
  return true;
}

void require_finite(std::span<const LinePath> lines, const LineStyle& style) {
  Findings findings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!all_finite(lines[i])) findings.push_back(not_finite(SubjectKind::Line, "line", i));
  }
  if (!std::isfinite(style.width)) findings.push_back(not_finite(SubjectKind::Line, "style of line", 0));
  if (!findings.empty()) throw Error(std::move(findings));
}

Bounds bounds_of(std::span<const LinePath> lines) {
  Bounds bounds;
  for (const LinePath& line : lines) {
    for (const LinePoint& point : line.points) bounds.add(point.position);
  }
  return bounds;
}

/// Appends the corners of one line, the last one marked as such.
void append_corners(const LinePath& line, LineItem& item) {
  const auto append = [&](const LinePoint& point) {
    const double width = item.style.width * std::max(0.0F, point.width_factor);
    item.corners.push_back({to_own_frame(item, point.position), static_cast<float>(std::min(width, 128.0)),
                            point.color.value_or(item.style.color)});
  };
  for (const LinePoint& point : line.points) append(point);
  // A segment needs two ends: a single point is one of length 0.
  if (line.closed || line.points.size() == 1) append(line.points.front());
  item.corners.back().width = -1 - item.corners.back().width;
}

bool one_color(const LineItem& item, std::size_t first, const Color& color) {
  for (std::size_t i = first; i < item.corners.size(); ++i) {
    if (item.corners[i].color != color) return false;
  }
  return true;
}

void require_drawable(std::span<const Vec3> positions, std::span<const StyledEdge> edges) {
  Findings findings;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b] = edges[i].vertices;
    if (std::max(a, b) >= positions.size()) {
      findings.push_back(not_there(SubjectKind::Vertex, "vertex", std::max(a, b), positions.size()));
    } else if (!positions[a].allFinite() || !positions[b].allFinite() || !std::isfinite(edges[i].width)) {
      findings.push_back(not_finite(SubjectKind::Edge, "edge", i));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

LineCorner corner_of(const LineItem& item, const Vec3& place, const StyledEdge& edge) {
  return {to_own_frame(item, to_glm(place)), std::clamp(edge.width, 0.0F, 128.0F), edge.color};
}

}  // namespace

LineItemPtr make_line_item(std::span<const LinePath> lines, const LineStyle& style) {
  require_finite(lines, style);
  auto item = std::make_shared<LineItem>();
  item->style = style;
  item->bounds = bounds_of(lines);
  set_own_frame(*item);
  std::size_t count = 0;
  for (const LinePath& line : lines) count += line.points.size() + 1;
  item->corners.reserve(count);
  bool previous_plain = false;  // of one colour all along
  for (const LinePath& line : lines) {
    if (line.points.empty()) continue;
    const std::size_t first = item->corners.size();
    append_corners(line, *item);
    const bool plain = one_color(*item, first, item->corners[first].color);
    const bool joins = plain && previous_plain && item->corners[first - 1].color == item->corners[first].color;
    if (!joins) item->runs.push_back({static_cast<std::uint32_t>(first), 0, false});
    LineRun& run = item->runs.back();
    run.count = static_cast<std::uint32_t>(item->corners.size()) - run.first;
    previous_plain = plain;
  }
  return item;
}

LineItemPtr make_line_item(const LinePath& line, const LineStyle& style) {
  return make_line_item(std::span(&line, 1), style);
}

LinePath line_through(std::span<const glm::dvec3> places, bool closed) {
  LinePath line;
  line.closed = closed;
  line.points.reserve(places.size());
  for (const glm::dvec3& place : places) line.points.push_back({place, 1, std::nullopt});
  return line;
}

LineItemPtr make_edge_item(std::span<const Vec3> positions, std::span<const StyledEdge> edges, LineDepth depth) {
  require_drawable(positions, edges);
  auto item = std::make_shared<LineItem>();
  item->style.depth = depth;
  for (const StyledEdge& edge : edges) {
    for (const Index vertex : edge.vertices) item->bounds.add(to_glm(positions[vertex]));
  }
  set_own_frame(*item);
  item->corners.reserve(2 * edges.size());
  for (const StyledEdge& edge : edges) {
    item->corners.push_back(corner_of(*item, positions[edge.vertices[0]], edge));
    item->corners.push_back(corner_of(*item, positions[edge.vertices[1]], edge));
    item->corners.back().width = -1 - item->corners.back().width;
  }
  // One run whatever the colours: where edges meet, each pixel goes to the edge that it lies deepest in.
  if (!edges.empty()) item->runs.push_back({0, static_cast<std::uint32_t>(item->corners.size()), true});
  return item;
}

}  // namespace croquis::render
