// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QToolButton>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/silhouette/joints.h"
#include "app/views/chip_places.h"

namespace croquis::app {

/// Buttons in the sketch view where a limb and a body may become one.
class JointChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on
  JointChips(Studio& studio, QWidget* views);

  /// What joints the newest result offers.
  void follow_result();

  /// Accepts every joint that is offered.
  void join_all();

  /// @param shown false while a stroke is under way: nothing covers it
  void place(ChipPlaces& places, bool shown);

 private:
  void add_chip();

  Studio& studio_;
  QWidget* views_;
  std::vector<Joint> joints_;
  std::vector<QToolButton*> chips_;  ///< one for each of joints_; later ones wait hidden
};

}  // namespace croquis::app
