// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_pin_view.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/tools/holes/hole_interaction.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double pin_height = 18;
constexpr double faint_strength = 0.35;  // of holes that the scan hides

bool contains(const std::vector<Index>& holes, Index hole) {
  return std::find(holes.begin(), holes.end(), hole) != holes.end();
}

}  // namespace

HolePinView::HolePinView(QWidget* views) : QWidget(views) {
  setObjectName("hole-pins");
  setAccessibleName(tr("Numbers of holes"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

HolePinView::Drawn HolePinView::drawn(const ViewPins& view, const HolePin& pin, const HoleInteraction& holes) {
  Drawn pictured;
  pictured.view = view.view;
  pictured.at = view.view.topLeft() + QPointF(pin.pixel.x(), pin.pixel.y());
  pictured.anchor = view.view.topLeft() + QPointF(pin.anchor.x(), pin.anchor.y());
  pictured.text = QString::number(pin.hole);
  if (pin.holes.size() > 1) pictured.text += QStringLiteral(" +%1").arg(pin.holes.size() - 1);
  const HoleRow* row = holes.row(pin.hole);
  if (row != nullptr) pictured.color = hole_color(*row);
  const std::vector<Index>& selected = holes.selected();
  const std::vector<Index>& hovered = holes.hovered();
  pictured.selected = std::any_of(pin.holes.begin(), pin.holes.end(), [&](Index h) { return contains(selected, h); });
  pictured.hovered = std::any_of(pin.holes.begin(), pin.holes.end(), [&](Index h) { return contains(hovered, h); });
  // While sight isn't computed, the faces' direction decides; some scans are inside out.
  pictured.faint = holes.knows_sight() ? !pin.visible : !pin.facing;
  return pictured;
}

void HolePinView::show_pins(Pins pins, const HoleInteraction& holes) {
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
