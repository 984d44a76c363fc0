// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/edge_item.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "croquis/base/error.h"
#include "render/items/item_frame.h"
#include "render/items/to_glm.h"

namespace croquis::render {
namespace {

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
