// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/number_box.h"

#include <QDoubleSpinBox>

namespace croquis::app {

QDoubleSpinBox* make_number_box(QWidget* parent, const QString& name, const NumberRange& range) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(range.low, range.high);
  box->setDecimals(range.decimals);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(number_box_width);
  return box;
}

}  // namespace croquis::app
