// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "croquis/tools/backdrop/backdrop_editor.h"

class QAction;
class QBoxLayout;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace croquis::app {

/// The picture behind the drawing by numbers: opacity, place and scale.
class BackdropPanel : public QWidget {
  Q_OBJECT

 public:
  /// @param action finds the window's actions by name: buttons do what menus and keys do
  explicit BackdropPanel(const std::function<QAction*(const QString&)>& action);

  /// @param backdrop null for none
  void follow(const Backdrop* backdrop);

 signals:
  void opacity_moved(double opacity);  ///< more follow, until …
  void opacity_left();                 ///< … this
  void place_wanted(const croquis::Vec2& centre, double scale);

 private:
  void make_opacity(QBoxLayout* column);
  void make_place(QBoxLayout* column);
  void make_buttons(QBoxLayout* column, const std::function<QAction*(const QString&)>& action);
  void tell_place();

  QLabel* name_;
  QSlider* opacity_;
  std::array<QDoubleSpinBox*, 2> centre_{};
  QDoubleSpinBox* scale_ = nullptr;
  bool following_ = false;
};

}  // namespace croquis::app
