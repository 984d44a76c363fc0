// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/item_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <type_traits>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::render {
namespace {

/// Clay first; then hues that differ in lightness, too, so that they stay apart without red and green.
constexpr std::array<std::array<std::uint8_t, 3>, 8> palette = {{{212, 200, 186},
                                                                 {136, 160, 184},
                                                                 {214, 178, 116},
                                                                 {130, 164, 150},
                                                                 {186, 124, 110},
                                                                 {182, 172, 202},
                                                                 {108, 120, 136},
                                                                 {232, 224, 204}}};

/// Parts in the order in which their keys appear.
std::vector<Index> number_keys(std::span<const double> keys) {
  std::map<double, Index> numbers;
  std::vector<Index> parts;
  parts.reserve(keys.size());
  for (const double key : keys) parts.push_back(numbers.emplace(key, static_cast<Index>(numbers.size())).first->second);
  return parts;
}

bool tells_apart(std::span<const Index> parts) {
  return std::any_of(parts.begin(), parts.end(), [](Index part) { return part != 0; });
}

std::optional<std::vector<Index>> parts_by_channel(const PolyMesh& mesh, const char* name) {
  const AttributeChannel* channel = mesh.channel(name, Domain::Face);
  if (channel == nullptr || channel->width != 1) return std::nullopt;
  const std::vector<double> keys = std::visit(
      [](const auto& values) {
        std::vector<double> result;
        // "None" (NaN) has no order; a number that is no index stands for it.
        for (const auto value : values) result.push_back(value == value ? static_cast<double>(value) : -1.5);
        return result;
      },
      channel->data);
  return number_keys(keys);
}

std::vector<Index> parts_by_component(const PolyMesh& mesh, std::span<const Index> welded) {
  DisjointSets sets(welded.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const Index vertex : mesh.face(f)) sets.unite(welded[mesh.face(f)[0]], welded[vertex]);
  }
  std::vector<double> keys;
  keys.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    keys.push_back(mesh.face(f).empty() ? -1.0 : static_cast<double>(sets.root(welded[mesh.face(f)[0]])));
  }
  return number_keys(keys);
}

template <typename Value>
std::optional<std::uint8_t> color_level(Value value) {
  if constexpr (std::is_floating_point_v<Value>) {
    if (std::isnan(value)) return std::nullopt;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp<double>(value, 0, 1)));
  } else {
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(value, 0, 255));
  }
}

/// The colour of one element; none where the channel has none.
std::optional<Color> color_at(const AttributeChannel& channel, std::size_t element) {
  return std::visit(
      [&](const auto& values) -> std::optional<Color> {
        const std::size_t first = element * static_cast<std::size_t>(channel.width);
        if (channel.width < 3 || first + 3 > values.size()) return std::nullopt;
        const auto red = color_level(values[first]);
        const auto green = color_level(values[first + 1]);
        const auto blue = color_level(values[first + 2]);
        if (!red || !green || !blue) return std::nullopt;
        return Color(*red, *green, *blue, 255);
      },
      channel.data);
}

}  // namespace

Color palette_color(std::size_t index) {
  const auto& [red, green, blue] = palette[index % palette.size()];
  return {red, green, blue, 255};
}

std::vector<Index> face_parts(const PolyMesh& mesh, std::span<const Index> welded) {
  for (const char* name : {"object", "group"}) {
    if (auto parts = parts_by_channel(mesh, name); parts && tells_apart(*parts)) return std::move(*parts);
  }
  return parts_by_component(mesh, welded);
}

OwnColors::OwnColors(const PolyMesh& mesh)
    : mesh_(mesh),
      by_face_(mesh.channel("color", Domain::Face)),
      by_corner_(mesh.channel("color", Domain::Corner)),
      by_vertex_(mesh.channel("color", Domain::Vertex)) {}

std::optional<Color> OwnColors::of(std::size_t face, std::size_t corner) const {
  std::optional<Color> color;
  if (by_face_ != nullptr) color = color_at(*by_face_, face);
  if (!color && by_corner_ != nullptr) color = color_at(*by_corner_, corner);
  if (!color && by_vertex_ != nullptr) color = color_at(*by_vertex_, mesh_.corners[corner]);
  return color;
}

std::vector<Color> corner_colors(const PolyMesh& mesh, std::span<const Index> parts) {
  const OwnColors own(mesh);
  std::vector<Color> colors;
  colors.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c)
      colors.push_back(own.of(f, c).value_or(palette_color(parts[f])));
  }
  return colors;
}

std::vector<Color> line_colors(const PolyMesh& mesh, const Color& fallback) {
  const AttributeChannel* by_line = mesh.channel("color", Domain::Line);
  const AttributeChannel* by_vertex = mesh.channel("color", Domain::Vertex);
  std::vector<Color> colors;
  colors.reserve(mesh.line_vertices.size());
  for (std::size_t l = 0; l < mesh.line_count(); ++l) {
    for (const Index vertex : mesh.line(l)) {
      std::optional<Color> color;
      if (by_line != nullptr) color = color_at(*by_line, l);
      if (!color && by_vertex != nullptr) color = color_at(*by_vertex, vertex);
      colors.push_back(color.value_or(fallback));
    }
  }
  return colors;
}

}  // namespace croquis::render
