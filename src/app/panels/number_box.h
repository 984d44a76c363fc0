// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QDoubleSpinBox;
class QWidget;

namespace croquis::app {

constexpr int number_box_width = 62;  ///< logical pixels, the least; not that of the longest number

/// The numbers that people may type.
struct NumberRange {
  double low = 0;
  double high = 1;  ///< >= low
  int decimals = 2;
};

/// A box for a number in a panel. It tells its value when the typing is done, not with every digit.
/// @param parent owns it
/// @param name   of the object, by which tests and recordings find it
QDoubleSpinBox* make_number_box(QWidget* parent, const QString& name, const NumberRange& range);

}  // namespace croquis::app
