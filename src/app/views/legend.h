// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QWidget>

namespace croquis::app {

/// A card over the views that tells what colours mean, a row for each. Lets the pointer through.
class Legend : public QWidget {
  Q_OBJECT

 public:
  /// @param meaning what it tells, for people who don't see it
  Legend(QWidget* views, const QString& name, const QString& title, const QString& meaning, int rows);

 protected:
  static constexpr int row_height = 16;
  static constexpr int text_left = 40;

  void paintEvent(QPaintEvent* event) override;

  /// One row. @param y its top. @param row from above, 0-based
  virtual void draw_row(QPainter& painter, int row, int y) = 0;

  /// The text of a row, behind what `draw_row` draws.
  void draw_label(QPainter& painter, int y, const QString& text) const;

 private:
  QString title_;
  int rows_;
};

}  // namespace croquis::app
