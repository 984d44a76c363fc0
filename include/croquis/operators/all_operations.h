// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/registry.h"

namespace croquis {

/// A registry with every operation of Croquis, for hosts to hand on.
Registry all_operations();

}  // namespace croquis
