// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pane_layout.h"

#include <algorithm>
#include <cmath>

namespace croquis::app {
namespace {

constexpr double panes_gap = 2;  // logical pixels between the views
constexpr double grip = 4;       // to either side of a border
constexpr double least_pane_share = 0.15;

}  // namespace

PaneLayout::PaneLayout()
    : panes_{first_pane(render::NamedView::Front), first_pane(render::NamedView::Perspective),
             first_pane(render::NamedView::Top), first_pane(render::NamedView::Side),
             first_pane(render::NamedView::Perspective)} {}

void PaneLayout::resize(const QSizeF& size) {
  size_ = size;
  lay_out();
}

void PaneLayout::arrange(Arrangement arrangement) {
  arrangement_ = arrangement;
  alone_ = -1;
  lay_out();
}

void PaneLayout::show_alone(int view) {
  alone_ = view;
  lay_out();
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
  set_shares({border.across ? place.x() / size_.width() : across_, border.down ? place.y() / size_.height() : down_});
}

void PaneLayout::set_shares(const QPointF& shares) {
  across_ = std::clamp(shares.x(), least_pane_share, 1 - least_pane_share);
  down_ = std::clamp(shares.y(), least_pane_share, 1 - least_pane_share);
  lay_out();
}

}  // namespace croquis::app
