// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include <Eigen/Geometry>

#include "app/studio/studio.h"

namespace croquis::app {

/// How large the active object is beside everything else that is seen, and its scaling to that size. Files don't name
/// their units: a mesh in metres is a dot in a sketch.
class SceneScale {
 public:
  explicit SceneScale(Studio& studio) : studio_(studio) {}

  /// The factor that gives the active object the diagonal of all the rest; none where it is alone or comes from
  /// a drawing.
  std::optional<double> factor() const;

  /// Whether the sizes differ so much that one is a dot beside the other: ten times and more.
  bool is_far_off() const;

  /// "cube is 300 times smaller than the rest", of one that is far off; else empty.
  QString sentence() const;

  /// Scales the active object to the rest, about the rest's middle where it lies outside of that, else about its own.
  /// One step of the history. @throws Error (E_EMPTY) where there is nothing to scale or to compare with
  void apply();

 private:
  using Box = Eigen::AlignedBox3d;
  Box box_of(const WorkObject& object) const;
  Box box_of_rest(const WorkObject& object) const;

  Studio& studio_;
};

}  // namespace croquis::app
