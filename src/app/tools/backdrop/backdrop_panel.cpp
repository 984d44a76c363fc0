// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/backdrop/backdrop_panel.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/panels/number_box.h"

namespace croquis::app {
namespace {

constexpr double percent = 0.01;

}  // namespace

BackdropPanel::BackdropPanel(const std::function<QAction*(const QString&)>& action) : name_(new QLabel(this)) {
  setObjectName("backdrop-panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  name_->setObjectName("backdrop-name");
  column->addWidget(name_);
  make_opacity(column);
  make_place(column);
  make_buttons(column, action);
  column->addStretch();
}

void BackdropPanel::make_opacity(QBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Opacity"), this));
  opacity_ = new QSlider(Qt::Horizontal, this);
  opacity_->setObjectName("backdrop-opacity");
  opacity_->setRange(0, 100);
  opacity_->setToolTip(tr("How strongly the picture is seen behind the drawing"));
  connect(opacity_, &QSlider::valueChanged, this, [this](int value) {
    if (following_) return;
    emit opacity_moved(value * percent);
    if (!opacity_->isSliderDown()) emit opacity_left();
  });
  connect(opacity_, &QSlider::sliderReleased, this, &BackdropPanel::opacity_left);
  row->addWidget(opacity_);
  column->addLayout(row);
}

void BackdropPanel::make_place(QBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->addWidget(new QLabel(tr("Middle x, y"), this), 0, 0);
  centre_ = {make_number_box(this, "backdrop-x", {-1e7, 1e7, 2}), make_number_box(this, "backdrop-y", {-1e7, 1e7, 2})};
  for (int i = 0; i < 2; ++i) {
    grid->addWidget(centre_[static_cast<std::size_t>(i)], 0, 1 + i);
    connect(centre_[static_cast<std::size_t>(i)], &QDoubleSpinBox::valueChanged, this, &BackdropPanel::tell_place);
  }
  grid->addWidget(new QLabel(tr("Scale"), this), 1, 0);
  scale_ = make_number_box(this, "backdrop-scale", {1e-3, 1e5, 3});
  scale_->setSuffix(QStringLiteral(" %"));
  scale_->setToolTip(tr("At 100 % a pixel of the picture is one unit of the drawing"));
  connect(scale_, &QDoubleSpinBox::valueChanged, this, &BackdropPanel::tell_place);
  grid->addWidget(scale_, 1, 1, 1, 2);
  column->addLayout(grid);
}

void BackdropPanel::make_buttons(QBoxLayout* column, const std::function<QAction*(const QString&)>& action) {
  auto* grid = new QGridLayout;
  grid->setSpacing(3);
  int place = 0;
  for (const char* name : {"show-picture", "fit-picture", "move-picture", "open-picture", "remove-picture"}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action(name));
    button->setObjectName(QString("button-") + name);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::NoFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(button, place / 3, place % 3);
    ++place;
  }
  column->addLayout(grid);
}

void BackdropPanel::tell_place() {
  if (following_) return;
  emit place_wanted(Vec2(centre_[0]->value(), centre_[1]->value()), scale_->value() * percent);
}

void BackdropPanel::follow(const Backdrop* backdrop) {
  setEnabled(backdrop != nullptr);
  if (backdrop == nullptr) return;
  following_ = true;
  const PictureFile& picture = *backdrop->picture;
  name_->setText(tr("%1, %2 × %3")
                     .arg(QFileInfo(QString::fromStdString(picture.file)).fileName())
                     .arg(picture.width)
                     .arg(picture.height));
  opacity_->setValue(static_cast<int>(std::lround(backdrop->opacity / percent)));
  for (int i = 0; i < 2; ++i) centre_[static_cast<std::size_t>(i)]->setValue(backdrop->centre[i]);
  scale_->setValue(backdrop->scale / percent);
  following_ = false;
}

}  // namespace croquis::app
