// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/marking_menu.h"

#include <QPainter>
#include <cmath>
#include <numbers>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double dead_radius = 12;  // logical pixels: nearer chooses nothing
constexpr double ring_x = 104;      // where labels stand
constexpr double ring_y = 74;
constexpr double label_height = 26;

QString text_of(const QAction& action) { return action.text().remove('&').section(QChar(0x2026), 0, 0); }

double angle_of(std::size_t place) { return static_cast<double>(place) * std::numbers::pi / 4; }

}  // namespace

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

void MarkingMenu::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int chosen = place_towards(pointer_ - middle_);
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

}  // namespace croquis::app
