// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/tools/recording/recording.h"

namespace croquis::recorded {

/// What is wrong with a line, without its end; becomes a finding with the line's number.
struct Mistake {
  std::string sentence;
};

/// One line of a recording. @throws Mistake
Step read_line(std::string_view text);

}  // namespace croquis::recorded
