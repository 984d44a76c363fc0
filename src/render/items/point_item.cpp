// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/point_item.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/render/mark_item.h"
#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

template <typename PlaceOf>
std::shared_ptr<PointItem> make_item(std::size_t count, const PlaceOf& place_of, const PointStyle& style) {
  auto item = std::make_shared<PointItem>();
  item->style = style;
  for (std::size_t i = 0; i < count; ++i) item->bounds.add(to_glm(place_of(i)));
  set_own_frame(*item);
  item->places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) item->places.push_back(to_own_frame(*item, to_glm(place_of(i))));
  return item;
}

void throw_any(Findings findings) {
  if (!findings.empty()) throw Error(std::move(findings));
}

void require_colors(std::size_t places, std::size_t colors) {
  if (colors == 0 || colors == places) return;
  throw Error(make_error(Category::Usage, "E_COUNT",
                         "There are " + std::to_string(colors) + " colours for " + std::to_string(places) +
                             " points; give one for each or none.",
                         {}));
}

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

PointItemPtr make_point_item(std::span<const Vec3> places, const PointStyle& style, std::span<const Color> colors) {
  require_colors(places.size(), colors.size());
  Findings findings;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].allFinite()) findings.push_back(not_finite(SubjectKind::Point, "point", i));
  }
  throw_any(std::move(findings));
  auto item = make_item(
      places.size(), [&](std::size_t i) -> const Vec3& { return places[i]; }, style);
  item->colors.assign(colors.begin(), colors.end());
  return item;
}

PointItemPtr make_point_item(std::span<const Vec3> places, std::span<const Index> chosen, const PointStyle& style) {
  Findings findings;
  for (const Index i : chosen) {
    if (i >= places.size()) {
      findings.push_back(not_there(SubjectKind::Point, "point", i, places.size()));
    } else if (!places[i].allFinite()) {
      findings.push_back(not_finite(SubjectKind::Point, "point", i));
    }
  }
  throw_any(std::move(findings));
  return make_item(
      chosen.size(), [&](std::size_t i) -> const Vec3& { return places[chosen[i]]; }, style);
}

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
