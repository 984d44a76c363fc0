// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/io/picture_trace.h"

/// The steps from a picture to lines: its ink, the ink's middle, branches of that, lines, curves.
namespace croquis::tracing {

/// One value for each pixel, top row first.
template <typename T>
struct PixelGrid {
  int width = 0;
  int height = 0;
  std::vector<T> values;  ///< width × height

  PixelGrid() = default;
  PixelGrid(int columns, int rows, T value = {})
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  T& at(int x, int y) { return values[index(x, y)]; }
  const T& at(int x, int y) const { return values[index(x, y)]; }
  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

  /// The value there, or the one that an empty pixel has beyond the border.
  T at_or_empty(int x, int y) const { return has(x, y) ? at(x, y) : T{}; }
};

/// Which pixels belong to something: 0 or 1.
using Mask = PixelGrid<std::uint8_t>;

struct Pixel {
  int x = 0;
  int y = 0;

  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The eight neighbours of a pixel in order around it, beginning to the right; even ones share a side with it.
inline constexpr std::array<Pixel, 8> around = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

inline Pixel neighbour(const Pixel& pixel, int direction) {
  const Pixel& step = around[static_cast<std::size_t>(direction & 7)];
  return {pixel.x + step.x, pixel.y + step.y};
}

/// What was drawn on the ground of a picture.
struct Ink {
  PixelGrid<float> darkness;  ///< 0..1 of the ground's own brightness; about 0 where nothing is drawn
  Mask mask;                  ///< where it is dark enough to belong to a line or a dot
};

/// Finds ink whose brightness differs from that of the ground around it, on the picture scaled down to
/// options.longest_side. What is wider than options.widest_line in every direction is ground.
Ink find_ink(const Picture& picture, const TraceOptions& options, Progress& progress);

/// What distances between pixels are counted in: a step to the side is 3, a diagonal one 4.
inline constexpr int pixel_step = 3;

/// The distance of each pixel of the mask from the nearest one outside; what lies beyond the border is outside.
/// Source: Borgefors 1986, "Distance transformations in digital images".
PixelGrid<int> distances_to_outside(const Mask& mask);

/// The middle lines of the mask, one pixel wide and as connected as it is: pixels go from the border inwards unless
/// something would fall apart or get a hole, or a line would get shorter.
/// Source: Pudney 1998, "Distance-ordered homotopic thinning".
/// @param distances of the mask
Mask thinned(const Mask& mask, const PixelGrid<int>& distances);

/// A place where middle lines meet.
struct SkeletonNode {
  Vec2 place = Vec2::Zero();  ///< pixels
  double half_width = 0;      ///< pixels from there to the border of the ink
};

/// A middle line between two nodes or free ends.
struct Branch {
  std::vector<Vec2> points;                        ///< pixels, the nodes not among them; at least one
  std::array<Index, 2> nodes{no_index, no_index};  ///< at its beginning and at its end
  bool closed = false;                             ///< it ends where it begins, without a node
};

struct Skeleton {
  std::vector<SkeletonNode> nodes;
  std::vector<Branch> branches;
};

/// Which branch, and which of its two ends: even numbers are beginnings.
inline Index end_at(std::size_t branch, std::size_t side) { return static_cast<Index>(2 * branch + side); }

/// The ends of branches at each node.
std::vector<std::vector<Index>> ends_at_nodes(const Skeleton& skeleton);

/// The branches of lines that are one pixel wide.
/// @param distances of the ink, as distances_to_outside gives them
Skeleton skeleton_of(const Mask& thin, const PixelGrid<int>& distances);

/// Removes what thinning leaves beside the middle of lines: spurs that hardly reach out of the ink, and, by making one
/// node of two, pieces between nodes that are no longer than lines are wide, or that two crossing lines share.
Skeleton simplified(Skeleton skeleton);

/// The middle of one drawn line.
struct TracedLine {
  std::vector<Vec2> points;  ///< pixels
  bool closed = false;
};

/// Joins branches to the lines that they were drawn as: two that go straight on at a node, and free ends that face each
/// other across a gap. What other branches there are at a node end at it.
/// @param half_width pixels, the usual one of a line
std::vector<TracedLine> joined_lines(const Skeleton& skeleton, double half_width);

/// Takes what is far wider than a line out of a mask, and gives the borders of the compact ones among it: filled
/// shapes, such as eyes. Wide bands and what reaches to the picture's border are no shapes.
/// @param distances  of the mask, as distances_to_outside gives them; kept up to date
/// @param half_width pixels, the usual one of a line
/// @return closed lines in the middle of the shapes' outermost pixels
std::vector<TracedLine> take_dots(Mask& mask, PixelGrid<int>& distances, double half_width);

}  // namespace croquis::tracing
