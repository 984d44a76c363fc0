// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/perspective_drawing.h"

/// Which ends of strokes meet, and which strokes can be used at all.
///
/// After Cho and Kim, "Reconstructing 3D solid shape from a single perspective drawing", section 3.1, whose strokes
/// share vertices from the beginning. Here ends are as somebody drew them.
namespace croquis {

struct DrawingVertexOptions {
  double snap = 0.0032;  ///< × the sheet's diagonal, 0.0005..0.02: ends closer than this become one vertex
};

struct StrokeEnd {
  Index stroke = no_index;
  bool at_end = false;  ///< the stroke's last point instead of its first
  friend bool operator==(const StrokeEnd&, const StrokeEnd&) = default;
};

struct DrawingVertex {
  Vec2 position = Vec2::Zero();  ///< px, mean of its ends
  std::string name;              ///< the one that its strokes give (PerspectiveStroke::from, to), empty for none
  std::vector<StrokeEnd> ends;   ///< at least one; edges and links
};

/// What becomes of a stroke.
enum class StrokeUse : std::uint8_t {
  Used,
  NotFinite,     ///< NOT_FINITE: a coordinate that is no number
  ZeroLength,    ///< ZERO_LENGTH: a point, or shorter than anybody can see
  UnknownGroup,  ///< UNKNOWN_GROUP: nothing is known of its direction or plane
  Duplicate      ///< DUPLICATE_STROKE: another edge joins the same vertices along the same curve
};

struct DrawingVertices {
  std::vector<DrawingVertex> vertices;          ///< in an order that follows from their places alone
  std::vector<std::array<Index, 2>> of_stroke;  ///< for each stroke its vertices at start and end; no_index for those
                                                ///< that aren't used and for construction strokes without link
  std::vector<StrokeUse> uses;                  ///< one for each stroke
  Findings warnings;                            ///< one for each stroke that isn't used, ordered by their ids; and
                                                ///< SHORT_STROKE: ends so near each other that neighbours may be wrong

  bool is_used(Index stroke) const { return uses[stroke] == StrokeUse::Used; }
};

/// Finds the vertices of edges and links.
///
/// Ends that name a vertex are at that one. Other ends of different strokes become one vertex by average linkage: the
/// two nearest groups of ends are joined as long as the mean distance between their ends stays below the limit. The two
/// ends of one stroke are never joined, nor are vertices of different names. Crossings and touches aren't vertices.
///
/// The same for any order and direction of the strokes, and for other ids but that of two equal strokes the one with
/// the lower id is kept. Nothing is thrown: what can't be used is left out with a warning. O(n² log n) for n ends on
/// one spot, else about linear.
DrawingVertices find_drawing_vertices(const PerspectiveDrawing& drawing, const DrawingVertexOptions& options = {});

}  // namespace croquis
