// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/solid_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "algorithms/silhouette/strokes/polyline.h"
#include "algorithms/silhouette/surface_columns.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Neighbouring points of a line may differ in depth by so many times their distance in the drawing; where they differ
// by more, the line goes over the edge of what lies in front.
constexpr double steepest = 8;

/// Height of the foremost surface over a place.
std::optional<double> front_height(const SurfaceColumns& columns, const Vec2& place) {
  std::optional<double> highest;
  columns.at(place, 0, [&](Index, double z, bool faces_viewer) {
    if (faces_viewer) highest = std::max(highest.value_or(z), z);
  });
  return highest;
}

}  // namespace

std::vector<SurfaceLine> surface_lines(const std::vector<DrawnLine>& drawn, const PolyMesh& mesh, double step) {
  std::vector<SurfaceLine> lines;
  if (drawn.empty()) return lines;
  const SurfaceColumns columns(mesh, 2 * step);
  for (const auto& [stroke, points, closed] : drawn) {
    std::vector<double> parameters = even_parameters(points, closed, step);
    if (closed) parameters.push_back(parameters.front());
    SurfaceLine line{stroke, {}};
    const auto finish = [&] {
      if (line.points.size() > 1) lines.push_back(line);
      line.points.clear();
    };
    for (const double parameter : parameters) {
      const Vec2 place = point_at(points, parameter);
      const std::optional<double> z = front_height(columns, place);
      if (z && !line.points.empty()) {
        const Vec3 way = Vec3(place.x(), place.y(), *z) - line.points.back();
        if (std::abs(way.z()) > steepest * std::max(step, way.head<2>().norm())) finish();
      }
      if (z) {
        line.points.emplace_back(place.x(), place.y(), *z);
      } else {
        finish();
      }
    }
    finish();
  }
  return lines;
}

std::vector<DrawnLine> inner_pieces(const std::vector<DrawnLine>& lines, const std::vector<LabelledFigure>& figures,
                                    double reach) {
  std::vector<GridSegment> shown;
  for (const LabelledFigure& figure : figures) {
    for (const FigureContour& contour : figure.contours) {
      for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const Index next = contour.vertices[(i + 1) % contour.vertices.size()];
        if (contour.drawn[i] != 0) shown.push_back({figure.points[contour.vertices[i]], figure.points[next], 0, 0});
      }
    }
  }
  const SegmentGrid grid(std::move(shown), reach);
  const auto is_shown = [&](const Vec2& place) {
    bool near = false;
    grid.near_place(place, reach, [&](const GridSegment&, const Vec2&) { near = true; });
    return near;
  };
  std::vector<DrawnLine> pieces;
  for (const DrawnLine& line : lines) {
    DrawnLine piece{line.stroke, {}, false};
    const auto finish = [&] {
      if (piece.points.size() > 1 && length(piece.points, false) >= 3 * reach) pieces.push_back(piece);
      piece.points.clear();
    };
    for (const double parameter : even_parameters(line.points, line.closed, reach / 2)) {
      const Vec2 place = point_at(line.points, parameter);
      is_shown(place) ? finish() : piece.points.push_back(place);
    }
    finish();
  }
  return pieces;
}

void append_skeleton(const Skeleton& skeleton, PolyMesh& curves) {
  const auto first = static_cast<Index>(curves.vertex_count());
  if (curves.channel("radius", Domain::Vertex) == nullptr) {
    curves.channels.push_back({"radius", Domain::Vertex, 1, std::vector<double>(curves.vertex_count(), 0.0), {}});
  }
  auto& radius = std::get<std::vector<double>>(curves.channel("radius", Domain::Vertex)->data);
  for (const SkeletonNode& node : skeleton.nodes) {
    curves.positions.emplace_back(node.position.x(), node.position.y(), node.z);
    radius.push_back(node.radius);
  }
  std::vector<std::vector<Index>> around(skeleton.nodes.size());  // per node its edges
  for (Index e = 0; e < skeleton.edges.size(); ++e) {
    for (const Index end : skeleton.edges[e]) around[end].push_back(e);
  }
  std::vector<std::uint8_t> used(skeleton.edges.size(), 0);
  const auto add_branch = [&](Index node, Index edge) {
    std::vector<Index> line{first + node};
    while (used[edge] == 0) {
      used[edge] = 1;
      const auto& [a, b] = skeleton.edges[edge];
      node = node == a ? b : a;
      line.push_back(first + node);
      if (around[node].size() != 2) break;
      edge = around[node][0] == edge ? around[node][1] : around[node][0];
    }
    curves.add_line(line);
  };
  // First those that start at an end or a junction, then the loops.
  for (const bool loops : {false, true}) {
    for (Index node = 0; node < around.size(); ++node) {
      if (!loops && around[node].size() == 2) continue;
      for (const Index edge : around[node]) {
        if (used[edge] == 0) add_branch(node, edge);
      }
    }
  }
}

}  // namespace croquis::silhouette
