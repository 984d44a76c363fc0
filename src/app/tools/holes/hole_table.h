// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "app/tools/holes/hole_plan.h"
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

/// The holes of a scan, a row each; headings sort. Its rows are what is selected.
class HoleTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit HoleTable(QWidget* parent = nullptr);

  void show_holes(const std::vector<HoleRow>& holes);
  void name_unit(const QString& unit);  ///< of lengths, in the titles; empty where nothing names one
  void show_selection(const std::vector<Index>& holes);

  /// Of the rows as they stand, from the top.
  std::vector<Index> order() const;

 signals:
  void holes_chosen(const std::vector<croquis::Index>& holes);
  void hole_opened(croquis::Index hole);  ///< double click
  void accepted();                        ///< Enter

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Index hole_of(int row) const;

  std::vector<HoleRow> shown_;
  bool showing_ = false;  ///< the program sets the selection, not the user
};

}  // namespace croquis::app
