// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// What a stroke's colour says: 0..2 straight and parallel to x, y, z; 3..5 in a plane whose normal is x, y, z.
enum class StrokeGroup : std::uint8_t { ParallelX, ParallelY, ParallelZ, NormalX, NormalY, NormalZ, Unknown };

/// The axis 0..2 that a group is about; the group is known.
inline int axis_of(StrokeGroup group) { return static_cast<int>(group) % 3; }

inline bool is_parallel(StrokeGroup group) { return group <= StrokeGroup::ParallelZ; }

enum class StrokeRole : std::uint8_t {
  Construction,  ///< helps to find the vanishing points, is no edge of the solid
  Edge
};

/// What somebody fixed at an end of a stroke.
enum class EndLock : std::uint8_t { None, Smooth, Corner };

/// A cubic Bézier in the picture, px.
using PictureCubic = std::array<Vec2, 4>;

/// A stroke of a perspective drawing as it was drawn; nothing downstream changes it.
struct PerspectiveStroke {
  std::string id;  ///< unique in the drawing, kept for ever, used in every finding
  StrokeRole role = StrokeRole::Edge;
  StrokeGroup group = StrokeGroup::Unknown;
  std::string colour;                ///< as in the file ("#F28C00"), empty for the group's own
  std::vector<PictureCubic> pieces;  ///< at least one, each begins where the one before ended; px, y down
  bool straight = false;             ///< one piece: a line from its first point to its last
  std::string from;                  ///< name of the vertex at the start, empty for none given
  std::string to;                    ///< name of the vertex at the end, empty for none given
  bool link = false;                 ///< a construction stroke whose ends are tied to the solid
  EndLock start_lock = EndLock::None;
  EndLock end_lock = EndLock::None;
  bool hidden = false;               ///< drawn through the solid
  double weight = 1;                 ///< > 0, in the fit of vertices
  std::optional<std::int64_t> line;  ///< 1-based line of the file it came from

  const Vec2& start() const { return pieces.front()[0]; }
  const Vec2& end() const { return pieces.back()[3]; }
};

/// All members, in the order of a project's bytes, which never changes.
inline auto members(const PerspectiveStroke& stroke) {
  const auto& [id, role, group, colour, pieces, straight, from, to, link, start_lock, end_lock, hidden, weight, line] =
      stroke;
  return std::tie(id, role, group, colour, straight, pieces, from, to, link, start_lock, end_lock, hidden, weight,
                  line);
}

inline constexpr std::array<const char*, 2> stroke_role_words = {"construction", "edge"};
inline constexpr std::array<const char*, 3> end_lock_words = {"none", "smooth", "corner"};

/// One of the members that strokes have beside their name, their shape, their role, their group and their colour.
/// Files, recorded steps and settings of strokes go through the list of them.
struct StrokeField {
  const char* name;      ///< in JSON; attributes of SVG and recorded steps have '-' instead of '_'
  const char* expected;  ///< what values of JSON have to be
  std::variant<std::string PerspectiveStroke::*, bool PerspectiveStroke::*, EndLock PerspectiveStroke::*,
               double PerspectiveStroke::*>
      member;
  const char* verb = nullptr;      ///< of a step that sets it ("Hide"); null for what people don't set
  const char* verb_off = nullptr;  ///< of a step that sets it to false
};

/// All of them, in the order of files.
inline constexpr std::array stroke_fields = {
    StrokeField{"from", "a text", &PerspectiveStroke::from},
    StrokeField{"to", "a text", &PerspectiveStroke::to},
    StrokeField{"link", "true or false", &PerspectiveStroke::link, "Link pieces by", "Unlink"},
    StrokeField{"start_lock", "\"smooth\" or \"corner\"", &PerspectiveStroke::start_lock, "Lock the ends of"},
    StrokeField{"end_lock", "\"smooth\" or \"corner\"", &PerspectiveStroke::end_lock, "Lock the ends of"},
    StrokeField{"hidden", "true or false", &PerspectiveStroke::hidden, "Hide", "Show"},
    StrokeField{"weight", "a number above 0", &PerspectiveStroke::weight, "Change"}};

/// A place of the picture whose point in space is known.
struct KnownPoint {
  Vec2 at = Vec2::Zero();     ///< px
  Vec3 point = Vec3::Zero();  ///< model units
  friend bool operator==(const KnownPoint& a, const KnownPoint& b) { return a.at == b.at && a.point == b.point; }
};

/// A stroke whose length in space is known.
struct KnownLength {
  std::string stroke;
  double length = 1;  ///< model units, > 0
  friend bool operator==(const KnownLength&, const KnownLength&) = default;
};

/// One drawing in perspective: coloured strokes, and what is known about the camera and the scale. The order of strokes
/// has no meaning.
struct PerspectiveDrawing {
  Vec2 origin = Vec2::Zero();      ///< px, upper left corner of the sheet
  Vec2 image_size = Vec2::Zero();  ///< px, width and height of the sheet, > 0
  std::vector<PerspectiveStroke> strokes;
  std::optional<KnownPoint> known_point;
  std::vector<KnownLength> known_lengths;
  std::optional<double> field_of_view;  ///< radians, across the width
  std::optional<Vec2> principal_point;  ///< px
  std::string unit;                     ///< name of the model unit, empty for none
  std::optional<int> shells;            ///< how many closed shells are expected
  std::string file;                     ///< where it came from, for findings

  Vec2 centre() const { return origin + image_size / 2; }
  double diagonal() const { return image_size.norm(); }
};

}  // namespace croquis
