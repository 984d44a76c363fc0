// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <utility>

#include "app/tools/holes/scan_holes.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double rim_width = 2.2;
constexpr double selected_rim_width = 4;
constexpr double hovered_rim_width = 5;
constexpr std::uint8_t covered_rim_alpha = 55;  // of rims behind the surface
constexpr double frame_share = 0.9;             // of a hole's size, to be seen around it

render::LinePath rim_path(const HoleRim& rim, const QColor& color) {
  render::LinePath path = path_of(rim.points, to_glm, true);
  for (render::LinePoint& point : path.points) point.color = with_own_alpha(color);
  return path;
}

render::Mark handle_mark(const PatchHandle& handle, bool hovered) {
  render::Mark mark{to_glm(handle.place), render::MarkShape::Square, hovered ? 11.0F : 9.0F,
                    with_own_alpha(hovered ? colors::accent.lighter(125) : colors::accent)};
  mark.outline_width = 1.5F;
  return mark;
}

SeenThrough rims(std::vector<render::LinePath> paths, double width) {
  if (paths.empty()) return {};
  SeenThrough lines;
  lines.clear = render::make_line_item(paths, {width, {}, {}, render::LineDepth::OnSurface});
  for (render::LinePath& path : paths) {
    for (render::LinePoint& point : path.points) point.color->a = covered_rim_alpha;
  }
  lines.faint = render::make_line_item(paths, {width, {}, {}});
  return lines;
}

constexpr double pin_height = 18;
constexpr double faint_strength = 0.35;  // of holes that the scan hides

}  // namespace

QColor hole_color(const HoleRow& hole) {
  if (hole.state == FillAction::Fill) return {0, 140, 105};
  if (hole.state == FillAction::Failed) return colors::error;
  return hole.is_border() ? QColor(110, 100, 130) : QColor(20, 92, 200);
}

void HoleOverlay::follow(const HoleTool& tool, const std::vector<HoleRow>& rows) {
  std::vector<render::LinePath> all;
  std::vector<render::LinePath> selected;
  for (const HoleRow& row : rows) {
    const HoleRim* rim = tool.rim(row.id);
    if (rim == nullptr) continue;
    if (tool.is_selected(row.id))
      selected.push_back(rim_path(*rim, colors::accent));
    else
      all.push_back(rim_path(*rim, hole_color(row)));
  }
  all_ = rims(std::move(all), rim_width);
  selected_ = rims(std::move(selected), selected_rim_width);
  follow_hover(tool);
}

void HoleOverlay::follow_hover(const HoleTool& tool) {
  const HolePreview& preview = tool.preview();
  std::vector<render::LinePath> hovered;
  for (const Index hole : preview.hovered.holes) {
    if (const HoleRim* rim = tool.rim(hole)) hovered.push_back(rim_path(*rim, colors::hover));
  }
  hovered_ = rims(std::move(hovered), hovered_rim_width);
  std::vector<render::Mark> marks;
  for (std::size_t k = 0; k < tool.handles().size(); ++k) {
    const bool over = preview.hovered.part == HolePart::Handle && preview.hovered.handle == k;
    marks.push_back(handle_mark(tool.handles()[k], over));
  }
  handles_ = marks_of(marks);
  pull_.reset();
  pulled_.reset();
  const bool aims = preview.hovered.part == HolePart::Patch && preview.hovered.place;
  if (!preview.pull && !aims) return;
  const Vec3 to = preview.pull ? preview.pull->to : *preview.hovered.place;
  pulled_ = marks_of({handle_mark({no_index, to, {}}, true)});
  if (!preview.pull) return;
  pull_ = lines_of({path_of(std::array{preview.pull->from, to}, to_glm)},
                   {1.5, with_own_alpha(colors::accent), {4, 3, 0, 0}});
}

void HoleOverlay::add_to(render::Scene& scene) const {
  add_items(scene, {all_.faint, selected_.faint, hovered_.faint, all_.clear, selected_.clear, hovered_.clear, pull_},
            {handles_, pulled_});
}

render::Bounds HoleOverlay::bounds_of(const HoleTool& tool, const std::vector<Index>& holes) {
  render::Bounds bounds;
  for (const Index hole : holes) {
    const HoleRim* rim = tool.rim(hole);
    if (rim == nullptr) continue;
    const Vec3 reach = Vec3::Constant(frame_share * rim->radius);
    bounds.add(to_glm(rim->at - reach));
    bounds.add(to_glm(rim->at + reach));
  }
  return bounds;
}

HolePinView::HolePinView(QWidget* views) : QWidget(views) {
  setObjectName("hole-pins");
  setAccessibleName(tr("Numbers of holes"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

HolePinView::Drawn HolePinView::drawn(const ViewPins& view, const HolePin& pin, const ScanHoles& holes) {
  Drawn pictured;
  pictured.view = view.view;
  pictured.at = view.view.topLeft() + QPointF(pin.pixel.x(), pin.pixel.y());
  pictured.anchor = view.view.topLeft() + QPointF(pin.anchor.x(), pin.anchor.y());
  pictured.text = QString::number(pin.hole);
  if (pin.holes.size() > 1) pictured.text += QStringLiteral(" +%1").arg(pin.holes.size() - 1);
  const HoleRow* row = holes.row(pin.hole);
  if (row != nullptr) pictured.color = hole_color(*row);
  const auto any_of = [&](const std::vector<Index>& some) {
    return std::ranges::any_of(pin.holes, [&](Index hole) { return std::ranges::count(some, hole) > 0; });
  };
  pictured.selected = any_of(holes.selected());
  pictured.hovered = any_of(holes.tool.preview().hovered.holes);
  // While sight isn't computed, the faces' direction decides; some scans are inside out.
  pictured.faint = holes.sight != nullptr ? !pin.visible : !pin.facing;
  return pictured;
}

void HolePinView::show_pins(Pins pins, const ScanHoles& holes) {
  std::vector<Drawn> wanted;
  for (const ViewPins& view : pins) {
    for (const HolePin& pin : view.pins) wanted.push_back(drawn(view, pin, holes));
  }
  // Faint ones below, what is selected or under the pointer above all.
  std::stable_sort(wanted.begin(), wanted.end(), [](const Drawn& a, const Drawn& b) {
    const auto rank = [](const Drawn& d) { return d.hovered ? 3 : d.selected ? 2 : d.faint ? 0 : 1; };
    return rank(a) < rank(b);
  });
  if (wanted == drawn_ && isVisible() == !wanted.empty()) return;
  drawn_ = std::move(wanted);
  setVisible(!drawn_.empty());
  if (geometry() != parentWidget()->rect()) setGeometry(parentWidget()->rect());
  update();
}

void HolePinView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(11);
  font.setBold(true);
  painter.setFont(font);
  for (const Drawn& pin : drawn_) {
    painter.setClipRect(pin.view);
    painter.setOpacity(pin.faint && !pin.selected && !pin.hovered ? faint_strength : 1);
    const QColor fill = pin.selected ? colors::accent : pin.color;
    if (pin.at != pin.anchor) {
      painter.setPen(QPen(fill, 1.2));
      painter.drawLine(pin.at, pin.anchor);
      painter.setBrush(fill);
      painter.drawEllipse(pin.anchor, 2, 2);
    }
    const double width = std::max(pin_height, painter.fontMetrics().horizontalAdvance(pin.text) + 10.0);
    const QRectF body(pin.at.x() - width / 2, pin.at.y() - pin_height / 2, width, pin_height);
    painter.setPen(QPen(pin.hovered ? colors::hover : QColor(Qt::white), pin.hovered ? 3 : 1.5));
    painter.setBrush(fill);
    painter.drawRoundedRect(body, pin_height / 2, pin_height / 2);
    painter.setPen(pin.selected ? QColor(24, 24, 26) : QColor(Qt::white));
    painter.drawText(body, Qt::AlignCenter, pin.text);
  }
}

}  // namespace croquis::app
