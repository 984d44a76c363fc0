// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <numbers>
#include <set>

#include "croquis/geometry/perspective_drawing.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const KnownPoint& known) { return std::tie(known.at, known.point); }
static_assert(lists_every_member<KnownPoint>);

inline auto members(const KnownLength& known) { return std::tie(known.stroke, known.length); }
static_assert(lists_every_member<KnownLength>);

inline auto members(const PerspectiveDrawing& drawing) {
  const auto& [origin, size, strokes, point, lengths, field_of_view, principal_point, unit, shells, file] = drawing;
  return std::tie(file, origin, size, point, lengths, field_of_view, principal_point, unit, shells, strokes);
}

constexpr StrokeRole last_of(StrokeRole) { return StrokeRole::Edge; }
constexpr StrokeGroup last_of(StrokeGroup) { return StrokeGroup::Unknown; }
constexpr EndLock last_of(EndLock) { return EndLock::Corner; }

/// Coordinates that aren't finite are drawn, too.
template <>
inline constexpr bool holds_any_number<PictureCubic> = true;

inline bool is_same_place(const Vec2& a, const Vec2& b) {
  return std::bit_cast<std::uint64_t>(a.x()) == std::bit_cast<std::uint64_t>(b.x()) &&
         std::bit_cast<std::uint64_t>(a.y()) == std::bit_cast<std::uint64_t>(b.y());
}

inline bool is_positive(double number) { return number > 0 && is_usable_number(number); }

inline void require_valid(const PerspectiveStroke& stroke) {
  if (stroke.pieces.empty() || (stroke.straight && stroke.pieces.size() > 1)) throw BadBytes("a stroke has no pieces");
  for (std::size_t i = 1; i < stroke.pieces.size(); ++i) {
    if (!is_same_place(stroke.pieces[i][0], stroke.pieces[i - 1][3]))
      throw BadBytes("a stroke's piece begins elsewhere");
  }
  if (!is_positive(stroke.weight)) throw BadBytes("a stroke's weight is not positive");
}

inline void require_valid(const KnownLength& known) {
  if (!is_positive(known.length)) throw BadBytes("a stroke's length is not positive");
}

inline void require_valid(const PerspectiveDrawing& drawing) {
  if (drawing.image_size.minCoeff() < 0) throw BadBytes("its sheet's size is negative");
  if (drawing.field_of_view && !is_positive(*drawing.field_of_view))
    throw BadBytes("its field of view is not positive");
  if (drawing.field_of_view && *drawing.field_of_view >= std::numbers::pi)
    throw BadBytes("its field of view is too wide");
  if (drawing.shells && *drawing.shells < 1) throw BadBytes("its number of shells is not positive");
  std::set<std::string> ids;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!ids.insert(stroke.id).second) throw BadBytes("two strokes have one name");
  }
}

namespace {

/// Coloured strokes in a picture, which has no place in space.
struct PerspectiveDrawingValue : ListedValue<PerspectiveDrawing> {
  static constexpr const char* name = "perspective drawing";
  static constexpr std::uint64_t tag = 4;

  /// In another order than the bytes.
  static void add_content(const PerspectiveDrawing& drawing, ContentHasher& hasher) {
    hash_member<Absent::Zero>(
        std::tie(drawing.origin, drawing.image_size, drawing.strokes, drawing.known_point, drawing.known_lengths,
                 drawing.field_of_view, drawing.principal_point, drawing.unit, drawing.shells, drawing.file),
        hasher);
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::PerspectiveDrawing = value_row<PerspectiveDrawingValue>();

}  // namespace croquis
