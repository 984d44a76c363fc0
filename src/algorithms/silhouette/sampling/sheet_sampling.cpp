// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/sheet_sampling.h"

#include <algorithm>
#include <string>
#include <utility>

#include "algorithms/silhouette/sampling/crossing_splits.h"
#include "algorithms/silhouette/sampling/figure_segments.h"
#include "algorithms/silhouette/sampling/layer_count.h"
#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/sampling/rim_distance.h"
#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/sampling/sheet_points.h"
#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

/// Splitting an edge can make a new one that needs it too, but never nearer to the contour than half the last: figures
/// need two or three rounds.
constexpr int max_split_rounds = 20;

// In parts of the first row's depth: an edge that starts shallower and ends past the row is cut there.
constexpr double shallow = 0.5;
constexpr double past_row = 1.3;
constexpr SheetDensity draft_density{1, 3};

constexpr int max_row_rounds = 1;  // later ones find only splinters between contours that nearly touch

void cut_segments(const LabelledFigure& figure, const std::vector<DirectedSegment>& segments,
                  const std::vector<std::vector<double>>& cuts, SheetSampling& sheets) {
  sheets.points = figure.points;
  sheets.step = figure.step;
  for (Index s = 0; s < segments.size(); ++s) {
    const DirectedSegment& segment = segments[s];
    const Vec2 begin = figure.points[segment.begin];
    const Vec2 end = figure.points[segment.end];
    Index last = segment.begin;
    for (const double fraction : cuts[s]) {
      const auto point = static_cast<Index>(sheets.points.size());
      sheets.points.push_back(begin + fraction * (end - begin));
      sheets.segments.push_back({last, point});
      sheets.parents.push_back(s);
      last = point;
    }
    sheets.segments.push_back({last, segment.end});
    sheets.parents.push_back(s);
  }
}

void triangulate_and_lift(const std::vector<DirectedSegment>& segments, SheetSampling& sheets) {
  PlanarTriangulationResult result = triangulate(sheets.points, sheets.segments);
  if (!result.conflict.empty()) throw_internal("The contours of the figure touch");
  sheets.planar = std::move(result.triangulation);
  std::vector<SidedSegment> sided;
  std::vector<int> depth;
  for (std::size_t k = 0; k < sheets.segments.size(); ++k) {
    const DirectedSegment& parent = segments[sheets.parents[k]];
    sided.push_back({sheets.segments[k][0], sheets.segments[k][1], parent.side});
    depth.push_back(parent.depth);
  }
  sheets.layers = count_layers(sheets.planar, sided);
  sheets.lifted = lift(sheets.planar, sheets.layers, depth);
}

/// A planar edge and where to split it.
struct PlanarEdge {
  Index low, high;
  Index constraint;
  double fraction = 0.5;  ///< from low to high
  auto operator<=>(const PlanarEdge&) const = default;
};

void keep_once_each(std::vector<PlanarEdge>& edges) {
  const auto same = [](const PlanarEdge& a, const PlanarEdge& b) { return a.low == b.low && a.high == b.high; };
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
}

std::vector<PlanarEdge> edges_between_rims(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  std::vector<PlanarEdge> edges;
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index a = lifted.triangles[m][(corner + 1) % 3];
      const Index b = lifted.triangles[m][(corner + 2) % 3];
      if (lifted.neighbours[m][corner] == no_index || !lifted.on_boundary[a] || !lifted.on_boundary[b]) continue;
      const auto [low, high] = std::minmax(lifted.planar_vertex[a], lifted.planar_vertex[b]);
      edges.push_back({low, high, sheets.planar.constraints[lifted.planar_triangle[m]][corner]});
    }
  }
  return edges;
}

/// Edges from the rim, or from close to it, that run past the first row: beside rims where the row is, they would stand
/// out as notches.
void add_edges_past_rows(const SheetSampling& sheets, std::vector<PlanarEdge>& edges) {
  const LiftedTriangulation& lifted = sheets.lifted;
  const RimDistances rim = rim_distances(sheets, greatest_first_row());
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Index a = lifted.triangles[m][(corner + 1) % 3];
      Index b = lifted.triangles[m][(corner + 2) % 3];
      if (lifted.neighbours[m][corner] == no_index) continue;
      if (rim.distance[a] > rim.distance[b]) std::swap(a, b);
      if (rim.nearest[a] == no_index || lifted.on_boundary[b]) continue;
      const RimEdge& edge = rim.edges[rim.nearest[a]];
      const double row = edge.first_row;
      if (rim.distance[a] > shallow * row) continue;
      const double depth = depth_below(sheets, edge, b);
      if (depth < past_row * row) continue;
      const double fraction = (row - rim.distance[a]) / (depth - rim.distance[a]);
      const Index from = lifted.planar_vertex[a];
      const Index to = lifted.planar_vertex[b];
      const Index constraint = sheets.planar.constraints[lifted.planar_triangle[m]][corner];
      edges.push_back({std::min(from, to), std::max(from, to), constraint, from < to ? fraction : 1 - fraction});
    }
  }
}

/// An edge that is a piece of another sheet's contour is split for all sheets.
void split_edges(const std::vector<PlanarEdge>& edges, SheetSampling& sheets) {
  for (const PlanarEdge& edge : edges) {
    const auto middle = static_cast<Index>(sheets.points.size());
    sheets.points.push_back((1 - edge.fraction) * sheets.points[edge.low] + edge.fraction * sheets.points[edge.high]);
    if (edge.constraint == no_index) continue;
    const Index end = sheets.segments[edge.constraint][1];
    sheets.segments[edge.constraint][1] = middle;
    sheets.segments.push_back({middle, end});
    sheets.parents.push_back(sheets.parents[edge.constraint]);
  }
}

/// A lone triangle has no inner edge to split.
void fill_lone_triangles(SheetSampling& sheets) {
  for (Index m = 0; m < sheets.lifted.triangles.size(); ++m) {
    if (sheets.lifted.neighbours[m] != std::array<Index, 3>{no_index, no_index, no_index}) continue;
    const std::array<Index, 3>& corners = sheets.planar.triangles[sheets.lifted.planar_triangle[m]];
    sheets.points.push_back((sheets.points[corners[0]] + sheets.points[corners[1]] + sheets.points[corners[2]]) / 3);
  }
}

double signed_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a) / 2; }

LiftedPlace place_in(const SheetSampling& sheets, Index planar_triangle, Index layer, const Vec2& position) {
  const std::array<Index, 3>& corners = sheets.planar.triangles[planar_triangle];
  const std::array<Vec2, 3> p{sheets.points[corners[0]], sheets.points[corners[1]], sheets.points[corners[2]]};
  const double area = signed_area(p[0], p[1], p[2]);
  LiftedPlace place;
  place.vertices = sheets.lifted.triangles[sheets.lifted.first_copy[planar_triangle] + layer];
  for (std::size_t k = 0; k < 3; ++k) {
    place.weights[k] = std::clamp(signed_area(position, p[(k + 1) % 3], p[(k + 2) % 3]) / area, 0.0, 1.0);
  }
  const double sum = place.weights[0] + place.weights[1] + place.weights[2];
  for (double& weight : place.weights) weight /= sum;
  return place;
}

}  // namespace

SheetSampling sample_sheets(const LabelledFigure& figure, const Skeleton& skeleton, Progress& progress, Quality quality,
                            std::span<const Index> thin) {
  SheetSampling sheets;
  const std::vector<DirectedSegment> segments = directed_segments(figure);
  const std::vector<std::vector<double>> radii = rim_radii(figure, skeleton);
  const std::vector<std::vector<double>> laid_out = row_radii(figure, radii, thin);
  cut_segments(figure, segments, crossing_splits(figure, segments, laid_out), sheets);

  std::vector<RimPiece> boundary;
  for (std::size_t k = 0; k < sheets.segments.size(); ++k) {
    const auto& [begin, end] = sheets.segments[k];
    const DirectedSegment& parent = segments[sheets.parents[k]];
    boundary.push_back(
        {sheets.points[begin], sheets.points[end], parent.contour, parent.position, begin >= figure.points.size()});
  }
  const SheetDensity density = quality == Quality::Draft ? draft_density : SheetDensity{};
  const std::vector<Vec2> inner = sheet_points(figure, skeleton, {std::move(boundary), laid_out}, density);
  sheets.points.insert(sheets.points.end(), inner.begin(), inner.end());

  for (int round = 0; round < max_split_rounds; ++round) {
    progress.check();
    sheets.piece_radii.clear();
    sheets.row_radii.clear();
    for (const Index parent : sheets.parents) {
      const DirectedSegment& segment = segments[parent];
      sheets.piece_radii.push_back(radii[segment.contour][segment.position]);
      sheets.row_radii.push_back(laid_out[segment.contour][segment.position]);
    }
    triangulate_and_lift(segments, sheets);
    const std::size_t count = sheets.points.size();
    fill_lone_triangles(sheets);
    std::vector<PlanarEdge> edges = edges_between_rims(sheets);
    if (round < max_row_rounds && quality == Quality::Final) add_edges_past_rows(sheets, edges);
    keep_once_each(edges);
    split_edges(edges, sheets);
    if (sheets.points.size() == count) return sheets;
  }
  throw_internal("The drawn region is too thin to be sampled");
}

std::vector<LiftedPlace> locate_nodes(const LabelledFigure& figure, const Skeleton& skeleton,
                                      const SheetSampling& sheets) {
  PlanarWalk walk(sheets.points, sheets.planar);
  std::vector<LiftedPlace> places;
  for (const SkeletonNode& node : skeleton.nodes) {
    Index triangle = walk.locate(node.position);
    // A node on a contour may be found on its other side; the layers must be counted in its own triangle's face.
    if (triangle != no_index && sheets.layers[triangle] != figure.layers[node.place.triangle]) {
      for (const Index other : sheets.planar.neighbours[triangle]) {
        if (other != no_index && sheets.layers[other] == figure.layers[node.place.triangle]) {
          triangle = other;
          break;
        }
      }
    }
    if (triangle == no_index || static_cast<int>(node.place.layer) >= sheets.layers[triangle]) {
      throw_internal("A skeleton node lies outside of its sheet");
    }
    places.push_back(place_in(sheets, triangle, node.place.layer, node.position));
  }
  return places;
}

}  // namespace croquis::silhouette
