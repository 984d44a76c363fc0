// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/network.h"
#include "app/tools/surface/network_scene.h"
#include "app/views/view_chips.h"
#include "croquis/attribute_surface/loop_search.h"

class QLabel;
class QToolButton;

namespace croquis::app {

/// How far a network is, in one sentence.
struct NetworkState {
  QString sentence;
  bool sound = false;        ///< all that is there could be made
  NetworkElements elements;  ///< that the sentence is about
};
NetworkState network_state(const AttributeNetwork& network, const ShownSurface& shown, const Findings& findings);

/// What the selected curves lack to be a loop.
struct LoopState {
  bool closed = false;
  std::optional<Vec3> gap;  ///< the middle of the only gap, in the network's own space
  QString sentence;         ///< what is missing; empty when it is closed
  Vec3 middle = Vec3::Zero();
};

/// @param curves selected. @return none where they aren't meant as a loop: fewer than two, or one that has a face
std::optional<LoopState> loop_state(const AttributeNetwork& network, const std::vector<std::string>& curves);

/// The elements of a network that a finding is about.
NetworkElements elements_in(const Finding& finding, const AttributeNetwork& network);

/// What stands over the views of a network: how far it is, what a loop lacks, angles along smooth curves, how far off
/// the dents of points are.
class SurfaceChips {
 public:
  SurfaceChips(DrawnNetwork& network, const UniformGhost& ghost);

  /// After the document, a result or the selection has changed.
  void follow();

  void place(ChipPlaces& places, bool shown);

 private:
  std::optional<QPointF> beside(const ViewPane& pane, const Vec3& world) const;
  void place_hint(const QRectF& rect);
  void place_state(const QRectF& rect);
  void place_loop(const ViewPane& pane);
  void place_numbers(const ViewPane& pane);
  std::vector<PlacedText> numbers() const;

  DrawnNetwork& network_;
  const UniformGhost& ghost_;
  int view_ = 0;  ///< that they stand on
  NetworkState state_;
  std::optional<LoopState> loop_;
  ChipSet chips_;
  QLabel* hint_;
  QToolButton* sentence_;
  QToolButton* patch_;
  QLabel* gap_;
};

}  // namespace croquis::app
