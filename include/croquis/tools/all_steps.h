// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/recording/vocabulary.h"

namespace croquis::recorded {

/// Every step of Croquis.
const Vocabulary& all_steps();

}  // namespace croquis::recorded
