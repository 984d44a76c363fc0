// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "croquis/tools/pointer/mesh_event.h"

namespace croquis {

/// Picks up to three places of the model to measure between. A click adds a place, one on four begins anew; a drag
/// moves the place that it begins at. Changes no document.
class MeasureTool {
 public:
  /// The place of the model at a pixel of a view; nothing where there is none.
  using Pick = std::function<std::optional<Vec3>(const ViewFrame& frame, const Vec2& pixel)>;

  static constexpr std::size_t most_places = 3;

  explicit MeasureTool(Pick pick) : pick_(std::move(pick)) {}

  const std::vector<Vec3>& places() const { return places_; }

  /// Under the pointer: where a click would add a place.
  const std::optional<Vec3>& hovered() const { return hovered_; }

  /// @return whether the places are others than before the gesture; known at its end
  bool handle(const MeshEvent& event);
  bool active() const { return before_.has_value(); }
  bool abandon();  ///< gives up the gesture under way. @return false when there was none

  /// @return whether hovered() changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();

  void set_places(std::vector<Vec3> places);  ///< the first three count
  bool remove_last();                         ///< @return false when there was none

 private:
  void begin(const MeshEvent& event);

  Pick pick_;
  std::vector<Vec3> places_;
  std::optional<Vec3> hovered_;
  std::optional<std::vector<Vec3>> before_;  ///< the gesture under way
  std::size_t held_ = 0;                     ///< the place that it moves
};

}  // namespace croquis
