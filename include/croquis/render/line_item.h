// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/render/bounds.h"
#include "croquis/render/color.h"

namespace croquis::render {

/// Lengths along a line in pixels, drawn and left out in turn, from its start on; continuous around corners. A dash is
/// rounded within its length; one shorter than the line is wide is a dot of that width. Both `off` zero: no gaps.
struct DashPattern {
  float on = 0;
  float off = 0;
  float second_on = 0;  ///< a second pair for dash-dot patterns; 0: the first one alone
  float second_off = 0;

  bool solid() const { return !(off > 0) && !(second_off > 0); }
  float length() const { return on + off + second_on + second_off; }

  bool operator==(const DashPattern&) const = default;
};

/// What covers a line.
enum class LineDepth {
  OnTop,     ///< nothing: drawn over all surfaces
  Tested,    ///< surfaces nearer to the eye; lines that lie in a surface are seen whole
  OnSurface  ///< the same, decided where the line's middle runs: edges of a surface keep all of their width at any
             ///< slope
};

/// How the lines of an item look. Lengths are in pixels of a screen with `RenderOptions::pixel_ratio` 1.
struct LineStyle {
  double width = 2;                 ///< in (0, 128]; thinner than a pixel fades instead
  Color color = {40, 36, 42, 255};  ///< of points without one; alpha is the strength
  DashPattern dash;
  LineDepth depth = LineDepth::OnTop;
};

/// A corner of a line.
struct LinePoint {
  glm::dvec3 position = glm::dvec3(0);  ///< model units
  float width_factor = 1;               ///< times the style's width (pen pressure), >= 0; blends along the line
  std::optional<Color> color;           ///< instead of the style's; blends along the line
};

/// A polyline: one point makes a dot.
struct LinePath {
  std::vector<LinePoint> points;
  bool closed = false;
};

/// A corner as the graphics card takes it.
struct LineCorner {
  glm::vec3 position;  ///< in the item's own frame
  float width;         ///< pixels; -1 - width at the last corner of a line, where no segment starts
  Color color;
};

/// Consecutive lines that are drawn as one shape.
struct LineRun {
  std::uint32_t first = 0;  ///< index into corners
  std::uint32_t count = 0;  ///< corners
  bool pairs = false;       ///< every two corners are a line of their own
};

/// Polylines ready to be drawn: never changed once made, shared between scenes, undo steps and views.
///
/// Joins and ends are round. A line never covers itself twice, however tightly it turns: a half transparent one is
/// even. Lines of one colour that follow each other are one shape in this sense; otherwise later lines lie over earlier
/// ones.
struct LineItem {
  glm::dvec3 origin = glm::dvec3(0);  ///< model coordinates = origin + scale * own coordinates
  double scale = 1;
  Bounds bounds;  ///< model coordinates
  LineStyle style;
  std::vector<LineCorner> corners;
  std::vector<LineRun> runs;  ///< each costs two draw calls
};

using LineItemPtr = std::shared_ptr<const LineItem>;

/// Makes lines ready. Cheap enough for every event of a pen: 3,000 points cost far less than a millisecond.
/// @throws Error (E_NOT_FINITE, malformed) naming each line with a coordinate or width that is NaN or infinite
/// O(points).
LineItemPtr make_line_item(std::span<const LinePath> lines, const LineStyle& style = {});

/// The same of a single line.
LineItemPtr make_line_item(const LinePath& line, const LineStyle& style = {});

/// A line through places, all of the style's width and colour.
LinePath line_through(std::span<const glm::dvec3> places, bool closed = false);

}  // namespace croquis::render
