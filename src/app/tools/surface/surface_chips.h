// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "app/tools/surface/network_interaction.h"
#include "app/tools/surface/network_state.h"
#include "app/tools/surface/uniform_ghost.h"
#include "app/views/chip_places.h"

class QLabel;
class QToolButton;

namespace croquis::app {

class Viewport;

/// What stands over the views of a network: how far it is, what a loop lacks, angles along smooth curves, how far off
/// the dents of points are.
class SurfaceChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on
  SurfaceChips(NetworkInteraction& network, const UniformGhost& ghost, Viewport& views);

  /// After the document, a result or the selection has changed.
  void follow();

  void place(ChipPlaces& places, bool shown);

  /// The curves of a closed loop without a patch, while nothing is selected; empty where there is none.
  const std::vector<std::string>& offered() const { return offered_; }

 signals:
  void patch_wanted();
  void elements_wanted(const croquis::NetworkElements& elements);  ///< selected, and looked at

 private:
  QToolButton* make_chip(const QString& name);
  QLabel& label(std::size_t number);
  void put(ChipPlaces& places, QWidget& chip, const QPointF& at, const QRectF& bounds);
  void put_at(ChipPlaces& places, QWidget& chip, const Vec3& world);
  void place_hint(ChipPlaces& places);
  void place_state(ChipPlaces& places);
  void place_loop(ChipPlaces& places);
  void place_numbers(ChipPlaces& places);
  std::vector<PlacedText> numbers() const;

  NetworkInteraction& network_;
  const UniformGhost& ghost_;
  Viewport& views_;
  int view_ = 0;  ///< that they stand on
  NetworkState state_;
  std::optional<LoopState> loop_;
  std::vector<std::string> offered_;
  std::vector<QWidget*> placed_;  ///< this time
  QLabel* hint_;
  QToolButton* sentence_;
  QToolButton* patch_;
  QLabel* gap_;
  std::vector<QLabel*> labels_;
};

}  // namespace croquis::app
