// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/backdrop.h"

#include "croquis/base/limits.h"

namespace croquis {

bool is_valid(const Backdrop& backdrop) {
  return backdrop.picture != nullptr && are_usable_numbers(backdrop.centre) && backdrop.scale > 0 &&
         is_usable_number(backdrop.scale) && backdrop.opacity >= 0 && backdrop.opacity <= 1;
}

}  // namespace croquis
