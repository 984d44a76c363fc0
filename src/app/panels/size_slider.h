// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "croquis/tools/holes/hole_histogram.h"

namespace croquis::app {

/// A slider of diameters over a histogram of the holes' diameters.
class SizeSlider : public QWidget {
  Q_OBJECT

 public:
  explicit SizeSlider(QWidget* parent = nullptr);

  /// @param diameters of the holes that may be chosen, model units
  void show_sizes(const std::vector<double>& diameters);

  /// Everything up to that is coloured; 0: nothing.
  void set_diameter(double diameter);
  double diameter() const { return diameter_; }
  const HoleHistogram& histogram() const { return histogram_; }

  QSize sizeHint() const override { return {200, 44}; }

 signals:
  void moved(double diameter);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void move_to(double position);
  QRectF track() const;

  HoleHistogram histogram_;
  std::vector<double> diameters_;
  double diameter_ = 0;
};

}  // namespace croquis::app
