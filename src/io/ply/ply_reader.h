// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_context.h"

namespace croquis {

/// PLY in its three encodings, with every property kept; triangle strips are expanded.
PolyMesh read_ply(std::string_view bytes, ReadContext& context);

}  // namespace croquis
