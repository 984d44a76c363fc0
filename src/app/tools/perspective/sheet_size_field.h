// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "croquis/geometry/vector.h"

class QComboBox;
class QDoubleSpinBox;

namespace croquis::app {

/// The size of the sheet: width and height, or one of the usual shapes.
class SheetSizeField : public QWidget {
  Q_OBJECT

 public:
  explicit SheetSizeField(QWidget* parent);

  void follow(const Vec2& size);  ///< px

 signals:
  void size_wanted(const croquis::Vec2& size);

 private:
  void take_shape(int index);
  void tell();

  QComboBox* shape_;
  std::array<QDoubleSpinBox*, 2> sides_{};
  bool following_ = false;
};

}  // namespace croquis::app
