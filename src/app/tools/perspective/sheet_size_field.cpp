// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/sheet_size_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/panels/number_box.h"

namespace croquis::app {
namespace {

struct SheetShape {
  const char* name;
  double aspect;  ///< width / height
};

constexpr std::array<SheetShape, 5> shapes{{{"4:3", 4.0 / 3},
                                            {"3:2", 3.0 / 2},
                                            {"16:9", 16.0 / 9},
                                            {"A4 landscape", std::numbers::sqrt2},
                                            {"A4 portrait", 1 / std::numbers::sqrt2}}};
constexpr double longest_sheet = 100'000;  // px

}  // namespace

SheetSizeField::SheetSizeField(QWidget* parent) : QWidget(parent), shape_(new QComboBox(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Sheet"), this));
  shape_->setObjectName("sheet-shape");
  shape_->addItem(tr("Other"));
  for (const SheetShape& shape : shapes) shape_->addItem(tr(shape.name));
  shape_->setToolTip(tr("The shape of the sheet; its longer side stays as it is. Strokes keep their places"));
  connect(shape_, &QComboBox::activated, this, &SheetSizeField::take_shape);
  row->addWidget(shape_, 1);
  const std::array<const char*, 2> names{"sheet-width", "sheet-height"};
  for (std::size_t i = 0; i < 2; ++i) {
    sides_[i] = make_number_box(this, names[i], {1, longest_sheet, 0});
    connect(sides_[i], &QDoubleSpinBox::valueChanged, this, &SheetSizeField::tell);
    row->addWidget(sides_[i]);
  }
}

void SheetSizeField::follow(const Vec2& size) {
  following_ = true;
  for (int i = 0; i < 2; ++i) sides_[static_cast<std::size_t>(i)]->setValue(size[i]);
  // Sides are whole pixels: the shape is right up to one of them.
  const auto fits = [&](const SheetShape& shape) { return std::abs(size.x() - shape.aspect * size.y()) <= 1; };
  const auto found = std::ranges::find_if(shapes, fits);
  shape_->setCurrentIndex(found == shapes.end() ? 0 : 1 + static_cast<int>(found - shapes.begin()));
  following_ = false;
}

void SheetSizeField::take_shape(int index) {
  if (index < 1) return;
  const double aspect = shapes[static_cast<std::size_t>(index - 1)].aspect;
  const double longer = std::max(sides_[0]->value(), sides_[1]->value());
  emit size_wanted(aspect > 1 ? Vec2(longer, std::round(longer / aspect)) : Vec2(std::round(longer * aspect), longer));
}

void SheetSizeField::tell() {
  if (!following_) emit size_wanted({sides_[0]->value(), sides_[1]->value()});
}

}  // namespace croquis::app
