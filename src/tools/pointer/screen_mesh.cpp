// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/screen_mesh.h"

#include <algorithm>

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

std::optional<std::pair<double, double>> part_in_box(const Vec2& a, const Vec2& b, const PickBox& box) {
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (a[axis] < box.low[axis] || a[axis] > box.high[axis]) return std::nullopt;
      continue;
    }
    const double at_low = (box.low[axis] - a[axis]) / step;
    const double at_high = (box.high[axis] - a[axis]) / step;
    enter = std::max(enter, std::min(at_low, at_high));
    leave = std::min(leave, std::max(at_low, at_high));
  }
  if (enter > leave) return std::nullopt;
  return std::pair(enter, leave);
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

}  // namespace croquis
