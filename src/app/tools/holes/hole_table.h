// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <vector>

#include "app/tools/holes/hole_rows.h"

namespace croquis::app {

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
