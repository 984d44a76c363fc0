// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/size_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double margin = 7;  // the handle's half width
constexpr double key_step = 0.04;

}  // namespace

SizeSlider::SizeSlider(QWidget* parent) : QWidget(parent) {
  setObjectName("size-slider");
  setAccessibleName(tr("Greatest width of holes to fill"));
  setToolTip(tr("Drag: open holes up to this diameter are selected and previewed"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SizeSlider::show_sizes(const std::vector<double>& diameters) {
  if (diameters == diameters_) return;
  diameters_ = diameters;
  histogram_ = HoleHistogram(diameters);
  diameter_ = std::min(diameter_, histogram_.greatest() * 2);
  setEnabled(!histogram_.empty());
  update();
}

void SizeSlider::set_diameter(double diameter) {
  diameter_ = diameter;
  update();
}

QRectF SizeSlider::track() const { return QRectF(rect()).adjusted(margin, 3, -margin, -12); }

void SizeSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = track();
  painter.setPen(Qt::NoPen);
  const double highest = static_cast<double>(std::max<std::size_t>(histogram_.highest(), 1));
  for (const HoleHistogram::Bin& bin : histogram_.bins()) {
    if (bin.count == 0) continue;
    const double left = area.left() + area.width() * histogram_.position(bin.low);
    const double right = std::max(area.left() + area.width() * histogram_.position(bin.high), left + 4);
    const double height = std::max(3.0, area.height() * std::sqrt(static_cast<double>(bin.count) / highest));
    painter.setBrush(bin.low <= diameter_ ? colors::accent : QColor(122, 128, 138));
    painter.drawRect(QRectF(left, area.bottom() - height, right - left - 1, height));
  }
  painter.setPen(QPen(QColor(122, 128, 138), 2));
  painter.drawLine(area.bottomLeft() + QPointF(0, 4), area.bottomRight() + QPointF(0, 4));
  if (histogram_.empty()) return;
  const double at = area.left() + area.width() * (diameter_ > 0 ? histogram_.position(diameter_) : 0);
  painter.setPen(QPen(hasFocus() ? colors::hover : QColor(220, 224, 230), 1.5));
  painter.setBrush(diameter_ > 0 ? colors::accent : QColor(70, 73, 79));
  painter.drawEllipse(QPointF(at, area.bottom() + 4), 5.5, 5.5);
}

void SizeSlider::move_to(double position) {
  if (histogram_.empty()) return;
  const double wanted = histogram_.snapped(std::clamp(position, 0.0, 1.0));
  if (wanted == diameter_) return;
  set_diameter(wanted);
  emit moved(wanted);
}

void SizeSlider::mousePressEvent(QMouseEvent* event) {
  move_to((event->position().x() - track().left()) / track().width());
}

void SizeSlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    move_to((event->position().x() - track().left()) / track().width());
  }
}

void SizeSlider::keyPressEvent(QKeyEvent* event) {
  const double now = diameter_ > 0 ? histogram_.position(diameter_) : 0;
  switch (event->key()) {
    case Qt::Key_Left: return move_to(now - key_step);
    case Qt::Key_Right: return move_to(now + key_step);
    case Qt::Key_Home: return move_to(0);
    case Qt::Key_End: return move_to(1);
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace croquis::app
