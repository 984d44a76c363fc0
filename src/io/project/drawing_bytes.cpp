// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/value_bytes.h"

namespace croquis {
namespace {

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

}  // namespace

void write_drawing_bytes(const Drawing& drawing, ByteWriter& writer) {
  writer.text(drawing.file);
  writer.count(drawing.object_data.size());
  for (const auto& [object, data] : drawing.object_data) {
    writer.text(object);
    writer.texts(data);
  }
  writer.count(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) write_stroke(stroke, writer);
}

Drawing read_drawing_bytes(ByteReader& reader) {
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

}  // namespace croquis
