// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tours/tour_guide.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "app/replay/replays.h"
#include "app/views/render_color.h"
#include "app/window/theme.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/surface/surface_steps.h"

namespace croquis::app {
namespace {

constexpr double near_share = 0.15;  // of a stroke's size
constexpr double dot_radius = 6;     // px
constexpr double ring_radius = 12;
constexpr double frame_margin = 12;

double path_size(const std::vector<Vec3>& path, Vec3& middle) {
  Vec3 low = path.front();
  Vec3 high = path.front();
  for (const Vec3& place : path) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  middle = (low + high) / 2;
  return (high - low).norm();
}

/// Of a path's places from another path, on average.
double mean_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double sum = 0;
  for (const Vec3& place : from) {
    double nearest = (place - to.front()).norm();
    for (std::size_t i = 0; i + 1 < to.size(); ++i) {
      const Vec3 side = to[i + 1] - to[i];
      const double length = side.squaredNorm();
      const double at = length > 0 ? std::clamp((place - to[i]).dot(side) / length, 0.0, 1.0) : 0;
      nearest = std::min(nearest, (place - to[i] - at * side).norm());
    }
    sum += nearest;
  }
  return sum / static_cast<double>(from.size());
}

bool closes(const std::vector<Vec3>& path, double size) {
  return (path.front() - path.back()).norm() < near_share * size;
}

double stroke_misfit(const std::vector<Vec3>& done, const std::vector<Vec3>& asked) {
  Vec3 middle;
  Vec3 asked_middle;
  const double size = path_size(done, middle);
  const double asked_size = path_size(asked, asked_middle);
  const double way = std::max(mean_distance(done, asked), mean_distance(asked, done));
  const bool loops = closes(done, size) && closes(asked, asked_size);
  const bool is_alike =
      loops && size > asked_size / 2 && size < 2 * asked_size && (middle - asked_middle).norm() < asked_size / 4;
  const double share = way / (near_share * asked_size);
  return is_alike ? std::min(share, 0.99) : share;
}

}  // namespace

StepPath path_of(const recorded::Step& step) {
  StepPath path;
  if (const auto* stroke = step.as<recorded::StrokeDrawn>()) {
    path.view = view_of(stroke->view);
    for (const StrokeSample& sample : stroke->points)
      path.places.emplace_back(sample.position.x(), sample.position.y(), 0);
  } else if (const auto* line = step.as<recorded::SheetStroke>()) {
    for (const Vec2& point : line->points) path.places.emplace_back(point.x(), -point.y(), 0);
  } else if (const auto* curve = step.as<recorded::SurfaceStroke>()) {
    path.view = PerspectiveView;
    for (const Vec3& point : curve->points) path.places.push_back(upright_placement()(point));
  } else if (const auto* point = step.as<recorded::SurfacePoint>()) {
    path.view = PerspectiveView;
    path.places = {upright_placement()(point->point.point)};
  } else if (const auto* click = step.as<recorded::Click>()) {
    path.view = view_of(click->view);
    path.places = {click->place.value_or(Vec3(click->at.x(), click->at.y(), 0))};
  }
  return path;
}

double misfit(const recorded::Step& done, const recorded::Step& asked) {
  constexpr double something_else = 1;
  if (&done.kind() != &asked.kind()) return something_else;
  if (const auto* action = asked.as<recorded::Action>())
    return action->name == done.as<recorded::Action>()->name ? 0 : something_else;
  const auto path = path_of(done).places;
  const auto asked_path = path_of(asked).places;
  return path.size() > 1 && asked_path.size() > 1 ? stroke_misfit(path, asked_path) : 0;
}

TourGuide::TourGuide(Views& views) : QWidget(&views.widget), views_(views) {
  setObjectName("tour-guide");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  connect(&views, &Views::changed, this, [this](int view) {
    if (view != ink_alone) update();
  });
  connect(&views, &Views::camera_moved, this, [this] { update(); });
  follow();
  show();
}

void TourGuide::follow() { setGeometry(views_.widget.rect()); }

void TourGuide::show_paths(std::vector<StepPath> paths) {
  paths_ = std::move(paths);
  for (const StepPath& path : paths_) {
    const QRectF seen =
        views_.layout.pane(path.view).rect.adjusted(frame_margin, frame_margin, -frame_margin, -frame_margin);
    const auto is_seen = [&](const Vec3& place) { return seen.contains(model_to_widget(views_, place, path.view)); };
    if (seen.isEmpty() || std::ranges::all_of(path.places, is_seen)) continue;
    render::Bounds bounds;
    for (const StepPath& other : paths_) {
      if (other.view != path.view) continue;
      for (const Vec3& place : other.places) bounds.add(to_glm(place));
    }
    views_.layout.pane(path.view).frame(bounds);
    emit views_.changed(path.view);
  }
  update();
}

void TourGuide::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const StepPath& path : paths_) {
    const ViewPane& pane = views_.layout.pane(path.view);
    if (path.places.empty() || !pane.visible()) continue;
    painter.setClipRect(pane.rect);
    QPainterPath line(model_to_widget(views_, path.places.front(), path.view));
    for (const Vec3& place : path.places) line.lineTo(model_to_widget(views_, place, path.view));
    QColor pale = colors::accent;
    pale.setAlpha(190);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(pale, 3, Qt::DotLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF first = line.elementAt(0);
    if (path.places.size() == 1) {
      painter.drawEllipse(first, ring_radius, ring_radius);
      continue;
    }
    painter.drawPath(line);
    painter.setBrush(colors::accent);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(first, dot_radius, dot_radius);
  }
}

}  // namespace croquis::app
