// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/sheet_sampling.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

/// Splitting an edge can make a new one that needs it too, but never nearer to the contour than half the last: figures
/// need two or three rounds.
constexpr int max_split_rounds = 20;

// In parts of the first row's depth: an edge that starts shallower and ends past the row is cut there.
constexpr double shallow_part = 0.5;
constexpr double past_row = 1.3;

/// Cuts a segment of the figure at these fractions.
void add_pieces(RimPiece piece, const std::vector<double>& cuts, SheetSampling& sheets) {
  const Vec2 begin = sheets.points[piece.begin];
  const Vec2 end = sheets.points[piece.end];
  const Index last = piece.end;
  for (const double fraction : cuts) {
    piece.end = static_cast<Index>(sheets.points.size());
    sheets.points.push_back(begin + fraction * (end - begin));
    sheets.pieces.push_back(piece);
    piece.begin = piece.end;
  }
  piece.end = last;
  sheets.pieces.push_back(piece);
}

/// The contours, cut where they cross, and the points between them.
SheetSampling sampled_points(const LabelledFigure& figure, const Skeleton& skeleton, Quality quality,
                             std::span<const Index> thin) {
  const RimValues radii = rim_radii(skeleton);
  const RimValues laid_out = row_radii(figure, radii, thin);
  RimRows rows;
  for (const std::vector<double>& contour : laid_out) {
    rows.emplace_back();
    for (const double radius : contour) rows.back().push_back(row_depths(radius, figure.step));
  }
  SheetSampling sheets;
  sheets.points = figure.points;
  sheets.step = figure.step;
  const std::vector<DirectedSegment> segments = directed_segments(figure);
  const std::vector<std::vector<double>> cuts = crossing_splits(figure, rows);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Index c = segments[s].contour, i = segments[s].position;
    add_pieces({segments[s], radii[c][i], laid_out[c][i]}, cuts[s], sheets);
  }
  const std::vector<Vec2> inner = sheet_points(figure, skeleton, sheets, rows, quality);
  sheets.points.insert(sheets.points.end(), inner.begin(), inner.end());
  return sheets;
}

void triangulate_and_lift(SheetSampling& sheets) {
  std::vector<std::array<Index, 2>> constraints;
  std::vector<int> depth;
  for (const RimPiece& piece : sheets.pieces) {
    constraints.push_back({piece.begin, piece.end});
    depth.push_back(piece.depth);
  }
  PlanarTriangulationResult result = triangulate(sheets.points, constraints);
  if (!result.conflict.empty()) throw_internal("The contours of the figure touch");
  sheets.planar = std::move(result.triangulation);
  sheets.layers = count_layers(sheets.planar, sheets.pieces);
  sheets.lifted = lift(sheets.planar, sheets.layers, depth);
}

/// A planar edge and where to split it.
struct PlanarEdge {
  Index low, high;
  Index constraint;
  double fraction;  ///< from low to high
  auto operator<=>(const PlanarEdge&) const = default;
};

/// Where to split an edge from a rim, or from close to it, that runs past the first row: beside rims where the row is,
/// it would stand out as a notch.
std::optional<double> fraction_at_row(const SheetSampling& sheets, const RimDistances& rim, Index from, Index to) {
  if (rim.nearest[from] == no_index) return std::nullopt;
  const RimEdge& edge = rim.edges[rim.nearest[from]];
  const double start = rim.distance[from], depth = depth_below(sheets, edge, to);
  if (start > shallow_part * edge.first_row || depth < past_row * edge.first_row) return std::nullopt;
  return (edge.first_row - start) / (depth - start);
}

/// Inner edges from rim to rim, and those that run past a row.
/// @param rim none: rows don't count
/// @return each planar edge once
std::vector<PlanarEdge> edges_to_split(const SheetSampling& sheets, const std::optional<RimDistances>& rim) {
  const LiftedTriangulation& lifted = sheets.lifted;
  std::vector<PlanarEdge> edges;
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[m][corner] == no_index) continue;
      Index from = lifted.triangles[m][next(corner)], to = lifted.triangles[m][previous(corner)];
      std::optional<double> fraction;
      if (lifted.on_boundary[from] && lifted.on_boundary[to]) {
        fraction = 0.5;
      } else if (rim) {
        if (rim->distance[from] > rim->distance[to]) std::swap(from, to);
        fraction = fraction_at_row(sheets, *rim, from, to);
      }
      if (!fraction) continue;
      const Index begin = lifted.planar_vertex[from], end = lifted.planar_vertex[to];
      const Index constraint = sheets.planar.constraints[lifted.planar_triangle[m]][corner];
      edges.push_back(
          {std::min(begin, end), std::max(begin, end), constraint, begin < end ? *fraction : 1 - *fraction});
    }
  }
  const auto same = [](const PlanarEdge& a, const PlanarEdge& b) { return a.low == b.low && a.high == b.high; };
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  return edges;
}

/// An edge that is a piece of another sheet's contour is split for all sheets.
void split_edges(const std::vector<PlanarEdge>& edges, SheetSampling& sheets) {
  for (const PlanarEdge& edge : edges) {
    const auto middle = static_cast<Index>(sheets.points.size());
    sheets.points.push_back((1 - edge.fraction) * sheets.points[edge.low] + edge.fraction * sheets.points[edge.high]);
    if (edge.constraint == no_index) continue;
    RimPiece rest = sheets.pieces[edge.constraint];
    sheets.pieces[edge.constraint].end = rest.begin = middle;
    sheets.pieces.push_back(rest);
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

}  // namespace

std::vector<int> count_layers(const PlanarTriangulation& planar, std::span<const RimPiece> pieces) {
  constexpr int unknown = std::numeric_limits<int>::min();
  std::vector<int> layers(planar.triangles.size(), unknown);
  std::vector<Index> reached;
  // Layers on the triangle's side of its edge opposite to the corner, less those on the other side.
  const auto step_across = [&](Index triangle, Index corner) {
    const Index constraint = planar.constraints[triangle][corner];
    if (constraint == no_index) return 0;
    const RimPiece& piece = pieces[constraint];
    return planar.triangles[triangle][next(corner)] == piece.begin ? piece.side : -piece.side;
  };
  const auto enter = [&](Index triangle, int count) {
    if (layers[triangle] == unknown) {
      layers[triangle] = count;
      reached.push_back(triangle);
    }
    if (layers[triangle] != count || count < 0) throw_internal("The sides of the contours contradict each other");
  };
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (planar.neighbours[t][corner] == no_index) enter(t, step_across(t, corner));
    }
  }
  for (std::size_t head = 0; head < reached.size(); ++head) {
    const Index t = reached[head];
    for (Index corner = 0; corner < 3; ++corner) {
      const Index beyond = planar.neighbours[t][corner];
      if (beyond != no_index) enter(beyond, layers[t] - step_across(t, corner));
    }
  }
  return layers;
}

SheetSampling sample_sheets(const LabelledFigure& figure, const Skeleton& skeleton, Progress& progress, Quality quality,
                            std::span<const Index> thin) {
  SheetSampling sheets = sampled_points(figure, skeleton, quality, thin);
  for (int round = 0; round < max_split_rounds; ++round) {
    progress.check();
    triangulate_and_lift(sheets);
    const std::size_t count = sheets.points.size();
    fill_lone_triangles(sheets);
    // In later rounds only splinters between contours that nearly touch run past rows.
    std::optional<RimDistances> rim;
    if (round == 0 && quality == Quality::Final) rim = rim_distances(sheets, greatest_first_row());
    split_edges(edges_to_split(sheets, rim), sheets);
    if (sheets.points.size() == count) return sheets;
  }
  throw_internal("The drawn region is too thin to be sampled");
}

LiftedPlace place_in(const SheetSampling& sheets, Index triangle, const Vec2& position) {
  const auto area_of = [](const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a) / 2; };
  const std::array<Index, 3>& corners = sheets.planar.triangles[sheets.lifted.planar_triangle[triangle]];
  const std::array<Vec2, 3> p{sheets.points[corners[0]], sheets.points[corners[1]], sheets.points[corners[2]]};
  const double area = area_of(p[0], p[1], p[2]);
  LiftedPlace place;
  place.vertices = sheets.lifted.triangles[triangle];
  for (Index k = 0; k < 3; ++k) {
    place.weights[k] = std::clamp(area_of(position, p[next(k)], p[previous(k)]) / area, 0.0, 1.0);
  }
  const double sum = place.weights[0] + place.weights[1] + place.weights[2];
  for (double& weight : place.weights) weight /= sum;
  return place;
}

std::vector<LiftedPlace> locate_nodes(const LabelledFigure& figure, const Skeleton& skeleton,
                                      const SheetSampling& sheets) {
  PlanarWalk walk(sheets.points, sheets.planar);
  std::vector<LiftedPlace> places;
  for (const SkeletonNode& node : skeleton.nodes) {
    Index triangle = walk.locate(node.position);
    // A node on a contour may be found on its other side; the layers must be counted in its own triangle's face.
    const int layers = figure.layers[node.place.triangle];
    if (triangle != no_index && sheets.layers[triangle] != layers) {
      for (const Index other : sheets.planar.neighbours[triangle]) {
        if (other == no_index || sheets.layers[other] != layers) continue;
        triangle = other;
        break;
      }
    }
    if (triangle == no_index || static_cast<int>(node.place.layer) >= sheets.layers[triangle]) {
      throw_internal("A skeleton node lies outside of its sheet");
    }
    places.push_back(place_in(sheets, sheets.lifted.first_copy[triangle] + node.place.layer, node.position));
  }
  return places;
}

}  // namespace croquis::silhouette
