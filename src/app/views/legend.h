// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QWidget>
#include <functional>
#include <vector>

namespace croquis::app {

/// A card over the views that shows what colours mean, a row for each. Lets the pointer through.
class Legend : public QWidget {
 public:
  static constexpr int row_height = 16;

  struct Row {
    std::string label;                                   ///< English: it is shown in the language in use
    std::function<void(QPainter& painter, int y)> draw;  ///< left of the label; y is the row's top
  };

  /// @param title   English
  /// @param meaning what it shows, for people who don't see it
  /// @param rows from above
  Legend(QWidget* views, const QString& name, const std::string& title, const QString& meaning, std::vector<Row> rows);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::string title_;
  std::vector<Row> rows_;
};

}  // namespace croquis::app
