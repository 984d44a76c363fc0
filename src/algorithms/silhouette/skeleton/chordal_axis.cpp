// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/chordal_axis.h"

#include <algorithm>

#include "algorithms/silhouette/skeleton/axis_graph.h"
#include "algorithms/silhouette/skeleton/sheet_walk.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"

namespace croquis::silhouette {
namespace {

/// Nodes nearer than this, in sketch units u, add nothing: the samples aren't denser.
constexpr double least_axis_spacing = 4;

/// Gives every node its chord and what lies along it.
class NodeMaker {
 public:
  NodeMaker(const LabelledFigure& figure, const LiftedTriangulation& lifted, const ImmersedTriangulation& immersed)
      : figure_(figure), lifted_(lifted), immersed_(immersed), walk_(figure.points, lifted) {}

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
    for (const auto& [from, to] : axis.absorbed) add_parts(walk(from, point(to)), point(from), point(to), node);
    return node;
  }

 private:
  const Vec2& point(Index vertex) const { return figure_.points[immersed_.planar_vertex[vertex]]; }

  std::vector<WalkStep> walk(Index from, const Vec2& to) const { return walk_.walk(immersed_.lifted_vertex[from], to); }

  Index object_of(Index vertex) const {
    const auto after = std::upper_bound(immersed_.first_vertex.begin(), immersed_.first_vertex.end(), vertex);
    return figure_.contours[static_cast<std::size_t>(after - immersed_.first_vertex.begin()) - 1].object;
  }

  SheetPlace place_of(Index triangle) const { return {lifted_.planar_triangle[triangle], lifted_.layer_of(triangle)}; }

  void follow_chord(Index from, Index to, SkeletonNode& node) const {
    node.chord = {point(from), point(to)};
    const std::vector<WalkStep> steps = walk(from, point(to));
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
      const std::vector<WalkStep> steps = walk(corners[i], node.position);
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
  SheetWalk walk_;
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
