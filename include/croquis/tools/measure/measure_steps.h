// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/tools/recording/vocabulary.h"

namespace croquis::recorded {

/// Places were picked to measure between.
struct Measure {
  std::vector<Vec3> places;  ///< one to three

  static constexpr std::array verbs{"measure"};
  void describe(Fields& fields);
};

const Vocabulary& measure_steps();

}  // namespace croquis::recorded
