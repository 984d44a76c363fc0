// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>
#include <array>
#include <functional>

#include "app/studio/studio.h"
#include "app/views/chip_places.h"

namespace croquis::app {

/// The labels that every view has: its name, and in one of them how large the objects are.
class ViewChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on
  ViewChips(Studio& studio, QWidget* views);

  /// In the middle, for as long as the program runs: for whatever can't be drawn.
  void say(const QString& sentence);

  /// @param titles of the views, where they aren't called by what they look along
  void place(ChipPlaces& places, const std::array<QString, view_count>& titles);

 private:
  void place_counts(ChipPlaces& places);
  QString counts() const;

  Studio& studio_;
  QWidget* views_;
  QLabel* message_;
  std::array<QLabel*, view_count> names_{};
  QLabel* counts_;
};

}  // namespace croquis::app
