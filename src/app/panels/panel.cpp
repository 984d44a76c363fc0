// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/panel.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace croquis::app {
namespace {

/// Long words are cut off where the panel is narrow, short ones never are.
void finish(QComboBox& box, const QString& name, const QString& tip) {
  box.setObjectName(name);
  box.setToolTip(tip);
  constexpr int most_letters = 9;
  int letters = 0;
  for (int i = 0; i < box.count(); ++i) letters = std::max(letters, static_cast<int>(box.itemText(i).size()));
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(std::min(letters, most_letters));
}

}  // namespace

Panel::Panel(const QString& name) : column_(new QVBoxLayout(this)) {
  setObjectName(name);
  column_->setContentsMargins(8, 6, 8, 6);
}

QDoubleSpinBox* Panel::number(const QString& name, const NumberRange& range, std::function<Number()> read,
                              std::function<void(double)> take, const QString& tip) {
  QDoubleSpinBox* box = make_number_box(this, name, range);
  box->setToolTip(tip);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, take = std::move(take)](double value) {
    if (!following_) take(value);
  });
  also([box, read = std::move(read)] {
    const Number now = read();
    box->setEnabled(now.enabled);
    // What people type there isn't overwritten.
    if (now.value && (!box->hasFocus() || box->value() != *now.value)) box->setValue(*now.value);
  });
  return box;
}

QComboBox* Panel::choice(const QString& name, const QStringList& words, std::function<std::optional<int>()> read,
                         std::function<void(int)> take, const QString& tip) {
  auto* box = new QComboBox(this);
  box->addItems(words);
  finish(*box, name, tip);
  connect(box, &QComboBox::activated, this, std::move(take));
  also([box, read = std::move(read)] {
    const std::optional<int> now = read();
    box->setEnabled(now.has_value());
    if (now) box->setCurrentIndex(*now);
  });
  return box;
}

QComboBox* Panel::choice_of_values(const QString& name, const std::vector<Choice>& choices,
                                   std::function<std::string()> read, std::function<void(const std::string&)> take,
                                   const QString& tip) {
  auto* box = new QComboBox(this);
  for (const Choice& choice : choices) box->addItem(choice.words, choice.value);
  finish(*box, name, tip);
  connect(box, &QComboBox::activated, this,
          [box, take = std::move(take)] { take(box->currentData().toString().toStdString()); });
  also([box, read = std::move(read)] { box->setCurrentIndex(box->findData(QString::fromStdString(read()))); });
  return box;
}

QCheckBox* Panel::flag(const QString& name, const QString& words, std::function<bool()> read,
                       std::function<void(bool)> take, const QString& tip) {
  auto* box = new QCheckBox(words, this);
  box->setObjectName(name);
  box->setToolTip(tip);
  connect(box, &QCheckBox::clicked, this, std::move(take));
  also([box, read = std::move(read)] { box->setChecked(read()); });
  return box;
}

QSlider* Panel::slider(const QString& name, int low, int high, std::function<int()> read,
                       std::function<void(int value, bool dragging)> take, const QString& tip) {
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setObjectName(name);
  slider->setRange(low, high);
  slider->setToolTip(tip);
  connect(slider, &QSlider::valueChanged, this, [this, slider, take](int value) {
    if (!following_) take(value, slider->isSliderDown());
  });
  connect(slider, &QSlider::sliderReleased, this, [slider, take] { take(slider->value(), false); });
  also([slider, read = std::move(read)] {
    if (!slider->isSliderDown()) slider->setValue(read());
  });
  return slider;
}

QPushButton* Panel::button(const QString& name, const QString& words, const QString& tip, std::function<void()> work) {
  auto* button = new QPushButton(words, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, std::move(work));
  return button;
}

QLabel* Panel::text(const QString& name, std::function<QString()> read) {
  QLabel* shown = label({});
  shown->setObjectName(name);
  shown->setWordWrap(true);
  also([shown, read = std::move(read)] {
    shown->setText(read());
    shown->setVisible(!shown->text().isEmpty());
  });
  return shown;
}

QLabel* Panel::label(const QString& words) { return new QLabel(words, this); }

QHBoxLayout* Panel::row(std::initializer_list<Cell> cells) {
  auto* row = new QHBoxLayout;
  QString title;
  for (const Cell& cell : cells) {
    row->addWidget(cell.widget, cell.stretch);
    if (const auto* label = qobject_cast<const QLabel*>(cell.widget)) title = label->text();
    const bool has_words = qobject_cast<const QAbstractButton*>(cell.widget) != nullptr;
    if (!has_words && cell.widget->accessibleName().isEmpty()) cell.widget->setAccessibleName(title);
  }
  column_->addLayout(row);
  return row;
}

void Panel::buttons(std::initializer_list<const char*> names, int columns, Qt::ToolButtonStyle style,
                    const std::function<QAction*(const QString&)>& action) {
  auto* grid = new QGridLayout;
  grid->setSpacing(3);
  for (const char* name : names) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action(name));
    button->setObjectName(QString("button-") + name);
    button->setToolButtonStyle(style);
    button->setFocusPolicy(Qt::NoFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(button, grid->count() / columns, grid->count() % columns);
  }
  column_->addLayout(grid);
}

void Panel::follow() {
  following_ = true;
  for (const auto& follow : follow_) follow();
  following_ = false;
}

QScrollArea* scrolled(QWidget* panel) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);  // its fields take the keyboard
  panel->setMinimumWidth(1);            // fields get narrower when a scroll bar takes some of the width
  scroll->setWidget(panel);
  return scroll;
}

}  // namespace croquis::app
