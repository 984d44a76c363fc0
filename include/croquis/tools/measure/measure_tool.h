// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/tools/pointer/mesh_event.h"

namespace croquis {

// Distances, angles and radii between places of the model.

/// At b, between the directions to a and c: degrees, 0..180; 0 where a place is b itself.
double angle_at(const Vec3& a, const Vec3& b, const Vec3& c);

/// Of the circle through three places; infinite where they lie on a line.
double radius_through(const Vec3& a, const Vec3& b, const Vec3& c);

/// One thing that was measured, and where its value stands.
struct MeasuredValue {
  std::string name;  ///< "Distance", "Angle", "Radius"
  double value = 0;  ///< model units, degrees
  std::string text;  ///< "5", "90°", "∞"
  Vec3 at = Vec3::Zero();
};

/// Of two places their distance; of three the distances along the way, the angle at the second one, and the radius of
/// the circle through them. Of fewer places nothing.
/// @param places at most three, finite
std::vector<MeasuredValue> measured(const std::vector<Vec3>& places);

/// The same as lines of text, with the differences along the axes behind each distance.
std::string measured_text(const std::vector<Vec3>& places);

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
