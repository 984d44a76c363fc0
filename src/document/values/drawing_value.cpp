// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "document/content_size.h"
#include "document/values/value_row.h"

namespace croquis {
namespace {

constexpr std::uint32_t first_drawing_layout = 1;
constexpr std::uint32_t placed_drawing_layout = 2;  // of drawings on another plane than the default one

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t sample_bytes = 6 * sizeof(double);
constexpr std::size_t least_stroke_bytes = 4 * sizeof(std::uint64_t) + 2;
constexpr std::size_t least_object_bytes = 2 * sizeof(std::uint64_t);

void write_sample(const StrokeSample& sample, ByteWriter& writer) {
  for (const double value :
       {sample.position.x(), sample.position.y(), sample.pressure, sample.tilt.x(), sample.tilt.y(), sample.time}) {
    writer.number(value);
  }
}

StrokeSample read_sample(ByteReader& reader) {
  StrokeSample sample;
  sample.position.x() = reader.number<double>();
  sample.position.y() = reader.number<double>();
  sample.pressure = reader.number<double>();
  sample.tilt.x() = reader.number<double>();
  sample.tilt.y() = reader.number<double>();
  sample.time = reader.number<double>();
  return sample;
}

void write_stroke(const Stroke& stroke, ByteWriter& writer) {
  writer.text(stroke.id);
  writer.flag(stroke.closed);
  writer.text(stroke.object);
  writer.texts(stroke.data);
  writer.flag(stroke.line.has_value());
  if (stroke.line) writer.number(*stroke.line);
  writer.count(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) write_sample(sample, writer);
}

Stroke read_stroke(ByteReader& reader) {
  Stroke stroke;
  stroke.id = reader.text();
  stroke.closed = reader.flag();
  stroke.object = reader.text();
  stroke.data = reader.texts();
  if (reader.flag()) stroke.line = reader.number<std::int64_t>();
  const std::size_t count = reader.count(sample_bytes);
  stroke.samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i) stroke.samples.push_back(read_sample(reader));
  return stroke;
}

void write_strokes(const Drawing& drawing, ByteWriter& writer) {
  writer.text(drawing.file);
  writer.count(drawing.object_data.size());
  for (const auto& [object, data] : drawing.object_data) {
    writer.text(object);
    writer.texts(data);
  }
  writer.count(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) write_stroke(stroke, writer);
}

Drawing read_strokes(ByteReader& reader) {
  Drawing drawing;
  drawing.file = reader.text();
  for (std::size_t left = reader.count(least_object_bytes); left > 0; --left) {
    std::string object = reader.text();
    drawing.object_data.insert_or_assign(std::move(object), reader.texts());
  }
  for (std::size_t left = reader.count(least_stroke_bytes); left > 0; --left) {
    Stroke stroke = read_stroke(reader);
    // Strokes have at least one sample, which the algorithms rely on.
    if (!stroke.samples.empty()) drawing.strokes.push_back(std::move(stroke));
  }
  return drawing;
}

void write_plane(const DrawingPlane& plane, ByteWriter& writer) {
  for (const Vec3& vector : {plane.origin, plane.u, plane.v}) {
    for (const double coordinate : vector) writer.number(coordinate);
  }
}

DrawingPlane read_plane(ByteReader& reader) {
  DrawingPlane plane;
  for (Vec3* vector : {&plane.origin, &plane.u, &plane.v}) {
    for (double& coordinate : *vector) coordinate = reader.number<double>();
  }
  if (!plane.is_orthonormal()) throw BadBytes("its plane has no right angle");
  return plane;
}

// ---- Hash

void hash_texts(const std::map<std::string, std::string>& texts, ContentHasher& hasher) {
  hasher.add(texts.size());
  for (const auto& [key, text] : texts) {
    hasher.add(key);
    hasher.add(text);
  }
}

void hash_stroke(const Stroke& stroke, ContentHasher& hasher) {
  hasher.add(stroke.id);
  hasher.add(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) {
    const std::array<double, 6> figures = {sample.position.x(), sample.position.y(), sample.pressure,
                                           sample.tilt.x(),     sample.tilt.y(),     sample.time};
    hasher.add(std::span<const double>(figures));
  }
  hasher.add(stroke.closed);
  hasher.add(stroke.object);
  hash_texts(stroke.data, hasher);
  hasher.add(stroke.line.has_value());
  hasher.add(stroke.line.value_or(0));
}

void hash_plane(const DrawingPlane& plane, ContentHasher& hasher) {
  for (const Vec3& vector : {plane.origin, plane.u, plane.v}) {
    for (const double coordinate : vector) hasher.add(coordinate);
  }
}

/// Strokes on their plane.
struct DrawingValue {
  using Content = Drawing;
  static constexpr const char* name = "drawing";
  static constexpr std::uint64_t tag = 1;

  static void add_content(const Drawing& drawing, ContentHasher& hasher) {
    hasher.add(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes) hash_stroke(stroke, hasher);
    hasher.add(drawing.object_data.size());
    for (const auto& [object, data] : drawing.object_data) {
      hasher.add(object);
      hash_texts(data, hasher);
    }
    hasher.add(drawing.file);
    if (!drawing.plane.is_default()) hash_plane(drawing.plane, hasher);  // last, as in what is stored
  }

  static std::size_t byte_size(const Drawing& drawing) {
    std::size_t bytes = sizeof(Drawing) + drawing.file.capacity() + size_of(drawing.strokes);
    for (const Stroke& stroke : drawing.strokes) {
      bytes += stroke.id.capacity() + stroke.object.capacity() + size_of(stroke.samples) + size_of(stroke.data);
    }
    for (const auto& [object, data] : drawing.object_data) bytes += tree_node + size_of(object) + size_of(data);
    return bytes;
  }

  static void store(const Drawing& drawing, ByteWriter& writer) {
    writer.number(drawing.plane.is_default() ? first_drawing_layout : placed_drawing_layout);
    write_strokes(drawing, writer);
    if (!drawing.plane.is_default()) write_plane(drawing.plane, writer);
  }

  static Drawing load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, placed_drawing_layout);
    Drawing drawing = read_strokes(reader);
    if (layout == placed_drawing_layout) drawing.plane = read_plane(reader);
    return drawing;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Drawing = value_row<DrawingValue>();

}  // namespace croquis
