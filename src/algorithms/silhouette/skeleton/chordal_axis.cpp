// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/chordal_axis.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>

#include "algorithms/silhouette/skeleton/axis_graph.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
namespace {

/// The immersed region, and where the fan of triangles around each of its vertices begins.
struct WalkedRegion {
  std::span<const Vec2> points;
  const LiftedTriangulation& lifted;
  std::vector<Index> first_corner;  ///< per lifted vertex: 3 triangle + i

  WalkedRegion(std::span<const Vec2> of, const LiftedTriangulation& region)
      : points(of), lifted(region), first_corner(region.planar_vertex.size(), no_index) {
    for (Index m = 0; m < lifted.triangles.size(); ++m) {
      for (Index corner = 0; corner < 3; ++corner) {
        // A fan that doesn't close begins where no triangle lies on the right.
        const bool begins = lifted.neighbours[m][previous(corner)] == no_index;
        Index& first = first_corner[lifted.triangles[m][corner]];
        if (first == no_index || begins) first = 3 * m + corner;
      }
    }
  }

  const Vec2& point(Index vertex) const { return points[lifted.planar_vertex[vertex]]; }
};

/// A stretch of a straight walk inside one lifted triangle, or along one of its edges.
struct WalkStep {
  Index triangle = no_index;  ///< lifted
  double enter = 0;           ///< 0..1 along the walk
  double leave = 0;
};

/// A straight walk through the immersed region, always in the sheet it started in: point location in the plane couldn't
/// distinguish the layers. Every turn is decided by exact orientation tests, so lines through vertices and along edges
/// are no special case. It stands at a vertex, or is about to enter a triangle.
struct SheetWalk {
  const WalkedRegion& region;
  Vec2 target;
  Index vertex = no_index;  ///< lifted; no_index between vertices
  Vec2 start = region.point(vertex);
  Index triangle = no_index;  ///< lifted, about to be entered …
  Index entry = 0;            ///< … across the edge opposite to this corner
  double along = 0;
  bool arrived = false;
  std::vector<WalkStep> steps = {};

  int side(const Vec2& point) const { return orientation(start, target, point); }

  double fraction(const Vec2& point) const {
    const Vec2 way = target - start;
    return (point - start).dot(way) / way.squaredNorm();
  }

  /// Where the line crosses the line through two points.
  double fraction(const Vec2& a, const Vec2& b) const { return crossing_fraction(start, target, a, b); }

  /// For points on the line: not before the target.
  bool reaches_target(const Vec2& point) const {
    const Vec2 way = target - start;
    const Eigen::Index axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    return way[axis] > 0 ? point[axis] >= target[axis] : point[axis] <= target[axis];
  }

  /// @param leave where the walk leaves these triangles, unless it ends in them
  void step_through(std::initializer_list<Index> triangles, double leave) {
    const double end = arrived ? 1 : std::clamp(leave, along, 1.0);
    for (const Index one : triangles) {
      if (one != no_index) steps.push_back({one, along, end});
    }
    along = end;
  }

  /// Goes on from a triangle to the one across the edge opposite to a corner.
  void enter_beyond(Index from, Index corner) {
    triangle = region.lifted.neighbours[from][corner];
    if (triangle != no_index) entry = corner_across(region.lifted.neighbours, triangle, from);
  }

  /// Looks round a vertex, counter-clockwise, for the triangle whose angle the line enters.
  void pass_vertex() {
    const LiftedTriangulation& lifted = region.lifted;
    const Index first = region.first_corner[vertex] / 3;
    Index here = first, corner = region.first_corner[vertex] % 3;
    for (;;) {
      const std::array<Index, 3>& corners = lifted.triangles[here];
      const Vec2 &right = region.point(corners[next(corner)]), &left = region.point(corners[previous(corner)]);
      const int side_of_right = side(right), side_of_left = side(left);
      if (side_of_right > 0 || side_of_left < 0) {
        const Index following = lifted.neighbours[here][next(corner)];
        if (following == no_index || following == first) {
          throw_internal("a chord leaves the region that it belongs to");
        }
        corner = next(corner_across(lifted.neighbours, following, here));
        here = following;
      } else if (side_of_right == 0 || side_of_left == 0) {
        const Index end = side_of_right == 0 ? next(corner) : previous(corner);
        vertex = corners[end];
        arrived = reaches_target(region.point(vertex));
        step_through({here, lifted.neighbours[here][3 - corner - end]}, fraction(region.point(vertex)));
        return;
      } else {
        vertex = no_index;
        arrived = orientation(right, left, target) >= 0;
        step_through({here}, fraction(right, left));
        return enter_beyond(here, corner);
      }
    }
  }

  void cross_triangle() {
    if (triangle == no_index) throw_internal("a chord leaves the region that it belongs to");
    const std::array<Index, 3>& corners = region.lifted.triangles[triangle];
    const Vec2& apex = region.point(corners[entry]);
    // Seen along the walk: the entry edge's end on the left comes next after the apex.
    const Vec2 &left = region.point(corners[next(entry)]), &right = region.point(corners[previous(entry)]);
    arrived = orientation(right, apex, target) >= 0 && orientation(apex, left, target) >= 0;
    const int side_of_apex = side(apex);
    if (side_of_apex == 0) {
      step_through({triangle}, fraction(apex));
      vertex = corners[entry];
    } else {
      step_through({triangle}, side_of_apex > 0 ? fraction(right, apex) : fraction(apex, left));
      enter_beyond(triangle, side_of_apex > 0 ? next(entry) : previous(entry));
    }
  }
};

/// From a lifted vertex straight to a place in the plane. Along an edge the triangles on both of its sides are steps.
/// @param target reached within the region; different from the vertex's own place
/// @throws Error (E_INTERNAL) when the line leaves the region before
std::vector<WalkStep> walk(const WalkedRegion& region, Index from, const Vec2& target) {
  SheetWalk state{region, target, from};
  while (!state.arrived) {
    if (state.vertex != no_index) {
      state.pass_vertex();
    } else {
      state.cross_triangle();
    }
  }
  return std::move(state.steps);
}

/// Nodes nearer than this, in sketch units u, add nothing: the samples aren't denser.
constexpr double least_axis_spacing = 4;

/// Gives every node its chord and what lies along it.
class NodeMaker {
 public:
  NodeMaker(const LabelledFigure& figure, const LiftedTriangulation& lifted, const ImmersedTriangulation& immersed)
      : figure_(figure), lifted_(lifted), immersed_(immersed), region_(figure.points, lifted) {}

  SkeletonNode make(const AxisNode& axis) const {
    SkeletonNode node;
    node.position = axis.position;
    node.radius = axis.radius;
    const std::array<Index, 3>& corners = immersed_.triangles[axis.triangle];
    node.object = object_of(corners[0]);
    if (axis.corner != no_index) {
      follow_chord(corners[next(axis.corner)], corners[previous(axis.corner)], node);
    } else {
      follow_spokes(corners, node);
    }
    for (const auto& [from, to] : axis.absorbed) add_parts(walk_from(from, point(to)), point(from), point(to), node);
    return node;
  }

 private:
  const Vec2& point(Index vertex) const { return figure_.points[immersed_.planar_vertex[vertex]]; }

  std::vector<WalkStep> walk_from(Index from, const Vec2& to) const {
    return walk(region_, immersed_.lifted_vertex[from], to);
  }

  Index object_of(Index vertex) const {
    const auto after = std::upper_bound(immersed_.first_vertex.begin(), immersed_.first_vertex.end(), vertex);
    return figure_.contours[static_cast<std::size_t>(after - immersed_.first_vertex.begin()) - 1].object;
  }

  SheetPlace place_of(Index triangle) const { return {lifted_.planar_triangle[triangle], lifted_.layer_of(triangle)}; }

  void follow_chord(Index from, Index to, SkeletonNode& node) const {
    node.chord = {point(from), point(to)};
    const std::vector<WalkStep> steps = walk_from(from, point(to));
    const auto half = std::find_if(steps.begin(), steps.end(), [](const WalkStep& step) { return step.leave >= 0.5; });
    node.place = place_of(half->triangle);
    add_parts(steps, point(from), point(to), node);
  }

  /// From the corners of its triangle to a node at the centre.
  void follow_spokes(const std::array<Index, 3>& corners, SkeletonNode& node) const {
    double longest = 0;
    for (Index i = 0; i < 3; ++i) {
      const Vec2& here = point(corners[i]);
      const Vec2& there = point(corners[next(i)]);
      if ((there - here).squaredNorm() > longest) {
        longest = (there - here).squaredNorm();
        node.chord = {here, there};
      }
      const std::vector<WalkStep> steps = walk_from(corners[i], node.position);
      node.place = place_of(steps.back().triangle);
      add_parts(steps, here, node.position, node);
    }
  }

  bool same_panel(const SheetPlace& a, const SheetPlace& b) const {
    return a.layer == b.layer && figure_.faces[a.triangle] == figure_.faces[b.triangle];
  }

  /// Joins the steps of a walk that stay in one panel.
  void add_parts(const std::vector<WalkStep>& steps, const Vec2& from, const Vec2& to, SkeletonNode& node) const {
    for (std::size_t begin = 0, end = 0; begin < steps.size(); begin = end) {
      const SheetPlace place = place_of(steps[begin].triangle);
      while (end < steps.size() && same_panel(place, place_of(steps[end].triangle))) ++end;
      const double enter = steps[begin].enter;
      const double leave = steps[end - 1].leave;
      add_part(place, {from + (enter + leave) / 2 * (to - from), (leave - enter) * (to - from).norm()}, node);
    }
  }

  void add_part(const SheetPlace& place, const ChordPart& part, SkeletonNode& node) const {
    for (std::size_t i = 0; i < node.crossed.size(); ++i) {
      if (!same_panel(node.crossed[i], place)) continue;
      if (part.length > node.parts[i].length) node.parts[i] = part;
      return;
    }
    node.crossed.push_back(place);
    node.parts.push_back(part);
  }

  const LabelledFigure& figure_;
  const LiftedTriangulation& lifted_;
  const ImmersedTriangulation& immersed_;
  WalkedRegion region_;
};

}  // namespace

Skeleton chordal_axis(const LabelledFigure& figure, double node_spacing, Progress& progress) {
  const LiftedTriangulation lifted = lift(figure);
  const ImmersedTriangulation immersed = immerse(figure, lifted, progress);
  const AxisGraph full = axis_graph(immersed, figure.points);
  const AxisGraph graph = decimate(full, {least_axis_spacing * figure.unit, node_spacing});

  Skeleton skeleton;
  const NodeMaker maker(figure, lifted, immersed);
  std::vector<double> radii;
  for (const AxisNode& node : graph.nodes) {
    skeleton.nodes.push_back(maker.make(node));
    radii.push_back(node.radius);
  }
  skeleton.edges = graph.edges;
  skeleton.scale = median(std::move(radii));
  for (std::size_t c = 0; c < figure.contours.size(); ++c) {
    const auto radius = full.vertex_radius.begin();
    skeleton.contour_radius.emplace_back(radius + immersed.first_vertex[c], radius + immersed.first_vertex[c + 1]);
  }
  return skeleton;
}

}  // namespace croquis::silhouette
