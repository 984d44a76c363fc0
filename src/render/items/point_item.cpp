// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/point_item.h"

#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "render/items/item_frame.h"
#include "render/items/to_glm.h"

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

}  // namespace croquis::render
