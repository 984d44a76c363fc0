// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/value_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "render/items/color_ramp.h"
#include "render/items/item_colors.h"

namespace croquis::render {
namespace {

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

}  // namespace

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

}  // namespace croquis::render
