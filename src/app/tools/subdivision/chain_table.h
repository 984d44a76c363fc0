// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <array>
#include <vector>

#include "app/studio/studio.h"

namespace croquis::app {

/// The chains of sharp edges of a subdivided object: how long they are, whether they close, and between which angles
/// the surface folds along them. Its rows choose them.
class ChainTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ChainTable(QWidget* parent = nullptr);

  /// @param object may be null or have no chains
  void show_chains(const WorkObject* object);

  /// "5 creases, 1 pin" of the object; empty for none.
  static QString summary(const WorkObject* object);

  /// The tagged edges of the cage that a chain of the table descends from, by their vertices.
  std::vector<std::array<Index, 2>> cage_edges(int chain) const;

 signals:
  void chain_chosen(int chain);  ///< 0-based

 private:
  std::vector<std::vector<std::array<Index, 2>>> cage_edges_;  ///< per row
};

}  // namespace croquis::app
