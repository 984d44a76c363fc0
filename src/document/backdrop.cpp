// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/backdrop.h"

#include <cmath>

namespace croquis {

bool is_valid(const Backdrop& backdrop) {
  return backdrop.picture != nullptr && backdrop.centre.allFinite() && backdrop.scale > 0 &&
         std::isfinite(backdrop.scale) && backdrop.opacity >= 0 && backdrop.opacity <= 1;
}

}  // namespace croquis
