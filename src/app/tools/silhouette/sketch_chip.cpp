// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_chip.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <cmath>
#include <utility>

#include "app/panels/number_box.h"
#include "app/window/icons.h"

namespace croquis::app {
namespace {

constexpr int chip_size = 22;  // logical pixels
constexpr int chip_icon_size = 14;
constexpr int number_decimals = 2;
constexpr double number_step = 0.05;

/// Background and border.
const char* style_of(SketchChip::Look::Strength strength) {
  using Strength = SketchChip::Look::Strength;
  switch (strength) {
    case Strength::Half:
      return "QToolButton { background: #cfe0f7; color: #2b3f5c; border: 1px solid #4d7cba; border-radius: 11px;"
             " padding: 0 3px; font-size: 12px } QToolButton:hover { background: #e2edfb }";
    case Strength::Full:
      return "QToolButton { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10; border-radius: 11px;"
             " padding: 0 3px; font-size: 12px } QToolButton:hover { background: #f7a552 }";
    case Strength::Warning:
      return "QToolButton { background: #fff4df; color: #7a4a00; border: 2px dashed #d08a1e; border-radius: 11px;"
             " padding: 0 3px; font-size: 12px } QToolButton:hover { background: #ffe2a8 }";
    case Strength::Plain: break;
  }
  return "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 11px;"
         " padding: 0 3px; font-size: 12px } QToolButton:hover { background: #ffe2c2 }";
}

}  // namespace

SketchChip::SketchChip(QWidget* views) : QToolButton(views) {
  setFocusPolicy(Qt::NoFocus);
  setIconSize({chip_icon_size, chip_icon_size});
  setFixedHeight(chip_size);
  hide();
}

void SketchChip::set_look(const Look& look) {
  const QString style = style_of(look.strength);
  if (styleSheet() != style) setStyleSheet(style);
  setIcon(action_icon(look.icon));
  setText(look.text);
  setToolButtonStyle(look.text.isEmpty() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
  setFixedWidth(look.text.isEmpty() ? chip_size : sizeHint().width());
  setToolTip(look.tooltip);
  setAccessibleName(look.tooltip);
}

void SketchChip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressed_at_ = event->globalPosition();
  QToolButton::mousePressEvent(event);
}

void SketchChip::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_at_ || !draggable_) return QToolButton::mouseMoveEvent(event);
  const QPointF by = event->globalPosition() - *pressed_at_;
  dragging_ = dragging_ || by.manhattanLength() >= QApplication::startDragDistance() / 2.0;
  if (dragging_) emit dragged(by);
}

void SketchChip::mouseReleaseEvent(QMouseEvent* event) {
  pressed_at_.reset();
  if (event->button() == Qt::RightButton) emit asked();
  if (!std::exchange(dragging_, false)) return QToolButton::mouseReleaseEvent(event);
  setDown(false);
  emit dropped();
}

ChipRow::ChipRow(QWidget* views, const QString& name, bool draggable)
    : QObject(views), views_(views), name_(name), draggable_(draggable) {}

void ChipRow::add_button() {
  auto* button = new SketchChip(views_);
  const std::size_t number = buttons_.size();
  button->setObjectName(name_ + "-" + QString::number(number));
  button->set_draggable(draggable_);
  connect(button, &QToolButton::clicked, this, [this, number] { emit clicked(number); });
  connect(button, &SketchChip::dragged, this, [this, number](const QPointF& by) { emit dragged(number, by); });
  connect(button, &SketchChip::dropped, this, [this, number] { emit dropped(number); });
  connect(button, &SketchChip::asked, this, [this, number] { emit asked(number); });
  buttons_.push_back(button);
}

void ChipRow::show(std::vector<Chip> chips) {
  chips_ = std::move(chips);
  while (buttons_.size() < chips_.size()) add_button();
  for (std::size_t i = 0; i < chips_.size(); ++i) buttons_[i]->set_look(chips_[i].look);
  for (std::size_t i = chips_.size(); i < buttons_.size(); ++i) buttons_[i]->hide();
}

void ChipRow::place(ChipPlaces& places, bool shown, bool drawn_through) {
  const ViewPane& pane = places.layout().pane(SketchView);
  for (std::size_t i = 0; i < chips_.size(); ++i) {
    SketchChip& button = *buttons_[i];
    button.setAttribute(Qt::WA_TransparentForMouseEvents, drawn_through);
    const Vec2 pixel = pane.sketch_frame().to_pixel(chips_[i].at);
    const QPointF at = pane.rect.topLeft() + QPointF(pixel.x(), pixel.y() - chips_[i].above);
    if (shown && pane.visible() && pane.rect.contains(at))
      places.put(button, at - QPointF(button.width(), button.height()) / 2, pane.rect);
    else
      button.hide();
  }
}

double chip_number(double value) {
  const double steps = std::pow(10, number_decimals);
  return std::round(value * steps) / steps;
}

QString chip_text(double value) { return number_words(chip_number(value)); }

void ask_number(SketchChip& chip, const QString& name, double value, double low, double high,
                const std::function<void(double)>& take) {
  auto* window = new QFrame(&chip, Qt::Popup);
  window->setAttribute(Qt::WA_DeleteOnClose);
  QDoubleSpinBox* box = make_number_box(window, name, {low, high, number_decimals});
  box->setSingleStep(number_step);
  box->setValue(value);
  auto* layout = new QHBoxLayout(window);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(box);
  QObject::connect(box, &QDoubleSpinBox::valueChanged, &chip, take);
  QObject::connect(box, &QDoubleSpinBox::editingFinished, window, &QWidget::close);
  window->move(chip.mapToGlobal(QPoint(0, chip.height() + 2)));
  window->show();
  box->setFocus();
  box->selectAll();
}

}  // namespace croquis::app
