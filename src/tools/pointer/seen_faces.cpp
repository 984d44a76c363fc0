// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/seen_faces.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

namespace croquis {
namespace {

Eigen::Vector4d clip_of(const ViewFrame& frame, const Vec3& place) {
  return frame.to_clip * Eigen::Vector4d(place.x(), place.y(), place.z(), 1);
}

/// How far beyond the near plane, in clip space. A point on it has a positive w in every view.
double beyond_near(const Eigen::Vector4d& clip) { return clip.z() + clip.w(); }

bool is_shown(const Eigen::Vector4d& clip) { return clip.w() > 0 && beyond_near(clip) >= 0; }

Projected on_screen(const ViewFrame& frame, const Eigen::Vector4d& clip) {
  const Vec3 at = clip.head<3>() / clip.w();
  return {{(at.x() + 1) / 2 * frame.size.x(), (1 - at.y()) / 2 * frame.size.y()}, at.z()};
}

/// Where the segment from a shown place to one that isn't meets the near plane: 0..1.
double at_near(const Eigen::Vector4d& shown, const Eigen::Vector4d& hidden) {
  const double inside = beyond_near(shown);
  const double outside = beyond_near(hidden);
  return outside < inside ? std::clamp(inside / (inside - outside), 0.0, 1.0) : 0.0;
}

constexpr double cells_per_vertex = 4;
constexpr double least_cells = 1 << 16;
constexpr double most_cells = 1 << 22;  // 50 MB
constexpr std::size_t faces_for_threads = 20'000;
constexpr double most_columns = 8192;      // of very long and thin boxes
constexpr double smallest_side = 1e-9;     // pixels
constexpr double depth_tolerance = 1e-10;  // of the depth range: rounding of places on one surface

/// Cells whose middles lie between two coordinates: [first, last).
std::pair<int, int> middles_between(double low, double high, int count) {
  const auto cell = [count](double at) {
    return static_cast<int>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(count)));
  };
  return {cell(low), cell(high)};
}

double count_inside(const ScreenMesh& screen, const PickBox& region) {
  double count = 0;
  for (std::size_t v = 0; v < screen.vertices.size(); ++v) {
    const Vec2& pixel = screen.vertices[v].pixel;
    const bool inside = (pixel.array() >= region.low.array()).all() && (pixel.array() <= region.high.array()).all();
    if (screen.shown[v] != 0 && inside) ++count;
  }
  return count;
}

double cross_of(const Projected& a, const Projected& b, double x, double y) {
  return (a.pixel.x() - x) * (b.pixel.y() - y) - (a.pixel.y() - y) * (b.pixel.x() - x);
}

/// Depth as a linear function of the place on the screen, which it is for flat polygons.
struct DepthPlane {
  double depth = 0, per_x = 0, per_y = 0;

  explicit DepthPlane(const std::vector<Projected>& polygon) {
    const auto point = [](const Projected& p) { return Vec3(p.pixel.x(), p.pixel.y(), p.depth); };
    const Vec3 origin = point(polygon[0]);
    const Vec3 normal = area_normal(polygon.size(), [&](std::size_t i) { return point(polygon[i]); });
    if (normal.z() != 0) {
      per_x = -normal.x() / normal.z();
      per_y = -normal.y() / normal.z();
    }
    depth = origin.z() - per_x * origin.x() - per_y * origin.y();
  }
};

}  // namespace

double ScreenSegment::on_edge(double on_screen) const {
  // Clip coordinates are linear along the edge; dividing by w isn't.
  const double part = on_screen * weight_a / (weight_b + on_screen * (weight_a - weight_b));
  return from + part * (to - from);
}

Projected ScreenSegment::at(double on_screen) const {
  return {a.pixel + on_screen * (b.pixel - a.pixel), a.depth + on_screen * (b.depth - a.depth)};
}

std::optional<ScreenSegment> project_segment(const ViewFrame& frame, const Vec3& a, const Vec3& b) {
  Eigen::Vector4d clip_a = clip_of(frame, a);
  Eigen::Vector4d clip_b = clip_of(frame, b);
  ScreenSegment segment;
  if (!is_shown(clip_a) && !is_shown(clip_b)) return std::nullopt;
  if (!is_shown(clip_a)) {
    segment.from = 1 - at_near(clip_b, clip_a);
    clip_a = clip_b + (1 - segment.from) * (clip_a - clip_b);
  } else if (!is_shown(clip_b)) {
    segment.to = at_near(clip_a, clip_b);
    clip_b = clip_a + segment.to * (clip_b - clip_a);
  }
  if (!(clip_a.w() > 0) || !(clip_b.w() > 0)) return std::nullopt;
  segment.a = on_screen(frame, clip_a);
  segment.b = on_screen(frame, clip_b);
  segment.weight_a = clip_a.w();
  segment.weight_b = clip_b.w();
  return segment;
}

ScreenMesh::ScreenMesh(const PolyMesh& mesh, const ViewFrame& frame)
    : vertices(mesh.vertex_count()), shown(mesh.vertex_count(), 0) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Eigen::Vector4d clip = clip_of(frame, mesh.positions[v]);
    if (!is_shown(clip)) continue;
    shown[v] = 1;
    vertices[v] = on_screen(frame, clip);
  }
}

std::optional<PickBox> ScreenMesh::bounds() const {
  std::optional<PickBox> box;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (shown[v] == 0) continue;
    const Vec2& pixel = vertices[v].pixel;
    box = box ? PickBox{box->low.cwiseMin(pixel), box->high.cwiseMax(pixel)} : PickBox{pixel, pixel};
  }
  return box;
}

void project_face(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen, Index face,
                  std::vector<Projected>& polygon) {
  polygon.clear();
  const auto corners = mesh.face(face);
  if (corners.size() < 3) return;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index from = corners[i];
    const Index to = corners[i + 1 < corners.size() ? i + 1 : 0];
    if (screen.shown[from] != 0) polygon.push_back(screen.vertices[from]);
    if (screen.shown[from] == screen.shown[to]) continue;
    const auto segment = project_segment(frame, mesh.positions[from], mesh.positions[to]);
    if (segment) polygon.push_back(screen.shown[from] != 0 ? segment->b : segment->a);
  }
  if (polygon.size() < 3) polygon.clear();
}

SeenFaces::SeenFaces(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen, const PickBox& region)
    : region_(region) {
  const Vec2 size = (region.high - region.low).cwiseMax(smallest_side);
  const double wanted = std::clamp(cells_per_vertex * count_inside(screen, region), least_cells, most_cells);
  const double columns = std::clamp(std::sqrt(wanted * size.x() / size.y()), 1.0, most_columns);
  columns_ = static_cast<int>(columns);
  rows_ = static_cast<int>(std::clamp(wanted / columns, 1.0, most_columns));
  cells_per_pixel_ = {columns_ / size.x(), rows_ / size.y()};
  cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                {std::numeric_limits<double>::infinity(), no_index});
  std::vector<Projected> vertices(screen.vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = in_cells(screen.vertices[v]);
  // Every thread has rows of its own, so each cell sees the faces in their order.
  const int bands = mesh.face_count() < faces_for_threads ? 1 : query_threads();
  for_each_part(static_cast<std::size_t>(bands), 1, bands, [&](std::size_t band, std::size_t) {
    const auto at = static_cast<int>(band);
    draw_rows(mesh, frame, screen, vertices, {rows_ * at / bands, rows_ * (at + 1) / bands});
  });
}

void SeenFaces::draw_rows(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen,
                          const std::vector<Projected>& vertices, const Rows& rows) {
  std::vector<Projected> polygon;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    polygon.clear();
    if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return screen.shown[v] != 0; })) {
      for (const Index v : corners) polygon.push_back(vertices[v]);
    } else {
      project_face(mesh, frame, screen, face, polygon);
      for (Projected& corner : polygon) corner = in_cells(corner);
    }
    if (polygon.size() >= 3) draw_face(mesh, face, polygon, rows);
  }
}

/// Rows of a band whose middles lie between two coordinates.
SeenFaces::Rows SeenFaces::rows_between(double top, double bottom, const Rows& rows) const {
  const auto [first, end] = middles_between(top, bottom, rows_);
  return {std::max(first, rows.first), std::min(end, rows.end)};
}

Projected SeenFaces::in_cells(const Projected& place) const {
  return {(place.pixel - region_.low).cwiseProduct(cells_per_pixel_), place.depth};
}

void SeenFaces::put(int column, int row, double depth, Index face) {
  Cell& cell =
      cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  if (depth < cell.depth) cell = {depth, face};
}

/// Whether the middle of any cell may be within a polygon's bounds: most faces of a fine mesh fall between.
bool SeenFaces::covers_cells(const std::vector<Projected>& polygon, const Rows& rows) const {
  Vec2 low = polygon[0].pixel;
  Vec2 high = low;
  for (const Projected& corner : polygon) {
    low = low.cwiseMin(corner.pixel);
    high = high.cwiseMax(corner.pixel);
  }
  const auto [first_column, end_column] = middles_between(low.x(), high.x(), columns_);
  const Rows covered = rows_between(low.y(), high.y(), rows);
  return first_column < end_column && covered.first < covered.end;
}

void SeenFaces::draw_face(const PolyMesh& mesh, Index face, const std::vector<Projected>& polygon, const Rows& rows) {
  if (!covers_cells(polygon, rows)) return;
  const auto corners = mesh.face(face);
  if (polygon.size() != corners.size() || polygon.size() > 4) return draw_polygon(polygon, face, rows);
  if (polygon.size() == 3) return draw_triangle(polygon[0], polygon[1], polygon[2], face, rows);
  const std::size_t first = quad_cut(mesh.positions, corners);
  draw_triangle(polygon[first], polygon[first + 1], polygon[first + 2], face, rows);
  draw_triangle(polygon[first], polygon[first + 2], polygon[(first + 3) % 4], face, rows);
}

void SeenFaces::draw_triangle(const Projected& a, const Projected& b, const Projected& c, Index face,
                              const Rows& rows) {
  const auto [left, right] = std::minmax({a.pixel.x(), b.pixel.x(), c.pixel.x()});
  const auto [top, bottom] = std::minmax({a.pixel.y(), b.pixel.y(), c.pixel.y()});
  const auto [first_column, end_column] = middles_between(left, right, columns_);
  const Rows covered = rows_between(top, bottom, rows);
  for (int row = covered.first; row < covered.end; ++row) {
    for (int column = first_column; column < end_column; ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const double at_a = cross_of(b, c, x, y);
      const double at_b = cross_of(c, a, x, y);
      const double at_c = cross_of(a, b, x, y);
      const bool inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
      const double area = at_a + at_b + at_c;
      if (inside && area != 0) put(column, row, (at_a * a.depth + at_b * b.depth + at_c * c.depth) / area, face);
    }
  }
}

void SeenFaces::draw_polygon(const std::vector<Projected>& polygon, Index face, const Rows& rows) {
  std::vector<double> crossings;
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Projected& corner : polygon) {
    top = std::min(top, corner.pixel.y());
    bottom = std::max(bottom, corner.pixel.y());
  }
  const DepthPlane plane(polygon);
  const Rows covered = rows_between(top, bottom, rows);
  for (int row = covered.first; row < covered.end; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2& from = polygon[i].pixel;
      const Vec2& to = polygon[i + 1 < polygon.size() ? i + 1 : 0].pixel;
      if ((from.y() > y) != (to.y() > y))
        crossings.push_back(from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto [first, end] = middles_between(crossings[i], crossings[i + 1], columns_);
      for (int column = first; column < end; ++column)
        put(column, row, plane.depth + plane.per_x * (column + 0.5) + plane.per_y * y, face);
    }
  }
}

SeenFaces::Answer SeenFaces::ask(const Projected& place, std::span<const Index> own_faces) const {
  const Projected at = in_cells(place);
  const auto clamped = [](double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(count - 1)));
  };
  const int column = clamped(at.pixel.x(), columns_);
  const int row = clamped(at.pixel.y(), rows_);
  double furthest = -std::numeric_limits<double>::infinity();
  double nearest = -furthest;
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      const Cell& cell =
          cells_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)];
      if (std::find(own_faces.begin(), own_faces.end(), cell.face) != own_faces.end()) return Answer::Seen;
      furthest = std::max(furthest, cell.depth);
      nearest = std::min(nearest, cell.depth);
    }
  }
  if (place.depth <= nearest) return Answer::Seen;
  return place.depth > furthest + depth_tolerance ? Answer::Hidden : Answer::Unclear;
}

std::vector<char> SeenFaces::faces_shown(std::size_t face_count) const {
  std::vector<char> shown(face_count, 0);
  for (const Cell& cell : cells_) {
    if (cell.face != no_index) shown[cell.face] = 1;
  }
  return shown;
}

}  // namespace croquis
