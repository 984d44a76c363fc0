// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/mark_item.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

bool all_finite(const Mark& mark) {
  for (const float number : {mark.size, mark.outline_width, mark.halo_width, mark.angle, mark.under_angle}) {
    if (!std::isfinite(number)) return false;
  }
  return is_finite(mark.position);
}

void require_finite(std::span<const Mark> marks) {
  Findings findings;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!all_finite(marks[i])) findings.push_back(not_finite(SubjectKind::Point, "mark", i));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

float drawn_width(float width, const Color& color) { return color.a == 0 ? 0.0F : std::clamp(width, 0.0F, 64.0F); }

MarkVertex vertex_of(const Mark& mark, const MarkItem& item) {
  MarkVertex vertex;
  vertex.position = to_own_frame(item, mark.position);
  vertex.size = std::clamp(mark.size, 0.0F, 256.0F);
  vertex.outline_width = drawn_width(mark.outline_width, mark.outline);
  vertex.halo_width = drawn_width(mark.halo_width, mark.halo);
  vertex.angle = mark.angle;
  vertex.under_angle = mark.under_angle;
  vertex.color = mark.color;
  vertex.outline = mark.outline;
  vertex.halo = mark.halo;
  vertex.shape = static_cast<std::uint32_t>(mark.shape);
  return vertex;
}

}  // namespace

MarkItemPtr make_mark_item(std::span<const Mark> marks, MarkDepth depth) {
  require_finite(marks);
  auto item = std::make_shared<MarkItem>();
  item->depth = depth;
  for (const Mark& mark : marks) item->bounds.add(mark.position);
  set_own_frame(*item);
  item->marks.reserve(marks.size());
  for (const Mark& mark : marks) item->marks.push_back(vertex_of(mark, *item));
  return item;
}

}  // namespace croquis::render
