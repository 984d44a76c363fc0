// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/alternative_chips.h"

#include <QEvent>
#include <algorithm>

namespace croquis::app {
namespace {

constexpr double alternatives_top = 42;  // logical pixels, below the chip that counts faces
constexpr double between_alternatives = 6;
constexpr const char* alternative_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px; padding: 2px 9px }"
    "QToolButton:hover { background: #dbe8fb; border: 1px solid #3a6fc4 }";

}  // namespace

AlternativeChips::AlternativeChips(QWidget* views) : QObject(views), views_(views) {}

void AlternativeChips::make_button() {
  const std::size_t number = buttons_.size();
  auto* button = new QToolButton(views_);
  button->setObjectName(QString("perspective-alternative-%1").arg(number + 1));
  button->setText(number == 0 ? tr("Other faces 1") : QString::number(number + 1));
  button->setToolTip(tr("These faces fit as well: the hatched ones instead of the dashed ones"));
  button->setFocusPolicy(Qt::NoFocus);
  button->setStyleSheet(alternative_style);
  button->installEventFilter(this);
  connect(button, &QToolButton::clicked, this, [this, number] {
    set_hovered(std::nullopt);
    emit wanted(number);
  });
  buttons_.push_back(button);
}

void AlternativeChips::place(ChipPlaces& places, const ViewPane& pane, std::size_t count) {
  while (buttons_.size() < count) make_button();
  double width = 0;
  for (std::size_t i = 0; i < count; ++i) {
    buttons_[i]->adjustSize();
    width += buttons_[i]->width() + between_alternatives;
  }
  double left = pane.rect.center().x() - width / 2;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (i >= count) {
      buttons_[i]->hide();
      continue;
    }
    places.put(*buttons_[i], QPointF(left, pane.rect.top() + alternatives_top), pane.rect);
    left += buttons_[i]->width() + between_alternatives;
  }
  if (hovered_ && *hovered_ >= count) set_hovered(std::nullopt);
}

void AlternativeChips::hide() {
  for (QToolButton* button : buttons_) button->hide();
  set_hovered(std::nullopt);
}

void AlternativeChips::set_hovered(std::optional<std::size_t> alternative) {
  if (hovered_ == alternative) return;
  hovered_ = alternative;
  emit hovered_changed();
}

bool AlternativeChips::eventFilter(QObject* button, QEvent* event) {
  const auto found = std::ranges::find(buttons_, button);
  if (found != buttons_.end() && event->type() == QEvent::Enter)
    set_hovered(static_cast<std::size_t>(found - buttons_.begin()));
  if (found != buttons_.end() && event->type() == QEvent::Leave) set_hovered(std::nullopt);
  return QObject::eventFilter(button, event);
}

}  // namespace croquis::app
