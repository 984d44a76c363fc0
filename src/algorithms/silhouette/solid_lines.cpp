// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/solid_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/polyline.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/segment_grid.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/surface_normals.h"

namespace croquis::silhouette {
namespace {

/// Per triangle its component, or no_index where it doesn't face the viewer.
std::vector<Index> surfaces_in_front(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<Index> surfaces(mesh.face_count(), no_index);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto place = [&](std::size_t corner) { return Vec2(mesh.positions[mesh.face(f)[corner]].head<2>()); };
    if (cross(place(1) - place(0), place(2) - place(0)) > 0) surfaces[f] = topology.component(f);
  }
  return surfaces;
}

/// The triangles of a mesh over each place of the drawing.
class SurfaceColumns {
 public:
  /// @param mesh triangles; not owned
  /// @param cell about the length of an edge, > 0
  SurfaceColumns(const PolyMesh& mesh, double cell) : mesh_(mesh), cell_(cell) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto corners = mesh.face(f);
      Vec2 low = xy(corners[0]), high = low;
      for (const Index v : corners) {
        low = low.cwiseMin(xy(v));
        high = high.cwiseMax(xy(v));
      }
      const auto [left, bottom] = cell_of(low);
      const auto [right, top] = cell_of(high);
      for (long x = left; x <= right; ++x) {
        for (long y = bottom; y <= top; ++y) faces_[{x, y}].push_back(f);
      }
    }
  }

  /// Calls visit(face, z, whether it faces the viewer) for every triangle over a place, ascending; those that are seen
  /// from their edge have none.
  /// @param slack barycentric: places so far beyond a triangle's edges count as within it
  template <typename Visit>
  void at(const Vec2& place, double slack, Visit visit) const {
    const auto faces = faces_.find(cell_of(place));
    if (faces == faces_.end()) return;
    for (const Index f : faces->second) {
      const auto corners = mesh_.face(f);
      const Vec2 a = xy(corners[0]), b = xy(corners[1]), c = xy(corners[2]);
      const double area = cross(b - a, c - a);
      if (area == 0) continue;
      const double at_b = cross(place - a, c - a) / area, at_c = cross(b - a, place - a) / area;
      if (at_b < -slack || at_c < -slack || at_b + at_c > 1 + slack) continue;
      visit(f, (1 - at_b - at_c) * z_of(corners[0]) + at_b * z_of(corners[1]) + at_c * z_of(corners[2]), area > 0);
    }
  }

 private:
  Vec2 xy(Index vertex) const { return mesh_.positions[vertex].head<2>(); }
  double z_of(Index vertex) const { return mesh_.positions[vertex].z(); }
  std::pair<long, long> cell_of(const Vec2& place) const {
    return {std::lround(place.x() / cell_), std::lround(place.y() / cell_)};
  }

  const PolyMesh& mesh_;
  double cell_;
  std::map<std::pair<long, long>, std::vector<Index>> faces_;
};

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

namespace {

/// @param v      corners of a triangle
/// @param middle of the edges that begin at them, or no_index
void add_cut(const std::array<Index, 3>& v, const std::array<Index, 3>& middle, PolyMesh& mesh) {
  std::vector<Index> rest;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index before = middle[(i + 2) % 3], after = middle[i];
    if (before != no_index && after != no_index) mesh.add_triangle(before, v[i], after);
    if (before == no_index || after == no_index) rest.push_back(v[i]);
    if (after != no_index) rest.push_back(after);
  }
  if (rest.size() == 4) {
    const auto length = [&](std::size_t i) { return (mesh.positions[rest[i]] - mesh.positions[rest[i + 2]]).norm(); };
    const bool is_only = std::ranges::count(middle, no_index) == 2;  // then it is joined to the corner across from it
    const bool is_odd = is_only ? middle[1] == no_index : length(1) < length(0);
    if (is_odd) std::rotate(rest.begin(), rest.begin() + 1, rest.end());
    mesh.add_triangle(rest[0], rest[2], rest[3]);
  }
  mesh.add_triangle(rest[0], rest[1], rest[2]);
}

}  // namespace

bool cut_edges(PolyMesh& mesh, const std::function<bool(Index face, const Vec3& a, const Vec3& b)>& cuts) {
  const MeshTopology topology(mesh);
  std::vector<Index> middle(topology.edge_count(), no_index);
  PolyMesh cut;
  cut.positions = mesh.positions;
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    Index& vertex = middle[topology.edge(corner)];
    const Vec3& a = mesh.positions[topology.vertex(corner)];
    const Vec3& b = mesh.positions[topology.vertex(topology.next(corner))];
    if (vertex != no_index || !cuts(topology.face(corner), a, b)) continue;
    vertex = static_cast<Index>(cut.positions.size());
    cut.positions.emplace_back((a + b) / 2);
  }
  if (cut.positions.size() == mesh.positions.size()) return false;
  std::vector<Index> origin;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto middle_of = [&](Index corner) { return middle[topology.edge(3 * f + corner)]; };
    const auto v = mesh.face(f);
    add_cut({v[0], v[1], v[2]}, {middle_of(0), middle_of(1), middle_of(2)}, cut);
    origin.resize(cut.face_count(), f);
  }
  for (const AttributeChannel& channel : mesh.channels) cut.channels.push_back(gathered(channel, origin));
  mesh = std::move(cut);
  return true;
}

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
