// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_pane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/panels/object_names.h"
#include "app/views/render_color.h"

namespace croquis::app {
namespace {

constexpr double radians_per_pixel = 0.008;
constexpr double first_height = 640;  // sketch units
constexpr double frame_margin = 0.1;
constexpr double least_share = 0.5;                  // of the view: a scene that fills less is framed again
constexpr std::size_t most_framed_points = 200'000;  // of more, only the box is framed: views must not wait

std::vector<glm::dvec3> framing_points(const render::Scene& scene) {
  std::size_t count = 0;
  for (const auto& mesh : scene.meshes) count += mesh.item ? mesh.item->vertices.size() : 0;
  if (count <= most_framed_points) return render::points_of(scene);
  const render::Bounds bounds = render::bounds_of(scene);
  if (bounds.empty()) return {};
  const auto corners = bounds.corners();
  return {corners.begin(), corners.end()};
}

Eigen::Matrix4d eigen_matrix(const glm::dmat4& matrix) {
  Eigen::Matrix4d result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) result(row, column) = matrix[column][row];
  }
  return result;
}

constexpr double panes_gap = 2;  // logical pixels between the views
constexpr double grip = 4;       // to either side of a border
constexpr double least_pane_share = 0.15;

constexpr double picture_share = 0.96;  // of the pane

/// What a result says, or null.
std::shared_ptr<const Camera> camera_of(const Evaluation& result) {
  for (const auto& [port, value] : result.outputs) {
    if (auto camera = value.as<Camera>(); camera && camera->image_size.minCoeff() > 0) return camera;
  }
  return nullptr;
}

/// Of the middle of what a result holds.
double depth_in(const Evaluation& result, const Camera& camera) {
  for (const auto& [port, value] : result.outputs) {
    const BoundingBox box = bounds_of(value);
    const double depth = box ? camera.depth(((*box)[0] + (*box)[1]) / 2) : 0;
    if (depth > 0) return depth;
  }
  return 1;
}

std::optional<SceneCamera> camera_in(const Studio& studio, const WorkObject& object) {
  for (const NodeId step : object.chain) {
    // Held here: results are computed and forgotten on other threads meanwhile.
    const auto result = studio.result(step);
    const auto camera = result ? camera_of(*result) : nullptr;
    if (!camera) continue;
    SceneCamera found;
    found.node = object.chain.front();
    found.name = shown_name(object);
    const Affine3 to_model = object.placement.map();
    found.camera = Value(camera).transformed(to_model).get<Camera>();
    const auto sheet = source_of<PerspectiveDrawing>(studio.session().document().find(found.node));
    if (sheet) found.origin = sheet->origin;
    found.depth = depth_in(*result, *camera) * std::cbrt(object.placement.scale.prod());
    return found;
  }
  return std::nullopt;
}

}  // namespace

SketchFrame ViewPane::sketch_frame() const {
  const double units = camera.height / std::max(rect.height(), 1.0);
  const Vec2 half(rect.width() / 2 * units, -camera.height / 2);
  return {Vec2(camera.target.x, camera.target.y) - half, units};
}

ViewFrame ViewPane::view_frame(const render::Bounds& bounds) const {
  const render::DepthRange range = render::depth_range(camera, bounds);
  const double aspect = visible() ? rect.width() / rect.height() : 1;
  const glm::dmat4 to_clip = render::projection_matrix(camera, aspect, range) * render::view_matrix(camera);
  return ViewFrame::of(eigen_matrix(to_clip), Vec2(std::max(rect.width(), 1.0), std::max(rect.height(), 1.0)));
}

void ViewPane::move(const CameraMotion& motion) {
  if (!visible()) return;
  const glm::dvec2 pixels(motion.delta.x(), motion.delta.y());
  switch (motion.kind) {
    case CameraMotion::Kind::Tumble: camera = render::tumble(camera, camera.target, pixels * radians_per_pixel); break;
    case CameraMotion::Kind::Track: camera = render::track(camera, pixels, rect.height()); break;
    case CameraMotion::Kind::Dolly:
      camera = flat()
                   ? render::dolly_about(camera, motion.factor, glm::dvec2(motion.about.x(), motion.about.y()), size())
                   : render::dolly(camera, motion.factor);
      break;
  }
}

void ViewPane::turn_to(const Vec3& facing) {
  constexpr double steep = 0.5, upright = 0.95;  // cosines
  const glm::dvec3 front(facing.x(), facing.y(), facing.z());
  const double distance = glm::length(camera.eye - camera.target);
  const glm::dvec3 to_eye = (camera.eye - camera.target) / distance;
  if (flat() || glm::dot(front, to_eye) >= steep) return;
  const glm::dvec3 up = glm::normalize(camera.up);
  // From straight above or below a little of where the eye was is kept: up has to stay up.
  const glm::dvec3 aside = to_eye - glm::dot(to_eye, up) * up;
  const bool is_upright = std::abs(glm::dot(front, up)) > upright && glm::length(aside) > 0;
  const glm::dvec3 seen_from = is_upright ? glm::normalize(front + 0.5 * glm::normalize(aside)) : front;
  camera.eye = camera.target + distance * seen_from;
}

void ViewPane::frame(const render::Bounds& bounds) {
  if (!visible() || bounds.empty()) return;
  const render::ViewDirection direction =
      flat() ? render::view_direction(kind)
             : render::ViewDirection{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(bounds, direction, rect.width() / rect.height(), frame_margin);
}

void ViewPane::frame(const render::Scene& scene) {
  const std::vector<glm::dvec3> points = framing_points(scene);
  if (!visible() || points.empty()) return;
  const render::ViewDirection direction{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(points, direction, rect.width() / rect.height(), frame_margin);
}

bool ViewPane::fits(const render::Scene& scene) const {
  if (!visible()) return true;
  // For scans of hundreds of thousands of points: matrices once, not for every point.
  const ViewFrame frame = view_frame(render::bounds_of(scene));
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const glm::dvec3& point : framing_points(scene)) {
    const auto seen = frame.project({point.x, point.y, point.z});
    if (!seen) return false;
    low = low.cwiseMin(seen->pixel);
    high = high.cwiseMax(seen->pixel);
  }
  if (!(low.x() <= high.x())) return false;
  constexpr double half = 0.5;  // pixels
  const bool inside = low.minCoeff() >= half && high.x() <= rect.width() - half && high.y() <= rect.height() - half;
  const Vec2 extent = high - low;
  return inside && (extent.x() > least_share * rect.width() || extent.y() > least_share * rect.height());
}

ViewPane first_pane(render::NamedView kind) {
  ViewPane pane;
  pane.kind = kind;
  const render::Bounds about{{-200, -200, -200}, {200, 200, 200}};
  pane.camera = render::frame(about, render::view_direction(kind), 1);
  if (kind == render::NamedView::Front) pane.camera.eye = {0, 0, first_height};
  if (pane.flat()) pane.camera.height = first_height;
  return pane;
}

PaneLayout::PaneLayout()
    : panes_{first_pane(render::NamedView::Front), first_pane(render::NamedView::Perspective),
             first_pane(render::NamedView::Top), first_pane(render::NamedView::Side),
             first_pane(render::NamedView::Perspective)} {}

void PaneLayout::resize(const QSizeF& size) {
  size_ = size;
  lay_out();
}

void PaneLayout::arrange(Arrangement arrangement, int alone) {
  arrangement_ = arrangement;
  show_alone(alone);
}

void PaneLayout::show_alone(int view) {
  alone_ = view;
  lay_out();
  changed();
}

std::vector<int> PaneLayout::shown() const {
  if (alone_ >= 0) return {alone_};
  switch (arrangement_) {
    case Arrangement::Four: return {TopView, PerspectiveView, SketchView, SideView};
    case Arrangement::Compare: return {PerspectiveView, ComparisonView};
    case Arrangement::SketchAndSolid: break;
  }
  return {SketchView, PerspectiveView};
}

void PaneLayout::lay_out() {
  for (ViewPane& pane : panes_) pane.rect = QRectF();
  const std::vector<int> views = shown();
  if (views.size() == 1) {
    pane(views.front()).rect = QRectF(QPointF(), size_);
    return;
  }
  const double left = std::round(size_.width() * across_ - panes_gap / 2);
  const double upper = views.size() == 2 ? size_.height() : std::round(size_.height() * down_ - panes_gap / 2);
  const double right_width = size_.width() - left - panes_gap;
  pane(views[0]).rect = QRectF(0, 0, left, upper);
  pane(views[1]).rect = QRectF(left + panes_gap, 0, right_width, upper);
  if (views.size() == 2) return;
  const double lower_height = size_.height() - upper - panes_gap;
  pane(views[2]).rect = QRectF(0, upper + panes_gap, left, lower_height);
  pane(views[3]).rect = QRectF(left + panes_gap, upper + panes_gap, right_width, lower_height);
}

int PaneLayout::view_at(const QPointF& place) const {
  const std::vector<int> views = shown();
  const auto distance = [&](int view) {
    const QRectF& rect = pane(view).rect;
    const double x = std::max({rect.left() - place.x(), place.x() - rect.right(), 0.0});
    const double y = std::max({rect.top() - place.y(), place.y() - rect.bottom(), 0.0});
    return std::hypot(x, y);
  };
  return *std::min_element(views.begin(), views.end(), [&](int a, int b) { return distance(a) < distance(b); });
}

PaneLayout::Border PaneLayout::border_at(const QPointF& place) const {
  const std::vector<int> views = shown();
  Border border;
  if (views.size() == 1) return border;
  border.across = std::abs(place.x() - pane(views[1]).rect.left()) <= grip;
  border.down = views.size() == 4 && std::abs(place.y() - pane(views[2]).rect.top()) <= grip;
  return border;
}

void PaneLayout::drag_border(const Border& border, const QPointF& place) {
  share({border.across ? place.x() / size_.width() : across_, border.down ? place.y() / size_.height() : down_});
}

void PaneLayout::set_shares(const QPointF& shares) {
  suggested_ = even_share;
  share(shares);
  changed();
}

void PaneLayout::suggest_share(double across) {
  if (across_ != suggested_) return;
  set_shares({across, down_});
  suggested_ = across;
}

void PaneLayout::share(const QPointF& shares) {
  across_ = std::clamp(shares.x(), least_pane_share, 1 - least_pane_share);
  down_ = std::clamp(shares.y(), least_pane_share, 1 - least_pane_share);
  lay_out();
}

render::Camera SceneCamera::in(const ViewPane& pane) const {
  const double scale =
      picture_share * std::min(pane.rect.width() / camera.image_size.x(), pane.rect.height() / camera.image_size.y());
  const double height = pane.rect.height() / scale;  // of the pane, px of the picture
  const Vec2 offset = camera.principal_point - (origin + camera.image_size / 2);
  render::Camera through;
  through.projection = render::Projection::Perspective;
  through.eye = to_glm(camera.eye);
  through.target = to_glm(camera.eye + depth * camera.rotation.row(2).transpose());
  through.up = to_glm(-camera.rotation.row(1).transpose());
  through.field_of_view = 2 * std::atan(height / (2 * camera.focal_length));
  through.principal_offset = {offset.x() / height, -offset.y() / height};
  return through;
}

glm::dvec3 SceneCamera::before_the_eye(const Vec2& place) const {
  return to_glm(camera.eye + depth * camera.ray(place));
}

std::vector<SceneCamera> scene_cameras(const Studio& studio) {
  std::vector<SceneCamera> cameras;
  for (const WorkObject& object : studio.objects()) {
    if (auto camera = camera_in(studio, object)) cameras.push_back(*std::move(camera));
  }
  return cameras;
}

std::optional<SceneCamera> scene_camera(const Studio& studio, NodeId first) {
  for (const WorkObject& object : studio.objects()) {
    if (object.chain.front() != first) continue;
    if (auto camera = camera_in(studio, object)) return camera;
  }
  return std::nullopt;
}

}  // namespace croquis::app
