// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/group_letters.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "app/tools/perspective/group_looks.h"
#include "app/tools/perspective/sheet_scene.h"
#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

// Logical pixels.
constexpr double letter_pixels = 9;
constexpr double letter_offset = 11;  // from the stroke
constexpr double letter_room = 17;    // between the middles of two letters
constexpr double least_lettered = 32;
constexpr double letter_width = 1.4, letter_casing_width = 4.5;

/// Along a stroke, the middle first.
constexpr std::array letter_places{0.5, 0.36, 0.64, 0.22, 0.78};

/// Of places along the stroke and both of its sides, the first that no letter is near.
std::optional<Vec2> free_place(const PerspectiveStroke& stroke, const std::vector<GroupLetter>& taken, double unit) {
  const std::vector<Vec2> places = traced(stroke.pieces, false);
  for (const double share : letter_places) {
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(places.size())), 1,
                                           places.size() - 2);
    const Vec2 way = places[i + 1] - places[i - 1];
    if (!(way.norm() > 0)) continue;
    for (const double side : {1.0, -1.0}) {
      const Vec2 at = places[i] + side * letter_offset * unit * left_of(way).normalized();
      const bool is_free = std::ranges::none_of(
          taken, [&](const GroupLetter& other) { return (other.at - at).norm() < letter_room * unit; });
      if (is_free) return at;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<GroupLetter> group_letters(const PerspectiveDrawing& drawing, double unit) {
  std::vector<GroupLetter> letters;
  for (const StrokeRole role : {StrokeRole::Edge, StrokeRole::Construction}) {
    for (const PerspectiveStroke& stroke : drawing.strokes) {
      const bool has_room = (stroke.end() - stroke.start()).norm() >= least_lettered * unit;
      if (stroke.role != role || !has_room || !is_drawable(stroke)) continue;
      if (const auto at = free_place(stroke, letters, unit)) letters.push_back({stroke.group, *at});
    }
  }
  return letters;
}

std::vector<render::LineItemPtr> letter_items(const std::vector<GroupLetter>& letters, double unit) {
  std::map<StrokeGroup, std::vector<render::LinePath>> by_group;
  std::vector<render::LinePath> casing;
  for (const GroupLetter& letter : letters) {
    for (const std::vector<Vec2>& part : group_glyph(letter.group)) {
      render::LinePath path;
      for (const Vec2& place : part) {
        path.points.push_back(
            {on_sketch_plane(letter.at) + letter_pixels * unit * glm::dvec3(place.x(), place.y(), 0), 1, {}});
      }
      casing.push_back(path);
      by_group[letter.group].push_back(std::move(path));
    }
  }
  std::vector<render::LineItemPtr> items;
  if (casing.empty()) return items;
  items.push_back(render::make_line_item(
      casing, {letter_casing_width, to_color(colors::paper, 220), {}, render::LineDepth::OnTop}));
  for (const auto& [group, paths] : by_group) {
    items.push_back(
        render::make_line_item(paths, {letter_width, to_color(group_color(group)), {}, render::LineDepth::OnTop}));
  }
  return items;
}

}  // namespace croquis::app
