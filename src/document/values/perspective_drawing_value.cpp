// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <numbers>
#include <set>

#include "croquis/base/limits.h"
#include "croquis/geometry/perspective_drawing.h"
#include "document/content_size.h"
#include "document/values/value_row.h"
#include "document/values/vector_bytes.h"

namespace croquis {
namespace {

constexpr std::uint32_t perspective_layout = 1;

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t picture_piece_bytes = 8 * sizeof(double);
constexpr std::size_t least_perspective_stroke_bytes = 5 * sizeof(std::uint64_t) + sizeof(double) + 8;
constexpr std::size_t least_length_bytes = sizeof(std::uint64_t) + sizeof(double);

template <typename Enum>
Enum read_kind(ByteReader& reader, Enum last) {
  const auto number = reader.number<std::uint8_t>();
  if (number > static_cast<std::uint8_t>(last)) throw BadBytes("a stroke's role, group or lock is not known");
  return static_cast<Enum>(number);
}

double read_positive(ByteReader& reader) {
  const auto number = reader.number<double>();
  if (!(number > 0 && is_usable_number(number))) throw BadBytes("a number is not positive");
  return number;
}

/// Coordinates that aren't finite are drawn, too.
bool is_same_place(const Vec2& a, const Vec2& b) {
  return std::bit_cast<std::uint64_t>(a.x()) == std::bit_cast<std::uint64_t>(b.x()) &&
         std::bit_cast<std::uint64_t>(a.y()) == std::bit_cast<std::uint64_t>(b.y());
}

void write_perspective_stroke(const PerspectiveStroke& stroke, ByteWriter& writer) {
  writer.text(stroke.id);
  writer.number(static_cast<std::uint8_t>(stroke.role));
  writer.number(static_cast<std::uint8_t>(stroke.group));
  writer.text(stroke.colour);
  writer.flag(stroke.straight);
  writer.count(stroke.pieces.size());
  for (const PictureCubic& piece : stroke.pieces) {
    for (const Vec2& point : piece) write_numbers(point, writer);
  }
  writer.text(stroke.from);
  writer.text(stroke.to);
  writer.flag(stroke.link);
  writer.number(static_cast<std::uint8_t>(stroke.start_lock));
  writer.number(static_cast<std::uint8_t>(stroke.end_lock));
  writer.flag(stroke.hidden);
  writer.number(stroke.weight);
  writer.flag(stroke.line.has_value());
  if (stroke.line) writer.number(*stroke.line);
}

void require_pieces(const PerspectiveStroke& stroke) {
  if (stroke.pieces.empty() || (stroke.straight && stroke.pieces.size() > 1)) throw BadBytes("a stroke has no pieces");
  for (std::size_t i = 1; i < stroke.pieces.size(); ++i) {
    if (!is_same_place(stroke.pieces[i][0], stroke.pieces[i - 1][3]))
      throw BadBytes("a stroke's piece begins elsewhere");
  }
}

PerspectiveStroke read_perspective_stroke(ByteReader& reader) {
  PerspectiveStroke stroke;
  stroke.id = reader.text();
  stroke.role = read_kind(reader, StrokeRole::Edge);
  stroke.group = read_kind(reader, StrokeGroup::Unknown);
  stroke.colour = reader.text();
  stroke.straight = reader.flag();
  stroke.pieces.resize(reader.count(picture_piece_bytes));
  for (PictureCubic& piece : stroke.pieces) {
    for (Vec2& point : piece) point = read_numbers<Vec2>(reader);
  }
  require_pieces(stroke);
  stroke.from = reader.text();
  stroke.to = reader.text();
  stroke.link = reader.flag();
  stroke.start_lock = read_kind(reader, EndLock::Corner);
  stroke.end_lock = read_kind(reader, EndLock::Corner);
  stroke.hidden = reader.flag();
  stroke.weight = read_positive(reader);
  if (reader.flag()) stroke.line = reader.number<std::int64_t>();
  return stroke;
}

void write_knowledge(const PerspectiveDrawing& drawing, ByteWriter& writer) {
  writer.flag(drawing.known_point.has_value());
  if (drawing.known_point) {
    write_numbers(drawing.known_point->at, writer);
    write_numbers(drawing.known_point->point, writer);
  }
  writer.count(drawing.known_lengths.size());
  for (const KnownLength& known : drawing.known_lengths) {
    writer.text(known.stroke);
    writer.number(known.length);
  }
  writer.flag(drawing.field_of_view.has_value());
  if (drawing.field_of_view) writer.number(*drawing.field_of_view);
  writer.flag(drawing.principal_point.has_value());
  if (drawing.principal_point) write_numbers(*drawing.principal_point, writer);
  writer.text(drawing.unit);
  writer.flag(drawing.shells.has_value());
  if (drawing.shells) writer.number(static_cast<std::int32_t>(*drawing.shells));
}

void read_knowledge(ByteReader& reader, PerspectiveDrawing& drawing) {
  if (reader.flag()) {
    const Vec2 at = read_usable<Vec2>(reader);
    drawing.known_point = KnownPoint{at, read_usable<Vec3>(reader)};
  }
  for (std::size_t left = reader.count(least_length_bytes); left > 0; --left) {
    std::string stroke = reader.text();
    drawing.known_lengths.push_back({std::move(stroke), read_positive(reader)});
  }
  if (reader.flag()) {
    drawing.field_of_view = read_positive(reader);
    if (*drawing.field_of_view >= std::numbers::pi) throw BadBytes("its field of view is too wide");
  }
  if (reader.flag()) drawing.principal_point = read_usable<Vec2>(reader);
  drawing.unit = reader.text();
  if (reader.flag()) {
    drawing.shells = reader.number<std::int32_t>();
    if (*drawing.shells < 1) throw BadBytes("its number of shells is not positive");
  }
}

void hash_perspective_stroke(const PerspectiveStroke& stroke, ContentHasher& hasher) {
  hasher.add(stroke.id);
  hasher.add(static_cast<int>(stroke.role));
  hasher.add(static_cast<int>(stroke.group));
  hasher.add(stroke.colour);
  hasher.add(stroke.straight);
  hasher.add(stroke.pieces.size());
  for (const PictureCubic& piece : stroke.pieces) {
    for (const Vec2& point : piece) hash_numbers(point, hasher);
  }
  hasher.add(stroke.from);
  hasher.add(stroke.to);
  hasher.add(stroke.link);
  hasher.add(static_cast<int>(stroke.start_lock));
  hasher.add(static_cast<int>(stroke.end_lock));
  hasher.add(stroke.hidden);
  hasher.add(stroke.weight);
  hasher.add(stroke.line.has_value());
  hasher.add(stroke.line.value_or(0));
}

void hash_knowledge(const PerspectiveDrawing& drawing, ContentHasher& hasher) {
  hasher.add(drawing.known_point.has_value());
  if (drawing.known_point) {
    hash_numbers(drawing.known_point->at, hasher);
    hash_numbers(drawing.known_point->point, hasher);
  }
  hasher.add(drawing.known_lengths.size());
  for (const KnownLength& known : drawing.known_lengths) {
    hasher.add(known.stroke);
    hasher.add(known.length);
  }
  hasher.add(drawing.field_of_view.has_value());
  hasher.add(drawing.field_of_view.value_or(0));
  hasher.add(drawing.principal_point.has_value());
  hash_numbers(drawing.principal_point.value_or(Vec2::Zero()), hasher);
  hasher.add(drawing.unit);
  hasher.add(drawing.shells.has_value());
  hasher.add(drawing.shells.value_or(0));
}

/// Coloured strokes in a picture, which has no place in space.
struct PerspectiveDrawingValue {
  using Content = PerspectiveDrawing;
  static constexpr const char* name = "perspective drawing";
  static constexpr std::uint64_t tag = 4;

  static void add_content(const PerspectiveDrawing& drawing, ContentHasher& hasher) {
    hash_numbers(drawing.origin, hasher);
    hash_numbers(drawing.image_size, hasher);
    hasher.add(drawing.strokes.size());
    for (const PerspectiveStroke& stroke : drawing.strokes) hash_perspective_stroke(stroke, hasher);
    hash_knowledge(drawing, hasher);
    hasher.add(drawing.file);
  }

  static std::size_t byte_size(const PerspectiveDrawing& drawing) {
    std::size_t bytes = sizeof(PerspectiveDrawing) + drawing.file.capacity() + drawing.unit.capacity() +
                        size_of(drawing.strokes) + size_of(drawing.known_lengths);
    for (const PerspectiveStroke& stroke : drawing.strokes) {
      bytes += stroke.id.capacity() + stroke.colour.capacity() + stroke.from.capacity() + stroke.to.capacity() +
               size_of(stroke.pieces);
    }
    for (const KnownLength& known : drawing.known_lengths) bytes += known.stroke.capacity();
    return bytes;
  }

  static void store(const PerspectiveDrawing& drawing, ByteWriter& writer) {
    writer.number(perspective_layout);
    writer.text(drawing.file);
    write_numbers(drawing.origin, writer);
    write_numbers(drawing.image_size, writer);
    write_knowledge(drawing, writer);
    writer.count(drawing.strokes.size());
    for (const PerspectiveStroke& stroke : drawing.strokes) write_perspective_stroke(stroke, writer);
  }

  static PerspectiveDrawing load(ByteReader& reader) {
    read_layout(reader, perspective_layout);
    PerspectiveDrawing drawing;
    drawing.file = reader.text();
    drawing.origin = read_usable<Vec2>(reader);
    drawing.image_size = read_usable<Vec2>(reader);
    if (drawing.image_size.minCoeff() < 0) throw BadBytes("its sheet's size is negative");
    read_knowledge(reader, drawing);
    std::set<std::string> ids;
    for (std::size_t left = reader.count(least_perspective_stroke_bytes); left > 0; --left) {
      drawing.strokes.push_back(read_perspective_stroke(reader));
      if (!ids.insert(drawing.strokes.back().id).second) throw BadBytes("two strokes have one name");
    }
    return drawing;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::PerspectiveDrawing = value_row<PerspectiveDrawingValue>();

}  // namespace croquis
