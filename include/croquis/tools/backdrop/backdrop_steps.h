// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/recording/vocabulary.h"

/// Steps about the picture behind a drawing. Which picture it is, the step that opens its file says.
namespace croquis::recorded {

/// Where the picture lies and how it is seen.
struct BackdropSetting {
  Vec2 centre = Vec2::Zero();  ///< on the plane that is drawn on, y up
  double scale = 1;            ///< units of the drawing per pixel of the picture, > 0
  double opacity = 1;          ///< 0..1
  bool visible = true;

  static constexpr std::array verbs{"backdrop"};
  void describe(Fields& fields);
};

struct BackdropRemoval {
  static constexpr std::array verbs{"remove-backdrop"};
  void describe(Fields&) {}
};

const Vocabulary& backdrop_steps();

}  // namespace croquis::recorded
