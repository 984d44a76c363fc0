// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "croquis/geometry/drawing.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const StrokeSample& sample) {
  return std::tie(sample.position, sample.pressure, sample.tilt, sample.time);
}
static_assert(lists_every_member<StrokeSample>);

inline auto members(const Stroke& stroke) {
  const auto& [id, samples, closed, object, data, line] = stroke;
  return std::tie(id, closed, object, data, line, samples);
}

inline auto members(const DrawingPlane& plane) { return std::tie(plane.origin, plane.u, plane.v); }
static_assert(lists_every_member<DrawingPlane>);

/// Drawings are kept as they are drawn.
template <>
inline constexpr bool holds_any_number<StrokeSample> = true;
template <>
inline constexpr bool holds_any_number<DrawingPlane> = true;

inline void require_valid(const DrawingPlane& plane) {
  if (!plane.is_orthonormal()) throw BadBytes("its plane has no right angle");
}

namespace {

constexpr std::uint32_t first_drawing_layout = 1;
constexpr std::uint32_t placed_drawing_layout = 2;  // of drawings on another plane than the default one

/// In another order than the bytes.
void hash_stroke(const Stroke& stroke, ContentHasher& hasher) {
  hasher.add(stroke.id);
  hasher.add(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) {
    const std::array<double, 6> figures = {sample.position.x(), sample.position.y(), sample.pressure,
                                           sample.tilt.x(),     sample.tilt.y(),     sample.time};
    hasher.add(std::span<const double>(figures));
  }
  hash_member<Absent::Zero>(std::tie(stroke.closed, stroke.object, stroke.data, stroke.line), hasher);
}

/// Strokes on their plane, which comes last where it isn't the default one.
struct DrawingValue {
  using Content = Drawing;
  static constexpr const char* name = "drawing";
  static constexpr std::uint64_t tag = 1;

  static void add_content(const Drawing& drawing, ContentHasher& hasher) {
    hasher.add(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes) hash_stroke(stroke, hasher);
    hash_member(std::tie(drawing.object_data, drawing.file), hasher);
    if (!drawing.plane.is_default()) hash_member(drawing.plane, hasher);
  }

  static std::size_t byte_size(const Drawing& drawing) {
    return sizeof(Drawing) + held_bytes(std::tie(drawing.file, drawing.object_data, drawing.strokes));
  }

  static void store(const Drawing& drawing, ByteWriter& writer) {
    writer.number(drawing.plane.is_default() ? first_drawing_layout : placed_drawing_layout);
    store_member(std::tie(drawing.file, drawing.object_data, drawing.strokes), writer);
    if (!drawing.plane.is_default()) store_member(drawing.plane, writer);
  }

  static Drawing load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, placed_drawing_layout);
    Drawing drawing;
    drawing.file = reader.text();
    drawing.object_data = load_member<decltype(drawing.object_data)>(reader);
    drawing.strokes = load_member<std::vector<Stroke>>(reader);
    // Strokes have at least one sample, which the algorithms rely on.
    std::erase_if(drawing.strokes, [](const Stroke& stroke) { return stroke.samples.empty(); });
    if (layout == placed_drawing_layout) drawing.plane = load_member<DrawingPlane>(reader);
    return drawing;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Drawing = value_row<DrawingValue>();

}  // namespace croquis
