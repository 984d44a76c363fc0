// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/item_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include <glm/glm.hpp>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/render/color.h"
#include "croquis/render/sharpness_color.h"
#include "croquis/render/value_color.h"

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

bool has_several(std::span<const Index> parts) {
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

/// Red, green, blue at evenly spaced places of a scale, 0..255.
template <std::size_t stops>
using ColorRamp = std::array<std::array<double, 3>, stops>;

/// The colour at a place of the scale, between its stops by share. @param place 0..1, not NaN
template <std::size_t stops>
Color color_on(const ColorRamp<stops>& ramp, double place) {
  const double at = std::clamp(place, 0.0, 1.0) * (stops - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), stops - 2);
  const double share = at - static_cast<double>(stop);
  Color color(0, 0, 0, 255);
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    color[i] = static_cast<std::uint8_t>(std::lround((1 - share) * ramp[stop][c] + share * ramp[stop + 1][c]));
  }
  return color;
}

constexpr ColorRamp<5> value_ramp = {{{68, 20, 92}, {58, 82, 139}, {33, 145, 140}, {105, 200, 92}, {248, 230, 84}}};
constexpr Color no_value_color = {150, 150, 150, 255};

double number_at(const AttributeChannel& channel, std::size_t element) {
  return std::visit(
      [&](const auto& values) {
        const std::size_t at = element * static_cast<std::size_t>(channel.width);
        return at < values.size() ? static_cast<double>(values[at]) : std::numeric_limits<double>::quiet_NaN();
      },
      channel.data);
}

/// The values of a mesh's corners, and which faces show them.
class CornerValues {
 public:
  CornerValues(const PolyMesh& mesh, const ValueColoring& coloring)
      : mesh_(mesh),
        coloring_(coloring),
        by_vertex_(mesh.channel(coloring.channel, Domain::Vertex)),
        by_face_(by_vertex_ != nullptr ? nullptr : mesh.channel(coloring.channel, Domain::Face)),
        marks_(mesh.channel(coloring.mark, Domain::Face)) {}

  bool none() const { return by_vertex_ == nullptr && by_face_ == nullptr; }

  /// 0 at the scale's low end, 1 at its high one.
  double at(std::size_t face, std::size_t corner) const {
    const double value =
        by_vertex_ != nullptr ? number_at(*by_vertex_, mesh_.corners[corner]) : number_at(*by_face_, face);
    return (value - coloring_.low) / (coloring_.high - coloring_.low);
  }

  bool shown(std::size_t face) const {
    if (marks_ != nullptr && !(number_at(*marks_, face) >= 0)) return false;
    bool all_high = true;
    for (std::size_t c = mesh_.face_offsets[face]; c < mesh_.face_offsets[face + 1]; ++c) {
      const double value = at(face, c);
      if (std::isnan(value)) return false;
      all_high = all_high && value >= 1;
    }
    return marks_ != nullptr || !all_high;
  }

 private:
  const PolyMesh& mesh_;
  const ValueColoring& coloring_;
  const AttributeChannel* by_vertex_;
  const AttributeChannel* by_face_;
  const AttributeChannel* marks_;
};

/// NaN where there is no colour: such places get one of the palette.
void append(std::vector<float>& values, const std::optional<Color>& color) {
  for (int i = 0; i < 3; ++i) {
    values.push_back(color ? static_cast<float>((*color)[i]) / 255.0F : std::numeric_limits<float>::quiet_NaN());
  }
}

constexpr ColorRamp<4> sharpness_ramp = {{{104, 206, 172}, {22, 156, 142}, {26, 96, 146}, {44, 26, 104}}};
constexpr Color infinite_color = {200, 0, 112, 255};

/// In [0, 1]: half a level matters more between 0 and 2 than between 8 and 10.
double share_of_ramp(double sharpness) {
  if (!(sharpness > 0)) return 0;
  return std::log1p(std::min(sharpness, greatest_sharpness)) / std::log1p(greatest_sharpness);
}

std::string label_of(double sharpness) {
  if (sharpness > greatest_sharpness) return "infinite";
  const bool half = sharpness != std::floor(sharpness);
  return std::to_string(static_cast<int>(sharpness)) + (half ? ".5" : "");
}

}  // namespace

Color palette_color(std::size_t index) {
  const auto& [red, green, blue] = palette[index % palette.size()];
  return {red, green, blue, 255};
}

std::vector<Index> face_parts(const PolyMesh& mesh, std::span<const Index> welded) {
  for (const char* name : {"object", "group"}) {
    if (auto parts = parts_by_channel(mesh, name); parts && has_several(*parts)) return std::move(*parts);
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

Color value_color(double value) {
  if (std::isnan(value)) return no_value_color;
  return color_on(value_ramp, value);
}

std::vector<ValueSample> value_legend(int count) {
  std::vector<ValueSample> samples;
  const int last = std::max(count, 2) - 1;
  for (int i = 0; i <= last; ++i) {
    const double value = static_cast<double>(i) / last;
    samples.push_back({value, std::to_string(std::lround(100 * value)) + " %", value_color(value)});
  }
  return samples;
}

PolyMesh with_value_colors(const PolyMesh& mesh, const ValueColoring& coloring) {
  const CornerValues values(mesh, coloring);
  if (values.none()) return mesh;
  const OwnColors own(mesh);
  AttributeChannel colors{"color", Domain::Corner, 3, {}, {}};
  std::vector<float> numbers;
  numbers.reserve(3 * mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const bool shown = values.shown(f);
    for (std::size_t c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c)
      append(numbers, shown ? std::optional(value_color(values.at(f, c))) : own.of(f, c));
  }
  colors.data = std::move(numbers);
  PolyMesh colored = mesh;
  std::erase_if(colored.channels, [](const AttributeChannel& channel) {
    return channel.name == "color" && (channel.domain == Domain::Face || channel.domain == Domain::Corner);
  });
  colored.channels.push_back(std::move(colors));
  return colored;
}

Color sharpness_color(double sharpness) {
  if (sharpness > greatest_sharpness) return infinite_color;
  return color_on(sharpness_ramp, share_of_ramp(sharpness));
}

float sharpness_width(double sharpness) {
  if (sharpness > greatest_sharpness) return 4;
  return static_cast<float>(2 + 1.5 * share_of_ramp(sharpness));
}

std::vector<SharpnessSample> sharpness_legend() {
  std::vector<SharpnessSample> samples;
  for (const double sharpness : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, infinite_sharpness}) {
    samples.push_back({sharpness, label_of(sharpness), sharpness_color(sharpness)});
  }
  return samples;
}

}  // namespace croquis::render
