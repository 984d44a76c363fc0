// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "algorithms/silhouette/edge_middles.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/surface_columns.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/segment_grid.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/surface_normals.h"

namespace croquis::silhouette {
namespace {

constexpr double relief_depth =
    1.0 / 4;                             // of the width: triangles across the middle meet at less than a crease's angle
constexpr double relief_edge = 1.0 / 4;  // of the width: between vertices a line is nearly as deep as at them
constexpr double relief_share = 0.25;    // of the way to the next surface
constexpr double relief_least = 1.0 / 16;                     // of the depth: what is less can't be seen
constexpr double on_edges = 1e-9;                             // slack of SurfaceColumns
constexpr double relief_aside = 0.15, relief_towards = 0.45;  // z of normals: the depth grows from 0 to all of it

/// Lines in space, in pieces, and the surfaces on which these lie.
struct Relief {
  struct Piece {
    Vec3 a, b;
    Index surface;
  };
  const SurfaceColumns& columns;
  double width, sign;  // sign of the way towards the viewer
  std::vector<Piece> pieces;
  SegmentGrid grid;  // `line` of its segments is that of the solid, `position` the piece

  /// Calls visit(line, distance) for the pieces of a surface within reach.
  template <typename Visit>
  void near_place(const Vec3& place, double reach, Index surface, Visit visit) const {
    grid.near_place(place.head<2>(), reach, [&](const GridSegment& segment, const Vec2&) {
      const Piece& piece = pieces[segment.position];
      const double distance = (place - nearest_on_segment(place, piece.a, piece.b)).norm();
      if (piece.surface == surface && distance <= reach) visit(segment.line, distance);
    });
  }
};

Relief relief_of(const Solid& solid, const SurfaceColumns& columns, double width, double sign) {
  const std::vector<Index> surfaces = surfaces_in_front(solid.mesh);
  std::vector<Relief::Piece> pieces;
  std::vector<GridSegment> segments;
  for (Index line = 0; line < solid.lines.size(); ++line) {
    for (std::size_t i = 1; i < solid.lines[line].points.size(); ++i) {
      const Vec3 &a = solid.lines[line].points[i - 1], &b = solid.lines[line].points[i];
      std::pair<double, Index> foremost{-std::numeric_limits<double>::infinity(), no_index};
      columns.at((0.5 * (a + b)).head<2>(), on_edges, [&](Index face, double z, bool) {
        foremost = std::max(foremost, {z, surfaces[face]});
      });
      segments.push_back({a.head<2>(), b.head<2>(), line, static_cast<Index>(pieces.size())});
      pieces.push_back({a, b, foremost.second});
    }
  }
  return {columns, width, sign, std::move(pieces), SegmentGrid(std::move(segments), width)};
}

/// Cuts edges in front that are too long for the lines near them; the farther off, the longer they may be.
bool refine_near(const Relief& relief, PolyMesh& mesh) {
  const std::vector<Index> surfaces = surfaces_in_front(mesh);
  return cut_edges(mesh, [&](Index face, const Vec3& a, const Vec3& b) {
    const double length = (b - a).norm();
    if (surfaces[face] == no_index || length <= relief_edge * relief.width) return false;
    bool is_near = false;
    relief.near_place((a + b) / 2, (relief.width + length) / 2, surfaces[face], [&](Index, double) { is_near = true; });
    return is_near;
  });
}

/// How far a vertex may go: as deep as asked, less where it is turned aside or the next surface is near.
double most_at(const Vec3& place, double facing, const Relief& relief) {
  const double share = std::clamp((facing - relief_aside) / (relief_towards - relief_aside), 0.0, 1.0);
  if (share == 0) return 0;
  double space = std::numeric_limits<double>::infinity();
  relief.columns.at(place.head<2>(), on_edges, [&](Index, double z, bool) {
    const double way = relief.sign * (z - place.z());
    if (way > 1e-6 * relief.width) space = std::min(space, way);  // else it is its own face
  });
  return std::min(relief_depth * relief.width * share * share * (3 - 2 * share) / facing, relief_share * space);
}

/// Per vertex the way along the view. Vertices of faces that don't face the viewer make the outline and stay.
/// @param reached per line the longest way of a vertex near it
std::vector<double> ways_of(const PolyMesh& mesh, const Relief& relief, std::vector<double>& reached) {
  const std::vector<Index> surfaces = surfaces_in_front(mesh);
  std::vector<Index> surface(mesh.vertex_count(), 0);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    surface[mesh.corners[c]] = std::max(surface[mesh.corners[c]], surfaces[c / 3]);  // no_index is the greatest
  }
  const std::vector<Vec3> normals =
      group_normals({mesh.face_offsets, mesh.corners}, mesh.positions, mesh.corners, mesh.vertex_count());
  std::vector<double> ways(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (surface[v] == no_index) continue;
    double most = -1;
    const auto pull = [&](Index line, double distance) {
      if (most < 0) most = most_at(mesh.positions[v], normals[v].z(), relief);
      const double way = most * (1 + std::cos(2 * std::numbers::pi * distance / relief.width)) / 2;
      reached[line] = std::max(reached[line], way);
      ways[v] = std::max(ways[v], way);
    };
    relief.near_place(mesh.positions[v], relief.width / 2, surface[v], pull);
  }
  return ways;
}

/// Moves vertices by as much of their ways as makes no new meetings of the surface with itself.
/// @return whether there is such a share
bool move_vertices(const std::vector<double>& ways, double sign, PolyMesh& mesh, const Progress& progress) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (std::ranges::any_of(mesh.face(f), [&](Index v) { return ways[v] > 0; })) faces.push_back(f);
  }
  const auto meetings = [&](const PolyMesh& moved) {
    Progress part = progress.silent();
    return find_intersections_of(moved, faces, part, {0}).count;
  };
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    PolyMesh moved = mesh;
    for (std::size_t v = 0; v < ways.size(); ++v) moved.positions[v].z() += sign * share * ways[v];
    const std::size_t found = meetings(moved);
    if (found > 0 && found > meetings(mesh)) continue;  // parts of drafts do overlap
    mesh = std::move(moved);
    return true;
  }
  return false;
}

Finding stays_line(const Drawing& drawing, Index stroke) {
  const std::string why = " stays a line: the solid is too thin or too steep there; draw it farther inside";
  return make_warning(Category::Geometry, "W_LEFT_OUT", in_quotes(drawing, stroke) + why,
                      {stroke_subject(drawing, stroke)});
}

}  // namespace

void carve_lines(const Drawing& drawing, const DetailOptions& options, double unit, Solid& solid, Progress& progress) {
  const double width = options.width * unit;
  const SurfaceColumns columns(solid.mesh, width);
  const Relief relief = relief_of(solid, columns, width, options.shape == DetailShape::Ridge ? 1.0 : -1.0);
  PolyMesh mesh = solid.mesh;
  while (refine_near(relief, mesh)) progress.check();
  std::vector<double> reached(solid.lines.size(), 0);
  const std::vector<double> ways = ways_of(mesh, relief, reached);
  const bool moved = move_vertices(ways, relief.sign, mesh, progress);
  std::vector<SurfaceLine> kept;
  for (std::size_t line = 0; line < reached.size(); ++line) {
    if (moved && reached[line] >= relief_least * relief_depth * width) continue;
    const Index stroke = solid.lines[line].stroke;
    if (kept.empty() || kept.back().stroke != stroke) solid.findings.push_back(stays_line(drawing, stroke));
    kept.push_back(std::move(solid.lines[line]));
  }
  solid.carved = reached.size() - kept.size();
  solid.lines = std::move(kept);
  if (*solid.carved > 0) solid.mesh = std::move(mesh);
  progress.report(1);
}

}  // namespace croquis::silhouette
