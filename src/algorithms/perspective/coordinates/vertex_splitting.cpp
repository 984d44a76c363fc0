// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/vertex_splitting.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "algorithms/perspective/coordinates/contradiction_search.h"
#include "algorithms/perspective/coordinates/seen_vertices.h"

namespace croquis {
namespace {

/// Ends of a corner.
constexpr int least_ends = 3;

/// There are about two hundred ways to divide so many.
constexpr std::size_t most_ends = 9;

/// Chi-squared that a division has to take away.
constexpr double least_gain = 100;

/// Which ends of a vertex go to a vertex of their own: bit i stands for the i-th.
using EndSet = std::uint32_t;

class VertexSplitter {
 public:
  VertexSplitter(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                 std::span<const StrokeGroup> groups, double sigma)
      : drawing_(drawing), tied_(tied_vertices(drawing, vertices, camera, groups)), sigma_(sigma), result_(vertices) {
    for (Index v = 0; v < vertices.vertices.size(); ++v) {
      const DrawingVertex& vertex = vertices.vertices[v];
      if (vertex.name.empty() && vertex.ends.size() >= 2 * least_ends && vertex.ends.size() <= most_ends)
        candidates_.push_back(v);
    }
  }

  std::optional<DrawingVertices> run(Progress& progress) {
    bool any = false;
    for (const Index v : candidates_) {
      progress.check();
      const EndSet moved = best_division(v, without_others(v));
      if (moved == 0) continue;
      divide(v, moved);
      any = true;
    }
    return any ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  const std::vector<StrokeEnd>& ends_of(Index v) const { return result_.vertices[v].ends; }

  /// Infinite where vertices would lie behind the eye.
  static double squares(const TiedVertices& tied) {
    const SolvedVertices now = solved(tied);
    return now.solution.in_front ? now.solution.squares : std::numeric_limits<double>::infinity();
  }

  /// A vertex of its own for an end.
  static void detach(const StrokeEnd& end, Index place, TiedVertices& tied) {
    tied.ties.of_stroke[end.stroke][end.at_end ? 1 : 0] = place;
  }

  static Index copy_of(Index v, TiedVertices& tied) {
    tied.seen.places.push_back(Vec2(tied.seen.places[v]));
    tied.seen.weights.push_back(double(tied.seen.weights[v]));
    return static_cast<Index>(tied.seen.places.size() - 1);
  }

  /// Other vertices that may be two corners tie nothing, so that each is judged by itself.
  TiedVertices without_others(Index kept) const {
    TiedVertices tied = tied_;
    for (const Index v : candidates_) {
      if (v == kept) continue;
      for (std::size_t i = 1; i < ends_of(v).size(); ++i) detach(ends_of(v)[i], copy_of(v, tied), tied);
    }
    return tied;
  }

  Vec2 direction(const StrokeEnd& end) const {
    const PerspectiveStroke& stroke = drawing_.strokes[end.stroke];
    return (end.at_end ? -1 : 1) * (stroke.end() - stroke.start());
  }

  bool would_overlap(const StrokeEnd& a, const StrokeEnd& b) const {
    const StrokeGroup group = tied_.ties.groups[a.stroke];
    return is_parallel(group) && group == tied_.ties.groups[b.stroke] && direction(a).dot(direction(b)) > 0;
  }

  bool has_overlap(const std::vector<StrokeEnd>& ends, EndSet moved) const {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (((moved >> i ^ moved >> j) & 1) == 0 && would_overlap(ends[i], ends[j])) return true;
      }
    }
    return false;
  }

  /// The first end stays. 0 where no division is much better than none.
  EndSet best_division(Index v, const TiedVertices& whole) const {
    const std::vector<StrokeEnd>& ends = ends_of(v);
    const EndSet all = (EndSet{1} << ends.size()) - 1;
    double least = squares(whole) - least_gain * sigma_ * sigma_;
    EndSet best = 0;
    for (EndSet moved = 2; moved <= all; moved += 2) {
      if (std::popcount(moved) < least_ends || std::popcount(all & ~moved) < least_ends) continue;
      if (has_overlap(ends, moved)) continue;
      const double after = squares(divided(whole, v, moved));
      if (after >= least) continue;
      least = after;
      best = moved;
    }
    return best;
  }

  TiedVertices divided(TiedVertices tied, Index v, EndSet moved) const {
    const Index copy = copy_of(v, tied);
    for (std::size_t i = 0; i < ends_of(v).size(); ++i) {
      if ((moved >> i & 1) != 0) detach(ends_of(v)[i], copy, tied);
    }
    return tied;
  }

  void divide(Index v, EndSet moved) {
    const auto copy = static_cast<Index>(result_.vertices.size());
    std::array<DrawingVertex, 2> parts;
    for (std::size_t i = 0; i < ends_of(v).size(); ++i) {
      const StrokeEnd end = ends_of(v)[i];
      const bool is_moved = (moved >> i & 1) != 0;
      const PerspectiveStroke& stroke = drawing_.strokes[end.stroke];
      parts[is_moved ? 1 : 0].ends.push_back(end);
      parts[is_moved ? 1 : 0].position += end.at_end ? stroke.end() : stroke.start();
      if (is_moved) result_.of_stroke[end.stroke][end.at_end ? 1 : 0] = copy;
    }
    for (DrawingVertex& part : parts) part.position /= static_cast<double>(part.ends.size());
    result_.vertices[v] = parts[0];
    result_.vertices.push_back(parts[1]);
  }

  const PerspectiveDrawing& drawing_;
  TiedVertices tied_;
  double sigma_;  // u
  DrawingVertices result_;
  std::vector<Index> candidates_;
};

}  // namespace

std::optional<DrawingVertices> with_split_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                                   const CameraEstimate& camera, std::span<const StrokeGroup> groups,
                                                   const CoordinateOptions& options, Progress& progress) {
  const double sigma = std::max(camera.sigma / SheetFrame(drawing).unit, options.contradiction_noise);
  return VertexSplitter(drawing, vertices, camera, groups, sigma).run(progress);
}

}  // namespace croquis
