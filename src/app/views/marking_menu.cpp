// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/marking_menu.h"

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double dead_radius = 12;  // logical pixels: nearer chooses nothing
constexpr double ring_x = 104;      // where labels stand
constexpr double ring_y = 74;
constexpr double label_height = 26;
constexpr double ring_inner = 17, ring_outer = 56, ring_marked = 66;
constexpr double letter_font = 10, short_font = 7.5;  // points: of a letter, of a short word
constexpr const char* sector_property = "sector-color";

QString text_of(const QAction& action) { return action.text().remove('&').section(QChar(0x2026), 0, 0); }

double angle_of(std::size_t place) { return static_cast<double>(place) * std::numbers::pi / 4; }

QColor sector_color(const QAction* action) {
  return action == nullptr ? QColor() : action->property(sector_property).value<QColor>();
}

}  // namespace

void set_sector_color(QAction& action, const QColor& color) { action.setProperty(sector_property, color); }

MarkingMenu::MarkingMenu(QWidget* parent) : QWidget(parent) {
  setObjectName("marking-menu");
  setAccessibleName(tr("Marking menu"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

int MarkingMenu::place_towards(const QPointF& way) {
  if (std::hypot(way.x(), way.y()) < dead_radius) return -1;
  const double turn = std::atan2(way.x(), -way.y()) / (std::numbers::pi / 4);
  return (static_cast<int>(std::lround(turn)) + static_cast<int>(places)) % static_cast<int>(places);
}

void MarkingMenu::open(const QPointF& at) {
  middle_ = at;
  pointer_ = at;
  setGeometry(parentWidget()->rect());
  raise();
  show();
}

void MarkingMenu::move_to(const QPointF& at) {
  pointer_ = at;
  update();
}

bool MarkingMenu::choose() {
  hide();
  const int place = place_towards(pointer_ - middle_);
  QAction* action = place < 0 ? nullptr : actions_.at(static_cast<std::size_t>(place));
  if (action == nullptr || !action->isEnabled()) return false;
  action->trigger();
  return true;
}

QRectF MarkingMenu::label_rect(std::size_t place) const {
  const double angle = angle_of(place);
  const QString text = actions_[place] == nullptr ? QString() : text_of(*actions_[place]);
  const double width = fontMetrics().horizontalAdvance(text) + 24;
  const QPointF at = middle_ + QPointF(ring_x * std::sin(angle), -ring_y * std::cos(angle));
  return {at.x() - width / 2, at.y() - label_height / 2, width, label_height};
}

bool MarkingMenu::is_ring() const {
  return std::ranges::any_of(actions_, [](const QAction* action) { return sector_color(action).isValid(); });
}

void MarkingMenu::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int chosen = place_towards(pointer_ - middle_);
  if (is_ring())
    paint_ring(painter, chosen);
  else
    paint_labels(painter, chosen);
}

void MarkingMenu::paint_labels(QPainter& painter, int chosen) const {
  painter.setPen(QPen(colors::accent, 2));
  painter.drawLine(middle_, pointer_);
  painter.setBrush(QColor(43, 45, 49));
  painter.drawEllipse(middle_, 4, 4);
  for (std::size_t place = 0; place < places; ++place) {
    if (actions_[place] == nullptr) continue;
    const bool marked = static_cast<int>(place) == chosen;
    const bool enabled = actions_[place]->isEnabled();
    painter.setPen(QPen(marked ? colors::accent : QColor(92, 96, 104), 1));
    painter.setBrush(marked ? QColor(106, 74, 38) : QColor(43, 45, 49, 235));
    const QRectF rect = label_rect(place);
    painter.drawRoundedRect(rect, 6, 6);
    painter.setPen(enabled ? QColor(236, 238, 242) : QColor(128, 132, 140));
    painter.drawText(rect, Qt::AlignCenter, text_of(*actions_[place]));
  }
}

/// The middle stays free: what is under the pen is seen.
void MarkingMenu::paint_ring(QPainter& painter, int chosen) const {
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  for (std::size_t place = 0; place < places; ++place) {
    if (static_cast<int>(place) != chosen) paint_sector(painter, place, false);
  }
  const QAction* action = chosen < 0 ? nullptr : actions_[static_cast<std::size_t>(chosen)];
  if (action == nullptr) return;
  paint_sector(painter, static_cast<std::size_t>(chosen), true);
  painter.setFont(this->font());
  paint_name(painter, *action);
}

void MarkingMenu::paint_sector(QPainter& painter, std::size_t place, bool marked) const {
  const QAction* action = actions_[place];
  if (action == nullptr) return;
  const double outer = marked ? ring_marked : ring_outer;
  const auto square = [this](double radius) {
    return QRectF(middle_.x() - radius, middle_.y() - radius, 2 * radius, 2 * radius);
  };
  const double from = 90 - 45 * static_cast<double>(place) + 22.5;  // degrees, against the clock from the right
  QPainterPath sector;
  sector.arcMoveTo(square(outer), from);
  sector.arcTo(square(outer), from, -45);
  sector.arcTo(square(ring_inner), from - 45, 45);
  sector.closeSubpath();
  QColor fill = sector_color(action).isValid() ? sector_color(action) : QColor(70, 74, 82);
  if (!action->isEnabled()) fill.setAlpha(90);
  painter.setPen(QPen(QColor(252, 252, 250), 2));
  painter.setBrush(fill);
  painter.drawPath(sector);
  if (action->isCheckable() && action->isChecked()) {
    painter.setPen(QPen(QColor(20, 20, 22), 2.5));
    painter.drawArc(square(outer + 3), static_cast<int>(16 * (from - 3)), -16 * 39);
  }
  const double angle = angle_of(place), reach = (ring_inner + outer) / 2 + 2;
  const QPointF at = middle_ + QPointF(reach * std::sin(angle), -reach * std::cos(angle));
  painter.setPen(text_color_on(fill));
  QFont font = painter.font();
  font.setPointSizeF(action->iconText().size() > 2 ? short_font : letter_font);
  painter.setFont(font);
  painter.drawText(QRectF(at.x() - 22, at.y() - 11, 44, 22), Qt::AlignCenter, action->iconText());
}

/// Beside the ring, on the side that has room.
void MarkingMenu::paint_name(QPainter& painter, const QAction& action) const {
  const QString text = text_of(action);
  const double width = fontMetrics().horizontalAdvance(text) + 20;
  const double above = middle_.y() - ring_marked - label_height - 8;
  const double top = above > 2 ? above : middle_.y() + ring_marked + 8;
  const double left = std::clamp(middle_.x() - width / 2, 2.0, std::max(2.0, this->width() - width - 2));
  const QRectF rect(left, top, width, label_height);
  painter.setPen(QPen(QColor(92, 96, 104), 1));
  painter.setBrush(QColor(43, 45, 49, 240));
  painter.drawRoundedRect(rect, 6, 6);
  painter.setPen(QColor(236, 238, 242));
  painter.drawText(rect, Qt::AlignCenter, text);
}

}  // namespace croquis::app
